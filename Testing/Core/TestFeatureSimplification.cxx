// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Corners and creases that are closer together than triangles are large.
#include "FeatureSimplification.h"
#include "OptimizerMeshes.h"
#include "VertexStar.h"

#include "MeshQuality.h"
#include "PolyDataConversion.h"

#include "vtkCellArray.h"
#include "vtkControlMap.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"

#include <algorithm>
#include <array>
#include <random>
#include <set>

using namespace stipple;
using meshes::Snapshot;
using meshes::worstOf;

namespace
{
/// A flat patch of 6 x 6 squares, of whose first side's points the first two have slid to so far
/// from the corner.
std::unique_ptr<meshes::TestMesh> crowdedPatch(double distance)
{
  auto t = meshes::patch(6);
  for (const int i : { 1, 2 })
  {
    const Vertex v(i);
    while (t->mesh.arcLength(v) > 1.001 * i * distance)
    {
      const double room = t->mesh.arcLength(v) - (i == 1 ? 0. : t->mesh.arcLength(Vertex(i - 1)));
      const double step = std::max({ i * distance - t->mesh.arcLength(v), -0.4 * room, -0.08 });
      if (!t->edit.trySlide(v, step, []() { return true; }))
      {
        ADD_FAILURE() << "the point does not slide: " << i << " at " << t->mesh.arcLength(v)
                      << " by " << step;
        return t;
      }
    }
  }
  return t;
}

double angleOf(const TriangleSurface& mesh)
{
  return measureQuality(mesh).minimumAngle;
}

/// A plate with teeth of a height on two of its sides, all edges sharp: `n` of them a unit of
/// length.
vtkSmartPointer<vtkPolyData> toothedPlate(int n, double height)
{
  TriangleSurface s;
  for (const double z : { 0., 0.5 })
  {
    for (const double side : { 0., 1. })
    {
      for (int i = 0; i <= 2 * n; ++i)
      {
        const double out = i % 2 == 0 ? 0. : side > 0 ? height : -height;
        s.points.emplace_back(0.5 * i / n, side + out, z);
      }
    }
  }
  const int row = 2 * n + 1;
  const auto quad = [&](int a, int b, int c, int d) {
    s.triangles.push_back({ { a, b, c } });
    s.triangles.push_back({ { a, c, d } });
  };
  for (int i = 0; i + 1 < row; ++i)
  {
    quad(i, row + i, row + i + 1, i + 1);                             // below
    quad(2 * row + i, 2 * row + i + 1, 3 * row + i + 1, 3 * row + i); // above
    quad(i, i + 1, 2 * row + i + 1, 2 * row + i);                     // in front
    quad(row + i, 3 * row + i, 3 * row + i + 1, row + i + 1);         // behind
  }
  quad(0, 2 * row, 3 * row, row);
  quad(row - 1, 2 * row - 1, 4 * row - 1, 3 * row - 1);
  return toPolyData(s.points, s.triangles);
}

struct Remeshed
{
  vtkNew<vtkGeometryRemesher> remesher;
  TriangleSurface mesh;
  int count = 0;

  Remeshed(vtkPolyData* input, int points, double tolerance)
  {
    this->remesher->SetInputData(input);
    this->remesher->SetNumberOfPoints(points);
    this->remesher->GetControlMap()->SetGrowth(0.); // sizes that grow leave less to simplify
    this->remesher->GetOptimizer()->SetFeatureTolerance(tolerance);
    this->remesher->Update();
    this->mesh = fromPolyData(this->remesher->GetOutput());
    this->count = this->remesher->GetOptimizer()->GetNumberOfSimplifiedFeatures();
  }
};
}

