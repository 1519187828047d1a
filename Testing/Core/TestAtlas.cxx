// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Kernels of Filters/Atlas: curvature, features, charts, maps.
#include "ChartPartition.h"
#include "Curvature.h"
#include "FeatureDetection.h"
#include "FeatureGraphBuilder.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

using namespace stipple;

namespace
{
double totalCurvature(const Curvature& c)
{
  return std::inner_product(c.gaussian.begin(), c.gaussian.end(), c.mixedArea.begin(), 0.);
}

int count(const FeatureGraph& graph, BackboneType type)
{
  return static_cast<int>(std::count_if(graph.backbones.begin(), graph.backbones.end(),
    [&](const Backbone& b) { return b.type == type; }));
}

int corners(const FeatureGraph& graph)
{
  return static_cast<int>(std::count(graph.isCorner.begin(), graph.isCorner.end(), 1));
}
}

TEST(Curvature, SphereIsTheInverseRadius)
{
  const double r = 2.5;
  const Curvature c = computeCurvature(shapes::sphere(r, 5));
  for (std::size_t p = 0; p < c.mean.size(); ++p)
  {
    ASSERT_NEAR(c.gaussian[p] * r * r, 1., 0.02);
    ASSERT_NEAR(c.mean[p] * r, 1., 0.02);
  }
}

TEST(Curvature, TorusHasBothSigns)
{
  const double ring = 3;
  const double cross = 1;
  const int nu = 240;
  const int nv = 80;
  const Curvature c = computeCurvature(shapes::torus(ring, cross, nu, nv));
  for (int j = 0; j < nv; ++j)
  {
    const double v = 2 * Pi * j / nv;
    const double r = ring + cross * std::cos(v);
    ASSERT_NEAR(c.gaussian[j * nu], std::cos(v) / (cross * r), 0.02 * 0.5);
    ASSERT_NEAR(c.mean[j * nu], 0.5 * (1 / cross + std::cos(v) / r), 0.02);
  }
}

TEST(Curvature, PlaneHasNone)
{
  TriangleSurface plane = shapes::saddle(9);
  for (Vec3& p : plane.points)
  {
    p.z() = 0;
  }
  const Curvature c = computeCurvature(plane);
  for (std::size_t p = 0; p < c.mean.size(); ++p)
  {
    const bool inside = plane.points[p].head<2>().cwiseAbs().maxCoeff() < 1 - 1e-9;
    ASSERT_NEAR(c.mean[p], 0., 1e-9);
    ASSERT_NEAR(inside ? c.gaussian[p] : 0., 0., 1e-9);
  }
}

TEST(Curvature, GaussBonnet)
{
  EXPECT_NEAR(totalCurvature(computeCurvature(shapes::sphere(3, 3))), 4 * Pi, 1e-9);
  EXPECT_NEAR(totalCurvature(computeCurvature(shapes::torus(3, 1, 31, 17))), 0., 1e-9);
  EXPECT_NEAR(totalCurvature(computeCurvature(shapes::saddle(13))), 2 * Pi, 1e-9);
  const TriangleSurface cube = shapes::cube(4);
  const Curvature c = computeCurvature(cube);
  EXPECT_NEAR(totalCurvature(c), 4 * Pi, 1e-9);
  EXPECT_NEAR(std::accumulate(c.mixedArea.begin(), c.mixedArea.end(), 0.), cube.area(), 1e-12);
}

TEST(Curvature, SliverStaysFinite)
{
  TriangleSurface s = shapes::saddle(4);
  s.points[12] = s.points[11] + 1e-15 * Vec3(1, 1, 0);
  const Curvature c = computeCurvature(s);
  for (std::size_t p = 0; p < c.mean.size(); ++p)
  {
    ASSERT_TRUE(std::isfinite(c.mean[p]) && std::isfinite(c.gaussian[p])) << p;
  }
}

