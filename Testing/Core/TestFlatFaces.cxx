// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AtlasSurface.h"
#include "FlatFaceCells.h"
#include "FlatFaces.h"
#include "PolyDataConversion.h"
#include "Shapes.h"
#include "SurfaceArrays.h"

#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace stipple;

namespace
{
const MayFlip Always = [](Halfedge, double, double) { return true; };

/// An ellipse as a fan about its first corner, bent by so much.
TriangleSurface fan(int corners, double bulge = 0.)
{
  TriangleSurface s;
  for (int i = 0; i < corners; ++i)
  {
    const double x = 2. * std::cos(2. * Pi * i / corners);
    const double y = std::sin(2. * Pi * i / corners);
    s.points.emplace_back(x, y, bulge * (x * x + 0.5 * x * y));
  }
  for (int i = 1; i + 1 < corners; ++i)
  {
    s.triangles.push_back({ 0, i, i + 1 });
  }
  s.connect();
  return s;
}

/// A prism with such a fan at each end.
TriangleSurface prism(int corners)
{
  TriangleSurface s;
  for (int i = 0; i < 2 * corners; ++i)
  {
    const double angle = 2. * Pi * (i % corners) / corners;
    s.points.emplace_back(2. * std::cos(angle), std::sin(angle), i / corners);
  }
  for (int i = 1; i + 1 < corners; ++i)
  {
    s.triangles.push_back({ 0, i + 1, i });
    s.triangles.push_back({ corners, corners + i, corners + i + 1 });
  }
  for (int i = 0; i < corners; ++i)
  {
    const int j = (i + 1) % corners;
    s.triangles.push_back({ i, j, corners + j });
    s.triangles.push_back({ i, corners + j, corners + i });
  }
  s.connect();
  return s;
}

RepairedSurface repairedFrom(const TriangleSurface& s)
{
  RepairedSurface repaired;
  EXPECT_TRUE(repairSurface(toPolyData(s.points, s.triangles), repaired).ok());
  return repaired;
}

CutSurface cutFrom(const RepairedSurface& repaired)
{
  return CutSurface(repaired.surface, repaired.sourceCell);
}

/// Largest sum of the two angles over an edge between two triangles.
double largestSumOfAngles(const CutSurface& s)
{
  const auto angle = [&](Halfedge h) {
    const Vec3& apex = s.point(s.tail(previousHalfedge(h)));
    const Vec3 u = s.point(s.tail(h)) - apex;
    const Vec3 w = s.point(s.head(h)) - apex;
    return std::atan2(u.cross(w).norm(), u.dot(w));
  };
  double largest = 0;
  for (const Halfedge h : s.halfedges())
  {
    largest = s.twin[h].valid() ? std::max(largest, angle(h) + angle(s.twin[h])) : largest;
  }
  return largest;
}

/// The halfedge of the edge from p to q.
Halfedge halfedge(const CutSurface& s, int p, int q)
{
  for (const Halfedge h : s.halfedges())
  {
    if (s.tail(h).index() == p && s.head(h).index() == q)
    {
      return h;
    }
  }
  return {};
}

bool isIn(const Vec3& p, const std::array<Vec3, 3>& t)
{
  return barycentricInSpace(p, t[0], t[1], t[2]).minCoeff() > -1e-9;
}
}

TEST(FlatFaces, AreDelaunayAfterwardsAndTheSameSurface)
{
  for (const int corners : { 24, 40, 97 })
  {
    const RepairedSurface repaired = repairedFrom(fan(corners));
    CutSurface surface = cutFrom(repaired);
    const double area = surface.area();
    const SurfaceTopology topology = surface.topology();
    ASSERT_GT(largestSumOfAngles(surface), Pi + 1e-3);
    triangulateFlatFaces(surface, Always);
    EXPECT_LE(largestSumOfAngles(surface), Pi + 1e-3) << corners;
    EXPECT_NEAR(surface.area(), area, 1e-12 * area);
    EXPECT_TRUE(surface.topology() == topology);
    const HalfedgeTwins kept = surface.twin;
    surface.connect();
    EXPECT_TRUE(std::equal(kept.begin(), kept.end(), surface.twin.begin()));
  }
}

