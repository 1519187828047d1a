// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A mesh taken apart: vertices that go elsewhere, and those that far places get.
#include "FarPlaces.h"
#include "LooseMesh.h"
#include "LooseTriangles.h"
#include "OptimizerMeshes.h"
#include "PolyDataConversion.h"
#include "TriangleIntersections.h"
#include "Tuning.h"

#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace stipple;

namespace
{
double areaOf(const OptimizedMesh& mesh)
{
  double area = 0;
  for (const Face f : mesh.faces())
  {
    area += mesh.faceArea(f);
  }
  return area;
}

/// What is protected of it.
struct Opened : LooseMesh
{
  using LooseMesh::collapseStaysApart;
  using LooseMesh::Fixed;
  using LooseMesh::hasSpare;
  using LooseMesh::LooseMesh;
  using LooseMesh::Now;
  using LooseMesh::NumberOfSwaps;
  using LooseMesh::OnBackbones;
  using LooseMesh::splitStaysApart;
  using LooseMesh::swapStaysApart;
  using LooseMesh::takeSpare;
};

/// A hill of this width and height in the middle of a square of m x m, narrower than these.
std::unique_ptr<meshes::TestMesh> hill(int m, double height)
{
  return meshes::patch(m, [=](double x, double y) {
    const double r = std::hypot(x - 0.5 - 0.5 / m, y - 0.5 - 0.5 / m) * m;
    return height * std::max(0., 1. - 2. * r);
  });
}
}

TEST(LooseTriangles, FansReplaceDisks)
{
  const auto t = meshes::patch(3);
  LooseTriangles loose(t->mesh);
  // The two triangles of the square in the middle, and their rim.
  const std::vector<int> disk = loose.beside(Vertex(5), Vertex(10));
  ASSERT_EQ(disk.size(), 2U);
  const std::size_t before = loose.triangles().size();
  // Vertex 0 goes there: a corner, of which only numbers matter here.
  loose.fan(disk, { { { 5, 6 } }, { { 6, 10 } }, { { 10, 9 } }, { { 9, 5 } } }, Vertex(0));
  EXPECT_EQ(loose.triangles().size(), before + 2);
  for (const int v : { 5, 6, 10, 9 })
  {
    EXPECT_EQ(loose.beside(Vertex(v), Vertex(0)).size(), 2U + (v == 5 ? 2U : 0U)) << v;
  }
  EXPECT_TRUE(loose.beside(Vertex(5), Vertex(10)).empty());
}

TEST(LooseTriangles, PlacesOnCreasesAreSharesOfTheWay)
{
  const auto t = meshes::patch(4);
  LooseTriangles loose(t->mesh);
  const auto there = loose.onChains(Vertex(1), Vertex(2), 0.25);
  const auto back = loose.onChains(Vertex(2), Vertex(1), 0.75);
  ASSERT_EQ(there.size(), 1U);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_NEAR(there[0].arcLength, 0.25 + 0.25 * 0.25, 1e-12);
  EXPECT_NEAR(back[0].arcLength, there[0].arcLength, 1e-12);
  EXPECT_TRUE(loose.onChains(Vertex(6), Vertex(7), 0.5).empty()) << "no crease";
  loose.splitCrease(Vertex(1), Vertex(2), there, Vertex(12));
  EXPECT_TRUE(loose.isCrease(Vertex(1), Vertex(12)) && loose.isCrease(Vertex(12), Vertex(2)));
  EXPECT_FALSE(loose.isCrease(Vertex(1), Vertex(2)));
  const LooseTriangles::Chain& chain = loose.chains()[there[0].chain];
  ASSERT_EQ(chain.size(), 6U);
  EXPECT_EQ(chain[2].vertex, Vertex(12));
  EXPECT_TRUE(std::is_sorted(chain.begin(), chain.end(),
    [](const BackboneVertex& a, const BackboneVertex& b) { return a.arcLength < b.arcLength; }));
}

TEST(LooseTriangles, EdgesOfChainsAreFoundByArcLength)
{
  const auto t = meshes::patch(4);
  LooseTriangles loose(t->mesh);
  const auto second = loose.edgeAt(0, 0.3);
  EXPECT_EQ(second.ends, VertexPair(Vertex(1), Vertex(2)));
  EXPECT_NEAR(second.share, 0.2, 1e-12);
  const auto there = loose.onChains(second.ends.first, second.ends.second, second.share);
  ASSERT_EQ(there.size(), 1U);
  EXPECT_NEAR(there[0].arcLength, 0.3, 1e-12);
  EXPECT_EQ(loose.edgeAt(0, 0.).ends, VertexPair(Vertex(0), Vertex(1)));
  EXPECT_FALSE(loose.edgeAt(0, 1.1).ends.first.valid()) << "the side is 1 long";
  loose.lead(Vertex(1), Vertex(2), there, Vertex(6));
  EXPECT_EQ(loose.edgeAt(0, 0.29).ends, VertexPair(Vertex(1), Vertex(6)));
  EXPECT_EQ(loose.edgeAt(0, 0.31).ends, VertexPair(Vertex(6), Vertex(2)));
}

