// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapSizing.h"

#include <gtest/gtest.h>

namespace
{
using stipple::MapChart;

TEST(MapSizing, PixelsFollowSamplesAndDensity)
{
  stipple::MapDemand demand;
  demand.extent = { 1., 0.5 };
  demand.area = 10.;
  demand.densityRatio = 10.;
  for (const double samples : { 100., 1000., 12345., 50000. })
  {
    const auto size = stipple::automaticMapSize(demand, samples);
    const double pixels = static_cast<double>(size[0]) * size[1];
    EXPECT_GE(pixels, 0.98 * 2. * samples * 10.) << samples;
    EXPECT_LE(pixels, 2.1 * 2. * samples * 10.) << samples;
    EXPECT_NEAR(size[0], 2. * size[1], 1.);
  }
  EXPECT_EQ(stipple::automaticMapSize(demand, 5000.), stipple::automaticMapSize(demand, 5200.));
  EXPECT_EQ(stipple::automaticMapSize(demand, 0.), (std::array<int, 2>{ 32, 32 }));
  EXPECT_EQ(stipple::automaticMapSize(demand, 1e9), (std::array<int, 2>{ 4096, 2048 }));
  EXPECT_EQ(stipple::fixedMapSize({ 0.25, 1. }, 400), (std::array<int, 2>{ 100, 400 }));
  EXPECT_EQ(stipple::fixedMapSize({ 1., 1e-6 }, 400), (std::array<int, 2>{ 400, 2 }));
}

TEST(MapSizing, AFewSamplesNeedFewPixelsHoweverDenseAMap)
{
  // A fifth of the surface in a millionth of the map.
  MapChart chart;
  chart.uv = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 1e-3, 1e-3 }, { 2e-3, 1e-3 },
    { 1e-3, 2e-3 } };
  chart.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 } };
  chart.area = { 1.f, 1.f, 0.5f };
  const stipple::MapDemand demand = stipple::demandOf(chart);
  EXPECT_GT(demand.densityRatio, 1e5);
  EXPECT_EQ(demand.ratioFor(1000.), demand.densityRatio);
  EXPECT_EQ(demand.ratioFor(1.), demand.densityRatio) << "a fifth of a sample is missed";
  EXPECT_LT(demand.ratioFor(0.1), 2.) << "a fiftieth is not";
  EXPECT_EQ(stipple::automaticMapSize(demand, 0.1), (std::array<int, 2>{ 32, 32 }));
}

TEST(MapSizing, PixelsOfLongRectanglesAreSquare)
{
  stipple::MapDemand demand;
  demand.area = 1.;
  for (const double ratio : { 0.1, 0.01, 0.001 })
  {
    demand.extent = { ratio, 1. };
    const auto size = stipple::automaticMapSize(demand, 20000.);
    EXPECT_GE(static_cast<double>(size[0]) * size[1], 0.4 * 40000.);
    EXPECT_NEAR(size[0] / (ratio * size[1]), 1., 0.15) << ratio;
  }
  demand.extent = { 1., 1e-6 };
  EXPECT_EQ(stipple::automaticMapSize(demand, 20000.), (std::array<int, 2>{ 4096, 4 }));
}

TEST(MapSizing, TheDensityRatioForgetsTheDensestThousandth)
{
  // Four equal triangles of the square, three of them of area 1 in space, the last one of area a.
  MapChart chart;
  chart.uv = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0.5, 0.5 } };
  chart.triangles = { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
  chart.area = { 1.f, 1.f, 1.f, 5.f };
  EXPECT_NEAR(stipple::densityRatio(chart), 5. / 2., 1e-6); // mean density 8 / 4 quarters
  // A tiny but very dense triangle of less than a thousandth of the surface does not count.
  chart.uv.push_back({ 0.5, 0.4999 });
  chart.triangles.push_back({ 4, 5, 4 });
  chart.triangles.back() = { 0, 5, 4 };
  chart.area = { 1.f, 1.f, 1.f, 1.f, 0.003f };
  const double plane = 0.5 * stipple::orient2(chart.uv[0], chart.uv[5], chart.uv[4]);
  ASSERT_GT(0.003 / plane, 50.) << "it is dense";
  EXPECT_LT(stipple::densityRatio(chart), 1.1);
  chart.area.back() = 0.006f;
  EXPECT_GT(stipple::densityRatio(chart), 50.);
}
} // namespace

using namespace stipple;

TEST(MapSizing, AllMapsTogetherAreBounded)
{
  // As of a wire that was cut into thousands of charts, infinitely dense at their corners.
  std::vector<MapDemand> demands(3000);
  for (std::size_t i = 0; i < demands.size(); ++i)
  {
    demands[i].area = 1. + static_cast<double>(i % 7);
    demands[i].densityRatio = i % 2 == 0 ? 1e15 : 3.;
  }
  const auto sizes = automaticMapSizes(demands, 1000);
  double pixels = 0;
  for (const std::array<int, 2>& size : sizes)
  {
    pixels += static_cast<double>(size[0]) * size[1];
  }
  EXPECT_LE(pixels, MostPixels);
  EXPECT_GE(pixels, 0.1 * MostPixels); // no less than it must be
  // Charts that are not that dense are as large as ever.
  const std::vector<MapDemand> few(demands.begin(), demands.begin() + 2);
  const auto alone = automaticMapSizes(few, 1000);
  for (std::size_t i = 0; i < few.size(); ++i)
  {
    EXPECT_EQ(alone[i], automaticMapSize(few[i], 1000 * few[i].area / 3.));
  }
}
