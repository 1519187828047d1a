// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CutSurface.h"
#include "FeatureDetection.h"
#include "Shapes.h"
#include "SurfaceRepair.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

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

TEST(SurfaceRepair, CopiesOfPartsAreDropped)
{
  const TriangleSurface saddle = shapes::saddle(6);
  for (const TriangleSurface& shape : { saddle, shapes::sphere(1, 2) })
  {
    const int n = static_cast<int>(shape.triangles.size());
    for (const bool turned : { false, true })
    {
      // Twice whole, and the first half once more, each with points of its own; the points are not
      // in the same order.
      TriangleSurface copies = shape;
      for (const int number : { n, n / 2 })
      {
        const int first = static_cast<int>(copies.points.size());
        const int last = static_cast<int>(shape.points.size()) - 1;
        copies.points.insert(copies.points.end(), shape.points.rbegin(), shape.points.rend());
        for (int f = 0; f < number; ++f)
        {
          Triangle t = shape.triangles[f];
          for (int& p : t)
          {
            p = first + last - p;
          }
          if (turned)
          {
            std::swap(t[0], t[1]);
          }
          copies.triangles.push_back(t);
        }
      }
      const RepairedSurface r = repaired(copies);
      EXPECT_EQ(r.surface.triangles, shape.triangles);
      EXPECT_EQ(r.counts.duplicateTriangles, n + n / 2);
      EXPECT_EQ(r.counts.splitEdges + r.counts.degenerateTriangles, 0);
    }
  }
  // What has one triangle more is no copy.
  TriangleSurface more = saddle;
  const int first = static_cast<int>(more.points.size());
  more.points.insert(more.points.end(), saddle.points.begin(), saddle.points.end());
  more.points.push_back(saddle.points[0] + Vec3(0, 0, 1));
  for (const Triangle& t : saddle.triangles)
  {
    more.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  }
  more.triangles.push_back({ first + 1, first, static_cast<int>(more.points.size()) - 1 });
  EXPECT_LT(repaired(more).counts.duplicateTriangles, 3)
    << "but at corners, once the rim is welded";
}

TEST(SurfaceRepair, ClosedSurfacesThatTouchAreLeftAlone)
{
  // Two cubes with a face in common, each with its own points: welded, the face would be gone, and
  // its edges would be those of four triangles.
  TriangleSurface both = shapes::cube(2);
  const TriangleSurface cube = both;
  const double side = std::sqrt(cube.area() / 6.);
  const int n = static_cast<int>(cube.points.size());
  for (const Vec3& p : cube.points)
  {
    both.points.emplace_back(p + Vec3(side, 0, 0));
  }
  for (const Triangle& t : cube.triangles)
  {
    both.triangles.push_back({ t[0] + n, t[1] + n, t[2] + n });
  }
  both.connect();
  const RepairedSurface r = repaired(both);
  EXPECT_EQ(r.counts.weldedPoints, 0);
  EXPECT_EQ(r.counts.splitEdges, 0);
  EXPECT_TRUE(r.surface.topology() == both.topology());
  EXPECT_EQ(r.surface.topology().components, 2);
  EXPECT_EQ(r.surface.topology().boundaryLoops, 0);
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
  const RepairedSurface edge = repaired(exploded(s));
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
    const auto mirrored = [&](int p) { return p == 0 ? 0 : base + p; };
    v.triangles.push_back({ mirrored(t[0]), mirrored(t[2]), mirrored(t[1]) });
  }
  const RepairedSurface vertex = repaired(v);
  EXPECT_EQ(vertex.counts.splitEdges, 0);
  EXPECT_EQ(vertex.counts.splitVertices, 1);
  EXPECT_EQ(vertex.surface.topology().components, 2);
}