TEST(LooseMesh, AVertexGoesFromAFaceToACrease)
{
  const auto t = meshes::patch(6);
  OptimizedMesh& mesh = t->mesh;
  const double area = areaOf(mesh);
  Opened loose(mesh, 1.);
  ASSERT_TRUE(loose.hasSpare());
  const auto places = loose.Now.onChains(Vertex(2), Vertex(3), 0.5);
  ASSERT_EQ(places.size(), 1U);
  const SurfacePoint there = t->pointAt(2.5 / 6., 0.);
  const Vertex v = loose.takeSpare(there, false);
  EXPECT_TRUE(mesh.isFree(v)) << "from inside a face";
  loose.Now.splitCrease(Vertex(2), Vertex(3), places, v);
  loose.OnBackbones.push_back({ v, places[0].chain, places[0].arcLength });
  loose.NumberOfSwaps = 1;
  ASSERT_TRUE(mesh.rebuild(loose.finish()).ok());
  EXPECT_EQ(mesh.freedom(v), Freedom::Backbone);
  EXPECT_LT((mesh.position(v) - Vec3(2.5 / 6., 0., 0.)).norm(), 1e-12);
  EXPECT_TRUE(mesh.isBoundary(v));
  EXPECT_EQ(mesh.chains()[0].size(), 8U);
  EXPECT_EQ(mesh.samples()[v.index()].kind, SampleKind::Backbone);
  EXPECT_EQ(mesh.samples()[v.index()].backbone, 0);
  EXPECT_EQ(mesh.vertices().size(), 49);
  EXPECT_EQ(meshes::eulerOf(mesh), 1);
  EXPECT_NEAR(areaOf(mesh), area, 1e-12);
  EXPECT_TRUE(t->edit.trySlide(v, 0.02, []() { return true; })) << "it slides on";
}

TEST(LooseMesh, SheetsStayApart)
{
  const auto t = meshes::foldedPatch(true);
  const auto at = [](int i, int j) { return Vertex(meshes::FoldedRow * j + i); };
  Opened loose(t->mesh, 1.);
  EXPECT_TRUE(loose.collapseStaysApart(at(2, 6), at(1, 6))) << "both sheets are flat there";
  EXPECT_FALSE(loose.collapseStaysApart(at(4, 5), at(3, 5))) << "what is below is higher";
  EXPECT_TRUE(loose.collapseStaysApart(at(4, 3), at(3, 3))) << "away from what is above";
  // The square of either sheet at the fold.
  ASSERT_EQ(loose.Now.beside(at(3, 4), at(4, 5)).size(), 2U);
  ASSERT_EQ(loose.Now.beside(at(3, 3), at(4, 4)).size(), 2U);
  EXPECT_TRUE(loose.swapStaysApart(at(3, 4), at(4, 5)));
  EXPECT_TRUE(loose.swapStaysApart(at(3, 3), at(4, 4)));
  loose.Now.swap(at(3, 3), at(4, 4));
  EXPECT_FALSE(loose.swapStaysApart(at(3, 4), at(4, 5)));
  loose.Now.swap(at(4, 3), at(3, 4));
  EXPECT_TRUE(loose.swapStaysApart(at(3, 4), at(4, 5))) << "as it was";
  // What is free moves apart again, but no vertex is put where it would be in the way: one on an
  // edge of the upper sheet, on that sheet and on the other.
  const auto f = meshes::foldedPatch(false);
  Opened free(f->mesh, 1.);
  EXPECT_TRUE(free.collapseStaysApart(at(4, 5), at(3, 5)));
  for (const bool isAbove : { true, false })
  {
    ASSERT_TRUE(free.hasSpare());
    const Vertex v = free.takeSpare(f->pointAt(4. / 8., isAbove ? 5.5 / 8. : 2.5 / 8.), true);
    EXPECT_EQ(free.splitStaysApart(at(4, 5), at(4, 6), v), isAbove);
  }
  free.Now.swap(at(3, 3), at(4, 4));
  EXPECT_TRUE(free.swapStaysApart(at(3, 4), at(4, 5)));
}

