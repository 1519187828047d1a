// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorDiffusion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stipple
{
namespace
{
/// Noise in [0, 1) for the threshold: a linear congruential generator (Numerical Recipes), of which
/// the upper bits count. The same in every run.
class Noise
{
public:
  float next()
  {
    this->State = this->State * 1664525u + 1013904223u;
    return static_cast<float>(this->State >> 8) * (1.f / (1u << 24));
  }

private:
  std::uint32_t State = 1;
};

/// Runs along one row in the direction of step. current holds the errors that the previous row left
/// here; next receives those for the row below; carry travels from pixel to pixel and, at a row's
/// end, down to the next row's first pixel, so that nothing is lost at the sides.
/// The columns of the samples go to hits, whose end is returned: no call in this loop, so that its
/// state stays in registers.
template <int step, bool modulated>
int* diffuseRow(const float* wanted, const float* current, float* next, int width, float scale,
  float& carryInOut, const DiffusionCoefficients* table, Noise& noise, int* hits)
{
  float carry = carryInOut;
  float pending = 0;
  int x = step > 0 ? 0 : width - 1;
  const float toIndex = scale * diffusionTableScale;
  constexpr float lastIndex = diffusionTableScale;
  for (int i = 0; i < width; ++i, x += step)
  {
    const float in = wanted[x];
    const DiffusionCoefficients& c =
      table[static_cast<int>(std::min(in * toIndex + 0.5f, lastIndex))];
    float error = in * scale + current[x] + carry;
    // A sample is rare, so that the branch is predicted and the chain of dependent operations stays
    // short.
    const float threshold = modulated ? c.threshold + c.modulation * noise.next() : c.threshold;
    if (error >= threshold && in > 0)
    {
      error -= 1.f;
      *hits++ = x;
    }
    carry = error * c.right;
    const float back = error * c.downLeft;
    next[x - step] = pending + back;
    pending = error - carry - back;
  }
  next[x - step] = pending;
  carryInOut = carry;
  return hits;
}

template <bool modulated>
void diffuseRows(const WantedRow& wanted, int width, int height, float scale,
  const DiffusionCoefficients* table, std::vector<int>& samples)
{
  std::vector<float> lines(2 * (static_cast<std::size_t>(width) + 2), 0.f);
  float* current = lines.data() + 1;
  float* next = current + width + 2;
  float carry = 0;
  Noise noise;
  std::vector<int> hits(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y)
  {
    const float* w = wanted(y);
    int* end = nullptr;
    if (y % 2 == 0)
    {
      end =
        diffuseRow<1, modulated>(w, current, next, width, scale, carry, table, noise, hits.data());
      next[0] += next[-1];
    }
    else
    {
      end =
        diffuseRow<-1, modulated>(w, current, next, width, scale, carry, table, noise, hits.data());
      std::reverse(hits.data(), end);
      next[width - 1] += next[width];
    }
    for (const int* x = hits.data(); x < end; ++x)
    {
      samples.push_back(y * width + *x);
    }
    std::swap(current, next);
  }
}
}

void diffuseErrors(const WantedRow& wanted, int width, int height,
  const ErrorDiffusionOptions& options, std::vector<int>& samples)
{
  samples.clear();
  if (width <= 0 || height <= 0)
  {
    return;
  }
  const DiffusionCoefficients* table = diffusionTable(options.method);
  const auto scale = static_cast<float>(options.scale);
  if (options.method == DiffusionMethod::ZhouFang)
  {
    diffuseRows<true>(wanted, width, height, scale, table, samples);
  }
  else
  {
    diffuseRows<false>(wanted, width, height, scale, table, samples);
  }
}

void diffuseErrors(const float* wanted, int width, int height, const ErrorDiffusionOptions& options,
  std::vector<int>& samples)
{
  diffuseErrors([=](int y) { return wanted + static_cast<std::ptrdiff_t>(y) * width; }, width,
    height, options, samples);
}
}
