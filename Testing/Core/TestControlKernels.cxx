// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Importance.h"
#include "NeighbourGrid.h"
#include "SampleBudget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace stipple;

TEST(Importance, CurvaturesOfKnownShapes)
{
  // A sphere of radius 2, a cylinder of radius 1, and a saddle.
  EXPECT_NEAR(minimumCurvature(0.5, 0.25), 0.5, 1e-12);
  EXPECT_NEAR(maximumCurvature(0.5, 0.25), 0.5, 1e-12);
  EXPECT_NEAR(minimumCurvature(0.5, 0.), 0., 1e-12);
  EXPECT_NEAR(maximumCurvature(0.5, 0.), 1., 1e-12);
  EXPECT_NEAR(totalCurvature(0.5, 0.), 1., 1e-12);
  EXPECT_NEAR(minimumCurvature(0., -1.), -1., 1e-12);
  EXPECT_NEAR(totalCurvature(0., -1.), 2., 1e-12);
  EXPECT_EQ(maximumCurvature(0.5, 0.3), 0.5) << "noise: H^2 < K";
  EXPECT_EQ(optimalL2Density(0., 0.), 0.);
  EXPECT_GT(optimalL2Density(0.5, 0.), 0.) << "a cylinder wants samples";
}

TEST(Importance, L2DensityIsTheMeanSquareErrorOfEquilateralTriangles)
{
  // The mean square of f - interpolant over the triangle, by brute force, is h^4 (9 H^2 - K) / 480.
  const double h = 0.3;
  for (const auto& [k1, k2] :
    { std::pair<double, double>{ 1., 1. }, { 1., 0. }, { 2., -1. }, { 0.3, -0.3 } })
  {
    for (double turn : { 0., 0.4, 1.1 })
    {
      const auto f = [&, k1 = k1, k2 = k2](const Vec2& p) {
        const Vec2 d(std::cos(turn), std::sin(turn));
        const double x = p.dot(d);
        const double y = cross2(d, p);
        return 0.5 * (k1 * x * x + k2 * y * y);
      };
      const Vec2 a(0, 0);
      const Vec2 b(h, 0);
      const Vec2 c(0.5 * h, 0.5 * std::sqrt(3.) * h);
      double sum = 0;
      int n = 0;
      const int m = 200;
      for (int i = 0; i < m; ++i)
      {
        for (int j = 0; j + i < m; ++j)
        {
          const double u = (i + 1. / 3) / m;
          const double v = (j + 1. / 3) / m;
          const Vec2 p = (1 - u - v) * a + u * b + v * c;
          const double e = f(p) - ((1 - u - v) * f(a) + u * f(b) + v * f(c));
          sum += e * e;
          ++n;
        }
      }
      const double H = 0.5 * (k1 + k2);
      const double expected = std::pow(h, 4) * std::pow(optimalL2Density(H, k1 * k2), 3) / 480.;
      EXPECT_NEAR(sum / n, expected, 0.01 * expected);
    }
  }
}