TEST(FarPlaces, AreFoundAndReached)
{
  const auto t = hill(10, 0.12);
  OptimizedMesh& mesh = t->mesh;
  std::vector<FarPlace> places;
  ASSERT_TRUE(farPlaces(mesh, 0.5, {}, places).ok());
  ASSERT_FALSE(places.empty()) << "the hill lies between the mesh's vertices";
  EXPECT_NEAR(places.front().distance, 0.12, 1e-9);
  EXPECT_LT((places.front().position - Vec3(0.55, 0.55, 0.12)).norm(), 1e-9);
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end(),
    [](const FarPlace& a, const FarPlace& b) { return a.distance > b.distance; }));
  ASSERT_TRUE(reachPlaces(mesh, places, 1.).ok());
  EXPECT_EQ(mesh.numberOfChanges(), 1);
  EXPECT_EQ(mesh.vertices().size(), 121);
  EXPECT_EQ(meshes::eulerOf(mesh), 1);
  std::vector<FarPlace> left;
  ASSERT_TRUE(farPlaces(mesh, 0.5, {}, left).ok());
  EXPECT_TRUE(left.empty());
  const auto isAtTop = [&](Vertex v) { return std::abs(mesh.position(v).z() - 0.12) < 1e-9; };
  int atTop = 0;
  for (const Vertex v : mesh.vertices())
  {
    atTop += isAtTop(v) ? 1 : 0;
    EXPECT_TRUE(!isAtTop(v) || mesh.freedom(v) == Freedom::None) << "it stays there";
  }
  EXPECT_EQ(atTop, 1);
}

TEST(FarPlaces, AreFarFromTheirOwnComponent)
{
  // A thorn of one sheet ends just below another sheet, which is no help to it.
  constexpr int N = 24;
  constexpr double Top = 0.3;
  auto t = std::make_unique<meshes::TestMesh>();
  const auto sheet = [](double height, double thorn) {
    return [=](int i, int j) {
      const bool isThorn = i == N / 2 + 1 && j == N / 2 + 1;
      return Vec3(
        static_cast<double>(i) / N, static_cast<double>(j) / N, height + (isThorn ? thorn : 0.));
    };
  };
  meshes::addOpenChart(t->builder, sheet(0., Top), N, Vec2(1, 1));
  meshes::addOpenChart(t->builder, sheet(Top + 0.01, 0.), N, Vec2(1, 1));
  t->read();
  t->samples = synthetic::sample(t->atlas->surface(), t->atlas->graph(), t->atlas->traces(), 60);
  ASSERT_TRUE(createMesh(*t->atlas, t->samples, t->triangles, {}).ok());
  t->build();
  ASSERT_EQ(meshes::eulerOf(t->mesh), 2);
  std::vector<FarPlace> places;
  ASSERT_TRUE(farPlaces(t->mesh, 0.5, {}, places).ok());
  ASSERT_FALSE(places.empty());
  EXPECT_NEAR(places.front().position.z(), Top, 1e-9);
  EXPECT_GT(places.front().distance, 0.5 * Top);
  ASSERT_TRUE(reachPlaces(t->mesh, places, 1.).ok());
  for (const Face f : t->mesh.faces())
  {
    int above = 0;
    for (const Vertex v : t->mesh.corners(f))
    {
      above += t->mesh.position(v).z() > Top + 0.005 ? 1 : 0;
    }
    EXPECT_EQ(above % 3, 0) << "no triangle leads from one sheet to the other";
  }
}

TEST(FarPlaces, OnCreasesGoIntoTheirEdges)
{
  const auto t = meshes::patch(10, [](double x, double y) {
    return 0.12 * std::max(0., 1. - 20. * std::hypot(x - 0.55, y)); // at the boundary
  });
  OptimizedMesh& mesh = t->mesh;
  std::vector<FarPlace> places;
  ASSERT_TRUE(farPlaces(mesh, 0.5, {}, places).ok());
  ASSERT_FALSE(places.empty());
  EXPECT_EQ(places.front().backbone, 0);
  EXPECT_LT((places.front().position - Vec3(0.55, 0., 0.12)).norm(), 1e-9);
  ASSERT_TRUE(reachPlaces(mesh, places, 1.).ok());
  EXPECT_EQ(meshes::eulerOf(mesh), 1);
  const OptimizedMesh::Chain& chain = mesh.chains()[0];
  ASSERT_EQ(chain.size(), 12U);
  const auto top = std::find_if(chain.begin(), chain.end(),
    [&](const BackboneVertex& v) { return std::abs(mesh.position(v.vertex).z() - 0.12) < 1e-9; });
  ASSERT_NE(top, chain.end());
  EXPECT_TRUE(mesh.isBoundary(top->vertex));
  EXPECT_EQ(mesh.freedom(top->vertex), Freedom::None);
  EXPECT_TRUE(std::is_sorted(chain.begin(), chain.end(),
    [](const BackboneVertex& a, const BackboneVertex& b) { return a.arcLength < b.arcLength; }));
}

