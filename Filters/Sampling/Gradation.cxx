// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Gradation.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stipple
{
namespace
{
constexpr int numberOfSteps = 6; // six implicit steps make a kernel that is close to a Gaussian

/// Solves (A - c D) u = A u along rows of n values, lines of them at a time; `stride` from one
/// value of a row to its next, lines being neighbours in memory. D is the second difference with
/// closed ends.
class LineSolver
{
public:
  LineSolver(int n, int lines)
    : Upper(static_cast<std::size_t>(n) * lines)
    , Count(n)
    , Lines(lines)
  {
  }
  void solve(float* u, const float* area, float least, float c, std::ptrdiff_t stride,
    std::ptrdiff_t lineStride)
  {
    for (int i = 0; i < this->Count; ++i)
    {
      const float ends = static_cast<float>((i > 0) + (i + 1 < this->Count)) * c;
      float* upper = this->Upper.data() + static_cast<std::ptrdiff_t>(i) * this->Lines;
      for (int l = 0; l < this->Lines; ++l)
      {
        const std::ptrdiff_t k = i * stride + l * lineStride;
        const float a = area[k] > least ? area[k] : least;
        const float before = i > 0 ? upper[l - this->Lines] : 0.f;
        const float inverse = 1.f / (a + ends - c * before);
        upper[l] = c * inverse;
        u[k] = (a * u[k] + (i > 0 ? c * u[k - stride] : 0.f)) * inverse;
      }
    }
    for (int i = this->Count - 2; i >= 0; --i)
    {
      const float* upper = this->Upper.data() + static_cast<std::ptrdiff_t>(i) * this->Lines;
      for (int l = 0; l < this->Lines; ++l)
      {
        const std::ptrdiff_t k = i * stride + l * lineStride;
        u[k] += upper[l] * u[k + stride];
      }
    }
  }

private:
  std::vector<float> Upper;
  int Count;
  int Lines;
};
}

void smoothOnSurface(float* values, const float* area, int width, int height, double pixelWidth,
  double pixelHeight, double sigma)
{
  const double step = 0.5 * sigma * sigma / numberOfSteps;
  const std::size_t n = static_cast<std::size_t>(width) * height;
  if (n == 0 || step <= 0)
  {
    return;
  }
  double mean = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    mean += area[i] > 0 ? area[i] : 0.f;
  }
  const float least = std::max(static_cast<float>(1e-5 * mean / static_cast<double>(n)), 1e-30f);
  const float cx = static_cast<float>(step / (pixelWidth * pixelWidth));
  const float cy = static_cast<float>(step / (pixelHeight * pixelHeight));
  LineSolver columns(height, width);
  for (int k = 0; k < numberOfSteps; ++k)
  {
    constexpr int lines = 8; // rows side by side, so that their divisions overlap
    for (int y = 0; y < height; y += lines)
    {
      LineSolver rows(width, std::min(lines, height - y));
      const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(y) * width;
      rows.solve(values + begin, area + begin, least, cx, 1, width);
    }
    columns.solve(values, area, least, cy, width, 1);
  }
}
}
