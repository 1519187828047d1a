// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "SurfaceRepair.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>

using namespace stipple;

namespace
{
RepairedSurface repaired(const TriangleSurface& soup)
{
  RepairedSurface r;
  const Status status = repairSurface(shapes::toPolyData(soup), r);
  EXPECT_TRUE(status.ok()) << status.message();
  return r;
}

/// Every triangle with points of its own.
TriangleSurface exploded(const TriangleSurface& s)
{
  TriangleSurface soup;
  for (const Triangle& t : s.triangles)
  {
    const int n = static_cast<int>(soup.points.size());
    for (int p : t)
    {
      soup.points.push_back(s.points[p]);
    }
    soup.triangles.push_back({ n, n + 1, n + 2 });
  }
  return soup;
}
}

TEST(SurfaceRepair, CleanInputIsLeftAlone)
{
  const TriangleSurface cube = shapes::cube(3);
  const RepairedSurface r = repaired(cube);
  EXPECT_EQ(r.surface.triangles, cube.triangles);
  EXPECT_EQ(r.counts.weldedPoints + r.counts.unusedPoints + r.counts.degenerateTriangles +
      r.counts.duplicateTriangles + r.counts.reorientedTriangles + r.counts.splitEdges +
      r.counts.splitVertices,
    0);
}

TEST(SurfaceRepair, LooseTrianglesAreWelded)
{
  const TriangleSurface sphere = shapes::sphere(1, 2);
  const RepairedSurface r = repaired(exploded(sphere));
  EXPECT_EQ(r.surface.points.size(), sphere.points.size());
  EXPECT_EQ(
    r.counts.weldedPoints, static_cast<int>(3 * sphere.triangles.size() - sphere.points.size()));
  EXPECT_TRUE(r.surface.topology() == sphere.topology());
}

TEST(SurfaceRepair, MinorityIsTurnedAround)
{
  TriangleSurface sphere = shapes::sphere(1, 2);
  const TriangleSurface good = sphere;
  for (int f = 0; f < 50; ++f)
  {
    std::swap(sphere.triangles[3 * f][0], sphere.triangles[3 * f][1]);
  }
  const RepairedSurface r = repaired(sphere);
  EXPECT_EQ(r.counts.reorientedTriangles, 50);
  EXPECT_TRUE(r.surface.topology() == good.topology());
  EXPECT_GT(r.surface.faceNormal(0).dot(r.surface.point(0, 0)), 0)
    << "outward, as most of the input was";
}

TEST(SurfaceRepair, DuplicatesDegenerateAndUnusedAreDroppedAndCounted)
{
  TriangleSurface s = shapes::sphere(1, 1);
  const TriangleSurface good = s;
  s.triangles.push_back(s.triangles[4]);
  s.triangles.push_back({ s.triangles[5][1], s.triangles[5][0], s.triangles[5][2] });
  s.triangles.push_back({ 3, 3, 7 });
  s.points.emplace_back(9, 9, 9);
  const RepairedSurface r = repaired(s);
  EXPECT_EQ(r.counts.duplicateTriangles, 2);
  EXPECT_EQ(r.counts.degenerateTriangles, 1);
  EXPECT_EQ(r.counts.unusedPoints, 1);
  EXPECT_TRUE(r.surface.topology() == good.topology());
}

TEST(SurfaceRepair, NonManifoldEdgeAndVertexAreSplit)
{
  // Two cubes that share an edge, and two tetrahedra-like fans that share a point.
  const TriangleSurface a = shapes::cube(1);
  TriangleSurface s = a;
  for (const Triangle& t : a.triangles)
  {
    const int n = static_cast<int>(s.points.size());
    for (int p : t)
    {
      s.points.push_back(a.points[p] + Vec3(1, 1, 0));
    }
    s.triangles.push_back({ n, n + 1, n + 2 });
  }
  const RepairedSurface edge = repaired(s);
  EXPECT_EQ(edge.counts.splitEdges, 1);
  EXPECT_GT(edge.counts.splitVertices, 0);
  EXPECT_EQ(edge.surface.topology().components, 2);
  EXPECT_EQ(edge.surface.topology().euler, 4);

  TriangleSurface v = shapes::sphere(1, 1);
  const TriangleSurface one = v;
  const int base = static_cast<int>(v.points.size());
  for (const Vec3& p : one.points)
  {
    v.points.push_back(Vec3(2. * one.points[0] - p));
  }
  for (const Triangle& t : one.triangles)
  {
    v.triangles.push_back({ base + t[0], base + t[2], base + t[1] });
  }
  const RepairedSurface vertex = repaired(v);
  EXPECT_EQ(vertex.counts.splitEdges, 0);
  EXPECT_EQ(vertex.counts.splitVertices, 1);
  EXPECT_EQ(vertex.surface.topology().components, 2);
}

TEST(SurfaceRepair, TriangleWithoutAreaIsRemovedWithoutACrack)
{
  TriangleSurface s = shapes::cube(2);
  const TriangleSurface good = s;
  // Split an edge for one of its triangles only and fill the slit with a triangle without area.
  const int p = s.triangles[0][0];
  const int q = s.triangles[0][1];
  const int apex = s.triangles[0][2];
  const int m = static_cast<int>(s.points.size());
  s.points.push_back(Vec3(0.5 * (s.points[p] + s.points[q])));
  s.triangles[0] = { p, m, apex };
  s.triangles.push_back({ m, q, apex });
  s.triangles.push_back({ p, q, m });
  const RepairedSurface r = repaired(s);
  EXPECT_EQ(r.counts.degenerateTriangles, 1);
  EXPECT_TRUE(r.surface.topology() == good.topology());
  for (int f = 0; f < r.surface.numberOfFaces(); ++f)
  {
    EXPECT_GT(r.surface.faceArea(f), 1e-6);
  }
}

TEST(SurfaceRepair, NotANumberNamesThePoint)
{
  TriangleSurface s = shapes::cube(1);
  s.points[5][1] = std::numeric_limits<double>::quiet_NaN();
  RepairedSurface r;
  const Status status = repairSurface(shapes::toPolyData(s), r);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message().find("Point 5 "), std::string::npos);
}
