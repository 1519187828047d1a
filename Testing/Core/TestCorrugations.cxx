// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Ridges and grooves in turn, on sheets with a profile, and the sections that tell them.
#include "Corrugations.h"
#include "FeatureDetection.h"
#include "FeatureGraphBuilder.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"
#include "Shapes.h"
#include "SurfaceSection.h"

#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

using namespace stipple;

namespace
{
constexpr int Rows = 6;

/// A sheet that has a profile in x and z, and is as wide as that in y.
CutSurface sheetOf(const std::vector<Vec2>& profile)
{
  TriangleSurface sheet;
  const auto columns = static_cast<int>(profile.size());
  const double step = (profile.back() - profile.front()).norm() / (Rows - 1);
  for (int j = 0; j < Rows; ++j)
  {
    for (const Vec2& p : profile)
    {
      sheet.points.emplace_back(p.x(), j * step, p.y());
    }
  }
  for (int j = 0; j + 1 < Rows; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const int a = j * columns + i;
      sheet.triangles.push_back({ { a, a + 1, a + columns + 1 } });
      sheet.triangles.push_back({ { a, a + columns + 1, a + columns } });
    }
  }
  sheet.connect();
  return shapes::cutSurface(sheet);
}

/// Flat, then so many teeth 1 wide, then flat.
std::vector<Vec2> saw(int teeth, double height)
{
  std::vector<Vec2> profile = { { -4, 0 } };
  for (int i = 0; i < teeth; ++i)
  {
    profile.emplace_back(i, 0);
    profile.emplace_back(i + 0.5, height);
  }
  profile.emplace_back(teeth, 0);
  profile.emplace_back(teeth + 4, 0);
  return profile;
}

/// The edge of the sheet's third row at a place of the profile.
Halfedge edgeAt(const CutSurface& surface, double x, double z)
{
  for (const Halfedge h : surface.halfedges())
  {
    const Vec3& a = surface.point(surface.tail(h));
    const Vec3& b = surface.point(surface.head(h));
    const double row = surface.points.back().y() / (Rows - 1);
    if (surface.twin[h].valid() && a.x() == x && b.x() == x && a.z() == z && b.z() == z &&
      std::abs(std::min(a.y(), b.y()) - 2 * row) < 1e-9 * row)
    {
      return h;
    }
  }
  return {};
}

double pitch(const std::vector<Vec2>& profile, double x, double z, double widest = 5.)
{
  const CutSurface surface = sheetOf(profile);
  return pitchAt(surface, faceNormalsOf(surface), edgeAt(surface, x, z), { 40., widest });
}

/// A box of 20 x 10 whose slices each turn against the one below, as OpenSCAD extrudes them.
TriangleSurface twistedPrism(int slices, double degrees, double height)
{
  TriangleSurface s;
  const Vec2 corners[] = { { -10, -5 }, { 10, -5 }, { 10, 5 }, { -10, 5 } };
  for (int k = 0; k <= slices; ++k)
  {
    const double turn = degrees * Pi / 180 * k / slices;
    for (const Vec2& c : corners)
    {
      s.points.emplace_back(c.x() * std::cos(turn) - c.y() * std::sin(turn),
        c.x() * std::sin(turn) + c.y() * std::cos(turn), height * k / slices);
    }
  }
  for (int k = 0; k < slices; ++k)
  {
    for (int i = 0; i < 4; ++i)
    {
      const int a = 4 * k + i;
      const int b = 4 * k + (i + 1) % 4;
      s.triangles.push_back({ { a, b, a + 4 } });
      s.triangles.push_back({ { b, b + 4, a + 4 } });
    }
  }
  const int top = 4 * slices;
  s.triangles.push_back({ { 0, 2, 1 } });
  s.triangles.push_back({ { 0, 3, 2 } });
  s.triangles.push_back({ { top, top + 1, top + 2 } });
  s.triangles.push_back({ { top, top + 2, top + 3 } });
  s.connect();
  return s;
}
}

TEST(SurfaceSection, TurnsWhereTheProfileDoes)
{
  const CutSurface surface = sheetOf(saw(3, 0.5)); // right angles
  const FaceNormals normals = faceNormalsOf(surface);
  const Halfedge edge = edgeAt(surface, 1.5, 0.5);
  ASSERT_TRUE(edge.valid());
  const SurfaceSection section(surface, normals, edge, SurfaceSection::Ends::AtBoundaries);
  EXPECT_NEAR(std::abs(section.ownTurn()), 0.5 * Pi, 1e-9);
  for (const Halfedge side : { edge, surface.twin[edge] })
  {
    SurfaceSection::Walk walk(section, side);
    walk.follow(section, 1.5);
    double sum = 0;
    double farthest = 0;
    for (const Turn& t : walk.turns())
    {
      sum += t.angle;
      farthest = std::max(farthest, t.distance);
    }
    EXPECT_LE(farthest, 1.5);
    EXPECT_NEAR(std::abs(sum), 0., 1e-9) << "a groove and a ridge";
    walk.follow(section, 100.);
    EXPECT_GT(walk.turns().back().distance, 1.5) << "as far as the boundary";
  }
}

