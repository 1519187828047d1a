// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The faces of machined parts: where creases part the surface, what can be unrolled, how holes are
// joined.
#include "ChartPartition.h"
#include "CreasePatches.h"
#include "FeatureDetection.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace stipple;

namespace
{
CutSurface creased(const TriangleSurface& s)
{
  CutSurface surface = shapes::cutSurface(s);
  detectFeatures(surface, {});
  return surface;
}

/// A tube about the z axis, without its lids.
TriangleSurface tube(double height, int n, int m)
{
  TriangleSurface s = shapes::cylinder(1, height, n, m);
  s.triangles.erase(std::remove_if(s.triangles.begin(), s.triangles.end(),
                      [&](const Triangle& t) {
                        return std::all_of(t.begin(), t.end(),
                          [&](int p) { return s.points[p].z() == 0 || s.points[p].z() == height; });
                      }),
    s.triangles.end());
  s.connect();
  return s;
}

/// A box whose top carries a small box, as a tower of two cubes; side: the small one's.
TriangleSurface boxOnBox(int n, double side)
{
  // The top's middle square of the grid grows the small box.
  TriangleSurface s = shapes::cube(n);
  const double low = 0.5 - 0.5 / n;
  const double high = 0.5 + 0.5 / n;
  for (Vec3& p : s.points)
  {
    // The square in the middle takes the wanted width; lines beside it stay where they are.
    for (int k = 0; k < 2; ++k)
    {
      p[k] = std::abs(p[k] - low) < 1e-9 ? 0.5 - 0.5 * side
        : std::abs(p[k] - high) < 1e-9   ? 0.5 + 0.5 * side
                                         : p[k];
    }
  }
  const auto isMiddle = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int v) {
      const Vec3& p = s.points[v];
      return p.z() == 1 && std::abs(p.x() - 0.5) < 0.51 * side + 1e-9 &&
        std::abs(p.y() - 0.5) < 0.51 * side + 1e-9;
    });
  };
  std::vector<int> lifted(s.points.size(), -1);
  std::vector<Triangle> walls;
  for (std::size_t f = 0; f < s.triangles.size(); ++f)
  {
    if (!isMiddle(s.triangles[f]))
    {
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      const int v = s.triangles[f][k];
      if (lifted[v] < 0)
      {
        lifted[v] = static_cast<int>(s.points.size());
        s.points.push_back(s.points[v] + Vec3(0, 0, side));
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      const Halfedge h = halfedgeOf(Face(static_cast<int>(f)), k);
      if (!isMiddle(s.triangles[s.twin[h].index() / 3]))
      {
        const int a = s.tail(h).index();
        const int b = s.head(h).index();
        walls.push_back({ a, b, lifted[b] });
        walls.push_back({ a, lifted[b], lifted[a] });
      }
    }
  }
  std::vector<char> lift;
  std::transform(s.triangles.begin(), s.triangles.end(), std::back_inserter(lift), isMiddle);
  for (std::size_t f = 0; f < s.triangles.size(); ++f)
  {
    for (int& v : s.triangles[f])
    {
      v = lift[f] ? lifted[v] : v;
    }
  }
  s.triangles.insert(s.triangles.end(), walls.begin(), walls.end());
  s.connect();
  return s;
}
}

TEST(CreasePatches, AreTheFacesOfACube)
{
  CutSurface surface = creased(shapes::cube(6));
  cutAlongCreases(surface);
  const std::vector<std::vector<Face>> patches = chartFaces(surface);
  ASSERT_EQ(patches.size(), 6U);
  for (const std::vector<Face>& patch : patches)
  {
    EXPECT_EQ(patch.size(), 72U);
    const Vec3 normal = surface.faceNormal(patch.front());
    EXPECT_TRUE(std::all_of(patch.begin(), patch.end(),
      [&](Face f) { return (surface.faceNormal(f) - normal).norm() < 1e-12; }));
  }
}

TEST(CreasePatches, CreasesThatEndInsideAreNotCut)
{
  CutSurface surface = shapes::cutSurface(shapes::sphere(1, 3));
  for (int h = 0; h < 30; h += 10)
  {
    surface.setSharp(Halfedge(h), true);
  }
  cutAlongCreases(surface);
  EXPECT_EQ(std::count(surface.cut.begin(), surface.cut.end(), 1), 0);
}