TEST(FarPlaces, AreFoundInsideLargeTriangles)
{
  // A roof of two large squares, which edges of the mesh cross below its ridge.
  const auto roof = [](double x, double y) { return Vec3(x, y, 0.6 * (0.5 - std::abs(x - 0.5))); };
  const auto t = meshes::patchOf(5, roof, 2);
  std::vector<FarPlace> places;
  ASSERT_TRUE(farPlaces(t->mesh, 0.1, {}, places).ok());
  EXPECT_TRUE(std::any_of(places.begin(), places.end(),
    [](const FarPlace& p) { return p.backbone < 0 && p.place.bary.minCoeff() > 0.01; }));
  for (const FarPlace& p : places)
  {
    EXPECT_LT(p.distance, 0.06 + 1e-9);
    EXPECT_NEAR(p.position.x(), 0.5, 0.1) << "elsewhere the mesh lies on the roof";
  }
}

TEST(FarPlaces, AreWorthAPoorTriangleIfTheyAreFar)
{
  const auto t = hill(10, 0.3); // at the top, triangles have some 19 degrees
  std::vector<FarPlace> places;
  // However long edges are, what shows is far; else it is what is farther than the share of them.
  ASSERT_TRUE(farPlaces(t->mesh, 4., {}, places).ok());
  ASSERT_FALSE(places.empty());
  const double shows = Tuning::VisibleDistance * t->mesh.atlas().surface().boundingBoxDiagonal();
  for (const FarPlace& p : places)
  {
    EXPECT_GT(p.distance, shows);
  }
  ASSERT_TRUE(farPlaces(t->mesh, 0.5, {}, places).ok());
  ASSERT_FALSE(places.empty());
  std::vector<FarPlace> near = { places.front() };
  near.front().distance *= 0.01;
  const meshes::Snapshot before(t->mesh);
  ASSERT_TRUE(reachPlaces(t->mesh, near, 1.).ok());
  EXPECT_TRUE(meshes::Snapshot(t->mesh) == before);
  ASSERT_TRUE(reachPlaces(t->mesh, places, 1.).ok());
  EXPECT_FALSE(meshes::Snapshot(t->mesh) == before);
  EXPECT_LT(meshes::worstOf(t->mesh), 0.5);
}

namespace
{
/// A square of 60 x 60, 20 thick, with a hole of radius 2.5 in 24 sides.
TriangleSurface plateWithHole()
{
  constexpr int N = 24;
  TriangleSurface s;
  for (const double z : { 0., 20. })
  {
    for (const bool isHole : { false, true })
    {
      for (int k = 0; k < N; ++k)
      {
        const double a = 2. * Pi * (k + 0.5) / N;
        const Vec3 p(std::cos(a), std::sin(a), 0);
        // The eighth from an axis on is the square's corner.
        const Vec3 out =
          k % 6 == 2 ? Vec3(30. * p.cwiseSign()) : Vec3(30. * p / p.cwiseAbs().maxCoeff());
        s.points.push_back((isHole ? Vec3(2.5 * p) : out) + Vec3(0, 0, z));
      }
    }
  }
  const auto quad = [&](int a, int b, int c, int d) {
    s.triangles.push_back({ { a, b, c } });
    s.triangles.push_back({ { a, c, d } });
  };
  for (int k = 0; k < N; ++k)
  {
    const int l = (k + 1) % N;
    quad(N + k, N + l, l, k);                         // below
    quad(3 * N + k, 2 * N + k, 2 * N + l, 3 * N + l); // above
    quad(k, l, 2 * N + l, 2 * N + k);                 // outside
    quad(N + l, N + k, 3 * N + k, 3 * N + l);         // the hole
  }
  return s;
}
}

// The hole is three edges around: a vertex that reached its wall twisted the tunnel.
TEST(FarPlaces, AreNotReachedWhereTheMeshWouldPassThroughItself)
{
  const TriangleSurface plate = plateWithHole();
  for (int number = 220; number <= 250; number += 10)
  {
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(toPolyData(plate.points, plate.triangles));
    remesher->SetNumberOfPoints(number);
    remesher->Update();
    const TriangleSurface mesh = fromPolyData(remesher->GetOutput());
    ASSERT_EQ(mesh.points.size(), static_cast<std::size_t>(number));
    EXPECT_EQ(placesOfIntersections(mesh.points, mesh.triangles)->size(), 0U) << number;
  }
}