TEST(FeatureSimplification, FreesWhatCrowdsACorner)
{
  const auto t = crowdedPatch(0.01);
  OptimizedMesh& mesh = t->mesh;
  const auto before = mesh.chains();
  const int points = mesh.vertices().size();
  const double worst = worstOf(mesh);
  EXPECT_LT(worst, 0.1);
  ASSERT_TRUE(simplifyFeatures(mesh, 1.).ok());
  EXPECT_EQ(mesh.numberOfSimplifiedFeatures(), 2);
  EXPECT_GT(worstOf(mesh), 2. * worst);
  EXPECT_EQ(mesh.vertices().size(), points);
  EXPECT_EQ(meshes::eulerOf(mesh), 1);
  // Both go; then the side's first edge is three spacings long, and gets one of them back.
  ASSERT_EQ(mesh.chains()[0].size() + 1, before[0].size());
  EXPECT_TRUE(mesh.chains()[0].front() == before[0].front()) << "the corner stays";
  EXPECT_TRUE(mesh.chains()[0].back() == before[0].back());
  for (std::size_t side = 1; side < 4; ++side)
  {
    EXPECT_EQ(mesh.chains()[side], before[side]);
  }
  const BackboneVertex& back = mesh.chains()[0][1];
  EXPECT_TRUE(back.vertex == Vertex(1) || back.vertex == Vertex(2));
  EXPECT_EQ(mesh.freedom(back.vertex), Freedom::Backbone);
  EXPECT_EQ(mesh.samples()[back.vertex.index()].kind, SampleKind::Backbone);
  EXPECT_GT(mesh.position(back.vertex).x(), 0.5 / 3. - 1e-12);
  EXPECT_LT(mesh.position(back.vertex).x(), 1. / 3. + 1e-12);
  const Vertex inside(3 - back.vertex.index());
  EXPECT_TRUE(mesh.isFree(inside));
  EXPECT_FALSE(mesh.isBoundary(inside));
  EXPECT_EQ(mesh.samples()[inside.index()].kind, SampleKind::Interior);
  const Vec3& p = mesh.position(inside);
  EXPECT_TRUE(p.x() > 0.01 && p.x() < 0.99 && p.y() > 0.01 && p.y() < 0.99) << p.transpose();
  for (const Face f : mesh.faces())
  {
    EXPECT_GT(mesh.faceNormal(f).z(), 0.99);
  }
}

// What a vertex took over counts whenever that vertex is led on: else a deep, narrow hole goes step
// by step, each of them small.
TEST(FeatureSimplification, RemembersWhatHasGone)
{
  const auto t = crowdedPatch(0.01);
  OptimizedMesh& mesh = t->mesh;
  const auto isAbsorbed = [&](const Vec3& place) {
    const std::vector<Vec3>& all = mesh.absorbed(Vertex(0));
    return std::find(all.begin(), all.end(), place) != all.end();
  };
  const std::array<Vec3, 2> before = { { mesh.position(Vertex(1)), mesh.position(Vertex(2)) } };
  for (int call = 0; call < 2; ++call)
  {
    ASSERT_TRUE(simplifyFeatures(mesh, 1.).ok());
    EXPECT_TRUE(isAbsorbed(before[0]) && isAbsorbed(before[1]));
    EXPECT_TRUE(mesh.absorbed(Vertex(1)).empty() && mesh.absorbed(Vertex(2)).empty());
  }
}

TEST(FeatureSimplification, KeepsWhatItShould)
{
  const auto none = crowdedPatch(0.01);
  const Snapshot before(none->mesh);
  ASSERT_TRUE(simplifyFeatures(none->mesh, 0.).ok());
  EXPECT_TRUE(Snapshot(none->mesh) == before) << "a tolerance of 0";

  const auto good = meshes::patch(6);
  const Snapshot regular(good->mesh);
  ASSERT_TRUE(simplifyFeatures(good->mesh, 1.).ok());
  EXPECT_TRUE(Snapshot(good->mesh) == regular) << "no triangle is poor";
  EXPECT_EQ(good->mesh.numberOfChanges(), 0);
}