TEST(SurfaceRepair, ASheetHasAFeatureWhereAnotherOneMeetsIt)
{
  // A wall that stands on a flat sheet, all the way across or on a short piece of it.
  const int n = 8;
  for (const int last : { n, 1 })
  {
    TriangleSurface s = shapes::grid(n);
    const auto row = [&](double z) {
      std::vector<int> ids;
      for (int i = 0; i <= last; ++i)
      {
        const Vec3 place(static_cast<double>(i) / n, 0.5, 0);
        const auto at = std::find_if(s.points.begin(), s.points.end(),
          [&](const Vec3& p) { return (p - place).norm() < 1e-9; });
        if (z == 0 && at != s.points.end())
        {
          ids.push_back(static_cast<int>(at - s.points.begin()));
          continue;
        }
        ids.push_back(static_cast<int>(s.points.size()));
        s.points.push_back(Vec3(place + Vec3(0, 0, z)));
      }
      return ids;
    };
    const std::vector<int> foot = row(0);
    const std::vector<int> top = row(0.5);
    ASSERT_EQ(s.points.size(), static_cast<std::size_t>((n + 1) * (n + 1) + last + 1));
    for (int i = 0; i < last; ++i)
    {
      s.triangles.push_back({ foot[i], foot[i + 1], top[i + 1] });
      s.triangles.push_back({ foot[i], top[i + 1], top[i] });
    }
    const RepairedSurface r = repaired(s);
    EXPECT_EQ(r.counts.splitEdges, last);
    EXPECT_EQ(r.surface.topology().components, 2);
    ASSERT_EQ(r.joints.size(), static_cast<std::size_t>(last));
    CutSurface cut(r.surface, r.sourceCell);
    FeatureDetectionOptions options;
    options.minimumLength = 0.2;
    detectFeatures(cut, options, r.joints);
    int sharp = 0;
    for (const Halfedge h : cut.halfedges())
    {
      if (cut.sharp[h] != 0 && cut.twin[h] > h)
      {
        ++sharp;
        EXPECT_NEAR(cut.points[cut.tail(h).index()].y(), 0.5, 1e-12);
        EXPECT_NEAR(cut.points[cut.head(h).index()].y(), 0.5, 1e-12);
      }
    }
    EXPECT_EQ(sharp, last == n ? n : 0) << "short ones are none";
  }
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

namespace
{
/// A strip of n x m squares, cut in two, around the z axis; half a turn makes it a Moebius strip.
TriangleSurface moebiusStrip(int n, int m)
{
  TriangleSurface s;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j <= m; ++j)
    {
      const double u = 2 * Pi * i / n;
      const double v = 0.8 * (static_cast<double>(j) / m - 0.5);
      const double r = 1 + v * std::cos(u / 2);
      s.points.emplace_back(r * std::cos(u), r * std::sin(u), v * std::sin(u / 2));
    }
  }
  const auto id = [&](int i, int j) { return i < n ? i * (m + 1) + j : m - j; };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      s.triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      s.triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return s;
}

double leastHeight(const TriangleSurface& s)
{
  double least = std::numeric_limits<double>::infinity();
  for (int f = 0; f < s.numberOfFaces(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double side = (s.point(f, (k + 1) % 3) - s.point(f, k)).norm();
      least = std::min(least, 2 * s.faceArea(f) / side);
    }
  }
  return least;
}
}

TEST(SurfaceRepair, MoebiusStripIsCutStraightAcross)
{
  const RepairedSurface r = repaired(moebiusStrip(60, 6));
  const SurfaceTopology topology = r.surface.topology();
  EXPECT_EQ(topology.components, 1);
  EXPECT_EQ(topology.boundaryLoops, 1);
  EXPECT_EQ(topology.euler, 1) << "a strip";
  EXPECT_LE(r.counts.splitVertices, 2 * 7);
  EXPECT_EQ(r.surface.numberOfFaces(), 2 * 60 * 6);
}

TEST(SurfaceRepair, TriangleThatRoundingKeepsFromHavingNoAreaIsRemoved)
{
  for (const double off : { 1e-17, 1e-12, -1e-9 })
  {
    TriangleSurface s = shapes::sphere(1, 3);
    const TriangleSurface good = s;
    int added = 0;
    for (int f = 0; f < good.numberOfFaces(); f += 7)
    {
      const Triangle t = s.triangles[f];
      const int m = static_cast<int>(s.points.size());
      s.points.push_back(Vec3(0.5 * (s.points[t[0]] + s.points[t[1]]) + off * good.faceNormal(f)));
      s.triangles[f] = { t[0], m, t[2] };
      s.triangles.push_back({ m, t[1], t[2] });
      s.triangles.push_back({ t[0], t[1], m });
      ++added;
    }
    const RepairedSurface r = repaired(s);
    EXPECT_EQ(r.counts.degenerateTriangles, added) << off;
    EXPECT_TRUE(r.surface.topology() == good.topology()) << off;
    EXPECT_GT(leastHeight(r.surface), 0.01) << off;
    EXPECT_NEAR(r.surface.area(), good.area(), 1e-6) << off;
  }
}