TEST(CreasePatches, NegligibleOnesGoToTheNeighbourWithMostOfTheirOutline)
{
  // A large small box has faces of its own: 6 of the large one's, and 5.
  CutSurface large = creased(boxOnBox(7, 0.3));
  ASSERT_EQ(large.topology().euler, 2);
  cutAlongCreases(large);
  EXPECT_EQ(chartFaces(large).size(), 11U);
  // Of side .03 each face has 1.5e-4 of the area, all five have less than a thousandth.
  CutSurface small = creased(boxOnBox(7, 0.03));
  cutAlongCreases(small);
  const std::vector<std::vector<Face>> patches = chartFaces(small);
  EXPECT_EQ(patches.size(), 6U);
  const double total = small.area();
  for (const std::vector<Face>& patch : patches)
  {
    double area = 0;
    for (const Face f : patch)
    {
      area += small.faceArea(f);
    }
    EXPECT_GT(area, NegligibleArea * total);
  }
}

TEST(CreasePatches, LidsOfTubesStayHoweverSmall)
{
  // A lid has 1 / (2 height) of the tube's area. In a short tube, where it is larger, it has always
  // been a face of its own.
  for (const double height : { 4., 700., 5000. })
  {
    CutSurface surface = creased(shapes::cylinder(1, height, 16, 40));
    cutAlongCreases(surface);
    EXPECT_EQ(chartFaces(surface).size(), 3U) << height;
  }
}

TEST(CreasePatches, TubesAndConesUnrollButHornsAndSpheresDoNot)
{
  const auto unrolls = [](const TriangleSurface& s) {
    const CutSurface surface = shapes::cutSurface(s);
    const ChartRegions regions(const_cast<CutSurface&>(surface));
    return isNearlyDevelopable(surface, regions.mesh(0));
  };
  EXPECT_TRUE(unrolls(tube(5, 16, 10)));
  EXPECT_FALSE(unrolls(shapes::sphere(1, 3))) << "4 pi";
  EXPECT_TRUE(unrolls(shapes::saddle(20)));
  // A pyramid without its base: the defect at its tip is 2 pi (1 - sin(half its angle)).
  const auto pyramid = [](double height) {
    TriangleSurface s;
    s.points = { { 0, 0, height }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } };
    s.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 } };
    s.connect();
    return s;
  };
  EXPECT_TRUE(unrolls(pyramid(0.5)));
  EXPECT_FALSE(unrolls(pyramid(4))) << "a spike: nearly 2 pi";
}

TEST(CreasePatches, JoinedLoopsLeaveADisk)
{
  CutSurface surface = shapes::cutSurface(tube(5, 16, 10));
  ChartRegions regions(surface);
  ASSERT_EQ(regions.mesh(0).boundaryLoops, 2);
  regions.clearChanges(0);
  const std::vector<Halfedge> opened = joinLoops(regions, 0);
  EXPECT_EQ(opened.size(), 10U) << "straight along the tube";
  double length = 0;
  for (const Halfedge h : opened)
  {
    EXPECT_TRUE(surface.cut[h]);
    length += surface.edgeLength(h);
  }
  EXPECT_NEAR(length, 5, 1e-12);
  EXPECT_TRUE(regions.mesh(0).isDisk());
  EXPECT_TRUE(regions.isReshaped(0));
  regions.closeCuts(0, opened);
  EXPECT_EQ(regions.mesh(0).boundaryLoops, 2) << "as it was";
}

TEST(CreasePatches, SeamsOfAPartLieOnItsCreasesOrAreStraight)
{
  // A box on a box: its charts have creases for seams, but for the slit from hole to outline.
  CutSurface surface = creased(boxOnBox(7, 0.3));
  std::vector<FlatChart> charts;
  ASSERT_TRUE(partitionSurface(surface, {}, charts, {}).ok());
  EXPECT_LE(charts.size(), 4U);
  double onCrease = 0;
  double elsewhere = 0;
  for (const Halfedge h : surface.halfedges())
  {
    if (surface.cut[h])
    {
      (surface.sharp[h] ? onCrease : elsewhere) += 0.5 * surface.edgeLength(h);
    }
  }
  EXPECT_GT(onCrease, 1);
  EXPECT_LT(elsewhere, 0.36) << "the ring around the small box is .35 wide";
  for (const FlatChart& chart : charts)
  {
    EXPECT_TRUE(chart.map.valid);
    EXPECT_LE(chart.map.densityRatio, 100);
  }
}
