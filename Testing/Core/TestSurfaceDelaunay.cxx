// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Lengths of straight lines of the parameter plane on the surface, and swaps by them.
#include "SurfaceDelaunay.h"

#include "ConstrainedDelaunay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <set>

using namespace stipple;

namespace
{
/// One chart, [0, width] x [0, 1], of 2 n^2 triangles; onSurface(uv) says where they are in space.
AtlasSurface makeChart(int n, double width, const std::function<Vec3(const Vec2&)>& onSurface)
{
  AtlasSurface s;
  std::vector<Vec2> uv;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      uv.emplace_back(width * i / n, static_cast<double>(j) / n);
      s.points.push_back(onSurface(uv.back()));
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i;
      s.triangles.push_back({ a, a + 1, a + n + 2 });
      s.triangles.push_back({ a, a + n + 2, a + n + 1 });
    }
  }
  for (const Triangle& t : s.triangles)
  {
    s.faceChart.push_back(Chart(0));
    s.chartPoints.push_back(t);
    for (const int v : t)
    {
      s.uv.push_back(uv[v]);
    }
  }
  s.extent.push_back(Vec2(width, 1.));
  s.chartBegin = { 0, static_cast<int>(s.triangles.size()) };
  s.connect();
  return s;
}

/// Random places inside the chart, and some along its sides; the segments are the sides.
struct Places
{
  std::vector<Vec2> points;
  std::vector<std::array<int, 2>> segments;

  Places(double width, int perSide, int inside)
  {
    const std::array<Vec2, 4> corner = { { { 0, 0 }, { width, 0 }, { width, 1 }, { 0, 1 } } };
    for (int side = 0; side < 4; ++side)
    {
      for (int i = 0; i < perSide; ++i)
      {
        const double t = static_cast<double>(i) / perSide;
        this->points.push_back(corner[side] + t * (corner[(side + 1) % 4] - corner[side]));
      }
    }
    const int n = static_cast<int>(this->points.size());
    for (int i = 0; i < n; ++i)
    {
      this->segments.push_back({ { i, (i + 1) % n } });
    }
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.02, 0.98);
    for (int i = 0; i < inside; ++i)
    {
      const double u = unit(random);
      this->points.emplace_back(width * u, unit(random));
    }
  }
};

TriangleComplex triangulate(const Places& places)
{
  TriangleComplex complex;
  EXPECT_EQ(constrainedDelaunay(places.points, places.segments, complex.triangles).kind,
    DelaunayConflict::Kind::None);
  complex.twin = halfedgeTwins(complex.triangles);
  complex.label.assign(complex.twin.size(), Label());
  return complex;
}

std::set<std::pair<int, int>> edgesOf(const std::vector<Triangle>& triangles)
{
  std::set<std::pair<int, int>> result;
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }
  return result;
}

double totalLength(const std::vector<Triangle>& triangles, const std::vector<Vec3>& position)
{
  double sum = 0;
  for (const auto& [a, b] : edgesOf(triangles))
  {
    sum += (position[b] - position[a]).norm();
  }
  return sum;
}
}

TEST(SurfaceDelaunay, WaysHaveTheirLengthOnTheSurface)
{
  const AtlasSurface stretched =
    makeChart(8, 1., [](const Vec2& p) { return Vec3(3. * p.x(), p.y(), 0.); });
  ParameterWalk walk(stretched, Chart(0));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.01, 0.99);
  Vec2 from(0.3, 0.4);
  ASSERT_GE(walk.walk(from), 0.);
  for (int i = 0; i < 200; ++i)
  {
    const Vec2 to(unit(random), unit(random));
    const Vec2 step = to - from;
    EXPECT_NEAR(walk.walk(to), std::hypot(3. * step.x(), step.y()), 1e-12);
    from = to;
  }
  // Through the corners of triangles, and along their sides.
  for (const Vec2& to : { Vec2(0.125, 0.125), Vec2(0.875, 0.875), Vec2(0.125, 0.875),
         Vec2(0.125, 0.25), Vec2(0.75, 0.25), Vec2(0.25, 0.5) })
  {
    const Vec2 step = to - from;
    EXPECT_NEAR(walk.walk(to), std::hypot(3. * step.x(), step.y()), 1e-12);
    from = to;
  }
}

TEST(SurfaceDelaunay, WaysGoAroundAFold)
{
  // Folded by a right angle in the middle, and as large as its chart: lengths are the plane's.
  const AtlasSurface folded = makeChart(6, 2., [](const Vec2& p) {
    return p.x() < 1. ? Vec3(p.x(), p.y(), 0.) : Vec3(1., p.y(), p.x() - 1.);
  });
  ParameterWalk walk(folded, Chart(0));
  walk.walk({ 0.1, 0.2 });
  EXPECT_NEAR(walk.walk({ 1.9, 0.7 }), std::hypot(1.8, 0.5), 1e-12);
}

