// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorDiffusion.h"

#include "SamplingConstants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

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

const DiffusionCoefficients& coefficients(const DiffusionCoefficients* table, float index)
{
  constexpr float last = DiffusionTableScale;
  return table[static_cast<int>(std::min(index + 0.5f, last))];
}

/// Runs along one row in the direction of step. current holds the errors that the previous row left
/// here; next receives those for the row below; carry travels from pixel to pixel and, at a row's
/// end, down to the next row's first pixel, so that nothing is lost at the sides.
/// The columns of the samples go to hits (one place more than the row has pixels), whose end is
/// returned: no call in this loop, so that its state stays in registers.
template <int step>
int* diffuseRow(const float* wanted, const float* current, float* next, int width, float scale,
  float& carryInOut, const DiffusionCoefficients* table, Noise& noiseInOut, int* hits)
{
  Noise noise = noiseInOut;
  float carry = carryInOut;
  float pending = 0;
  int x = step > 0 ? 0 : width - 1;
  const float toIndex = scale * DiffusionTableScale;
  for (int i = 0; i < width; ++i, x += step)
  {
    const float in = wanted[x];
    const float mass = std::abs(in);
    const DiffusionCoefficients& c = coefficients(table, mass * toIndex);
    const float threshold = c.threshold + c.modulation * noise.next();
    float error = mass * scale + current[x] + carry;
    carry = error * c.right;
    // A sample is rare, so that the branch is predicted and the chain of dependent operations stays
    // short.
    if (error >= threshold && in > 0)
    {
      error -= 1.f;
      carry -= c.right;
      *hits++ = x;
    }
    const float back = error * c.downLeft;
    next[x - step] = pending + back;
    pending = error - carry - back;
  }
  next[x - step] = pending;
  carryInOut = carry;
  noiseInOut = noise;
  return hits;
}

#ifdef __SSE2__
/// The same, to the last bit, for rows whose samples are frequent: no prediction foresees these,
/// and each surprise costs more than a mask. Compilers make branches of all that is not written so.
template <int step>
int* diffuseDenseRow(const float* wanted, const float* current, float* next, int width, float scale,
  float& carryInOut, const DiffusionCoefficients* table, Noise& noiseInOut, int* hits)
{
  Noise noise = noiseInOut;
  __m128 carry = _mm_set_ss(carryInOut);
  __m128 pending = _mm_setzero_ps();
  int x = step > 0 ? 0 : width - 1;
  const float toIndex = scale * DiffusionTableScale;
  const __m128 one = _mm_set_ss(1.f);
  for (int i = 0; i < width; ++i, x += step)
  {
    const float in = wanted[x];
    const float mass = std::abs(in);
    const DiffusionCoefficients& c = coefficients(table, mass * toIndex);
    const float modulated = c.threshold + c.modulation * noise.next();
    const float threshold = in > 0 ? modulated : std::numeric_limits<float>::max();
    __m128 error = _mm_add_ss(_mm_set_ss(mass * scale + current[x]), carry);
    const __m128 hit = _mm_cmpge_ss(error, _mm_set_ss(threshold));
    *hits = x;
    hits -= _mm_cvtsi128_si32(_mm_castps_si128(hit)); // a mask is -1
    const __m128 right = _mm_load_ss(&c.right);
    carry = _mm_sub_ss(_mm_mul_ss(error, right), _mm_and_ps(hit, right));
    error = _mm_sub_ss(error, _mm_and_ps(hit, one));
    const __m128 back = _mm_mul_ss(error, _mm_load_ss(&c.downLeft));
    _mm_store_ss(&next[x - step], _mm_add_ss(pending, back));
    pending = _mm_sub_ss(_mm_sub_ss(error, carry), back);
  }
  _mm_store_ss(&next[x - step], pending);
  carryInOut = _mm_cvtss_f32(carry);
  noiseInOut = noise;
  return hits;
}
#else
template <int step>
int* diffuseDenseRow(const float* wanted, const float* current, float* next, int width, float scale,
  float& carry, const DiffusionCoefficients* table, Noise& noise, int* hits)
{
  return diffuseRow<step>(wanted, current, next, width, scale, carry, table, noise, hits);
}
#endif
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
  std::vector<float> lines(2 * (static_cast<std::size_t>(width) + 2), 0.f);
  float* current = lines.data() + 1;
  float* next = current + width + 2;
  float carry = 0;
  Noise noise;
  std::vector<int> hits(static_cast<std::size_t>(width) + 1);
  int* end = hits.data();
  for (int y = 0; y < height && !isAsked(options.stop); ++y)
  {
    const float* w = wanted(y);
    const bool dense = (end - hits.data()) * Constants::DenseFrom > width; // as the row before was
    const auto run = [&](auto row) {
      return row(w, current, next, width, scale, carry, table, noise, hits.data());
    };
    if (y % 2 == 0)
    {
      end = dense ? run(diffuseDenseRow<1>) : run(diffuseRow<1>);
      next[0] += next[-1];
    }
    else
    {
      end = dense ? run(diffuseDenseRow<-1>) : run(diffuseRow<-1>);
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

void diffuseErrors(const float* wanted, int width, int height, const ErrorDiffusionOptions& options,
  std::vector<int>& samples)
{
  diffuseErrors([=](int y) { return wanted + static_cast<std::ptrdiff_t>(y) * width; }, width,
    height, options, samples);
}
}
