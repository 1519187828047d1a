// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Two neighbours on each side of vertices on creases: one fault at a time, then all of a mesh.
#include "EdgeSwaps.h"
#include "MeshOptimizer.h"
#include "OptimizerMeshes.h"
#include "RibSearch.h"
#include "Ribs.h"
#include "SurfaceProximity.h"
#include "VertexStar.h"

using namespace stipple;
using meshes::Snapshot;

namespace
{
constexpr SurfaceDistances Near = { 1e-6, 1e-6 };

double worstOf(const OptimizedMesh& mesh)
{
  double worst = 10;
  for (const Face f : mesh.faces())
  {
    worst = std::min(worst, faceQuality(mesh, f));
  }
  return worst;
}

/// The halfedge along a crease with a vertex's only side, or one of its sides, to the left.
Halfedge sideOf(const OptimizedMesh& mesh, Vertex v)
{
  Halfedge result;
  mesh.forEachCorner(v, [&](Halfedge h) { result = mesh.isCrease(mesh.edge(h)) ? h : result; });
  return result;
}

/// Sides of vertices on creases that have more or fewer than two neighbours.
int numberOfFaults(const OptimizedMesh& mesh)
{
  int count = 0;
  for (const Vertex v : mesh.vertices())
  {
    if (mesh.freedom(v) == Freedom::Backbone)
    {
      mesh.forEachCorner(
        v, [&](Halfedge h) { count += mesh.isCrease(mesh.edge(h)) && ribExcess(mesh, h) != 0; });
    }
  }
  return count;
}

/// 8 x 8 squares; the vertex 2 on the lower side lacks a neighbour, and the one `steps` farther has
/// one too many.
std::unique_ptr<meshes::TestMesh> patchWithFault(int steps)
{
  auto t = meshes::patch(8);
  for (int i = 0; i < steps; ++i)
  {
    t->edit.flip(t->edgeBetween(2 + i, 12 + i));
  }
  return t;
}
}

TEST(RibSearch, OneSwapMendsNeighbours)
{
  const auto t = patchWithFault(1);
  EXPECT_EQ(numberOfFaults(t->mesh), 2);
  const SurfaceProximity proximity(t->mesh);
  const Halfedge side = sideOf(t->mesh, Vertex(2));
  ASSERT_EQ(ribExcess(t->mesh, side), -1);
  EXPECT_FALSE(RibSearch(t->edit, proximity, 0).mend(side, { 1, 10, 0.3, Near }));
  RibSearch spent(t->edit, proximity, 2);
  EXPECT_FALSE(spent.mend(side, { 1, 10, 0.3, { -1., -1. } })) << "nothing is as near as that";
  EXPECT_FALSE(spent.mend(side, { 1, 10, 0.3, Near })) << "that trial has spent the budget";
  RibSearch search(t->edit, proximity, 2);
  EXPECT_TRUE(search.mend(side, { 1, 10, 0.3, Near }));
  EXPECT_EQ(numberOfFaults(t->mesh), 0);
  const auto& moved = search.moved();
  EXPECT_TRUE(std::find(moved.begin(), moved.end(), Vertex(12)) != moved.end());
  const Snapshot mended(t->mesh);
  EXPECT_FALSE(search.mend(side, { 1, 10, 0.3, Near })) << "there is nothing to mend";
  EXPECT_TRUE(Snapshot(t->mesh) == mended);
}

TEST(RibSearch, AFaultIsHandedOnAlongTheCrease)
{
  const auto t = patchWithFault(3);
  EXPECT_EQ(numberOfFaults(t->mesh), 2) << "only the ends of the row";
  const SurfaceProximity proximity(t->mesh);
  RibSearch search(t->edit, proximity, 1000);
  const Halfedge side = sideOf(t->mesh, Vertex(2));
  const Snapshot before(t->mesh);
  EXPECT_FALSE(search.mend(side, { 1, 10, 0.3, Near })) << "a swap alone only moves it";
  EXPECT_TRUE(Snapshot(t->mesh) == before);
  EXPECT_TRUE(search.moved().empty());
  EXPECT_TRUE(search.mend(side, { 100, 10, 0.3, Near }));
  EXPECT_EQ(ribExcess(t->mesh, sideOf(t->mesh, Vertex(2))), 0);
  EXPECT_LT(numberOfFaults(t->mesh), 2);
  EXPECT_GE(worstOf(t->mesh), 0.3);
}