TEST(Curvature, StopsWhenAsked)
{
  const TriangleSurface sphere = shapes::sphere(1, 5); // 20,480 triangles
  int asked = 0;
  const Curvature c = computeCurvature(sphere, [&asked] { return ++asked == 3; });
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(c.gaussian.size(), sphere.points.size());
  computeCurvature(sphere, [&asked] {
    ++asked;
    return false;
  });
  EXPECT_EQ(asked, 3 + 5) << "once in 4,096 triangles";
}

TEST(FeatureGraph, CubeHasTwelveEdgesAndEightCorners)
{
  CutSurface s = shapes::cutSurface(shapes::cube(5));
  detectFeatures(s, {});
  const FeatureGraph graph = buildFeatureGraph(s, 60);
  EXPECT_EQ(graph.backbones.size(), 12u);
  EXPECT_EQ(count(graph, BackboneType::Sharp), 12);
  EXPECT_EQ(corners(graph), 8);
  for (const Backbone& b : graph.backbones)
  {
    EXPECT_FALSE(b.closed);
    EXPECT_EQ(b.numberOfSegments(), 5);
  }
}

TEST(FeatureGraph, CylinderHasTwoClosedLoopsAndNoCorner)
{
  CutSurface s = shapes::cutSurface(shapes::cylinder(1, 2, 40, 10));
  detectFeatures(s, {});
  const FeatureGraph graph = buildFeatureGraph(s, 60);
  ASSERT_EQ(graph.backbones.size(), 2u);
  EXPECT_EQ(corners(graph), 0);
  for (const Backbone& b : graph.backbones)
  {
    EXPECT_TRUE(b.closed);
    EXPECT_EQ(b.numberOfSegments(), 40);
  }
}

TEST(FeatureGraph, ConeHasOneTipAndOneClosedLoop)
{
  CutSurface s = shapes::cutSurface(shapes::cone(1, 2, 48, 12));
  detectFeatures(s, {});
  const FeatureGraph graph = buildFeatureGraph(s, 60);
  ASSERT_EQ(graph.backbones.size(), 1U);
  EXPECT_TRUE(graph.backbones[0].closed);
  EXPECT_EQ(corners(graph), 0);
  const std::vector<int> tips = findTips(s, {});
  ASSERT_EQ(tips.size(), 1U);
  EXPECT_EQ(s.points[tips[0]], Vec3(0, 0, 2));
  FeatureDetectionOptions none;
  none.angle = 180;
  EXPECT_TRUE(findTips(s, none).empty());
}

TEST(FeatureGraph, SmoothSurfacesHaveNoTips)
{
  EXPECT_TRUE(findTips(shapes::cutSurface(shapes::sphere(1, 3)), {}).empty());
  EXPECT_TRUE(findTips(shapes::cutSurface(shapes::torus(3, 1, 60, 20)), {}).empty());
}

TEST(FeatureGraph, SaddleHasOneBoundaryWithFourCorners)
{
  CutSurface s = shapes::cutSurface(shapes::saddle(10));
  detectFeatures(s, {});
  const FeatureGraph graph = buildFeatureGraph(s, 60);
  EXPECT_EQ(count(graph, BackboneType::Boundary), 4);
  EXPECT_EQ(count(graph, BackboneType::Sharp), 0);
  EXPECT_EQ(corners(graph), 4);
}

TEST(FeatureGraph, AngleOf180FindsNothing)
{
  CutSurface s = shapes::cutSurface(shapes::cube(3));
  FeatureDetectionOptions options;
  options.angle = 180;
  detectFeatures(s, options);
  EXPECT_TRUE(buildFeatureGraph(s, 60).backbones.empty());
}

TEST(CutSurface, SplitEdgeKeepsTheSurface)
{
  CutSurface s = shapes::cutSurface(shapes::cube(2));
  const double area = s.area();
  detectFeatures(s, {});
  const auto before = std::count(s.sharp.begin(), s.sharp.end(), 1);
  int sharpSplits = 0;
  for (int h = 0; h < 60; h += 7)
  {
    sharpSplits += s.sharp[h];
    s.splitEdge(Halfedge(h), 0.25);
  }
  EXPECT_NEAR(s.area(), area, 1e-12);
  EXPECT_EQ(s.twin, halfedgeTwins(s.triangles));
  EXPECT_EQ(std::count(s.sharp.begin(), s.sharp.end(), 1), before + 2 * sharpSplits);
  EXPECT_TRUE(s.topology().manifold);
  EXPECT_EQ(s.topology().euler, 2);
}