// Vertices that lie on a side, or on another vertex: no move and no swap of a sound mesh opens
// those triangles.
TEST(FeatureSimplification, LeavesNoTriangleWithoutAnAngle)
{
  const auto flat = [](const OptimizedMesh& mesh) {
    int count = 0;
    for (const Face f : mesh.faces())
    {
      count += faceQuality(mesh, f) < Tuning::NoAngle ? 1 : 0;
    }
    return count;
  };
  std::mt19937 random(7);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  int opened = 0;
  for (int draw = 0; draw < 60; ++draw)
  {
    const auto t = meshes::patch(6);
    OptimizedMesh& mesh = t->mesh;
    for (int i = 0; i < 3; ++i)
    {
      const int column = 1 + below(5);
      const Vertex v(7 + column); // of the first row inside
      ASSERT_TRUE(mesh.isFree(v));
      const double x = (column + (below(3) - 1) * 0.5) / 6.;
      t->edit.put(v, t->pointAt(x, i == 0 && draw % 2 == 0 ? 1. / 6. : 0.));
    }
    const int before = flat(mesh);
    for (int look = 0; look < Tuning::LastOpenings && flat(mesh) > 0; ++look)
    {
      ASSERT_TRUE(simplifyFeatures(mesh, 1., Tuning::NoAngle).ok());
    }
    EXPECT_EQ(flat(mesh), 0) << "draw " << draw << " with " << before;
    EXPECT_EQ(meshes::eulerOf(mesh), 1);
    EXPECT_EQ(mesh.vertices().size(), 49);
    opened += before;
  }
  EXPECT_GT(opened, 100);
}

// Where two holes meet in a point, two vertices are at one place: no edge leads from one to the
// other.
TEST(FeatureSimplification, LeavesNoEdgeWithoutALength)
{
  for (const double d : { 1e-4, 1e-3, 1e-2 })
  {
    const std::vector<Vec3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
      { 0.5 - 2. * d, 0.5, 0 }, { 0.5 - d, 0.5 - d, 0 }, { 0.5, 0.5, 0 }, { 0.5 - d, 0.5 + d, 0 },
      { 0.5 + d, 0.5 - d, 0 }, { 0.5 + 2. * d, 0.5, 0 }, { 0.5 + d, 0.5 + d, 0 } };
    const std::vector<Triangle> triangles = { { 3, 4, 7 }, { 3, 7, 10 }, { 7, 6, 10 }, { 3, 10, 2 },
      { 2, 10, 9 }, { 2, 9, 1 }, { 1, 9, 8 }, { 8, 6, 5 }, { 1, 8, 5 }, { 1, 5, 0 }, { 0, 5, 4 },
      { 0, 4, 3 } };
    const auto holes = toPolyData(points, triangles);
    for (const int number : { 20, 40, 100 })
    {
      const Remeshed result(holes, number, 1.);
      EXPECT_EQ(result.remesher->GetErrorCode(), 0U) << number << ", " << d;
      EXPECT_EQ(result.mesh.points.size(), static_cast<std::size_t>(number));
    }
  }
}

TEST(FeatureSimplification, IsTheSameInAllScales)
{
  const auto scaled = [](double scale) {
    auto t = meshes::patchOf(6, [=](double x, double y) { return Vec3(scale * x, scale * y, 0); });
    // The corners' neighbours on the side slide half the way, again and again.
    for (int i = 0; i < 4; ++i)
    {
      t->edit.trySlide(Vertex(1), -0.45 * t->mesh.arcLength(Vertex(1)), []() { return true; });
    }
    EXPECT_TRUE(simplifyFeatures(t->mesh, 1.).ok());
    EXPECT_EQ(t->mesh.numberOfSimplifiedFeatures(), 1);
    return t->mesh.triangles();
  };
  const auto unit = scaled(1.);
  EXPECT_EQ(scaled(1024.), unit);
  EXPECT_EQ(scaled(1. / 1024.), unit);
}

