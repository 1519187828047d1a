// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ControlImage.h"

#include <array>

namespace stipple
{
ControlMass controlMass(const ControlImage& image)
{
  // Four sums side by side: a single one would wait for itself, and its order must not depend on
  // threads.
  ControlMass mass;
  for (int y = 0; y < image.height; ++y)
  {
    const float* row = image.control + static_cast<std::size_t>(y) * image.width;
    std::array<float, 4> sum = { { 0, 0, 0, 0 } };
    std::array<float, 4> top = { { 0, 0, 0, 0 } };
    int x = 0;
    for (; x + 4 <= image.width; x += 4)
    {
      for (int k = 0; k < 4; ++k)
      {
        const float v = row[x + k] > 0 ? row[x + k] : 0.f;
        sum[k] += v;
        top[k] = v > top[k] ? v : top[k];
      }
    }
    for (; x < image.width; ++x)
    {
      const float v = row[x] > 0 ? row[x] : 0.f;
      sum[0] += v;
      top[0] = v > top[0] ? v : top[0];
    }
    mass.total += (static_cast<double>(sum[0]) + sum[1]) + (static_cast<double>(sum[2]) + sum[3]);
    mass.largest = std::max<double>(mass.largest, *std::max_element(top.begin(), top.end()));
  }
  mass.total *= image.pixelArea();
  return mass;
}
}
