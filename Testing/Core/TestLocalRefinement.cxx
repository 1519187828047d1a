// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Faults of a mesh, and shorter edges where they are: on a square, a folded sheet and a thin wall.
#include "LocalRefinement.h"
#include "MeshFaults.h"
#include "MeshOptimizer.h"
#include "MeshRegion.h"
#include "OptimizerMeshes.h"
#include "Tuning.h"

#include <cmath>

using namespace stipple;

namespace
{
double meanEdge(const OptimizedMesh& mesh, const std::vector<Vertex>& vertices)
{
  double sum = 0;
  const std::vector<Edge> edges = edgesAbout(mesh, vertices);
  for (const Edge e : edges)
  {
    const Halfedge h = mesh.halfedge(e);
    sum += (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
  }
  return sum / static_cast<double>(edges.size());
}

std::vector<Vertex> within(const OptimizedMesh& mesh, const Vec3& place, double distance)
{
  std::vector<Vertex> result;
  for (const Vertex v : mesh.vertices())
  {
    if ((mesh.position(v) - place).norm() < distance)
    {
      result.push_back(v);
    }
  }
  return result;
}
}

TEST(MeshFaults, AreNarrowTriangles)
{
  const auto t = meshes::patch(4);
  KnownOverlaps known;
  EXPECT_TRUE(MeshFaults(t->mesh, known).all().empty());
  t->edit.put(Vertex(12), t->pointAt(0.5, 0.28)); // .03 above the edge between 7 and 8
  const MeshFaults faults(t->mesh, known);
  ASSERT_FALSE(faults.all().empty());
  double lack = 0;
  for (const Face f : t->mesh.faces())
  {
    lack += std::pow(std::max(0., Tuning::NarrowAngle - faceQuality(t->mesh, f)), 2);
  }
  EXPECT_DOUBLE_EQ(faults.sum().lack, lack);
  EXPECT_EQ(faults.sum().overlaps, 0);
  for (const MeshFaults::Fault& fault : faults.all())
  {
    EXPECT_LT(faceQuality(t->mesh, fault.face), Tuning::NarrowAngle);
    EXPECT_LT((fault.position - Vec3(0.5, 0.3, 0)).norm(), 0.25);
  }
  EXPECT_DOUBLE_EQ(faults.sumNear(Vec3(0.5, 0.3, 0), 0.25).lack, lack);
  EXPECT_EQ(faults.sumNear(Vec3(0, 1, 0), 0.25).lack, 0.);
}

TEST(MeshFaults, AreNoneBetweenCreases)
{
  // A square drawn out to a rhombus: its corners (0, 0) and (1, 1) have 12 degrees, which no
  // edges, however short, change.
  const double s = std::tan(6. * Pi / 180.);
  const auto t =
    meshes::patchOf(1, [=](double u, double v) { return Vec3(u + v, s * (v - u), 0); });
  const auto other =
    meshes::patchOf(4, [=](double u, double v) { return Vec3(u + v, s * (v - u), 0); });
  KnownOverlaps known;
  for (const Face f : t->mesh.faces())
  {
    EXPECT_LT(faceQuality(t->mesh, f), Tuning::NarrowAngle);
  }
  EXPECT_FALSE(MeshFaults(t->mesh, known).all().empty()) << "the diagonal halves the corners";
  ASSERT_TRUE(t->edit.swap(t->edgeBetween(0, 3)));
  for (const Face f : t->mesh.faces())
  {
    EXPECT_LT(faceQuality(t->mesh, f), Tuning::NarrowAngle);
  }
  EXPECT_TRUE(MeshFaults(t->mesh, known).all().empty());
  EXPECT_FALSE(MeshFaults(other->mesh, known).all().empty()) << "most are inside";
}

TEST(MeshFaults, AreTrianglesThatPassThroughOthers)
{
  const auto t = meshes::foldedPatch(false);
  KnownOverlaps known;
  const auto at = [](int i, int j) { return meshes::FoldedRow * j + i; };
  EXPECT_EQ(MeshFaults(t->mesh, known).sum().overlaps, 0);
  ASSERT_TRUE(t->edit.swap(t->edgeBetween(at(3, 3), at(4, 4))));
  ASSERT_TRUE(t->edit.swap(t->edgeBetween(at(3, 4), at(4, 5))));
  known.ofSurface.emplace(std::vector<Box>());
  const MeshFaults faults(t->mesh, known);
  EXPECT_EQ(faults.sum().overlaps, static_cast<int>(SelfIntersections(t->mesh).faces().size()));
  EXPECT_GT(faults.sum().overlaps, 1);
  EXPECT_TRUE(FaultSum() < faults.sum());
  const FaultSum ugly = { 0, 5. };
  EXPECT_TRUE(ugly < faults.sum()) << "what is wrong goes before what is ugly";
  KnownOverlaps everywhere;
  everywhere.ofSurface.emplace(std::vector<Box>{ { Vec3::Constant(-2), Vec3::Constant(2) } });
  EXPECT_EQ(MeshFaults(t->mesh, everywhere).sum().overlaps, 0) << "where the surface has them";
}

TEST(LocalRefinement, EdgesGetShorterInOnePlaceAndNoneIsLost)
{
  const auto t = meshes::patch(24);
  OptimizedMesh& mesh = t->mesh;
  const int faces = mesh.faces().size();
  const Face middle = mesh.face(mesh.halfedge(t->edgeBetween(312, 338)));
  const auto [a, b, c] = mesh.corners(middle);
  const Vec3 place = (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3.;
  const std::vector<Vertex> near = within(mesh, place, 0.05);
  const double before = meanEdge(mesh, near);
  const std::vector<Triangle> triangles = mesh.triangles();
  std::vector<Vertex> changed;
  ASSERT_TRUE(refineAbout(mesh, { middle }, changed).ok());
  EXPECT_EQ(mesh.faces().size(), faces);
  for (const Vertex v : { a, b, c })
  {
    EXPECT_LT(mesh.fineness(v), 0.9);
    EXPECT_GT(mesh.density(v), 1.2);
  }
  EXPECT_GT(within(mesh, place, 0.05).size(), near.size());
  EXPECT_LT(meanEdge(mesh, within(mesh, place, 0.05)), 0.9 * before);
  // Triangles that changed are about vertices that are said to have.
  std::size_t same = 0;
  for (const Triangle& u : mesh.triangles())
  {
    const bool isChanged = std::any_of(u.begin(), u.end(),
      [&](int v) { return std::binary_search(changed.begin(), changed.end(), Vertex(v)); });
    const bool wasThere = std::find_if(triangles.begin(), triangles.end(), [&](const Triangle& o) {
      return std::is_permutation(o.begin(), o.end(), u.begin());
    }) != triangles.end();
    same += wasThere ? 1 : 0;
    EXPECT_TRUE(wasThere || isChanged) << u[0] << " " << u[1] << " " << u[2];
  }
  EXPECT_GT(same, mesh.faces().size() * 3U / 4U) << "all the rest is as it was";
}
