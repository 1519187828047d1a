// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DiffusionCoefficients.h"
#include "ErrorDiffusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

using namespace stipple;

namespace
{
constexpr int Size = 512;

std::vector<int> halftone(const std::vector<float>& wanted, ErrorDiffusionOptions options = {})
{
  std::vector<int> samples;
  diffuseErrors(wanted.data(), Size, static_cast<int>(wanted.size()) / Size, options, samples);
  return samples;
}

std::vector<int> halftone(double level, ErrorDiffusionOptions options = {})
{
  return halftone(std::vector<float>(Size * Size, static_cast<float>(level)), options);
}

/// Samples in rows [begin, end) over what is wanted there.
double fill(const std::vector<int>& samples, double level, int begin, int end)
{
  int n = 0;
  for (int i : samples)
  {
    n += i / Size >= begin && i / Size < end;
  }
  return n / (level * Size * (end - begin));
}

/// Mean power of frequencies up to a radius (cycles a pixel), relative to white noise.
double lowFrequencyPower(const std::vector<int>& samples, double level, double radius)
{
  std::mt19937 engine(7);
  const int reach = static_cast<int>(radius * Size);
  const auto random = [&] { return static_cast<int>(engine() % (2u * reach + 1)) - reach; };
  std::vector<std::complex<double>> root(Size);
  for (int i = 0; i < Size; ++i)
  {
    root[i] = std::polar(1., -2. * M_PI * i / Size);
  }
  double sum = 0;
  int n = 0;
  while (n < 400)
  {
    const int fx = random();
    const int fy = random();
    if ((fx == 0 && fy == 0) || fx * fx + fy * fy > reach * reach)
    {
      continue;
    }
    std::complex<double> f = 0;
    for (int i : samples)
    {
      f += root[static_cast<unsigned>(i % Size * fx + i / Size * fy) % Size];
    }
    sum += std::norm(f) / static_cast<double>(samples.size()) / (1. - level);
    ++n;
  }
  return sum / n;
}
}

TEST(ErrorDiffusion, CoefficientsAreThePublishedOnesMirroredAndInterpolated)
{
  const auto at = [](double level) {
    return diffusionCoefficients(DiffusionMethod::Ostromoukhov, level / 255.);
  };
  EXPECT_FLOAT_EQ(at(0).right, 13.f / 18.f);
  EXPECT_FLOAT_EQ(at(0).downLeft, 0.f);
  EXPECT_FLOAT_EQ(at(44).downLeft, 120.f / 392.f);
  EXPECT_FLOAT_EQ(at(64).downLeft, 0.3f) << "a key of our own";
  EXPECT_FLOAT_EQ(at(77).downLeft, 1.f / 6.f);
  EXPECT_FLOAT_EQ(at(127).right, 4.f / 6.f);
  EXPECT_FLOAT_EQ(at(128).right, at(127).right);
  EXPECT_FLOAT_EQ(at(255 - 44).downLeft, 120.f / 392.f);
  EXPECT_FLOAT_EQ(at(255).right, at(0).right);
  EXPECT_NEAR(at(22.25).right, 0.75 * 3. / 6. + 0.25 * 481. / 980., 1e-6);
  for (double level = 0; level <= 255; level += 0.37)
  {
    EXPECT_LT(at(level).right + at(level).downLeft, 1. + 1e-6);
    const auto threshold = [&](double x) { return at(x).threshold + 0.5 * at(x).modulation; };
    EXPECT_NEAR(threshold(level), 1. - threshold(255 - level), 1e-6);
    EXPECT_NEAR(at(level).downLeft, at(255 - level).downLeft, 1e-6);
  }
}

TEST(ErrorDiffusion, NothingIsLost)
{
  for (double level : { 1. / 300, 1. / 64, 1. / 7, 0.25, 0.5 })
  {
    const double wanted = level * Size * Size;
    EXPECT_NEAR(static_cast<double>(halftone(level).size()), wanted, 0.002 * wanted + 8.) << level;
  }
  ErrorDiffusionOptions half;
  half.scale = 0.5;
  EXPECT_EQ(halftone(0.1, half), halftone(0.05));
}

TEST(ErrorDiffusion, NoDeadZoneAtAnyBorder)
{
  for (double level : { 1. / 256, 1. / 64, 1. / 20 })
  {
    const int row = static_cast<int>(std::lround(1. / std::sqrt(level)));
    const std::vector<int> samples = halftone(level);
    std::vector<int> turned; // so that columns are rows
    for (int i : samples)
    {
      turned.push_back(i % Size * Size + i / Size);
    }
    for (const std::vector<int>& s : { samples, turned })
    {
      for (int begin : { 0, Size - 2 * row })
      {
        EXPECT_NEAR(fill(s, level, begin, begin + 2 * row), 1., 0.3) << level; // whole rows
      }
      for (int begin : { 0, Size - 6 * row })
      {
        EXPECT_NEAR(fill(s, level, begin, begin + 6 * row), 1., 0.05) << level;
      }
    }
  }
}

