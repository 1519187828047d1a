// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Bounds on the largest distance between two surfaces, against shapes whose distance is known.
#include "DeviationSearch.h"
#include "MeshQuality.h"
#include "NearestTriangle.h"
#include "Shapes.h"
#include "SurfaceDeviation.h"
#include "TriangleDistance.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace stipple;

namespace
{
DeviationBounds deviation(const TriangleSurface& a, const TriangleSurface& b, double accuracy)
{
  DeviationBounds bounds;
  EXPECT_TRUE(surfaceDeviation(a, b, accuracy, nullptr, bounds).ok());
  EXPECT_LE(bounds.upper, 1.01 * bounds.lower + accuracy + 1e-15);
  return bounds;
}

DeviationBounds oneSided(const TriangleSurface& a, const TriangleSurface& b, double accuracy)
{
  const NearestTriangle nearest(b);
  DeviationBounds bounds;
  EXPECT_TRUE(oneSidedDeviation(a, nearest, accuracy, nullptr, bounds).ok());
  return bounds;
}

TriangleSurface triangles(std::vector<Vec3> points, std::vector<Triangle> list)
{
  TriangleSurface s;
  s.points = std::move(points);
  s.triangles = std::move(list);
  return s;
}

void expectAround(const DeviationBounds& bounds, double value, double accuracy)
{
  EXPECT_LE(bounds.lower, value + 1e-12);
  EXPECT_GE(bounds.upper, value - 1e-12);
  EXPECT_LE(bounds.upper, 1.01 * value + accuracy + 1e-12);
}
}

TEST(TriangleDistance, IsThatOfTheNearestCornerEdgeOrInside)
{
  const Vec3 a(0, 0, 0);
  const Vec3 b(2, 0, 0);
  const Vec3 c(0, 2, 0);
  EXPECT_DOUBLE_EQ(squaredDistanceToTriangle({ 0.5, 0.5, 3 }, a, b, c), 9.);
  EXPECT_DOUBLE_EQ(squaredDistanceToTriangle({ -1, -1, 0 }, a, b, c), 2.);
  EXPECT_DOUBLE_EQ(squaredDistanceToTriangle({ 1, -2, 0 }, a, b, c), 4.);
  EXPECT_DOUBLE_EQ(squaredDistanceToTriangle({ 2, 2, 0 }, a, b, c), 2.);
}

TEST(NearestTriangle, IsTheNearestOfAll)
{
  const TriangleSurface s = shapes::torus(3., 1., 40, 20);
  const NearestTriangle nearest(s);
  std::mt19937 engine(5);
  const auto random = [&] { return 10. * (engine() / 4294967296. - 0.5); };
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 p(random(), random(), random());
    double least = 1e300;
    for (int f = 0; f < s.numberOfFaces(); ++f)
    {
      least = std::min(least, nearest.squaredDistance(p, f));
    }
    EXPECT_EQ(nearest.find(p).squaredDistance, least);
    EXPECT_EQ(nearest.find(p, i).squaredDistance, least) << "with a hint";
    for (const double enough : { 0., 2. })
    {
      const NearestTriangle::Hit hit = nearest.find(p, -1, enough);
      EXPECT_NEAR(hit.squaredDistance, nearest.squaredDistance(p, hit.face), 1e-10);
      EXPECT_TRUE(least <= enough ? hit.squaredDistance <= enough : hit.squaredDistance == least)
        << enough;
    }
  }
}

TEST(SurfaceDeviation, OfTheSameSurfaceIsNothingHoweverItIsCut)
{
  for (const auto& [a, b] : { std::pair(1, 1), std::pair(1, 23), std::pair(7, 30) })
  {
    const DeviationBounds bounds = deviation(shapes::cube(a), shapes::cube(b), 1e-6);
    EXPECT_LT(bounds.lower, 1e-12);
    EXPECT_LE(bounds.upper, 1e-6);
  }
}