TEST(SurfaceDelaunay, WaysThatLeaveTheChartHaveNone)
{
  const AtlasSurface flat = makeChart(4, 1., [](const Vec2& p) { return Vec3(p.x(), p.y(), 0.); });
  ParameterWalk walk(flat, Chart(0));
  EXPECT_LT(walk.walk({ 1.5, 0.5 }), 0.);
  ASSERT_GE(walk.walk({ 0.25, 0.3 }), 0.);
  EXPECT_NEAR(walk.walk({ 0.75, 0.3 }), 0.5, 1e-12);
}

TEST(SurfaceDelaunay, OfAStretchedChartIsThatOfTheStretchedPlane)
{
  const auto onSurface = [](const Vec2& p) { return Vec3(4. * p.x(), p.y(), 0.); };
  const AtlasSurface surface = makeChart(10, 1., onSurface);
  const Places places(1., 12, 300);
  TriangleComplex complex = triangulate(places);
  std::vector<Vec3> position;
  Places stretched = places;
  for (Vec2& p : stretched.points)
  {
    position.push_back(onSurface(p));
    p.x() *= 4.;
  }
  const double before = totalLength(complex.triangles, position);
  EXPECT_GT(swapToSurfaceDelaunay(surface, Chart(0), places.points, complex), 100);
  EXPECT_TRUE(complex.isSound());
  EXPECT_LT(totalLength(complex.triangles, position), 0.8 * before);
  for (const Triangle& t : complex.triangles)
  {
    EXPECT_GT(orient2(places.points[t[0]], places.points[t[1]], places.points[t[2]]), 0.);
  }
  // All but where a Delaunay edge is the longer one.
  const auto wanted = edgesOf(triangulate(stretched).triangles);
  const auto edges = edgesOf(complex.triangles);
  int common = 0;
  for (const auto& edge : edges)
  {
    common += static_cast<int>(wanted.count(edge));
  }
  EXPECT_EQ(edges.size(), wanted.size());
  EXPECT_GT(common, 0.93 * static_cast<double>(edges.size()));
}

TEST(SurfaceDelaunay, UntwistsAStrip)
{
  // A wall about a hole: bent to three quarters of a circle, and sheared by five edges.
  constexpr int Edges = 60;
  constexpr double Shear = 5.;
  const auto along = [](const Vec2& p) { return p.x() + Shear * p.y(); };
  const AtlasSurface surface = makeChart(240, Edges, [&](const Vec2& p) {
    const double angle = 1.5 * EIGEN_PI * along(p) / Edges;
    const double radius = Edges / (1.5 * EIGEN_PI);
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), p.y());
  });
  Places strip(Edges, 1, 0); // its corners
  strip.segments.clear();
  std::vector<int> outline;
  for (int side = 0; side < 2; ++side)
  {
    for (int i = 0; i <= Edges; ++i)
    {
      const bool isCorner = i == 0 || i == Edges;
      const int x = side == 0 ? i : Edges - i;
      outline.push_back(isCorner ? (side == 0 ? (i == 0 ? 0 : 1) : (i == 0 ? 2 : 3))
                                 : static_cast<int>(strip.points.size()));
      if (!isCorner)
      {
        strip.points.emplace_back(x, side);
      }
    }
  }
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    strip.segments.push_back({ { outline[i], outline[(i + 1) % outline.size()] } });
  }
  TriangleComplex complex = triangulate(strip);
  const auto across = [&](const std::pair<int, int>& e) {
    const Vec2& p = strip.points[e.first];
    const Vec2& q = strip.points[e.second];
    const bool isInside =
      std::min(p.x(), q.x()) > Shear + 1. && std::max(p.x(), q.x()) < Edges - Shear - 1.;
    return isInside && p.y() != q.y() ? std::abs(along(q) - along(p)) : 0.;
  };
  double longest = 0;
  for (const auto& edge : edgesOf(complex.triangles))
  {
    longest = std::max(longest, across(edge));
  }
  EXPECT_GT(longest, 4.5); // upright in the plane is not so on the surface
  swapToSurfaceDelaunay(surface, Chart(0), strip.points, complex);
  longest = 0;
  for (const auto& edge : edgesOf(complex.triangles))
  {
    longest = std::max(longest, across(edge));
  }
  EXPECT_LT(longest, 1.01);
}

TEST(SurfaceDelaunay, LeavesLabelledEdgesAndStopsWhenAsked)
{
  const AtlasSurface surface =
    makeChart(10, 1., [](const Vec2& p) { return Vec3(4. * p.x(), p.y(), 0.); });
  const Places places(1., 6, 60);
  TriangleComplex complex = triangulate(places);
  const std::vector<Triangle> before = complex.triangles;
  EXPECT_EQ(
    swapToSurfaceDelaunay(surface, Chart(0), places.points, complex, [] { return true; }), 0);
  complex.label.assign(complex.twin.size(), Label(0));
  EXPECT_EQ(swapToSurfaceDelaunay(surface, Chart(0), places.points, complex), 0);
  EXPECT_EQ(complex.triangles, before);
}
