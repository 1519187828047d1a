// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a mesh passes through itself and the surface that it is of does not.
#include "MeshOverlaps.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace stipple;

namespace
{
constexpr int Side = 8;

/// Unit squares of Side x Side cells, parallel to the x-y plane but for a slope along x.
struct Sheets
{
  TriangleSurface surface;

  void add(double z, double slope = 0.)
  {
    const TriangleSurface sheet = shapes::grid(Side);
    const auto first = static_cast<int>(this->surface.points.size());
    for (const Vec3& p : sheet.points)
    {
      this->surface.points.emplace_back(p.x(), p.y(), z + slope * (p.x() - 0.51));
    }
    for (const Triangle& t : sheet.triangles)
    {
      this->surface.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    }
  }
};
}

TEST(MeshOverlaps, AreFoundWhereTheSurfaceHasNone)
{
  Sheets apart;
  apart.add(0.);
  apart.add(0.1);
  EXPECT_TRUE(findOverlaps(apart.surface, shapes::intersectionsOf(apart.surface)).empty());

  Sheets mesh;
  mesh.add(0.);
  mesh.add(0., 0.05);
  const std::vector<MeshOverlap> overlaps =
    findOverlaps(mesh.surface, shapes::intersectionsOf(apart.surface));
  EXPECT_GE(overlaps.size(), static_cast<std::size_t>(2 * Side)) << "along a line across the sheet";
  const int half = static_cast<int>(mesh.surface.triangles.size()) / 2;
  for (const MeshOverlap& overlap : overlaps)
  {
    EXPECT_NEAR(overlap.position.x(), 0.51, 1.1 / Side);
    EXPECT_NEAR(overlap.position.z(), 0., 0.01);
    const auto [low, high] = std::minmax(overlap.faces[0], overlap.faces[1]);
    EXPECT_LT(low.index(), half) << "one of each sheet";
    EXPECT_GE(high.index(), half);
  }
}

TEST(MeshOverlaps, OfTheSurfaceDoNotCount)
{
  Sheets mesh;
  mesh.add(0.);
  mesh.add(0., 0.05);
  EXPECT_TRUE(findOverlaps(mesh.surface, shapes::intersectionsOf(mesh.surface)).empty());

  // Another pair of sheets far away crosses in the mesh alone.
  Sheets both = mesh;
  Sheets surface = mesh;
  both.add(5.);
  both.add(5., 0.05);
  surface.add(5.);
  surface.add(5.1);
  const std::vector<MeshOverlap> overlaps =
    findOverlaps(both.surface, shapes::intersectionsOf(surface.surface));
  EXPECT_FALSE(overlaps.empty());
  EXPECT_TRUE(std::all_of(overlaps.begin(), overlaps.end(),
    [](const MeshOverlap& overlap) { return overlap.position.z() > 4.; }));
}