// The spacing is 0.05, teeth are as wide as 0.04: without simplification, their outlines leave
// slivers; between them, ridges are too fine to be creases. None is as high as
// Tuning::VisibleDistance.
TEST(FeatureSimplification, OpensTrianglesOfToothedPlates)
{
  double poor = 0;
  double poorIfKept = 0;
  for (const double height : { 0.01, 0.014, 0.018 })
  {
    const auto input = toothedPlate(24, height);
    const Remeshed kept(input, 900, 0.);
    const Remeshed simplified(input, 900, 1.);
    EXPECT_EQ(kept.count, 0);
    EXPECT_GT(simplified.count, 150);
    EXPECT_GT(angleOf(simplified.mesh), angleOf(kept.mesh)) << height;
    const MeshQuality q = measureQuality(simplified.mesh);
    const double ifKept = measureQuality(kept.mesh).percentBelow30;
    EXPECT_LT(q.percentBelow30, 0.3 * ifKept);
    poor += q.percentBelow30;
    poorIfKept += ifKept;
    EXPECT_EQ(q.numberOfPoints, 900);
    EXPECT_EQ(q.nonManifoldEdges + q.nonManifoldVertices + q.misorientedEdges + q.boundaryEdges, 0);
    EXPECT_EQ(q.euler, 2);
    EXPECT_EQ(q.degenerate, 0);
    const double spacing = std::sqrt(2. / std::sqrt(3.) * q.area / q.numberOfPoints);
    const double diagonal = std::hypot(1., 1. + 2. * height, 0.5);
    EXPECT_LT(
      measureDistance(simplified.mesh, fromPolyData(input)).hausdorffPercent * diagonal / 100.,
      spacing);

    // Lines run along edges of the mesh, also where backbones have become one.
    std::set<std::pair<vtkIdType, vtkIdType>> edges;
    for (const Triangle& t : simplified.mesh.triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        edges.insert({ t[k], t[(k + 1) % 3] });
      }
    }
    auto* lines = vtkPolyData::SafeDownCast(simplified.remesher->GetOutputDataObject(1));
    vtkIdType n = 0;
    const vtkIdType* p = nullptr;
    EXPECT_GT(lines->GetNumberOfLines(), 12);
    for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
    {
      lines->GetLines()->GetCellAtId(i, n, p);
      for (vtkIdType k = 1; k < n; ++k)
      {
        EXPECT_EQ(edges.count({ p[k - 1], p[k] }), 1U);
      }
    }
  }
  // Of one height a share of .11 to .29 is left, by luck: neighbouring numbers of points differ so.
  EXPECT_LT(poor, 0.2 * poorIfKept);
}

// The base mesh is one like others; what it keeps of its features has vertices in the middles.
TEST(FeatureSimplification, OpensBaseMeshesOfSubdivisions)
{
  const auto input = toothedPlate(60, 0.004);
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(input);
  remesher->SetNumberOfPoints(900);
  remesher->SetPatternToSemiRegular();
  remesher->SetNumberOfSubdivisions(1);
  const auto quality = [&](double tolerance) {
    remesher->GetOptimizer()->SetFeatureTolerance(tolerance);
    remesher->Update();
    EXPECT_EQ(remesher->GetErrorCode(), 0UL);
    EXPECT_EQ(remesher->GetOptimizer()->GetNumberOfSimplifiedFeatures() > 0, tolerance > 0);
    const MeshQuality q = measureQuality(fromPolyData(remesher->GetOutput()));
    EXPECT_EQ(q.numberOfTriangles, 4 * remesher->GetOptimizer()->GetOutput()->GetNumberOfPolys());
    EXPECT_EQ(q.nonManifoldEdges + q.nonManifoldVertices + q.misorientedEdges + q.boundaryEdges, 0);
    EXPECT_EQ(q.euler, 2);
    EXPECT_EQ(q.degenerate, 0);
    return q.percentBelow30;
  };
  EXPECT_LT(quality(1.), 0.5 * quality(0.));
}