TEST(SurfaceDeviation, SeesWhatNoSampleSees)
{
  // A thin spike of height .3 in the middle of a square of two triangles, off its corners.
  const double w = 1e-4;
  const TriangleSurface square =
    triangles({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  TriangleSurface spiked = square;
  spiked.points.insert(
    spiked.points.end(), { { 0.61, 0.2, 0 }, { 0.61 + w, 0.2, 0 }, { 0.61, 0.2 + w, 0.3 } });
  spiked.triangles.push_back({ 4, 5, 6 });
  expectAround(oneSided(spiked, square, 1e-5), 0.3, 1e-5);
  expectAround(oneSided(square, spiked, 1e-5), 0., 1e-5);

  // A narrow slot: no corner and no centroid of the square is near its middle.
  const TriangleSurface slotted =
    triangles({ { 0, 0, 0 }, { 0.6, 0, 0 }, { 0.6, 1, 0 }, { 0, 1, 0 }, { 0.62, 0, 0 }, { 1, 0, 0 },
                { 1, 1, 0 }, { 0.62, 1, 0 } },
      { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 } });
  expectAround(oneSided(square, slotted, 1e-5), 0.01, 1e-5);
  expectAround(oneSided(slotted, square, 1e-5), 0., 1e-5);
}

TEST(SurfaceDeviation, OfASphereAndItsOctahedronIsItsSagitta)
{
  // The farthest place of the sphere is over the middle of a face.
  TriangleSurface octahedron = triangles(
    { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } }, {});
  for (const int x : { 0, 1 })
  {
    for (const int y : { 2, 3 })
    {
      octahedron.triangles.push_back({ x, y, 4 });
      octahedron.triangles.push_back({ x, y, 5 });
    }
  }
  const double sagitta = 1. - std::sqrt(1. / 3.);
  const DeviationBounds bounds = deviation(octahedron, shapes::sphere(1., 5), 1e-4);
  EXPECT_NEAR(bounds.lower, sagitta, 0.012 * sagitta);
  EXPECT_NEAR(bounds.upper, sagitta, 0.012 * sagitta);
}

TEST(SurfaceDeviation, BoundsWhatManySamplesFindInASoup)
{
  std::mt19937 engine(11);
  const auto random = [&] { return engine() / 4294967296. - 0.5; };
  const auto soup = [&](int number) {
    TriangleSurface s;
    for (int i = 0; i < number; ++i)
    {
      const Vec3 at(random(), random(), random());
      for (int k = 0; k < 3; ++k)
      {
        s.points.push_back(at + 0.3 * Vec3(random(), random(), random()));
      }
      s.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    }
    return s;
  };
  for (int draw = 0; draw < 5; ++draw)
  {
    const TriangleSurface a = soup(60);
    const TriangleSurface b = soup(80);
    const DeviationBounds bounds = deviation(a, b, 1e-3);
    double found = 0;
    for (const auto& [from, to] : { std::pair(&a, &b), std::pair(&b, &a) })
    {
      const NearestTriangle nearest(*to);
      for (const Vec3& p : sampleSurface(*from, 50000))
      {
        double least = 1e300;
        for (int f = 0; f < to->numberOfFaces(); ++f)
        {
          least = std::min(least, nearest.squaredDistance(p, f));
        }
        found = std::max(found, std::sqrt(least));
      }
    }
    EXPECT_GE(bounds.upper, found * (1. - 1e-9));
    EXPECT_LE(bounds.lower, 1.02 * found + 1e-3) << "samples come close to the farthest place";
  }
}

TEST(SurfaceDeviation, IsTheSameForAnyNumberOfThreadsAndCanBeStopped)
{
  const TriangleSurface a = shapes::torus(3., 1., 60, 24);
  const TriangleSurface b = shapes::torus(3., 1.01, 37, 41);
  const auto run = [&](int threads) {
    DeviationBounds bounds;
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ threads }, [&]() { bounds = deviation(a, b, 1e-4); });
    return bounds;
  };
  const DeviationBounds one = run(1);
  const DeviationBounds four = run(4);
  EXPECT_EQ(one.lower, four.lower);
  EXPECT_EQ(one.upper, four.upper);
  DeviationBounds bounds;
  const auto stop = [](double) { return false; };
  EXPECT_TRUE(surfaceDeviation(a, b, 1e-4, stop, bounds).isAbort());
  EXPECT_EQ(deviation({}, b, 1e-4).upper, 0.) << "of nothing";
}

namespace
{
struct Found
{
  int points = 0;
  int trials = 0;
  int largest = 0;
  double nearest = 0;
  double tooMany = 0;
};

/// Of a surface with this deviation by number; no mesh has fewer than `fewest` points.
Found search(double wanted, double first, const std::function<double(int)>& of, int fewest = 1)
{
  DeviationSearch s(wanted, first, 1., 1e6);
  Found result;
  while (s.next() > 0)
  {
    const int asked = s.next();
    const int got = std::max(asked, fewest);
    s.add(asked, got, of(got));
    ++result.trials;
    result.largest = std::max(result.largest, got);
  }
  result.points = s.found();
  result.nearest = s.nearest();
  result.tooMany = s.tooMany();
  return result;
}
}