TEST(FlatFaces, FanIsNoFanAnyMore)
{
  const RepairedSurface repaired = repairedFrom(fan(40));
  CutSurface surface = cutFrom(repaired);
  const auto joined = triangulateFlatFaces(surface, Always);
  EXPECT_GT(joined.size(), 10U);
  EXPECT_LE(largestSumOfAngles(surface), Pi + 1e-3);
  int atFirst = 0;
  for (const Triangle& t : surface.triangles)
  {
    atFirst += std::find(t.begin(), t.end(), 0) != t.end() ? 1 : 0;
  }
  EXPECT_LT(atFirst, 20);
}

TEST(FlatFaces, WhatIsNotFlatStays)
{
  for (const double bulge : { 1e-3, 0.1 })
  {
    const RepairedSurface repaired = repairedFrom(fan(12, bulge));
    CutSurface surface = cutFrom(repaired);
    EXPECT_TRUE(triangulateFlatFaces(surface, Always).empty()) << bulge;
  }
}

TEST(FlatFaces, WhatIsHardlyBentMovesByNoMoreThanItMay)
{
  // A gutter of thin strips, as programs write a cylinder: each flip moves the surface a little,
  // and all of them together no farther than one may.
  TriangleSurface s;
  const int strips = 400;
  const auto bend = [](double x) { return 2e-3 * x * x; };
  for (int i = 0; i <= strips; ++i)
  {
    const double x = static_cast<double>(i) / strips;
    for (const double y : { 0., 0.37, 0.71, 1. })
    {
      s.points.emplace_back(x, y + (y > 0 && y < 1 ? 0.02 * (i * 7 % 11) : 0.), bend(x));
    }
  }
  for (int i = 0; i < strips; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const int a = 4 * i + j;
      s.triangles.push_back({ a, a + 4, a + 5 });
      s.triangles.push_back({ a, a + 5, a + 1 });
    }
  }
  s.connect();
  const RepairedSurface repaired = repairedFrom(s);
  CutSurface surface = cutFrom(repaired);
  const auto joined = triangulateFlatFaces(surface, Always);
  EXPECT_GT(joined.size(), 400U);
  const double most = 5e-6 * surface.boundingBoxDiagonal();
  double farthest = 0;
  for (const Face f : surface.faces())
  {
    for (const Vec3& bary :
      { Vec3(1. / 3, 1. / 3, 1. / 3), Vec3(0.5, 0.5, 0), Vec3(0, 0.5, 0.5), Vec3(0.5, 0, 0.5) })
    {
      const Vec3 p = bary[0] * surface.point(f, 0) + bary[1] * surface.point(f, 1) +
        bary[2] * surface.point(f, 2);
      const double i = std::min(std::floor(p.x() * strips), strips - 1.);
      const double share = p.x() * strips - i;
      const double before = (1 - share) * bend(i / strips) + share * bend((i + 1) / strips);
      farthest = std::max(farthest, std::abs(p.z() - before));
    }
  }
  EXPECT_LE(farthest, most);
  EXPECT_GT(farthest, 0.02 * most) << "some flip moved it";
}

TEST(FlatFaces, WhatHasNoSliverStays)
{
  CutSurface surface = cutFrom(repairedFrom(fan(6)));
  EXPECT_GT(largestSumOfAngles(surface), Pi + 0.5); // it would be flipped
  EXPECT_TRUE(triangulateFlatFaces(surface, Always).empty());
}

TEST(FlatFaces, MarkedEdgesStay)
{
  TriangleSurface s; // a long diagonal of a kite
  s.points = { Vec3(-4, 0, 0), Vec3(4, 0, 0), Vec3(0, 0.5, 0), Vec3(0, -0.6, 0) };
  s.triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
  s.connect();
  const RepairedSurface repaired = repairedFrom(s);
  const auto flips = [&](const std::function<void(CutSurface&, Halfedge)>& mark,
                       const MayFlip& mayFlip = Always) {
    CutSurface surface = cutFrom(repaired);
    mark(surface, halfedge(surface, 0, 1));
    return triangulateFlatFaces(surface, mayFlip).size();
  };
  EXPECT_EQ(flips([](CutSurface&, Halfedge) {}), 1U);
  EXPECT_EQ(flips([](CutSurface& c, Halfedge h) { c.setSharp(h, true); }), 0U);
  EXPECT_EQ(flips([](CutSurface& c, Halfedge h) { c.setCut(h, true); }), 0U);
  EXPECT_EQ(flips([](CutSurface& c, Halfedge h) { c.setKeep(h, Keep::Border); }), 0U);
  EXPECT_EQ(
    flips([](CutSurface&, Halfedge) {}, [](Halfedge, double, double) { return false; }), 0U);
  const auto noted = [](Halfedge, double along, double across) {
    EXPECT_NEAR(along, 0.5, 1e-12);
    EXPECT_NEAR(std::min(across, 1 - across), 0.5 / 1.1, 1e-12);
    return true;
  };
  EXPECT_EQ(flips([](CutSurface&, Halfedge) {}, noted), 1U);
}

