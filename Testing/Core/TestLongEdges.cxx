// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LongEdges.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace stipple;

namespace
{
CutSurface cutSurface(const TriangleSurface& s)
{
  std::vector<int> cells(s.triangles.size());
  std::iota(cells.begin(), cells.end(), 0);
  CutSurface surface(s, cells);
  surface.connect();
  return surface;
}

double longestEdge(const CutSurface& s)
{
  double longest = 0;
  for (int h = 0; h < 3 * s.numberOfFaces(); ++h)
  {
    longest = std::max(longest, (s.points[s.head(h)] - s.points[s.tail(h)]).norm());
  }
  return longest;
}

/// A strip of two slender triangles, 10 by 0.1.
TriangleSurface strip()
{
  TriangleSurface s;
  s.points = { Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 0.1, 0), Vec3(0, 0.1, 0) };
  s.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  s.connect();
  return s;
}
}

TEST(LongEdges, AreHalvedUntilThereAreNone)
{
  for (const TriangleSurface& shape : { shapes::cube(1), strip() })
  {
    CutSurface surface = cutSurface(shape);
    const double area = surface.area();
    const SurfaceTopology topology = surface.topology();
    const int added = splitLongEdges(surface, 0.3);
    EXPECT_GT(added, 0);
    EXPECT_EQ(surface.points.size(), shape.points.size() + added);
    EXPECT_LE(longestEdge(surface), 0.3);
    EXPECT_GT(longestEdge(surface), 0.15);
    EXPECT_NEAR(surface.area(), area, 1e-9 * area);
    EXPECT_TRUE(surface.topology() == topology);
    // Every triangle lies in the one that it comes from.
    for (int f = 0; f < surface.numberOfFaces(); ++f)
    {
      const int source = surface.sourceCell[f];
      EXPECT_NEAR(surface.faceNormal(f).dot(shape.faceNormal(source)), 1., 1e-9);
      for (int k = 0; k < 3; ++k)
      {
        const Vec3 bary = barycentricInSpace(surface.point(f, k), shape.point(source, 0),
          shape.point(source, 1), shape.point(source, 2));
        EXPECT_GT(bary.minCoeff(), -1e-9);
      }
    }
  }
}

TEST(LongEdges, KeepTheirMarks)
{
  CutSurface surface = cutSurface(shapes::cube(1));
  for (const Halfedge h : surface.halfedges())
  {
    const double cosine =
      surface.faceNormal(faceOf(h)).dot(surface.faceNormal(faceOf(surface.twin[h])));
    surface.setSharp(h, cosine < 0.5);
  }
  splitLongEdges(surface, 0.2);
  double length = 0;
  for (const Halfedge h : surface.halfedges())
  {
    const double cosine =
      surface.faceNormal(faceOf(h)).dot(surface.faceNormal(faceOf(surface.twin[h])));
    EXPECT_EQ(surface.sharp[h] != 0, cosine < 0.5);
    length += surface.sharp[h] ? 0.5 * surface.edgeLength(h) : 0.;
  }
  const double side = std::sqrt(surface.area() / 6.);
  EXPECT_NEAR(length, 12. * side, 1e-9);
}

TEST(LongEdges, OfFineSurfacesThereAreNone)
{
  CutSurface surface = cutSurface(shapes::cube(40));
  EXPECT_EQ(splitLongEdges(surface, longestEdgeForCharts(surface)), 0);
  EXPECT_EQ(surface.numberOfFaces(), shapes::cube(40).numberOfFaces());
}

TEST(LongEdges, AreHalvedTheLongestFirstAsFarAsPointsGo)
{
  CutSurface surface = cutSurface(strip());
  EXPECT_EQ(splitLongEdges(surface, 0.3, 3), 3);
  EXPECT_LE(longestEdge(surface), 5.01);
}