TEST(DeviationSearch, FindsAboutTheFewestPointsInFewTrials)
{
  for (const double power : { 1., 0.5, 1.5 })
  {
    for (const double first : { 30., 1000., 30000. })
    {
      // With jumps of a tenth.
      const Found f = search(0.01, first,
        [&](int n) { return std::pow(50. / n, power) * (1. + 0.05 * std::sin(0.7 * n)); });
      const double exact = 50. * std::pow(100., 1. / power);
      EXPECT_GT(f.points, 0.85 * exact) << power << " " << first;
      EXPECT_LT(f.points, 1.4 * exact) << power << " " << first;
      EXPECT_LE(f.trials, 10) << power << " " << first;
    }
  }
}

TEST(DeviationSearch, JumpsOnSmallStepsAreNotTakenForTheEnd)
{
  // As the elephant's at .2 %: nearly there, deviations happen not to fall for a while.
  const auto of = [](int n) { return n > 4700 && n < 8000 ? 0.0102 : 50. / n; };
  for (const double first : { 300., 1000., 3000. })
  {
    const Found f = search(0.01, first, of);
    EXPECT_GE(f.points, 8000) << first;
    EXPECT_LT(f.points, 13000) << first;
  }
}

TEST(DeviationSearch, GoesOnWhereDeviationsFallSlowlyAndLeadThere)
{
  // As a scanned skull's at .5 %, with the fifth root.
  const auto of = [](int n) { return 0.0143 * std::pow(3552. / n, 0.2); };
  const Found f = search(0.01, 1112., of);
  const double exact = 3552. * std::pow(1.43, 5.);
  EXPECT_GT(f.points, 0.99 * exact);
  EXPECT_LT(f.points, 2. * exact);
  // But not where it would take more than there may be.
  const Found far = search(0.001, 1112., of);
  EXPECT_EQ(far.points, 0);
  EXPECT_LE(far.trials, 4);
}

TEST(DeviationSearch, LooksBetweenNumbersThatAreFarApart)
{
  // As a ball cut by a cylinder at .5 %: from 4,000 points on its edge is met, and then more points
  // do not bring much.
  for (const double first : { 140., 800., 2400. })
  {
    const Found f =
      search(0.01, first, [](int n) { return n < 4000 ? 0.0256 * std::sqrt(2400. / n) : 0.009; });
    EXPECT_GE(f.points, 4000) << first;
    EXPECT_LT(f.points, 8500) << first;
    EXPECT_LE(f.trials, 9) << first;
  }
}

TEST(DeviationSearch, EndsWhereThereAreNoFewerAndWhereMoreDoNotHelp)
{
  EXPECT_EQ(search(
              0.01, 500., [](int) { return 1e-12; }, 8)
              .points,
    8)
    << "of a cube";
  const Found stalled = search(0.01, 500., [](int) { return 0.2; });
  EXPECT_EQ(stalled.points, 0);
  EXPECT_EQ(stalled.nearest, 0.2);
  EXPECT_LT(stalled.largest, 100000);
  EXPECT_EQ(stalled.tooMany, 0.) << "no number does";
  const Found far = search(1e-9, 500., [](int n) { return 50. / n; });
  EXPECT_EQ(far.points, 0);
  EXPECT_EQ(far.trials, 1) << "far more than there may be";
  EXPECT_NEAR(far.tooMany / 5e10, 1., 0.1);
  const double none = std::numeric_limits<double>::infinity();
  const Found raised = search(0.2, 10., [&](int n) { return n < 100 ? none : 10. / n; });
  EXPECT_GE(raised.points, 100) << "no mesh of fewer";
  EXPECT_LT(raised.points, 130);
}

// Finer than coordinates are, pieces would be cut without end.
TEST(SurfaceDeviation, EndsWhereTheAccuracyIsBelowRounding)
{
  TriangleSurface a = shapes::saddle(6);
  TriangleSurface b = shapes::saddle(7);
  for (TriangleSurface* surface : { &a, &b })
  {
    for (Vec3& p : surface->points)
    {
      p += Vec3::Constant(1e9);
    }
  }
  DeviationBounds bounds;
  ASSERT_TRUE(surfaceDeviation(a, b, 1e-300, nullptr, bounds).ok());
  EXPECT_GT(bounds.lower, 1e-3);
  EXPECT_LE(bounds.upper, 1.01 * bounds.lower + 1e-4);
}

TEST(DeviationSearch, StartsWithTheNumberOfASphere)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(DeviationSearch(1., nan, 5., 100.).next(), 5);
  EXPECT_EQ(DeviationSearch(1., nan, nan, 100.).next(), 1);
  const TriangleSurface sphere = shapes::sphere(1., 4);
  const double off = deviation(sphere, shapes::sphere(1., 6), 1e-5).upper;
  const double points = pointsOfSphere(2. * std::sqrt(3.), off);
  EXPECT_NEAR(points / sphere.numberOfVertices(), 1., 0.35);
}