TEST(ErrorDiffusion, NoLagWhereTheLevelChanges)
{
  // Dense, sparse, dense: with one threshold for all levels, 30 % of the samples are missing in the
  // rows behind the first step, and as many are too many behind the second one.
  for (DiffusionMethod method : { DiffusionMethod::Ostromoukhov, DiffusionMethod::ZhouFang })
  {
    const double dense = 1. / 10;
    const double sparse = 1. / 150;
    std::vector<float> wanted(Size * Size);
    for (int i = 0; i < Size * Size; ++i)
    {
      wanted[i] = static_cast<float>(i / Size >= 170 && i / Size < 340 ? sparse : dense);
    }
    ErrorDiffusionOptions options;
    options.method = method;
    const std::vector<int> samples = halftone(wanted, options);
    EXPECT_NEAR(fill(samples, sparse, 170, 220), 1., 0.1);
    EXPECT_NEAR(fill(samples, sparse, 170, 340), 1., 0.04);
    EXPECT_NEAR(fill(samples, dense, 340, 350), 1., 0.06);
  }
}

TEST(ErrorDiffusion, BlueNoise)
{
  for (double level : { 1. / 64, 1. / 32, 1. / 16, 1. / 8, 1. / 4, 1. / 2 })
  {
    const std::vector<int> samples = halftone(level);
    const double principal = std::sqrt(level);
    EXPECT_LT(lowFrequencyPower(samples, level, 0.25 * principal), 0.05) << level;
    EXPECT_LT(lowFrequencyPower(samples, level, 0.5 * principal), 0.05) << level;
  }
  std::mt19937 engine(3);
  std::vector<int> white;
  for (int i = 0; i < Size * Size; ++i)
  {
    if (engine() % 64 == 0)
    {
      white.push_back(i);
    }
  }
  EXPECT_NEAR(lowFrequencyPower(white, 1. / 64, 0.06), 1., 0.2) << "the measure itself";
}

TEST(ErrorDiffusion, WhitePixelsStayWhiteAndTheirErrorMovesOn)
{
  std::vector<float> wanted(Size * Size, 1.f / 32);
  double mass = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    const bool white = std::abs(i % Size - 200) < 6 || std::abs(i / Size - 300) < 4 || i % Size < 5;
    wanted[i] = white ? 0.f : wanted[i];
    mass += wanted[i];
  }
  const std::vector<int> samples = halftone(wanted);
  for (int i : samples)
  {
    ASSERT_GT(wanted[i], 0.f);
  }
  EXPECT_NEAR(static_cast<double>(samples.size()), mass, 0.005 * mass);
  EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end()));
}

TEST(ErrorDiffusion, FollowsAGradient)
{
  std::vector<float> wanted(Size * Size);
  for (int i = 0; i < Size * Size; ++i)
  {
    wanted[i] = static_cast<float>(0.001 + 0.2 * std::pow((i % Size) / 511., 2.));
  }
  std::vector<double> got(16, 0.);
  for (int i : halftone(wanted))
  {
    got[i % Size / 32] += 1;
  }
  for (int k = 0; k < 16; ++k)
  {
    double mass = 0;
    for (int x = 32 * k; x < 32 * k + 32; ++x)
    {
      mass += wanted[x] * static_cast<double>(Size);
    }
    EXPECT_NEAR(got[k], mass, 0.03 * mass + 0.8 * std::sqrt(mass)) << k;
  }
}

TEST(ErrorDiffusion, WhatIsNegativeIsForThoseBesideIt)
{
  // Every fourth column holds none of what it wants.
  constexpr double Level = 0.05;
  std::vector<float> wanted(Size * Size, static_cast<float>(Level));
  for (int i = 0; i < Size * Size; i += 4)
  {
    wanted[i] = -wanted[i];
  }
  const std::vector<int> samples = halftone(wanted);
  EXPECT_TRUE(std::none_of(samples.begin(), samples.end(), [](int i) { return i % 4 == 0; }));
  EXPECT_NEAR(fill(samples, Level, 0, Size), 1., 0.005) << "nothing is lost";
}

TEST(ErrorDiffusion, TinyImages)
{
  std::vector<int> samples = { 5 };
  diffuseErrors(nullptr, 0, 0, {}, samples);
  EXPECT_TRUE(samples.empty());
  const float one = 1.f;
  diffuseErrors(&one, 1, 1, {}, samples);
  EXPECT_EQ(samples, std::vector<int>{ 0 });
}