TEST(RibSearch, WhatWasFoundInVainIsKeptForLesserDemands)
{
  const auto t = patchWithFault(3);
  const SurfaceProximity proximity(t->mesh);
  const Halfedge side = sideOf(t->mesh, Vertex(2));
  const RibDemand brief = { 2, 5, 0.3, Near };
  EXPECT_FALSE(RibSearch(t->edit, proximity, 1000).mend(side, brief));
  RibSearch search(t->edit, proximity, 1000);
  const Snapshot before(t->mesh);
  EXPECT_FALSE(search.mend(side, { 100, 5, 0.3, { -1., -1. } })) << "nothing is as near as that";
  EXPECT_TRUE(Snapshot(t->mesh) == before);
  EXPECT_TRUE(search.mend(side, brief)) << "with what the long search had found";
  EXPECT_EQ(ribExcess(t->mesh, sideOf(t->mesh, Vertex(2))), 0);
}

TEST(Ribs, WhatHasThemIsLeftAlone)
{
  const auto t = meshes::patch(6);
  const Snapshot before(t->mesh);
  EXPECT_EQ(makeRibs(t->edit, {}), 0);
  EXPECT_TRUE(Snapshot(t->mesh) == before);
}

TEST(Ribs, FaultsOfAPatchAreMended)
{
  const auto t = patchWithFault(3);
  EXPECT_GE(makeRibs(t->edit, {}), 1);
  EXPECT_EQ(numberOfFaults(t->mesh), 0);
  EXPECT_GT(worstOf(t->mesh), 0.43);
  for (const Vertex v : t->mesh.vertices())
  {
    if (t->mesh.freedom(v) == Freedom::None)
    {
      const SurfacePlace& place = t->mesh.place(v);
      const Sample& s = t->samples[v.index()];
      EXPECT_EQ(place.face, s.face);
      EXPECT_EQ(place.bary, s.bary);
    }
  }
}

TEST(Ribs, AreStoppedWhileTheyAreMade)
{
  const auto t = meshes::cube(400, false);
  ASSERT_TRUE(optimizeMesh(t->mesh, {}, {}).ok());
  int asked = 0;
  makeRibs(t->edit, [&asked] { return ++asked > 30; });
  EXPECT_GT(asked, 30) << "asked for each side";
  EXPECT_LT(asked, 60) << "and then it ends";
  for (const Face f : t->mesh.faces())
  {
    EXPECT_TRUE(t->mesh.isSound(f)) << "what was done is a mesh";
  }
}

TEST(Ribs, OfACubeCostNeitherFoldsNorEdges)
{
  const auto t = meshes::cube(400, false);
  ASSERT_TRUE(optimizeMesh(t->mesh, {}, {}).ok());
  const int before = numberOfFaults(t->mesh);
  EXPECT_GT(before, 10);
  const double worst = worstOf(t->mesh);
  EXPECT_GT(makeRibs(t->edit, {}), 0);
  EXPECT_LT(numberOfFaults(t->mesh), 0.1 * before);
  EXPECT_GE(worstOf(t->mesh), std::min(0.26, worst) - 1e-9);
  const SurfaceProximity proximity(t->mesh);
  for (const Face f : t->mesh.faces())
  {
    EXPECT_TRUE(proximity.facesOutwards(f));
  }
  EXPECT_LT(proximity.largest().faces, 1e-9);
  EXPECT_LT(proximity.largest().creases, 1e-9);
  // The optimiser makes them when it is asked to.
  const auto asked = meshes::cube(400, false);
  OptimizerOptions ribs;
  ribs.ribs = true;
  ASSERT_TRUE(optimizeMesh(asked->mesh, ribs, {}).ok());
  EXPECT_LT(numberOfFaults(asked->mesh), 0.1 * before);
}
