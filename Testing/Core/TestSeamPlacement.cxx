// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Seams between charts: balanced areas, smooth lines, and the surface kept.
#include "ChartPartition.h"
#include "FeatureGraphBuilder.h"
#include "SeamPlacement.h"
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
    for (const Face f : c.mesh.faces)
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

namespace
{
/// The rectangle of width 2 and height 1 as two regions, whose seam zigzags about a line of its
/// length: 2 n x n squares, each cut in two.
struct Halves
{
  CutSurface surface;
  explicit Halves(int n, double line)
  {
    TriangleSurface s;
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= 2 * n; ++i)
      {
        s.points.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n, 0);
      }
    }
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < 2 * n; ++i)
      {
        const int a = j * (2 * n + 1) + i;
        const int b = a + 2 * n + 1;
        s.triangles.push_back({ a, a + 1, b + 1 });
        s.triangles.push_back({ a, b + 1, b });
      }
    }
    s.connect();
    this->surface = shapes::cutSurface(s);
    const auto isLeft = [&](Face face) {
      const int square = face.index() / 2;
      return square % (2 * n) < line * n + square / (2 * n) % 2;
    };
    for (const Halfedge h : this->surface.halfedges())
    {
      const Halfedge g = this->surface.twin[h];
      if (g.valid() && isLeft(faceOf(h)) != isLeft(faceOf(g)))
      {
        this->surface.setCut(h, true);
      }
    }
  }
};

/// Smallest and largest x, and the length.
std::array<double, 3> extentOf(const CutSurface& s, const SeamArc& arc)
{
  std::array<double, 3> result = { { 1e300, -1e300, 0 } };
  for (const Halfedge h : arc.halfedges)
  {
    for (const Vertex p : { s.tail(h), s.head(h) })
    {
      result[0] = std::min(result[0], s.point(p).x());
      result[1] = std::max(result[1], s.point(p).x());
    }
    result[2] += s.edgeLength(h);
  }
  return result;
}
}

TEST(PlaceSeam, GivesTheFirstRegionItsShareBehindAStraightLine)
{
  for (const double share : { 0.36, 0.5, 0.61 })
  {
    Halves halves(20, 0.8);
    ChartRegions regions(halves.surface);
    ASSERT_EQ(regions.size(), 2);
    std::vector<SeamArc> arcs = regions.arcs(0, 1);
    ASSERT_EQ(arcs.size(), 1U);
    EXPECT_NEAR(extentOf(halves.surface, arcs[0])[2], 1 + 19 * 0.05, 1e-12) << "it zigzags";
    ASSERT_TRUE(placeSeam(regions, 0, 1, arcs[0], { share, true }));
    EXPECT_NEAR(regions.area(0), 2 * share, 0.002);
    EXPECT_NEAR(regions.area(0) + regions.area(1), 2., 1e-12);
    EXPECT_TRUE(regions.mesh(0).isDisk() && regions.mesh(1).isDisk());
    arcs = regions.arcs(0, 1);
    ASSERT_EQ(arcs.size(), 1U);
    const auto [low, high, length] = extentOf(halves.surface, arcs[0]);
    EXPECT_NEAR(low, 2 * share, 0.05) << share;
    EXPECT_NEAR(high, 2 * share, 0.05) << share;
    EXPECT_NEAR(length, 1., 0.01);
  }
}

TEST(PlaceSeam, GoesAlongEdgesWhereItMayNotCut)
{
  Halves halves(20, 0.6);
  ChartRegions regions(halves.surface);
  const int faces = halves.surface.numberOfFaces();
  ASSERT_TRUE(placeSeam(regions, 0, 1, regions.arcs(0, 1).front(), { 0.4375, false }));
  EXPECT_EQ(halves.surface.numberOfFaces(), faces);
  EXPECT_NEAR(regions.area(0), 0.875, 0.05) << "a column of triangles has 0.05";
}

TEST(PlaceSeam, IsHalfwayWithoutAShare)
{
  // Far sides lie at the ends whatever the seam is, so that halfway is the middle.
  Halves halves(20, 1.3);
  ChartRegions regions(halves.surface);
  ASSERT_TRUE(placeSeam(regions, 0, 1, regions.arcs(0, 1).front(), { std::nullopt, true }));
  const auto [low, high, length] = extentOf(halves.surface, regions.arcs(0, 1).front());
  EXPECT_NEAR(low, 1., 0.08);
  EXPECT_NEAR(high, 1., 0.08);
  EXPECT_LT(length, 1.02);
}

TEST(PlaceSeam, LeavesTheSeamWhereItCannotBePlaced)
{
  const auto expectRefused = [](CutSurface& surface) {
    ChartRegions regions(surface);
    ASSERT_EQ(regions.size(), 2);
    const auto cut = surface.cut;
    std::array<std::vector<Face>, 2> faces = { { regions.faces(0), regions.faces(1) } };
    EXPECT_FALSE(placeSeam(regions, 0, 1, regions.arcs(0, 1).front(), {}));
    EXPECT_TRUE(surface.cut == cut);
    for (const int r : { 0, 1 })
    {
      std::vector<Face> now = regions.faces(r);
      std::sort(now.begin(), now.end());
      std::sort(faces[r].begin(), faces[r].end());
      EXPECT_EQ(now, faces[r]);
    }
  };
  Halves few(11, 0.8); // 484 triangles
  expectRefused(few.surface);
  // A disk within an annulus: what would be mapped is a disk that ends at no seam.
  Halves hole(20, 5);
  for (const Halfedge h : hole.surface.halfedges())
  {
    const auto inside = [&](Face f) {
      return (hole.surface.position(f, Vec3::Constant(1. / 3)) - Vec3(1, 0.5, 0))
               .lpNorm<Eigen::Infinity>() < 0.3;
    };
    if (!hole.surface.isBoundary(h) && inside(faceOf(h)) != inside(faceOf(hole.surface.twin[h])))
    {
      hole.surface.setCut(h, true);
    }
  }
  expectRefused(hole.surface);
}

TEST(PlaceSeams, VoronoiSeamsStay)
{
  Halves halves(20, 0.6);
  ChartRegions regions(halves.surface);
  const auto cut = halves.surface.cut;
  EXPECT_TRUE(placeSeams(regions, BoundaryPlacement::Voronoi, {}).ok());
  smoothSeams(regions, 0, 1, BoundaryPlacement::Voronoi);
  EXPECT_TRUE(halves.surface.cut == cut);
  EXPECT_TRUE(placeSeams(regions, BoundaryPlacement::AreaMedian, {}).ok());
  EXPECT_FALSE(halves.surface.cut == cut);
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
  for (const Halfedge h : s.halfedges())
  {
    const auto above = [&](Face f) {
      return s.point(f, 0).z() + s.point(f, 1).z() + s.point(f, 2).z() > 3 * level;
    };
    if (above(faceOf(h)) != above(faceOf(s.twin[h])))
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
  for (const Halfedge h : arcs.front().halfedges)
  {
    EXPECT_NEAR(s.point(s.tail(h)).z(), level, 0.05) << "a circle of latitude";
  }
}

TEST(Seams, FewTrianglesAreLeftAlone)
{
  CutSurface s = shapes::cutSurface(shapes::cube(3));
  const auto isFirstHalf = [&](Halfedge h) { return faceOf(h) < Face(s.numberOfFaces() / 2); };
  for (const Halfedge h : s.halfedges())
  {
    if (isFirstHalf(h) != isFirstHalf(s.twin[h]))
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