TEST(SurfaceSection, EndsAtFeaturesIfItIsToldTo)
{
  CutSurface surface = sheetOf(saw(3, 0.5));
  const Halfedge edge = edgeAt(surface, 1.5, 0.5);
  surface.setSharp(edgeAt(surface, 1., 0.), true);
  surface.setSharp(edgeAt(surface, 2., 0.), true);
  const FaceNormals normals = faceNormalsOf(surface);
  const SurfaceSection section(surface, normals, edge, SurfaceSection::Ends::AtFeatures);
  for (const Halfedge side : { edge, surface.twin[edge] })
  {
    SurfaceSection::Walk walk(section, side);
    walk.follow(section, 100.);
    for (const Turn& t : walk.turns())
    {
      EXPECT_LT(t.distance, std::hypot(0.5, 0.5));
      EXPECT_NEAR(t.angle, 0., 1e-9) << "diagonals of flat faces";
    }
  }
}

TEST(Corrugations, HaveThePitchOfTheirTeeth)
{
  const double slope = std::hypot(0.5, 0.5);
  for (const double x : { 2.5, 3., 3.5, 4. })
  {
    const double z = x == std::floor(x) ? 0. : 0.5;
    EXPECT_NEAR(pitch(saw(7, 0.5), x, z), 2 * slope, 1e-9) << "along the surface, at " << x;
  }
  // Stairs are, too, whatever their steps are like.
  std::vector<Vec2> stairs;
  for (int i = 0; i < 9; ++i)
  {
    stairs.emplace_back(i, 0.25 * i);
    stairs.emplace_back(i + 1, 0.25 * i);
  }
  EXPECT_NEAR(pitch(stairs, 4., 1.), 1.25, 1e-9);
}

TEST(Corrugations, AreNoEdgesOfOtherShapes)
{
  EXPECT_TRUE(std::isinf(pitch(saw(7, 0.1), 3.5, 0.1))) << "not sharp";
  EXPECT_TRUE(std::isinf(pitch(saw(7, 0.5), 0., 0.))) << "where it begins it turns, on the average";
  EXPECT_TRUE(std::isinf(pitch(saw(2, 0.5), 1., 0.))) << "two teeth";
  EXPECT_TRUE(std::isinf(pitch(saw(7, 0.5), 3.5, 0.5, 1.))) << "wider than is looked for";
  const std::vector<Vec2> step = { { -4, 0 }, { 0, 0 }, { 0, 1 }, { 4, 1 } };
  EXPECT_TRUE(std::isinf(pitch(step, 0., 1.)));
  // Faces of a rod in seven sides turn on and on.
  std::vector<Vec2> rod;
  for (int i = 0; i < 8; ++i)
  {
    rod.emplace_back(std::cos(2 * Pi * i / 7), std::sin(2 * Pi * i / 7));
  }
  rod[7] += Vec2(0.01, 0);
  EXPECT_TRUE(std::isinf(pitch(rod, rod[3].x(), rod[3].y())));
}

TEST(Corrugations, AreMeasuredOnBackbones)
{
  CutSurface surface = sheetOf(saw(7, 0.5));
  FeatureDetectionOptions detection;
  detectFeatures(surface, detection);
  FeatureGraph graph = buildFeatureGraph(surface, 60., {});
  measureCorrugations(surface, { 40., 5. }, graph);
  int with = 0;
  for (const Backbone& b : graph.backbones)
  {
    const double x = surface.points[b.points.front()].x();
    const bool isInside = b.type == BackboneType::Sharp && x > 1. && x < 6.;
    EXPECT_TRUE(!isInside || b.pitch > 0) << "at " << x;
    EXPECT_TRUE(b.type == BackboneType::Sharp || b.pitch == 0);
    with += b.pitch > 0 ? 1 : 0;
  }
  EXPECT_GE(with, 9);
}

TEST(Corrugations, AreCreasesToFineMeshes)
{
  Backbone ridge;
  ridge.pitch = 1.;
  EXPECT_TRUE(ridge.isCreaseTo(0.9));
  EXPECT_FALSE(ridge.isCreaseTo(1.1));
  ridge.keep = Keep::Line;
  EXPECT_TRUE(ridge.isCreaseTo(1.1)) << "what users name stays";
}

TEST(Corrugations, DoNotHideTheRimsAroundThem)
{
  constexpr int Slices = 100;
  CutSurface prism = shapes::cutSurface(twistedPrism(Slices, 500., 20.));
  detectFeatures(prism, FeatureDetectionOptions());
  // Four helices, from one slice's corner to the next one's.
  int found = 0;
  for (const Halfedge h : prism.halfedges())
  {
    const int a = prism.tail(h).index();
    const int b = prism.head(h).index();
    found += b == a + 4 && prism.sharp[h] != 0 ? 1 : 0;
  }
  EXPECT_GT(found, 4 * Slices * 9 / 10);
}

// As creases, the ridges left 13 and 14 % of the triangles below 30 degrees.
TEST(Corrugations, AreSmoothToCoarseMeshes)
{
  const TriangleSurface prism = twistedPrism(100, 360., 40.);
  for (const int points : { 1500, 3000 })
  {
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(toPolyData(prism.points, prism.triangles));
    remesher->SetNumberOfPoints(points);
    remesher->Update();
    const TriangleSurface mesh = fromPolyData(remesher->GetOutput());
    const MeshQuality q = measureQuality(mesh);
    EXPECT_EQ(q.numberOfPoints, points);
    EXPECT_GT(q.minimumAngle, 5.);
    EXPECT_LT(q.percentBelow30, 0.5);
    EXPECT_LT(measureDistance(mesh, prism).hausdorffPercent, 2.);
  }
}
