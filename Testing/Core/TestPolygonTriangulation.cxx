// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonTriangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace stipple;

namespace
{
/// Of corners counterclockwise in the plane z = x + 2 y: two triangles fewer than corners, which
/// share the polygon's orientation and together have its area, so that none overlap.
void expectCovered(const std::vector<Vec2>& corners, bool strictly = true)
{
  double area = 0;
  std::vector<Vec3> lifted;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    area += 0.5 * cross2(corners[i], corners[(i + 1) % corners.size()]);
    lifted.emplace_back(corners[i].x(), corners[i].y(), corners[i].x() + 2 * corners[i].y());
  }
  ASSERT_GT(area, 0);
  const std::vector<Triangle> triangles = triangulatePolygon(lifted);
  ASSERT_EQ(triangles.size() + 2, corners.size());
  double sum = 0;
  for (const Triangle& t : triangles)
  {
    const double twice = orient2(corners[t[0]], corners[t[1]], corners[t[2]]);
    EXPECT_GE(twice, strictly ? 1e-9 * area : -1e-9 * area);
    sum += 0.5 * twice;
  }
  EXPECT_NEAR(sum, area, 1e-9 * area);
}
}

TEST(PolygonTriangulation, ConvexIsAFan)
{
  std::vector<Vec3> corners;
  for (int i = 0; i < 7; ++i)
  {
    corners.emplace_back(std::cos(2 * Pi * i / 7), std::sin(2 * Pi * i / 7), 3);
  }
  const std::vector<Triangle> fan = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 },
    { 0, 5, 6 } };
  EXPECT_EQ(triangulatePolygon(corners), fan);
}

TEST(PolygonTriangulation, QuadsAreCutAlongTheShorterDiagonal)
{
  const Vec3 a(0, 0, 0);
  const Vec3 b(1, 0, 0.2);
  const Vec3 c(1.4, 1.4, 0); // far from a
  const Vec3 d(0, 1, 0.2);
  using Triangles = std::vector<Triangle>;
  EXPECT_EQ(triangulatePolygon({ a, b, c, d }), (Triangles{ { 1, 2, 3 }, { 1, 3, 0 } }));
  EXPECT_EQ(triangulatePolygon({ b, c, d, a }), (Triangles{ { 0, 1, 2 }, { 0, 2, 3 } }));
  const Vec3 e(1, 1, 0);
  EXPECT_EQ(triangulatePolygon({ a, b, e, d }), (Triangles{ { 0, 1, 2 }, { 0, 2, 3 } })) << "alike";
  const Vec3 within(0.2, 0.2, 0); // the diagonal from b to d, the shorter one, is outside
  EXPECT_EQ(triangulatePolygon({ Vec3(-2, -2, 0), Vec3(1, 0, 0), within, Vec3(0, 1, 0) }),
    (Triangles{ { 0, 1, 2 }, { 0, 2, 3 } }));
}

TEST(PolygonTriangulation, FewCorners)
{
  EXPECT_TRUE(triangulatePolygon({}).empty());
  EXPECT_TRUE(triangulatePolygon({ Vec3(0, 0, 0), Vec3(1, 0, 0) }).empty());
  EXPECT_EQ(triangulatePolygon({ Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, 1) }).size(), 1U);
  EXPECT_EQ(triangulatePolygon(std::vector<Vec3>(5, Vec3(1, 2, 3))).size(), 3U);
}

TEST(PolygonTriangulation, WhateverCornerComesFirst)
{
  std::vector<Vec2> ell = { Vec2(0, 0), Vec2(4, 0), Vec2(4, 1), Vec2(1, 1), Vec2(1, 3),
    Vec2(0, 3) };
  std::vector<Vec2> dart = { Vec2(0, 0), Vec2(3, 1), Vec2(0, 2), Vec2(1, 1) };
  std::vector<Vec2> star;
  for (int i = 0; i < 22; ++i)
  {
    star.emplace_back((i % 2 ? 0.2 : 1) * Vec2(std::cos(Pi * i / 11), std::sin(Pi * i / 11)));
  }
  std::vector<Vec2> spiral;
  for (int i = 0; i <= 60; ++i)
  {
    spiral.emplace_back((1 + 0.1 * i) * Vec2(std::cos(0.3 * i), std::sin(0.3 * i)));
  }
  for (int i = 60; i >= 0; --i)
  {
    spiral.emplace_back((0.5 + 0.1 * i) * Vec2(std::cos(0.3 * i), std::sin(0.3 * i)));
  }
  std::reverse(spiral.begin(), spiral.end());
  for (std::vector<Vec2>* corners : { &ell, &dart, &star, &spiral })
  {
    double area = 0;
    for (std::size_t i = 0; i < corners->size(); ++i)
    {
      area += cross2((*corners)[i], (*corners)[(i + 1) % corners->size()]);
    }
    if (area < 0)
    {
      std::reverse(corners->begin(), corners->end());
    }
    for (std::size_t i = 0; i < corners->size(); ++i)
    {
      std::rotate(corners->begin(), corners->begin() + 1, corners->end());
      expectCovered(*corners);
    }
  }
}

TEST(PolygonTriangulation, CornersOnASide)
{
  std::vector<Vec2> square = { Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(3, 0), Vec2(3, 3),
    Vec2(1, 3), Vec2(0, 3) };
  for (std::size_t i = 0; i < square.size(); ++i)
  {
    std::rotate(square.begin(), square.begin() + 1, square.end());
    expectCovered(square, false); // the last ears may be flat, which repair takes out
  }
}

TEST(PolygonTriangulation, ABridgeToAHole)
{
  expectCovered({ Vec2(0, 0), Vec2(4, 0), Vec2(4, 4), Vec2(0, 4), Vec2(0, 0), Vec2(1, 1),
                  Vec2(1, 3), Vec2(3, 3), Vec2(3, 1), Vec2(1, 1) },
    false);
}
