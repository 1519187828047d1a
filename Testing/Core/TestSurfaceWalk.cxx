// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Straight walks: exact in the plane, isometric over folds, ended by boundaries and walls.
#include "../Cxx/SyntheticAtlas.h"
#include "SurfaceWalk.h"

#include <gtest/gtest.h>

using namespace stipple;

namespace
{
/// An n x n grid over the unit square, bent by `bend` radians about the line x = 1/2.
TriangleSurface foldedSquare(int n, double bend)
{
  TriangleSurface s;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = static_cast<double>(i) / n;
      const double beyond = std::max(0., x - 0.5);
      s.points.emplace_back(std::min(x, 0.5) + beyond * std::cos(bend), static_cast<double>(j) / n,
        beyond * std::sin(bend));
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int p = j * (n + 1) + i;
      s.triangles.push_back({ p, p + 1, p + n + 2 });
      s.triangles.push_back({ p, p + n + 2, p + n + 1 });
    }
  }
  s.connect();
  return s;
}

SurfacePlace placeAt(const TriangleSurface& s, double x, double y)
{
  for (int f = 0; f < s.numberOfFaces(); ++f)
  {
    const Vec3 b = barycentric(
      { x, y }, s.point(f, 0).head<2>(), s.point(f, 1).head<2>(), s.point(f, 2).head<2>());
    if (b.minCoeff() >= 0)
    {
      return { f, b };
    }
  }
  return {};
}

Vec3 position(const TriangleSurface& s, const SurfacePlace& p)
{
  return s.position(p.face, p.bary);
}
}

TEST(SurfaceWalk, IsAStraightLineInThePlane)
{
  const TriangleSurface s = foldedSquare(8, 0.);
  const SurfaceWalk walk(s);
  std::mt19937 engine(7);
  const auto random = [&]() { return 0.05 + 0.9 * (engine() / 4294967296.); };
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 from(random(), random(), 0);
    const Vec3 to(random(), random(), 0);
    const SurfacePlace end = walk.walk(placeAt(s, from.x(), from.y()), to - from);
    EXPECT_LT((position(s, end) - to).norm(), 1e-12);
    EXPECT_GE(end.bary.minCoeff(), 0.);
    EXPECT_NEAR(end.bary.sum(), 1., 1e-14);
  }
}

TEST(SurfaceWalk, StartsAtVerticesAndEdgesInAnyDirection)
{
  const TriangleSurface s = foldedSquare(4, 0.);
  const SurfaceWalk walk(s);
  for (int f = 0; f < s.numberOfFaces(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      for (const double weight : { 1., 0.5 })
      {
        SurfacePlace start;
        start.face = f;
        start.bary[k] = weight;
        start.bary[(k + 1) % 3] = 1. - weight;
        const Vec3 from = position(s, start);
        for (int a = 0; a < 16; ++a)
        {
          const Vec3 to = from + 0.2 * Vec3(std::cos(a * 0.4), std::sin(a * 0.4), 0);
          if (to.head<2>().minCoeff() > 0 && to.head<2>().maxCoeff() < 1 &&
            from.head<2>().minCoeff() > 0 && from.head<2>().maxCoeff() < 1)
          {
            EXPECT_LT((position(s, walk.walk(start, to - from)) - to).norm(), 1e-12);
          }
        }
      }
    }
  }
}

TEST(SurfaceWalk, UnfoldsOverAnEdge)
{
  const double bend = 1.2;
  const TriangleSurface s = foldedSquare(8, bend);
  const SurfaceWalk walk(s);
  const SurfacePlace end = walk.walk(placeAt(s, 0.4, 0.31), Vec3(0.3, 0.2, 0.));
  const Vec3 wanted(0.5 + 0.2 * std::cos(bend), 0.51, 0.2 * std::sin(bend));
  EXPECT_LT((position(s, end) - wanted).norm(), 1e-12);
}

TEST(SurfaceWalk, EndsAtTheBoundary)
{
  const TriangleSurface s = foldedSquare(8, 0.);
  const SurfaceWalk walk(s);
  const Vec3 end = position(s, walk.walk(placeAt(s, 0.5, 0.3), Vec3(2., 0.4, 0.)));
  EXPECT_NEAR(end.x(), 1., 1e-12);
  EXPECT_NEAR(end.y(), 0.4, 1e-12);
}

TEST(SurfaceWalk, EndsAtAWallUnlessToldToPass)
{
  const TriangleSurface s = foldedSquare(8, 0.);
  std::vector<char> wall(3 * s.triangles.size(), 0);
  for (int h = 0; h < static_cast<int>(wall.size()); ++h)
  {
    wall[h] = s.points[s.tail(h)].x() == 0.5 && s.points[s.head(h)].x() == 0.5;
  }
  const SurfaceWalk walk(s, wall);
  const SurfacePlace start = placeAt(s, 0.4, 0.3);
  EXPECT_NEAR(position(s, walk.walk(start, Vec3(0.3, 0., 0.))).x(), 0.5, 1e-12);
  EXPECT_NEAR(position(s, walk.walk(start, Vec3(0.3, 0., 0.), true)).x(), 0.7, 1e-12);
}

TEST(SurfaceWalk, EndsWhereItWindsAboutAWire)
{
  constexpr int Sides = 12;
  TriangleSurface s;
  for (int i = 0; i < Sides; ++i)
  {
    const double angle = 2. * Pi * i / Sides;
    s.points.emplace_back(std::cos(angle), std::sin(angle), 0.);
    s.points.emplace_back(std::cos(angle), std::sin(angle), 1000.);
  }
  for (int i = 0; i < Sides; ++i)
  {
    const int p = 2 * i;
    const int q = 2 * ((i + 1) % Sides);
    s.triangles.push_back({ p, q, q + 1 });
    s.triangles.push_back({ p, q + 1, p + 1 });
  }
  s.connect();
  const SurfaceWalk walk(s);
  const SurfacePlace start{ 0, Vec3(0.25, 0.25, 0.5) }; // half way up
  const double from = position(s, start).z();
  const Vec3 around = (s.points[2] - s.points[0]).normalized();
  const double turn = Sides * (s.points[2] - s.points[0]).norm();
  // Half a turn is a shortest way; a helix of many turns is none, and ends in its third turn at
  // the latest.
  const auto rise = [&](double turns) {
    const Vec3 step = turns * turn * around + Vec3(0., 0., turns);
    return position(s, walk.walk(start, step)).z() - from;
  };
  EXPECT_NEAR(rise(0.5), 0.5, 1e-9);
  EXPECT_NEAR(rise(-0.5), -0.5, 1e-9);
  for (const double turns : { 20., -20., 1e4 })
  {
    EXPECT_GT(std::abs(rise(turns)), 0.5);
    EXPECT_LT(std::abs(rise(turns)), 3.);
  }
}