TEST(Importance, WeightedQuantile)
{
  std::mt19937 engine(5);
  std::vector<float> value(20000);
  std::vector<float> weight(20000);
  std::vector<std::pair<float, float>> sorted;
  double total = 0;
  for (std::size_t i = 0; i < value.size(); ++i)
  {
    value[i] = std::exp(static_cast<float>(engine() % 1000) / 70.f);
    weight[i] = 1.f + static_cast<float>(engine() % 50);
    total += weight[i];
    sorted.emplace_back(value[i], weight[i]);
  }
  std::sort(sorted.begin(), sorted.end());
  double below = 0;
  float exact = 0;
  for (const auto& [v, w] : sorted)
  {
    below += w;
    if (below >= 0.7 * total)
    {
      exact = v;
      break;
    }
  }
  const std::vector<WeightedValues> runs = { { value.data(), weight.data(), 9000, 2. },
    { value.data() + 9000, weight.data() + 9000, 11000, 2. } };
  EXPECT_NEAR(weightedQuantile(runs, 0.7), exact, 0.02 * exact);
  value.assign(value.size(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(weightedQuantile(runs, 0.995), 0.);
}

TEST(Importance, UnitFunctionTable)
{
  for (double gamma : { 0.25, 0.5, 1., 2., 5. })
  {
    const UnitFunctionTable table([=](double x) { return std::pow(x, gamma); });
    EXPECT_EQ(table(0.f), 0.f);
    EXPECT_EQ(table(1.f), 1.f);
    EXPECT_EQ(table(7.f), 1.f);
    EXPECT_EQ(table(-1.f), 0.f);
    EXPECT_EQ(table(std::numeric_limits<float>::quiet_NaN()), 0.f);
    for (double x = 1e-6; x < 1; x *= 1.37)
    {
      const double exact = std::pow(static_cast<float>(x), gamma);
      EXPECT_NEAR(table(static_cast<float>(x)), exact, 3e-5 * exact + 1e-12) << x << "^" << gamma;
    }
  }
}

TEST(SampleBudget, ApportionIsExactProportionalAndKeepsTheLeast)
{
  std::mt19937 engine(11);
  for (int draw = 0; draw < 2000; ++draw)
  {
    const std::size_t n = 1 + engine() % 9;
    std::vector<double> share(n);
    std::vector<int> least(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      share[i] = engine() % 4 == 0 ? 0. : static_cast<double>(engine() % 1000) / 7.;
      least[i] = static_cast<int>(engine() % 5 == 0);
    }
    const int leastSum = std::accumulate(least.begin(), least.end(), 0);
    const int total = leastSum + static_cast<int>(engine() % 500);
    const std::vector<int> got = apportion(total, share, least);
    ASSERT_EQ(std::accumulate(got.begin(), got.end(), 0), total);
    const double sum = std::accumulate(share.begin(), share.end(), 0.);
    for (std::size_t i = 0; i < n; ++i)
    {
      ASSERT_GE(got[i], least[i]);
      if (sum > 0)
      {
        ASSERT_NEAR(got[i], share[i] / sum * total, 1. + leastSum);
        ASSERT_TRUE(share[i] > 0 || got[i] == least[i]);
      }
    }
  }
  EXPECT_EQ(apportion(10, { 1, 1, 2 }, { 0, 0, 0 }), (std::vector<int>{ 3, 2, 5 }));
}

TEST(SampleBudget, LargestScaleIsTheLargest)
{
  const auto stairs = [](double s) { return 5. + std::floor(1000. * s); };
  const double s = largestScale(stairs, 42.5, 100.);
  EXPECT_LE(stairs(s), 42.5);
  EXPECT_GT(stairs(s * 1.0001), 42.5);
  EXPECT_EQ(largestScale(stairs, 4., 100.), 0.);
  EXPECT_EQ(largestScale(stairs, 1e9, 100.), 100.);
}

TEST(NeighbourGrid, AgreesWithBruteForce)
{
  std::mt19937 engine(4);
  const auto random = [&] { return engine() / 4294967296.; };
  const Vec2 extent(1., 0.3);
  NeighbourGrid grid(extent, 300);
  std::vector<Vec2> points;
  std::vector<char> gone;
  for (int i = 0; i < 300; ++i)
  {
    points.emplace_back(std::pow(random(), 3), 0.3 * random());
    gone.push_back(0);
    ASSERT_EQ(grid.insert(points.back()), i);
  }
  for (int round = 0; round < 2; ++round)
  {
    for (int i = 0; i < 300; ++i)
    {
      const Vec2 p = i % 2 ? points[i] : Vec2(random(), 0.3 * random());
      double best = std::numeric_limits<double>::max();
      for (int j = 0; j < 300; ++j)
      {
        if (!gone[j] && (i % 2 == 0 || j != i))
        {
          best = std::min(best, (points[j] - p).squaredNorm());
        }
      }
      ASSERT_DOUBLE_EQ(grid.nearest(p, i % 2 ? i : -1), best);
    }
    for (int i = 0; i < 300; i += 3)
    {
      grid.remove(i);
      gone[i] = 1;
    }
  }
}