TEST(FlatFaces, AFlipCarriesMarksOfTheSides)
{
  CutSurface surface = cutFrom(repairedFrom(fan(6)));
  surface.setSharp(halfedge(surface, 1, 2), true);
  surface.setKeep(halfedge(surface, 2, 3), Keep::Line);
  surface.setCut(halfedge(surface, 0, 3), true);
  const Halfedge h = halfedge(surface, 0, 2);
  ASSERT_TRUE(h.valid());
  surface.flipEdge(h);
  EXPECT_FALSE(halfedge(surface, 0, 2).valid());
  ASSERT_TRUE(halfedge(surface, 1, 3).valid() || halfedge(surface, 3, 1).valid());
  EXPECT_NE(surface.sharp[halfedge(surface, 1, 2)], 0);
  EXPECT_EQ(surface.keep[halfedge(surface, 2, 3)], Keep::Line);
  EXPECT_NE(surface.cut[halfedge(surface, 0, 3)], 0);
  EXPECT_NE(surface.cut[halfedge(surface, 3, 0)], 0);
  EXPECT_EQ(surface.cut[h], 0);
  const HalfedgeTwins kept = surface.twin;
  surface.connect();
  EXPECT_TRUE(std::equal(kept.begin(), kept.end(), surface.twin.begin()));
}

TEST(FlatFaces, OnlyWhereArraysStayAsTheyAre)
{
  const TriangleSurface s = fan(40);
  const vtkSmartPointer<vtkPolyData> input = toPolyData(s.points, s.triangles);
  RepairedSurface repaired;
  ASSERT_TRUE(repairSurface(input, repaired).ok());
  const auto flips = [&](vtkAbstractArray* atPoints, vtkAbstractArray* atCells) {
    vtkNew<vtkPolyData> data;
    data->ShallowCopy(input);
    if (atPoints)
    {
      atPoints->SetName("a");
      data->GetPointData()->AddArray(atPoints);
    }
    if (atCells)
    {
      atCells->SetName("c");
      data->GetCellData()->AddArray(atCells);
    }
    CutSurface surface = cutFrom(repaired);
    const ArraysOverEdges arrays(data, repaired, surface);
    return triangulateFlatFaces(surface, [&](Halfedge h, double along, double across) {
      return arrays.allowFlip(h, along, across);
    }).size();
  };
  vtkNew<vtkDoubleArray> linear;
  vtkNew<vtkDoubleArray> curved;
  vtkNew<vtkIntArray> one;
  vtkNew<vtkIntArray> many;
  for (const Vec3& p : s.points)
  {
    linear->InsertNextValue(2. * p.x() - p.y() + 5.);
    curved->InsertNextValue(p.x() * p.x());
    one->InsertNextValue(7);
    many->InsertNextValue(static_cast<int>(many->GetNumberOfTuples()));
  }
  vtkNew<vtkIntArray> region;
  vtkNew<vtkIntArray> halves;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
  {
    region->InsertNextValue(3);
    halves->InsertNextValue(t < s.triangles.size() / 2 ? 0 : 1);
  }
  const std::size_t all = flips(nullptr, nullptr);
  ASSERT_GT(all, 10U);
  EXPECT_EQ(flips(linear, region), all);
  EXPECT_EQ(flips(one, nullptr), all);
  EXPECT_EQ(flips(curved, nullptr), 0U);
  EXPECT_EQ(flips(many, nullptr), 0U);
  EXPECT_LT(flips(nullptr, halves), all);
}