TEST(ChartRegions, NoChordRemains)
{
  CutSurface s = shapes::cutSurface(shapes::saddle(6));
  ChartRegions regions(s);
  const std::size_t before = regions.faces(0).size();
  regions.splitChords(0);
  EXPECT_GT(regions.faces(0).size(), before) << "two corners of a grid are cut off by chords";
  const ChartMesh chart = regions.mesh(0);
  EXPECT_TRUE(chart.isDisk());
  for (std::size_t i = 0; i < chart.faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const bool chord = !s.cut[halfedgeOf(chart.faces[i], k)] &&
        chart.onBoundary[chart.triangles[i][k]] &&
        chart.onBoundary[chart.triangles[i][(k + 1) % 3]];
      ASSERT_FALSE(chord);
    }
  }
}

class Partition : public testing::TestWithParam<shapes::Named>
{
};

TEST_P(Partition, GivesFlatDisksOfBoundedDensity)
{
  const TriangleSurface& shape = GetParam().surface;
  for (int least : { 1, 5 })
  {
    CutSurface s = shapes::cutSurface(shape);
    ChartPartitionOptions options;
    options.numberOfCharts = least;
    options.maximumDensityRatio = 20;
    std::vector<FlatChart> charts;
    ASSERT_TRUE(partitionSurface(s, options, charts, {}).ok());
    EXPECT_GE(static_cast<int>(charts.size()), least);
    EXPECT_NEAR(s.area(), shape.area(), 1e-9 * shape.area());
    EXPECT_TRUE(s.topology() == shape.topology());
    std::set<Face> seen;
    for (const FlatChart& c : charts)
    {
      EXPECT_TRUE(c.mesh.isDisk());
      EXPECT_TRUE(c.map.valid);
      EXPECT_LE(c.map.densityRatio, 20);
      EXPECT_DOUBLE_EQ(c.map.extent.maxCoeff(), 1.);
      seen.insert(c.mesh.faces.begin(), c.mesh.faces.end());
      double plane = 0;
      for (const Triangle& t : c.mesh.triangles)
      {
        const double a = orient2(c.map.uv[t[0]], c.map.uv[t[1]], c.map.uv[t[2]]);
        ASSERT_GT(a, 0.);
        plane += 0.5 * a;
      }
      EXPECT_NEAR(plane, c.map.extent.prod(), 1e-9) << "the chart fills its rectangle";
      for (int v : c.mesh.boundary)
      {
        const Vec2& p = c.map.uv[v];
        EXPECT_TRUE(
          p.x() == 0 || p.y() == 0 || p.x() == c.map.extent.x() || p.y() == c.map.extent.y());
      }
    }
    EXPECT_EQ(static_cast<int>(seen.size()), s.numberOfFaces())
      << "every triangle lies in one chart";
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Partition,
  testing::Values(shapes::Named{ "sphere", shapes::sphere(1, 3) },
    shapes::Named{ "torus", shapes::torus(3, 1, 60, 20) }, shapes::Named{ "cube", shapes::cube(8) },
    shapes::Named{ "tube", shapes::cylinder(1, 20, 24, 120) },
    shapes::Named{ "saddle", shapes::saddle(12) },
    shapes::Named{ "icosahedron", shapes::sphere(1, 0) }),
  [](const auto& info) { return info.param.name; });

TEST(Partition, CanBeStopped)
{
  CutSurface s = shapes::cutSurface(shapes::sphere(1, 3));
  std::vector<FlatChart> charts;
  EXPECT_TRUE(partitionSurface(s, {}, charts, [](double) { return false; }).isAbort());
}
