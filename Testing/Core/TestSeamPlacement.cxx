// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Seams between charts: balanced areas, smooth lines, and the surface kept.
#include "ChartPartition.h"
#include "FeatureGraphBuilder.h"
#include "SeamTurns.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace stipple;

namespace
{
struct Partition
{
  CutSurface surface;
  std::vector<FlatChart> charts;
};

Partition partition(const TriangleSurface& shape, int numberOfCharts, BoundaryPlacement placement)
{
  Partition result = { shapes::cutSurface(shape), {} };
  ChartPartitionOptions options;
  options.numberOfCharts = numberOfCharts;
  options.maximumDensityRatio = 1e9;
  options.placement = placement;
  EXPECT_TRUE(partitionSurface(result.surface, options, result.charts, {}).ok());
  EXPECT_EQ(static_cast<int>(result.charts.size()), numberOfCharts);
  EXPECT_NEAR(result.surface.area(), shape.area(), 1e-9 * shape.area());
  EXPECT_TRUE(result.surface.topology() == shape.topology());
  for (const FlatChart& c : result.charts)
  {
    EXPECT_TRUE(c.mesh.isDisk());
  }
  return result;
}

/// Largest over smallest area of the charts.
double areaRatio(const Partition& partition)
{
  double least = 1e300;
  double most = 0;
  for (const FlatChart& c : partition.charts)
  {
    double area = 0;
    for (int f : c.mesh.faces)
    {
      area += partition.surface.faceArea(f);
    }
    least = std::min(least, area);
    most = std::max(most, area);
  }
  return most / least;
}

double meanTurn(const Partition& partition, double step)
{
  return test::meanTurnOfSeams(
    buildFeatureGraph(partition.surface, 180), partition.surface.points, step);
}

double meanEdge(const TriangleSurface& surface)
{
  double sum = 0;
  for (std::size_t h = 0; h < surface.twin.size(); ++h)
  {
    const int i = static_cast<int>(h);
    sum += (surface.points[surface.head(i)] - surface.points[surface.tail(i)]).norm();
  }
  return sum / static_cast<double>(surface.twin.size());
}
}

class Seams : public testing::TestWithParam<int>
{
};

TEST_P(Seams, AreStraightAndHalveTheArea)
{
  const TriangleSurface sphere = shapes::sphere(1, 4);
  const Partition smooth = partition(sphere, GetParam(), BoundaryPlacement::AreaMedian);
  const Partition raw = partition(sphere, GetParam(), BoundaryPlacement::Voronoi);
  EXPECT_LT(areaRatio(smooth), 1.2);
  const double step = meanEdge(sphere);
  EXPECT_LT(meanTurn(smooth, step), meanTurn(raw, step) / 3);
}

INSTANTIATE_TEST_SUITE_P(Charts, Seams, testing::Values(2, 3, 6, 12));

TEST(Seams, TheMiddleSlipsAwayFromAHornAndTheAreaMedianDoesNot)
{
  const TriangleSurface horned = shapes::hornedSphere(5);
  EXPECT_GT(areaRatio(partition(horned, 2, BoundaryPlacement::Middle)), 1.5);
  EXPECT_LT(areaRatio(partition(horned, 2, BoundaryPlacement::AreaMedian)), 1.05);
}

TEST(Seams, KeepTheirShareOfTheArea)
{
  CutSurface s = shapes::cutSurface(shapes::sphere(1, 4));
  const double level = 0.3;
  for (int h = 0; h < 3 * s.numberOfFaces(); ++h)
  {
    const auto above = [&](int f) {
      return s.point(f, 0).z() + s.point(f, 1).z() + s.point(f, 2).z() > 3 * level;
    };
    if (above(h / 3) != above(s.twin[h] / 3))
    {
      s.setCut(h, true);
    }
  }
  ChartRegions regions(s);
  ASSERT_EQ(regions.size(), 2);
  const double before = regions.area(0);
  smoothSeams(regions, 0, 1, BoundaryPlacement::AreaMedian);
  EXPECT_NEAR(regions.area(0), before, 1e-3 * before);
  const std::vector<SeamArc> arcs = regions.arcs(0, 1);
  ASSERT_EQ(arcs.size(), 1U);
  EXPECT_TRUE(arcs.front().closed);
  for (int h : arcs.front().halfedges)
  {
    EXPECT_NEAR(s.points[s.tail(h)].z(), level, 0.05) << "a circle of latitude";
  }
}

TEST(Seams, FewTrianglesAreLeftAlone)
{
  CutSurface s = shapes::cutSurface(shapes::cube(3));
  for (int h = 0; h < 3 * s.numberOfFaces(); ++h)
  {
    if ((h / 3 < s.numberOfFaces() / 2) != (s.twin[h] / 3 < s.numberOfFaces() / 2))
    {
      s.setCut(h, true);
    }
  }
  ChartRegions regions(s);
  ASSERT_EQ(regions.size(), 2);
  const int before = s.numberOfFaces();
  smoothSeams(regions, 0, 1, BoundaryPlacement::AreaMedian);
  EXPECT_EQ(s.numberOfFaces(), before);
}

TEST(Seams, PlacingCanBeStopped)
{
  CutSurface s = shapes::cutSurface(shapes::sphere(1, 3));
  ChartRegions regions(s);
  EXPECT_TRUE(
    placeSeams(regions, BoundaryPlacement::AreaMedian, [](double) { return false; }).isAbort());
}

TEST(Partition, OfHighGenusHasFewCharts)
{
  const TriangleSurface slab = shapes::perforatedSlab(5, 4, 6);
  ASSERT_EQ(slab.topology().euler, 2 - 2 * 20);
  CutSurface s = shapes::cutSurface(slab);
  std::vector<FlatChart> charts;
  ChartPartitionOptions options;
  ASSERT_TRUE(partitionSurface(s, options, charts, {}).ok());
  EXPECT_TRUE(s.topology() == slab.topology());
  EXPECT_NEAR(s.area(), slab.area(), 1e-9 * slab.area());
  EXPECT_LE(charts.size(), 60U);
  for (const FlatChart& c : charts)
  {
    EXPECT_TRUE(c.mesh.isDisk());
    EXPECT_TRUE(c.map.valid);
    EXPECT_LE(c.map.densityRatio, options.maximumDensityRatio);
  }
}
