// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Curvature of the smooth pieces of a surface, whatever its triangles.
#include "FeatureDetection.h"
#include "NormalCurvature.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace stipple;

namespace
{
/// With the creases that are found by default.
std::vector<double> curvatureOf(const TriangleSurface& s)
{
  CutSurface cut = shapes::cutSurface(s);
  detectFeatures(cut, {});
  return largestNormalCurvature(cut);
}

/// The surface with its points moved at random by up to `amount` and put back onto the shape.
TriangleSurface shaken(TriangleSurface s, double amount, const std::function<Vec3(Vec3)>& onto)
{
  std::mt19937 engine(3);
  const auto random = [&] { return amount * (engine() / 2147483648. - 1.); };
  for (Vec3& p : s.points)
  {
    const Vec3 step(random(), random(), random());
    p = onto(p + step);
  }
  return s;
}

Vec3 ontoTorus(const Vec3& p)
{
  const Vec3 ring = 3. * Vec3(p.x(), p.y(), 0.).normalized();
  return ring + (p - ring).normalized();
}
}

TEST(NormalCurvature, OfASphereIsExactHoweverTrianglesLie)
{
  const double radius = 2.5;
  const auto onto = [&](const Vec3& p) { return Vec3(radius * p.normalized()); };
  const TriangleSurface even = shapes::sphere(radius, 3);
  for (const double amount : { 0., 0.1 }) // edges are .35 to .4 long
  {
    for (const double k : curvatureOf(shaken(even, amount, onto)))
    {
      EXPECT_NEAR(k * radius, 1., 1e-6);
    }
  }
}

TEST(NormalCurvature, EndsAtCreases)
{
  // A third of the mantle's triangles have no corner off the creases; none has with one ring.
  for (const int rings : { 1, 3, 20 })
  {
    const TriangleSurface s = shapes::cylinder(0.5, 2., 24, rings);
    const std::vector<double> k = curvatureOf(s);
    for (const Face f : s.faces())
    {
      const bool onCap = std::abs(s.faceNormal(f).z()) > 0.5;
      EXPECT_NEAR(k[f.index()], onCap ? 0. : 2., onCap ? 1e-9 : 0.05) << rings << " rings";
    }
  }
  for (const double k : curvatureOf(shapes::cube(4)))
  {
    EXPECT_NEAR(k, 0., 1e-9);
  }
}

TEST(NormalCurvature, EndsAtBoundaries)
{
  TriangleSurface cap = shapes::sphere(1., 4);
  const auto below = [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](int p) { return cap.points[p].z() < 0.3; });
  };
  cap.triangles.erase(
    std::remove_if(cap.triangles.begin(), cap.triangles.end(), below), cap.triangles.end());
  cap.connect();
  for (const double k : curvatureOf(cap))
  {
    EXPECT_NEAR(k, 1., 1e-6);
  }
}

TEST(NormalCurvature, OfATorusIsThatOfItsTube)
{
  for (const double amount : { 0., 0.04 }) // edges are .1 to .2 long
  {
    const TriangleSurface s = shaken(shapes::torus(3., 1., 120, 48), amount, ontoTorus);
    std::vector<double> off;
    for (const double k : curvatureOf(s))
    {
      off.push_back(std::abs(k - 1.));
    }
    std::sort(off.begin(), off.end());
    EXPECT_LT(off[off.size() / 2], amount > 0 ? 0.03 : 2e-3);
    EXPECT_LT(off[off.size() * 99 / 100], amount > 0 ? 0.3 : 5e-3);
  }
}

TEST(NormalCurvature, ANarrowRoundStripBesideLargePlanesIsRound)
{
  // A sheet with a quarter of a cylinder of radius .1 between two squares, in four strips.
  TriangleSurface s;
  const auto add = [&](double x, double z) {
    s.points.emplace_back(x, -1., z);
    s.points.emplace_back(x, 1., z);
  };
  add(-2., 0.);
  for (int i = 0; i <= 4; ++i)
  {
    const double angle = std::acos(-1.) / 8. * i;
    add(0.1 * std::sin(angle), 0.1 * std::cos(angle) - 0.1);
  }
  add(0.1, -2.);
  for (int i = 0; i < 6; ++i)
  {
    s.triangles.push_back({ 2 * i, 2 * i + 2, 2 * i + 3 });
    s.triangles.push_back({ 2 * i, 2 * i + 3, 2 * i + 1 });
  }
  s.connect();
  const std::vector<double> k = curvatureOf(s);
  for (int f = 0; f < 12; ++f)
  {
    const bool isFlat = f < 2 || f >= 10;
    EXPECT_LT(k[f], isFlat ? 1. : 12.);
    EXPECT_GT(k[f], isFlat ? -1e-9 : 3.) << f; // the outer strips' normals lean
  }
  EXPECT_NEAR(k[5], 10., 2.) << "in the middle";
}
