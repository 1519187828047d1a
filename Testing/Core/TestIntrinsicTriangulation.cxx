// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Intrinsic Delaunay triangulations against what is known of the surface unrolled.
#include "HarmonicSystem.h"
#include "IntrinsicTriangulation.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

using namespace stipple;

namespace
{
/// Long slivers: n columns of very uneven heights, sheared, so that few edges are Delaunay; each
/// point (x, y) of the plane is placed in space.
CutSurface slivers(int n, double shear, const std::function<Vec3(double, double)>& place)
{
  TriangleSurface s;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double y = std::pow(static_cast<double>(j) / n, 3);
      s.points.push_back(place(static_cast<double>(i) / n + shear * y, 0.02 * y));
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i;
      const int b = a + n + 1;
      s.triangles.push_back({ a, a + 1, b + 1 });
      s.triangles.push_back({ a, b + 1, b });
    }
  }
  s.connect();
  return shapes::cutSurface(s);
}

ChartMesh whole(const CutSurface& s)
{
  std::vector<Face> faces;
  for (const Face f : s.faces())
  {
    faces.push_back(f);
  }
  return extractChart(s, faces);
}

/// No inner edge has a weight below zero, but for rounding.
void expectDelaunay(const IntrinsicTriangulation& t)
{
  std::map<std::pair<int, int>, std::vector<double>> opposite;
  for (const Halfedge h : t.halfedges())
  {
    if (!t.isBoundary(h))
    {
      opposite[std::minmax(t.tail(h), t.head(h))].push_back(t.cotangentOpposite(h));
    }
  }
  for (const auto& [edge, cotangents] : opposite)
  {
    double sum = 0;
    double size = 1;
    for (const double c : cotangents)
    {
      sum += c;
      size += std::abs(c);
    }
    EXPECT_GE(sum, -2e-9 * size) << edge.first << " " << edge.second;
  }
}

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
}

TEST(IntrinsicTriangulation, OfAPlaneIsThatOfItsPoints)
{
  const CutSurface s = slivers(12, 0.7, [](double x, double y) { return Vec3(x, y, 0); });
  const ChartMesh chart = whole(s);
  IntrinsicTriangulation t(s, chart);
  EXPECT_GT(t.flipToDelaunay(), 100) << "the shape is a poor one";
  expectDelaunay(t);
  for (const Halfedge h : t.halfedges())
  {
    // Convex or nearly: an edge is the straight line between its ends.
    const Vec3 edge = s.points[chart.vertices[t.head(h)]] - s.points[chart.vertices[t.tail(h)]];
    EXPECT_NEAR(t.length(h), edge.norm(), 1e-12);
  }
  EXPECT_EQ(t.flipToDelaunay(), 0) << "nothing is left to flip";
}

TEST(IntrinsicTriangulation, KnowsLengthsAlongABentSurface)
{
  // The same rolled up: lengths are those of the plane, not of space.
  const double radius = 0.003;
  const CutSurface s = slivers(12, 0.7, [=](double x, double y) {
    return Vec3(x, radius * std::cos(y / radius), radius * std::sin(y / radius));
  });
  const CutSurface flat = slivers(12, 0.7, [](double x, double y) { return Vec3(x, y, 0); });
  const ChartMesh chart = whole(flat);
  // Lengths along the roll: of the flat one, as both are the same but for chords.
  IntrinsicTriangulation rolled(s, whole(s));
  IntrinsicTriangulation plane(flat, chart);
  rolled.flipToDelaunay();
  plane.flipToDelaunay();
  expectDelaunay(rolled);
  double inSpace = 0;
  double along = 0;
  for (const Halfedge h : rolled.halfedges())
  {
    along += rolled.length(h);
    inSpace +=
      (s.points[chart.vertices[rolled.head(h)]] - s.points[chart.vertices[rolled.tail(h)]]).norm();
  }
  EXPECT_GT(along, inSpace + 1e-6) << "edges go around";
}

TEST(IntrinsicTriangulation, LeavesADelaunayOneAsItIs)
{
  const TriangleSurface ball = shapes::sphere(1, 3);
  const CutSurface s = shapes::cutSurface(ball);
  const ChartMesh chart = whole(s);
  IntrinsicTriangulation t(s, chart);
  EXPECT_EQ(t.flipToDelaunay(), 0);
  for (const Halfedge h : t.halfedges())
  {
    EXPECT_EQ(t.tail(h), chart.triangles[faceOf(h).index()][cornerOf(h)]);
  }
}

TEST(IntrinsicTriangulation, HarmonicFunctionsOnSliversAreLinearAndKeepTheMaximumPrinciple)
{
  const CutSurface s = slivers(12, 0.7, [](double x, double y) { return Vec3(x, y, 0); });
  const ChartMesh chart = whole(s);
  HarmonicSystem system(s, chart, chart.onBoundary);
  ASSERT_TRUE(system.factorizeDelaunay());
  Matrix values = Matrix::Zero(chart.numberOfVertices(), 2);
  Matrix wanted = values;
  for (int v = 0; v < chart.numberOfVertices(); ++v)
  {
    const Vec3& p = s.points[chart.vertices[v]];
    wanted.row(v) << p.x() + 30 * p.y(), p.x() > 1; // one linear, one that jumps
    if (chart.onBoundary[v])
    {
      values.row(v) = wanted.row(v);
    }
  }
  system.solve(values);
  EXPECT_LT((values.col(0) - wanted.col(0)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GE(values.col(1).minCoeff(), -1e-9);
  EXPECT_LE(values.col(1).maxCoeff(), 1 + 1e-9);
  // The chart's own triangles do not keep it: this shape can tell.
  ASSERT_TRUE(system.factorize());
  Matrix own = Matrix::Zero(chart.numberOfVertices(), 1);
  for (int v = 0; v < chart.numberOfVertices(); ++v)
  {
    own(v, 0) = chart.onBoundary[v] ? wanted(v, 1) : 0.;
  }
  system.solve(own);
  EXPECT_TRUE(own.minCoeff() < -1e-3 || own.maxCoeff() > 1 + 1e-3);
}
