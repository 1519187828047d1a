// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The one way to change a mesh under optimisation: what is not kept is taken back to the bit, what
// would fold is refused.
#include "OptimizerMeshes.h"

using namespace stipple;
using meshes::Snapshot;

TEST(MeshEdit, WhatFailsIsTakenBackToTheBit)
{
  const auto t = meshes::patch(4, [](double x, double y) { return 0.2 * x * y; });
  MeshEdit& edit = t->edit;
  const Snapshot before(t->mesh);
  const bool kept = edit.attempt([&]() {
    edit.flip(t->edgeBetween(12, 18));
    edit.put(Vertex(12), t->pointAt(0.52, 0.47));
    EXPECT_TRUE(edit.trySlide(Vertex(2), 0.05, []() { return true; }));
    edit.flip(t->edgeBetween(6, 12));
    edit.put(Vertex(12), t->pointAt(0.41, 0.55));
    EXPECT_FALSE(Snapshot(t->mesh) == before);
    return false;
  });
  EXPECT_FALSE(kept);
  EXPECT_TRUE(Snapshot(t->mesh) == before);
}

TEST(MeshEdit, AttemptsNest)
{
  const auto t = meshes::patch(4);
  MeshEdit& edit = t->edit;
  const Snapshot before(t->mesh);
  const auto inner = [&](bool isKept) {
    return edit.attempt([&]() {
      edit.put(Vertex(6), t->pointAt(0.3, 0.3));
      return isKept;
    });
  };
  // An inner success goes with an outer failure.
  EXPECT_FALSE(edit.attempt([&]() {
    edit.flip(t->edgeBetween(12, 18));
    EXPECT_TRUE(inner(true));
    return false;
  }));
  EXPECT_TRUE(Snapshot(t->mesh) == before);
  // An inner failure leaves what the outer attempt did before and does after.
  EXPECT_TRUE(edit.attempt([&]() {
    edit.put(Vertex(18), t->pointAt(0.8, 0.7));
    EXPECT_FALSE(inner(false));
    edit.put(Vertex(7), t->pointAt(0.45, 0.2));
    return true;
  }));
  EXPECT_LT((t->mesh.position(Vertex(18)) - Vec3(0.8, 0.7, 0)).norm(), 1e-14);
  EXPECT_LT((t->mesh.position(Vertex(7)) - Vec3(0.45, 0.2, 0)).norm(), 1e-14);
  EXPECT_LT((t->mesh.position(Vertex(6)) - Vec3(0.25, 0.25, 0)).norm(), 1e-14);
  // What was kept is not taken back by a later failure.
  const Snapshot kept(t->mesh);
  EXPECT_FALSE(inner(false));
  EXPECT_TRUE(Snapshot(t->mesh) == kept);
}

TEST(MeshEdit, SwapsNeitherCreasesNorIntoFolds)
{
  const auto t = meshes::patch(4);
  MeshEdit& edit = t->edit;
  EXPECT_FALSE(edit.swap(t->edgeBetween(1, 2))) << "on the boundary";
  EXPECT_TRUE(edit.swap(t->edgeBetween(12, 18)));
  EXPECT_EQ(t->mesh.valence(Vertex(12)), 5);
  EXPECT_EQ(t->mesh.valence(Vertex(13)), 7);
  EXPECT_TRUE(t->edgeBetween(13, 17).valid());
  // With the vertex 18 beyond the line from 13 to 17, the quad about 12-18 is not convex.
  const auto u = meshes::patch(4);
  u->edit.put(Vertex(18), u->pointAt(0.6, 0.6));
  EXPECT_FALSE(u->edit.swap(u->edgeBetween(12, 18)));
  // A triangle of the boundary's edges without an area would be left.
  const auto w = meshes::patch(4);
  EXPECT_TRUE(w->edit.swap(w->edgeBetween(0, 6)));
  EXPECT_TRUE(w->edit.swap(w->edgeBetween(1, 5)));
  w->edit.put(Vertex(1), w->pointAt(1e-6, 0.));
  EXPECT_FALSE(w->edit.swap(w->edgeBetween(0, 6)));
}

TEST(MeshEdit, SlidesAtMostHalfTheWay)
{
  const auto t = meshes::patch(4);
  const auto yes = []() { return true; };
  EXPECT_FALSE(t->edit.trySlide(Vertex(12), 0.01, yes)) << "it is on no backbone";
  EXPECT_FALSE(t->edit.trySlide(Vertex(0), 0.01, yes)) << "a corner stays";
  EXPECT_FALSE(t->edit.trySlide(Vertex(2), 0.13, yes)) << "more than half an edge";
  const Snapshot before(t->mesh);
  EXPECT_FALSE(t->edit.trySlide(Vertex(2), 0.12, []() { return false; }));
  EXPECT_TRUE(Snapshot(t->mesh) == before);
  EXPECT_TRUE(t->edit.trySlide(Vertex(2), 0.12, yes));
  EXPECT_LT((t->mesh.position(Vertex(2)) - Vec3(0.62, 0, 0)).norm(), 1e-14);
  EXPECT_NEAR(t->mesh.arcLength(Vertex(2)), 0.62, 1e-14);
}