TEST(SurfaceRepair, NeedlesAreCollapsed)
{
  // Some points doubled, a hair apart: two needles between the two copies.
  TriangleSurface s = shapes::torus(2, 0.7, 40, 20);
  const TriangleSurface good = s;
  const auto first = good.vertexHalfedges();
  int needles = 0;
  for (int p = 0; p < 800; p += 90)
  {
    const int h = first[p];
    const int g = good.twin[previousHalfedge(good.twin[previousHalfedge(h)])];
    const int copy = static_cast<int>(s.points.size());
    s.points.push_back(Vec3(s.points[p] + Vec3(1e-10, -1e-10, 2e-10)));
    // The fan from h up to g takes the copy; along both of its ends a needle opens.
    for (int c = h; c != g; c = good.twin[previousHalfedge(c)])
    {
      s.triangles[c / 3][c % 3] = copy;
    }
    s.triangles.push_back({ copy, p, good.head(h) });
    s.triangles.push_back({ p, copy, good.head(g) });
    needles += 2;
  }
  s.connect();
  ASSERT_TRUE(s.topology() == good.topology());
  const RepairedSurface r = repaired(s);
  EXPECT_EQ(r.counts.degenerateTriangles, needles);
  EXPECT_EQ(r.surface.points.size(), good.points.size());
  EXPECT_TRUE(r.surface.topology() == good.topology());
  EXPECT_GT(leastHeight(r.surface), 0.01);
}

TEST(SurfaceRepair, ThinTrianglesAtTheBoundaryAreDropped)
{
  TriangleSurface s = shapes::saddle(8);
  const TriangleSurface good = s;
  int added = 0;
  for (int h = 0; h < 3 * good.numberOfFaces(); h += 1)
  {
    if (good.twin[h] < 0 && h % 2 == 0)
    {
      const int f = h / 3;
      const int k = h % 3;
      const Triangle t = s.triangles[f];
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      const int c = t[(k + 2) % 3];
      const int m = static_cast<int>(s.points.size());
      const Vec3 inwards = s.points[c] - s.points[a];
      s.points.push_back(Vec3(0.5 * (s.points[a] + s.points[b]) + 1e-10 * inwards));
      if (t == good.triangles[f])
      {
        s.triangles[f] = { a, m, c };
        s.triangles.push_back({ m, b, c });
        s.triangles.push_back({ a, b, m });
        ++added;
      }
    }
  }
  ASSERT_GT(added, 4);
  const RepairedSurface r = repaired(s);
  EXPECT_EQ(r.counts.degenerateTriangles, added);
  EXPECT_TRUE(r.surface.topology() == good.topology());
  EXPECT_GT(leastHeight(r.surface), 0.01);
  EXPECT_NEAR(r.surface.area(), good.area(), 1e-6);
}

TEST(SurfaceRepair, NothingIsLeftOfASurfaceThatIsAllThin)
{
  TriangleSurface s;
  s.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1e-9, 0), Vec3(2, 1e-9, 0) };
  s.triangles = { { 0, 1, 2 }, { 1, 3, 2 } };
  const RepairedSurface r = repaired(s);
  EXPECT_EQ(r.surface.numberOfFaces(), 0);
  EXPECT_EQ(r.counts.degenerateTriangles, 2);
}

TEST(SurfaceRepair, PolygonsThatAreNotConvexAreCovered)
{
  // A fan from the first corner would leave the L.
  vtkNew<vtkPoints> points;
  for (const auto& [x, y] : { std::pair(4, 1), { 1, 1 }, { 1, 3 }, { 0, 3 }, { 0, 0 }, { 4, 0 } })
  {
    points->InsertNextPoint(x, y, 7);
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3, 4, 5 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polys);
  RepairedSurface r;
  ASSERT_TRUE(repairSurface(data, r).ok());
  EXPECT_EQ(r.surface.numberOfFaces(), 4);
  EXPECT_NEAR(r.surface.area(), 6, 1e-12);
  for (int f = 0; f < 4; ++f)
  {
    EXPECT_EQ(r.surface.faceNormal(f), Vec3(0, 0, 1));
  }
}

