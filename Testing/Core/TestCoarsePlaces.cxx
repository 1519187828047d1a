// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a mesh's edges are too long: a flat fan whose middle goes towards its rim.
#include "CoarsePlaces.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace stipple;

namespace
{
constexpr int Rim = 6;

/// A regular hexagon about a vertex, the last one, at this place.
TriangleSurface fan(const Vec3& middle)
{
  TriangleSurface mesh;
  for (int i = 0; i < Rim; ++i)
  {
    mesh.points.emplace_back(std::cos(i * Pi / 3), std::sin(i * Pi / 3), 0);
    mesh.triangles.push_back({ i, (i + 1) % Rim, Rim });
  }
  mesh.points.push_back(middle);
  mesh.connect();
  return mesh;
}

const std::vector<char> Inside = { 0, 0, 0, 0, 0, 0, 1 };
const std::vector<char> Nothing(Rim + 1, 0);
}

TEST(CoarsePlaces, AreTrianglesWithSmallAngles)
{
  const TriangleSurface good = fan(Vec3::Zero());
  EXPECT_TRUE(coarsePlaces(good, Inside, shapes::intersectionsOf(good)).empty());
  // The triangle on the first edge gets an angle of 13 degrees.
  const Vec3 rim = 0.5 * (good.points[0] + good.points[1]);
  const Vec3 middle = rim - 0.5 * std::tan(13. * Pi / 180) * rim.normalized();
  const TriangleSurface flat = fan(middle);
  const std::vector<CoarsePlace> places = coarsePlaces(flat, Inside, shapes::intersectionsOf(good));
  ASSERT_EQ(places.size(), 1U);
  EXPECT_LT((places[0].position - (good.points[0] + good.points[1] + middle) / 3.).norm(), 1e-12);
  EXPECT_NEAR(places[0].edgeLength, (1. + 1. / std::cos(13. * Pi / 180)) / 3., 1e-12);
  EXPECT_TRUE(coarsePlaces(flat, Nothing, shapes::intersectionsOf(good)).empty())
    << "all corners on features";
  const Vec3 better = rim - 0.5 * std::tan(16. * Pi / 180) * rim.normalized();
  EXPECT_TRUE(coarsePlaces(fan(better), Inside, shapes::intersectionsOf(good)).empty());
}

TEST(CoarsePlaces, AreWhereTheMeshPassesThroughItself)
{
  // A second fan, whose middle comes through the first one.
  const auto both = [](double height) {
    TriangleSurface mesh = fan(Vec3::Zero());
    const TriangleSurface other = fan(Vec3(0, 0, height));
    for (const Vec3& p : other.points)
    {
      mesh.points.push_back(p + Vec3(0.1, 0.05, 0.3));
    }
    for (Triangle t : other.triangles)
    {
      for (int& p : t)
      {
        p += Rim + 1;
      }
      mesh.triangles.push_back(t);
    }
    mesh.connect();
    return mesh;
  };
  const TriangleSurface apart = both(0.);
  const TriangleSurface through = both(-0.35);
  const std::vector<char> none(apart.points.size(), 0);
  EXPECT_TRUE(coarsePlaces(apart, none, shapes::intersectionsOf(apart)).empty());
  const std::vector<CoarsePlace> places =
    coarsePlaces(through, none, shapes::intersectionsOf(apart));
  EXPECT_FALSE(places.empty());
  for (const CoarsePlace& place : places)
  {
    EXPECT_NEAR(place.edgeLength, 1., 0.15);
    EXPECT_LT(place.position.norm(), 1.);
  }
  EXPECT_TRUE(coarsePlaces(through, none, shapes::intersectionsOf(through)).empty())
    << "the surface does so, too";
}