TEST(MeshEdit, TriesAllDirections)
{
  const auto t = meshes::patch(4);
  Vec3 sum = Vec3::Zero();
  int steps = 0;
  t->edit.tryAround(
    Vertex(12), 0.1,
    [&](const Vec3& step) {
      EXPECT_NEAR(step.norm(), 0.1, 1e-15);
      EXPECT_EQ(step.z(), 0.) << "in the tangent plane";
      sum += step;
      ++steps;
    },
    []() { return false; });
  EXPECT_EQ(steps, 8);
  EXPECT_LT(sum.norm(), 1e-14);
  // On a backbone it slides as long as that helps.
  double best = 0.1;
  t->edit.tryAround(
    Vertex(2), 0.03, [](const Vec3&) { ADD_FAILURE() << "a step off the backbone"; },
    [&]() {
      const double distance = std::abs(t->mesh.position(Vertex(2)).x() - 0.6);
      const bool isBetter = distance < best;
      best = std::min(best, distance);
      return isBetter;
    });
  EXPECT_NEAR(t->mesh.position(Vertex(2)).x(), 0.59, 1e-14);
}

TEST(MeshEdit, MovesAreDrawnBackBeforeTheyFold)
{
  const auto t = meshes::patch(4);
  ElementArray<Vertex, Vec3> step(25, Vec3::Zero());
  ElementArray<Vertex, double> arcLength(25, 0.);
  for (const Vertex v : t->mesh.vertices())
  {
    arcLength[v] = t->mesh.arcLength(v);
  }
  step[Vertex(6)] = Vec3(0.05, 0.02, 0);   // harmless
  step[Vertex(18)] = Vec3(-0.3, -0.25, 0); // beyond its ring; half of it is not
  arcLength[Vertex(2)] = 0.55;
  t->edit.moveAll(step, arcLength);
  EXPECT_LT((t->mesh.position(Vertex(6)) - Vec3(0.3, 0.27, 0)).norm(), 1e-14);
  EXPECT_LT((t->mesh.position(Vertex(18)) - Vec3(0.6, 0.625, 0)).norm(), 1e-14);
  EXPECT_LT((t->mesh.position(Vertex(2)) - Vec3(0.55, 0, 0)).norm(), 1e-14);
  EXPECT_EQ(step[Vertex(6)], Vec3(0.05, 0.02, 0)) << "momentum goes on";
  EXPECT_EQ(step[Vertex(18)], Vec3(Vec3::Zero())) << "but not into what was refused";
  for (const Face f : t->mesh.faces())
  {
    EXPECT_TRUE(t->mesh.isSound(f));
  }
}

TEST(MeshEdit, OnlySomeVerticesMove)
{
  const auto t = meshes::patch(6);
  MeshEdit& edit = t->edit;
  const auto n = static_cast<std::size_t>(t->mesh.vertices().size());
  ElementArray<Vertex, char> isMoving(n, 0);
  isMoving[Vertex(16)] = 1; // in the second row, third column
  isMoving[Vertex(3)] = 1;  // on the lower side
  edit.restrictTo(isMoving);
  const auto yes = []() { return true; };
  EXPECT_FALSE(edit.tryPut(Vertex(32), t->pointAt(0.68, 0.68), yes));
  EXPECT_TRUE(edit.tryPut(Vertex(16), t->pointAt(0.34, 0.34), yes));
  EXPECT_FALSE(edit.trySlide(Vertex(4), 0.02, yes));
  EXPECT_TRUE(edit.trySlide(Vertex(3), 0.02, yes));
  const Edge far = t->edgeBetween(32, 40);
  EXPECT_FALSE(edit.maySwap(far));
  EXPECT_FALSE(edit.swap(far));
  EXPECT_TRUE(edit.swap(t->edgeBetween(16, 24)));
  const meshes::Snapshot before(t->mesh);
  ElementArray<Vertex, Vec3> step(n, Vec3(0.01, 0.005, 0));
  ElementArray<Vertex, double> arcLength(n, 0.);
  for (const Vertex v : t->mesh.vertices())
  {
    arcLength[v] = t->mesh.arcLength(v) + 0.01;
  }
  edit.moveAll(step, arcLength);
  const meshes::Snapshot after(t->mesh);
  for (const Vertex v : t->mesh.vertices())
  {
    EXPECT_EQ(before.vertices[v.index()] == after.vertices[v.index()], isMoving[v] == 0)
      << v.index();
  }
  edit.restrictTo({});
  EXPECT_TRUE(edit.tryPut(Vertex(32), t->pointAt(0.68, 0.68), yes));
  EXPECT_TRUE(edit.maySwap(far));
}