TEST(FlatFaceCells, GoThroughFieldDataAndAreFoundByPlace)
{
  FlatFaceCells faces;
  EXPECT_TRUE(faces.empty());
  const auto square = [](double x, int first) {
    const Vec3 a(x, 0, 0);
    const Vec3 b(x + 1, 0, 0);
    const Vec3 c(x + 1, 1, 0);
    const Vec3 d(x, 1, 0);
    return std::vector<FlatFaceCells::Piece>{ { first, { { a, b, c } } },
      { first + 1, { { a, c, d } } } };
  };
  faces.add(square(0., 10));
  faces.add(square(0., 20)); // another sheet at the same place
  faces.add(square(5., 30));
  EXPECT_EQ(faces.faceOf(11), 0);
  EXPECT_EQ(faces.faceOf(12), -1);
  vtkNew<vtkPolyData> chart;
  faces.write({ 4, 11, 20 }, chart->GetFieldData());
  FlatFaceCells read;
  ASSERT_TRUE(read.read(chart->GetFieldData(), "Chart 0").ok());
  ASSERT_TRUE(read.read(chart->GetFieldData(), "Chart 1").ok()); // the same once more
  EXPECT_EQ(read.size(), 2);
  FlatFaceLocator locator(read);
  EXPECT_EQ(locator.cellAt(10, Vec3(0.9, 0.1, 0)), 10);
  EXPECT_EQ(locator.cellAt(10, Vec3(0.1, 0.9, 0)), 11);
  EXPECT_EQ(locator.cellAt(21, Vec3(0.9, 0.1, 0)), 20);
  EXPECT_EQ(locator.cellAt(30, Vec3(0.1, 0.9, 0)), 30); // on none of these
  FlatFaceCells none;
  vtkNew<vtkPolyData> elsewhere;
  faces.write({ 4 }, elsewhere->GetFieldData());
  EXPECT_TRUE(none.read(elsewhere->GetFieldData(), "Chart 0").ok());
  EXPECT_TRUE(none.empty());
}

TEST(FlatFaceCells, WrongArraysAreErrors)
{
  FlatFaceCells faces;
  faces.add({ { 1, { { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0) } } },
    { 2, { { Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0) } } } });
  const auto readChanged = [&](const std::function<void(vtkFieldData*)>& change) {
    vtkNew<vtkPolyData> chart;
    faces.write({ 1 }, chart->GetFieldData());
    change(chart->GetFieldData());
    return FlatFaceCells().read(chart->GetFieldData(), "Chart 0").ok();
  };
  EXPECT_TRUE(readChanged([](vtkFieldData*) {}));
  EXPECT_FALSE(readChanged([](vtkFieldData* d) { d->RemoveArray("FlatFaceCells"); }));
  EXPECT_FALSE(readChanged([](vtkFieldData* d) { d->RemoveArray("FlatFaceCorners"); }));
  EXPECT_FALSE(
    readChanged([](vtkFieldData* d) { d->GetArray("FlatFaceCells")->SetComponent(0, 0, -1); }));
  EXPECT_FALSE(
    readChanged([](vtkFieldData* d) { d->GetArray("FlatFaceOffsets")->SetComponent(1, 0, -5); }));
  EXPECT_FALSE(
    readChanged([](vtkFieldData* d) { d->GetArray("FlatFaceOffsets")->SetComponent(1, 0, 1e9); }));
}

TEST(FlatFaceCells, EveryPlaceOfAnAtlasIsInItsCell)
{
  const TriangleSurface s = prism(60);
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(toPolyData(s.points, s.triangles));
  atlas->Update();
  AtlasSurface surface;
  ASSERT_TRUE(readAtlas(atlas->GetOutput(), surface).ok());
  EXPECT_FALSE(surface.flatFaces.empty());
  EXPECT_NEAR(surface.area(), s.area(), 1e-9 * s.area());
  FlatFaceLocator locator(surface.flatFaces);
  int others = 0;
  for (const Face f : surface.faces())
  {
    const Vec3 place = surface.position(f, Vec3(0.5, 0.3, 0.2));
    const int cell = locator.cellAt(surface.sourceCell[f], place);
    const Triangle& t = s.triangles[static_cast<std::size_t>(cell)];
    EXPECT_TRUE(isIn(place, { { s.points[t[0]], s.points[t[1]], s.points[t[2]] } }));
    others += cell != surface.sourceCell[f] ? 1 : 0;
  }
  EXPECT_GT(others, 0); // else this shows nothing
}
