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
template <int step, bool record, bool modulated>
float diffuseRow(const float* wanted, const float* current, float* next, int width, float scale,
  float carry, int rowBegin, const DiffusionCoefficients* table, Noise& noise,
  std::vector<int>& samples)
{
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
    const float threshold = modulated ? 0.5f + c.modulation * noise.next() : 0.5f;
    if (error >= threshold && in > 0)
    {
      error -= 1.f;
      if (record)
      {
        samples.push_back(rowBegin + x);
      }
    }
    carry = error * c.right;
    const float back = error * c.downLeft;
    next[x - step] = pending + back;
    pending = error - carry - back;
  }
  next[x - step] = pending;
  return carry;
}

/// The rows [-warmUpRows, height), those below zero being the flipped copy's.
template <bool modulated>
void diffuseRows(const WantedRow& wanted, int width, int height, int warmUpRows, float scale,
  const DiffusionCoefficients* table, std::vector<int>& samples)
{
  std::vector<float> lines(2 * (static_cast<std::size_t>(width) + 2), 0.f);
  float* current = lines.data() + 1;
  float* next = current + width + 2;
  float carry = 0;
  Noise noise;
  bool forward = warmUpRows % 2 == 0; // so that row 0 always runs forward
  for (int y = -warmUpRows; y < height; ++y)
  {
    const bool record = y >= 0;
    const float* w = wanted(record ? y : -1 - y);
    const int begin = record ? y * width : 0;
    const std::size_t first = samples.size();
    if (forward)
    {
      carry = record ? diffuseRow<1, true, modulated>(
                         w, current, next, width, scale, carry, begin, table, noise, samples)
                     : diffuseRow<1, false, modulated>(
                         w, current, next, width, scale, carry, begin, table, noise, samples);
      next[0] += next[-1];
    }
    else
    {
      carry = record ? diffuseRow<-1, true, modulated>(
                         w, current, next, width, scale, carry, begin, table, noise, samples)
                     : diffuseRow<-1, false, modulated>(
                         w, current, next, width, scale, carry, begin, table, noise, samples);
      std::reverse(samples.begin() + static_cast<std::ptrdiff_t>(first), samples.end());
      next[width - 1] += next[width];
    }
    forward = !forward;
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
  int warmUpRows = 0;
  for (double depth = 0; depth < options.warmUpDepth && warmUpRows < height; ++warmUpRows)
  {
    float sum = 0;
    const float* w = wanted(warmUpRows);
    for (int x = 0; x < width; ++x)
    {
      sum += w[x];
    }
    depth += std::sqrt(static_cast<double>(sum) * options.scale / width);
  }
  const DiffusionCoefficients* table = diffusionTable(options.method);
  const auto scale = static_cast<float>(options.scale);
  if (options.method == DiffusionMethod::ZhouFang)
  {
    diffuseRows<true>(wanted, width, height, warmUpRows, scale, table, samples);
  }
  else
  {
    diffuseRows<false>(wanted, width, height, warmUpRows, scale, table, samples);
  }
}

void diffuseErrors(const float* wanted, int width, int height, const ErrorDiffusionOptions& options,
  std::vector<int>& samples)
{
  diffuseErrors([=](int y) { return wanted + static_cast<std::ptrdiff_t>(y) * width; }, width,
    height, options, samples);
}
}