TEST(SurfaceRepair, CornersOnAPolygonsSideLeaveNoFlatTriangle)
{
  vtkNew<vtkPoints> points;
  for (const auto& [x, y] :
    { std::pair(0, 0), { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 3 }, { 1, 3 }, { 0, 3 } })
  {
    points->InsertNextPoint(x, y, 0);
  }
  for (vtkIdType first = 0; first < 7; ++first)
  {
    vtkNew<vtkCellArray> polys;
    polys->InsertNextCell(7);
    for (vtkIdType k = 0; k < 7; ++k)
    {
      polys->InsertCellPoint((first + k) % 7);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(polys);
    RepairedSurface r;
    ASSERT_TRUE(repairSurface(data, r).ok());
    EXPECT_NEAR(r.surface.area(), 9, 1e-12);
    EXPECT_EQ(r.surface.numberOfFaces(), 5);
    EXPECT_GT(leastHeight(r.surface), 0.1);
  }
}

TEST(SurfaceRepair, SizesBeyondSinglePrecisionAreRefused)
{
  for (const double scale : { 1e-200, 1e-16, 1e16, 1e150 })
  {
    TriangleSurface s = shapes::cube(2);
    for (Vec3& p : s.points)
    {
      p *= scale;
    }
    RepairedSurface r;
    const Status status = repairSurface(shapes::toPolyData(s), r);
    EXPECT_FALSE(status.ok()) << scale;
    EXPECT_NE(status.message().find("scale it to between 1e-15 and 1e+15"), std::string::npos)
      << status.message();
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

TEST(SurfaceRepair, APointOfVeryManyTrianglesTakesNoMoreTimeThanItsTriangles)
{
  // Pairing each halfedge with each other one at the point would take hours: ctest's limit fails.
  constexpr int n = 500000;
  TriangleSurface s;
  s.points.emplace_back(0, 0, 0);
  for (int i = 0; i < n; ++i)
  {
    const double a = 2 * Pi * i / n;
    s.points.emplace_back(std::cos(a), std::sin(a), 0);
    s.triangles.push_back({ 0, 1 + i, 1 + (i + 1) % n });
  }
  s.connect();
  const SurfaceTopology topology = s.topology();
  EXPECT_TRUE(topology.manifold);
  EXPECT_EQ(topology.euler, 1);
  EXPECT_EQ(topology.boundaryLoops, 1);
}

namespace
{
/// A torus as formulas make it: the last row and column of points lie where the first do, but for
/// rounding.
TriangleSurface formulaTorus(int n, double scale, const Vec3& center, bool single)
{
  TriangleSurface torus = shapes::grid(n);
  const double turn = 2 * std::acos(-1.);
  for (Vec3& p : torus.points)
  {
    const double u = turn * p.x();
    const double v = turn * p.y();
    const Vec3 x(
      (2 + std::cos(v)) * std::cos(u + .3), (2 + std::cos(v)) * std::sin(u + .3), std::sin(v + .1));
    p = center + scale * x;
    p = single ? Vec3(p.cast<float>().cast<double>()) : p;
  }
  return torus;
}
}

TEST(SurfaceRepair, SeamsThatRoundingOpensAreWelded)
{
  for (const bool single : { false, true })
  {
    for (const double scale : { 1e-6, 1., 1e6 })
    {
      const RepairedSurface r = repaired(formulaTorus(24, scale, scale * Vec3(5, -3, 2), single));
      const SurfaceTopology topology = r.surface.topology();
      EXPECT_EQ(topology.euler, 0) << single << " " << scale;
      EXPECT_EQ(topology.boundaryLoops, 0);
      EXPECT_EQ(topology.components, 1);
      EXPECT_EQ(r.counts.weldedPoints, 49);
      EXPECT_EQ(r.pointOfInput.back(), r.pointOfInput.front());
    }
  }
  // Rounded first, then turned.
  TriangleSurface turned = formulaTorus(24, 1., Vec3::Zero(), true);
  for (Vec3& p : turned.points)
  {
    p = 1e9 * Vec3(.6 * p.x() - .8 * p.y(), .8 * p.x() + .6 * p.y(), p.z());
  }
  EXPECT_EQ(repaired(turned).surface.topology().boundaryLoops, 0);
}

TEST(SurfaceRepair, SlitsWiderThanRoundingStayOpen)
{
  // Two squares side by side, a millionth apart.
  TriangleSurface squares;
  for (const double x : { 0., 1 + 1e-6 })
  {
    const int n = static_cast<int>(squares.points.size());
    for (const Vec3& p : { Vec3(0, 0, .1), Vec3(1, 0, .1), Vec3(1, 1, .1), Vec3(0, 1, .1) })
    {
      squares.points.push_back(p + Vec3(x, 0, 0));
    }
    squares.triangles.push_back({ n, n + 1, n + 2 });
    squares.triangles.push_back({ n, n + 2, n + 3 });
  }
  const RepairedSurface r = repaired(squares);
  EXPECT_EQ(r.counts.weldedPoints, 0);
  EXPECT_EQ(r.surface.topology().components, 2);
}

TEST(SurfaceRepair, NothingIsLeftOfASurfaceAsSmallAsRounding)
{
  TriangleSurface speck;
  const float ulp = std::numeric_limits<float>::epsilon();
  speck.points = { Vec3(1, 1, 0), Vec3(1. + ulp, 1, 0), Vec3(1, 1. + ulp, 0) };
  speck.triangles = { { 0, 1, 2 } };
  const RepairedSurface r = repaired(speck);
  EXPECT_EQ(r.surface.numberOfFaces(), 0);
  EXPECT_EQ(r.counts.degenerateTriangles, 1);
}
