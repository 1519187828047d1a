// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Importance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace stipple
{
namespace
{
std::uint32_t bitsOf(float x)
{
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

float floatOf(std::uint32_t bits)
{
  float x;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}

double halfDifference(double H, double K)
{
  return std::sqrt(std::max(0., H * H - K));
}

// The table's places are floats whose last 15 mantissa bits are zero, from 2^-24 to 1: they are
// finer the nearer to zero, and a float's own bits say between which two it lies.
constexpr int TableShift = 15;
constexpr std::uint32_t TableBegin = (127u - 24u) << 23;
constexpr std::uint32_t TableEnd = 127u << 23;
}

double minimumCurvature(double H, double K)
{
  return H - halfDifference(H, K);
}

double maximumCurvature(double H, double K)
{
  return H + halfDifference(H, K);
}

double totalCurvature(double H, double K)
{
  return std::max(0., 4. * H * H - 2. * K);
}

double optimalL2Density(double H, double K)
{
  return std::cbrt(std::max({ 9. * H * H - K, 8. * H * H, 0. }));
}

double weightedQuantile(const std::vector<WeightedValues>& values, double fraction)
{
  // Positive floats are ordered like their bits: the upper 16 bits make bins of 0.8 % of their
  // value.
  std::vector<double> bins(1u << 15, 0.);
  std::size_t size = 0;
  for (const WeightedValues& v : values)
  {
    size += v.size;
  }
  const std::size_t stride = std::max<std::size_t>(1, size / 2000000);
  double total = 0;
  for (const WeightedValues& v : values)
  {
    for (std::size_t i = 0; i < v.size; i += stride)
    {
      const float x = v.value[i] > 0 ? v.value[i] : 0.f;
      const double w = v.weight[i] > 0 ? v.weight[i] * v.factor : 0.;
      bins[bitsOf(x) >> 16] += w;
      total += w;
    }
  }
  double below = 0;
  for (std::size_t i = 0; i < bins.size(); ++i)
  {
    if (bins[i] > 0 && below + bins[i] >= fraction * total)
    {
      const auto low = static_cast<std::uint32_t>(i << 16);
      if (low == 0)
      {
        return 0;
      }
      const double a = floatOf(low);
      const double b = floatOf(low + (1u << 16));
      return a + (b - a) * (fraction * total - below) / bins[i];
    }
    below += bins[i];
  }
  return 0;
}

UnitFunctionTable::UnitFunctionTable(const std::function<double(double)>& f)
{
  this->Value.push_back(static_cast<float>(f(0.)));
  for (std::uint32_t bits = TableBegin; bits <= TableEnd; bits += 1u << TableShift)
  {
    this->Value.push_back(static_cast<float>(f(floatOf(bits))));
  }
}

float UnitFunctionTable::operator()(float x) const
{
  if (!(x < 1.f))
  {
    return x >= 1.f ? this->Value.back() : this->Value.front();
  }
  const float least = floatOf(TableBegin);
  if (x < least)
  {
    const float t = x > 0 ? x / least : 0.f;
    return this->Value[0] + t * (this->Value[1] - this->Value[0]);
  }
  const std::uint32_t offset = bitsOf(x) - TableBegin;
  const std::uint32_t i = 1 + (offset >> TableShift);
  const float t = static_cast<float>(offset & ((1u << TableShift) - 1)) / (1u << TableShift);
  return this->Value[i] + t * (this->Value[i + 1] - this->Value[i]);
}
}
