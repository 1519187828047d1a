// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Swaps, steps, repairs and measures of the optimisation, each alone, where the answer is known.
#include "BridgeSwaps.h"
#include "EdgeSwaps.h"
#include "FailedMoves.h"
#include "LocalEmbedding.h"
#include "LocalRepair.h"
#include "MeshCrossings.h"
#include "OptimizerMeshes.h"
#include "Relaxation.h"
#include "SelfIntersections.h"
#include "SpacingRegions.h"
#include "SurfaceError.h"
#include "SurfaceProximity.h"
#include "Tuning.h"
#include "VertexStar.h"

using namespace stipple;
using meshes::worstOf;

namespace
{
/// The inner vertices of a patch, moved at random by up to `most` of an edge.
void jitter(meshes::TestMesh& t, int m, double most)
{
  std::mt19937 engine(5);
  const auto random = [&]() { return most / m * (engine() / 2147483648. - 1.); };
  for (const Vertex v : t.mesh.vertices())
  {
    if (t.mesh.isFree(v))
    {
      const Vec3 p = t.mesh.position(v);
      const double dx = random();
      const double dy = random();
      t.edit.put(v, t.pointAt(p.x() + dx, p.y() + dy));
    }
  }
}
}

TEST(EdgeSwaps, DelaunayLeavesNoEdgeToSwap)
{
  const auto t = meshes::patch(8);
  jitter(*t, 8, 0.4);
  const auto wanted = [&]() {
    int count = 0;
    for (const Edge e : t->mesh.edges())
    {
      count += isDelaunaySwap(t->mesh, e);
    }
    return count;
  };
  EXPECT_GT(wanted(), 10);
  const double before = worstOf(t->mesh);
  EXPECT_GT(delaunaySwaps(t->edit, 20), 10);
  EXPECT_EQ(wanted(), 0);
  EXPECT_GE(worstOf(t->mesh), before) << "Delaunay triangulations have the largest least angle";
}

TEST(EdgeSwaps, RegularitySwapsMakeValencesSix)
{
  const auto t = meshes::patch(6);
  EXPECT_EQ(regularitySwaps(t->edit, 0.5, 5), 0) << "a lattice is as regular as can be";
  t->edit.flip(t->edgeBetween(24, 32));
  EXPECT_EQ(t->mesh.valence(Vertex(25)), 7);
  EXPECT_EQ(regularitySwaps(t->edit, 0.8, 5), 0) << "45 degrees are 0.785, and were there before";
  EXPECT_EQ(regularitySwaps(t->edit, 0.7, 5), 1);
  for (const int v : { 24, 25, 31, 32 })
  {
    EXPECT_EQ(t->mesh.valence(Vertex(v)), 6);
  }
}

TEST(EdgeSwaps, AspectSwapsRaiseTheLeastAspect)
{
  const auto t = meshes::patch(4);
  t->edit.put(Vertex(12), t->pointAt(0.6, 0.6)); // the diagonal 12-18 is the short one now
  t->edit.put(Vertex(18), t->pointAt(0.7, 0.7));
  t->edit.flip(t->edgeBetween(12, 18));
  EXPECT_EQ(aspectSwaps(t->edit, 1) > 0, true);
  EXPECT_TRUE(t->edgeBetween(12, 18).valid());
}

TEST(BridgeSwaps, AnEdgeOverAValleyGoesDownIntoIt)
{
  // Two slopes that meet in a valley along x = 1/2, where edges of the mesh lie.
  const auto t =
    meshes::patchOf(4, [](double x, double y) { return Vec3(x, y, 3. * std::abs(x - 0.5)); });
  const auto swap = [&]() { return swapBridges(t->edit, Tuning::FarShare, 1.); };
  EXPECT_EQ(swap(), 0) << "all edges are on the surface";
  const Edge valley = t->edgeBetween(7, 12);
  t->edit.flip(valley);
  const SurfaceProximity surface(t->mesh);
  EXPECT_GT(surface.distanceOf(t->edgeBetween(6, 13)), 0.2);
  EXPECT_EQ(swap(), 1);
  EXPECT_LT(surface.distanceOf(t->edgeBetween(7, 12)), 1e-12);
  EXPECT_LT(surface.largest().faces, 1e-12);
}

TEST(BridgeSwaps, AnEdgeStaysWhereTheOtherWouldBeNoNearer)
{
  // A saddle over the square in the middle, less high than deep: one diagonal runs over it, the
  // other one farther away below.
  const auto t = meshes::patchOf(5, [](double x, double y) {
    const double p = 100. * std::clamp(x - 0.5, -0.1, 0.1) * std::clamp(y - 0.5, -0.1, 0.1);
    return Vec3(x, y, (p > 0 ? 0.1 : 0.2) * p);
  });
  const SurfaceProximity surface(t->mesh);
  const Edge over = t->edgeBetween(14, 21);
  const double near = surface.distanceOf(over);
  EXPECT_GT(near, 0.03) << "which shows";
  EXPECT_EQ(swapBridges(t->edit, Tuning::FarShare, 1.), 0);
  t->edit.flip(over);
  EXPECT_GT(surface.distanceOf(t->edgeBetween(15, 20)), near);
  EXPECT_EQ(swapBridges(t->edit, Tuning::FarShare, 1.), 1);
  EXPECT_EQ(surface.distanceOf(t->edgeBetween(14, 21)), near);
}

TEST(EdgeSwaps, ExcessesCountSectors)
{
  const auto t = meshes::patch(4);
  const auto at = [&](int v) {
    Halfedge inside = t->mesh.halfedge(Vertex(v));
    t->mesh.forEachCorner(Vertex(v), [&](Halfedge h) { inside = h; });
    return inside;
  };
  EXPECT_EQ(valenceExcess(t->mesh, at(12)), 0);
  EXPECT_EQ(valenceExcess(t->mesh, at(2)), 0) << "three triangles over 180 degrees";
  EXPECT_EQ(valenceExcess(t->mesh, at(0)), 0) << "two over 90 degrees";
  EXPECT_EQ(valenceExcess(t->mesh, at(4)), -1) << "one over 90 degrees";
  t->edit.flip(t->edgeBetween(2, 8));
  EXPECT_EQ(valenceExcess(t->mesh, at(2)), -1);
  EXPECT_EQ(ribExcess(t->mesh, at(2)), -1);
  EXPECT_EQ(valenceExcess(t->mesh, at(7)), 1);
  EXPECT_EQ(irregularity(0), 0);
  EXPECT_EQ(irregularity(-1), 0);
  EXPECT_EQ(irregularity(2), 2);
  EXPECT_EQ(irregularity(-3), 5);
  // Swapping back makes 1 + 1 + 1 + 1 squares nought.
  EXPECT_EQ(costChangeOfSwap(
              t->mesh, t->edgeBetween(3, 7), [&](Halfedge h) { return valenceExcess(t->mesh, h); },
              [](Vertex, int x) { return x * x; }),
    -4);
}

TEST(VertexStar, QualityIsTheSmallestAngleOrAFold)
{
  const auto t = meshes::patch(4);
  EXPECT_NEAR(starQuality(t->mesh, Vertex(12)), 0.25 * Pi, 1e-12);
  const VertexStar star(t->mesh, Vertex(12));
  EXPECT_NEAR(star.quality(t->mesh.state(Vertex(12))), 0.25 * Pi, 1e-12);
  // (12, 13, 18) with 12 at (0.5, 0.45): atan(0.2 / ...) by the cosine rule of its corners
  const SurfacePoint there = t->pointAt(0.5, 0.45);
  const double quality = star.quality(there);
  EXPECT_LT(quality, 0.25 * Pi);
  EXPECT_TRUE(star.exceeds(there, quality - 1e-9));
  EXPECT_FALSE(star.exceeds(there, quality + 1e-9));
  t->edit.put(Vertex(12), there);
  EXPECT_DOUBLE_EQ(starQuality(t->mesh, Vertex(12)), quality) << "a star foretells the mesh's";
  EXPECT_LT(star.quality(t->pointAt(0.9, 0.5)), 0) << "beyond its ring triangles are folded";
  EXPECT_NEAR(triangleQuality(t->mesh,
                { { t->mesh.halfedge(Vertex(0)), t->mesh.halfedge(Vertex(6)),
                  t->mesh.halfedge(Vertex(1)) } }),
    -2., 0.5)
    << "and one that faces away is";
  EXPECT_EQ(triangleQuality(t->mesh,
              { { t->mesh.halfedge(Vertex(16)), t->mesh.halfedge(Vertex(17)),
                t->mesh.halfedge(Vertex(18)) } }),
    -2.)
    << "and one without an area, whose normal is rounding's";
}

TEST(VertexStar, TheWayBackFromAFoldDoesNotEndOnANeighbour)
{
  const auto t = meshes::patch(4);
  t->edit.put(Vertex(12), t->pointAt(0.9, 0.1)); // out of its ring
  const VertexStar star(t->mesh, Vertex(12));
  const double folded = star.quality(t->mesh.state(Vertex(12)));
  ASSERT_LT(folded, 0);
  const SurfacePoint onNeighbour = t->mesh.state(Vertex(13));
  EXPECT_GT(star.quality(onNeighbour), folded) << "it would be the smaller fault";
  EXPECT_FALSE(star.exceeds(onNeighbour, folded));
  EXPECT_TRUE(star.exceeds(t->pointAt(0.5, 0.45), folded));
}

TEST(Relaxation, LatticesRest)
{
  const auto t = meshes::patch(4);
  EXPECT_LT(lloydStep(t->mesh, Vertex(12)).norm(), 1e-14);
  EXPECT_LT(laplacianStep(t->mesh, Vertex(12), false).norm(), 1e-14);
  EXPECT_LT(stepToMiddle(t->mesh, Vertex(12)).norm(), 1e-14);
  EXPECT_LT(towardsRidges(t->mesh, Vertex(12), Vec3(0.1, 0, 0)).x(), 0.1 + 1e-12);
  EXPECT_NEAR(meanEdgeLength(t->mesh, Vertex(12)), (4. + 2. * std::sqrt(2.)) / 24., 1e-12);
  EXPECT_TRUE(exceedsEdges(t->mesh, Vertex(12), 0.15, 0.5));
  EXPECT_FALSE(exceedsEdges(t->mesh, Vertex(12), 0.14, 0.5));
}

TEST(Relaxation, StepsLeadBack)
{
  const auto t = meshes::patch(4);
  t->edit.put(Vertex(12), t->pointAt(0.53, 0.48));
  const Vec3 back = Vec3(0.5, 0.5, 0) - t->mesh.position(Vertex(12));
  FaceMeasures measures;
  measures.update(t->mesh);
  const Vec3 lloyd = lloydStep(t->mesh, measures, Vertex(12), true);
  EXPECT_EQ(lloyd, lloydStep(t->mesh, Vertex(12))) << "measured at once or one by one";
  for (const Vec3& step :
    { lloyd, laplacianStep(t->mesh, Vertex(12), true), stepToMiddle(t->mesh, Vertex(12)) })
  {
    EXPECT_GT(step.dot(back), 0.3 * back.squaredNorm());
    EXPECT_LT((step - back).norm(), 0.8 * back.norm());
  }
  EXPECT_LT((stepToMiddle(t->mesh, Vertex(12)) - back).norm(), 1e-14);
}

TEST(Relaxation, BackbonesSpaceTheirVerticesEvenly)
{
  const auto t = meshes::patch(4);
  EXPECT_TRUE(t->edit.trySlide(Vertex(2), 0.1, []() { return true; }));
  ElementArray<Vertex, double> arcLength(25, -1.);
  relaxBackbones(t->mesh, { 0, 1, 1, 1 }, arcLength);
  EXPECT_EQ(arcLength[Vertex(1)], -1.) << "not asked for";
  relaxBackbones(t->mesh, { 1, 0, 0, 0 }, arcLength);
  EXPECT_NEAR(arcLength[Vertex(1)], 0.25, 1e-12);
  EXPECT_NEAR(arcLength[Vertex(2)], 0.5, 1e-12);
  EXPECT_NEAR(arcLength[Vertex(3)], 0.75, 1e-12);
  EXPECT_EQ(arcLength[Vertex(0)], -1.) << "corners have none";
  EXPECT_EQ(arcLength[Vertex(12)], -1.);
}

TEST(Relaxation, SlidesLeadBackAlongTheBackbone)
{
  const auto slideOf = [](const meshes::TestMesh& t) {
    FaceMeasures measures;
    measures.update(t.mesh);
    return lloydSlide(t.mesh, measures, Vertex(2));
  };
  const auto t = meshes::patch(4);
  EXPECT_NEAR(slideOf(*t), 0, 1e-12) << "cells are squares";
  EXPECT_TRUE(t->edit.trySlide(Vertex(2), 0.1, []() { return true; }));
  EXPECT_LT(slideOf(*t), -0.3 * 0.1);
  EXPECT_GT(slideOf(*t), -0.1);
}

TEST(Relaxation, SlidesInNarrowPartsGoToTheMiddle)
{
  // A hundredth as wide: the cell of a vertex that has slid reaches the other side of triangles.
  const auto t = meshes::patchOf(4, [](double x, double y) { return Vec3(x, 0.01 * y, 0); });
  EXPECT_TRUE(t->edit.trySlide(Vertex(2), 0.1, []() { return true; }));
  FaceMeasures measures;
  measures.update(t->mesh);
  EXPECT_NEAR(lloydSlide(t->mesh, measures, Vertex(2)),
    stepToMiddle(t->mesh, Vertex(2)).dot(Vec3(1, 0, 0)), 1e-9);
}

TEST(Relaxation, SlidesKeepNeighboursApart)
{
  // All about the vertex keeps it beside its neighbour, as on a small loop whose other neighbours
  // are far away: without a bound it would come ever nearer.
  const auto t = meshes::patchOf(4, [](double x, double y) { return Vec3(x, 0.01 * y, 0); });
  const auto always = []() { return true; };
  double left = 0.25; // to the neighbour
  for (; left > 0.01; left *= 0.5)
  {
    ASSERT_TRUE(t->edit.trySlide(Vertex(2), 0.5 * left, always));
  }
  ASSERT_TRUE(t->edit.trySlide(Vertex(1), 0.12, always));
  ASSERT_TRUE(t->edit.trySlide(Vertex(1), 0.06, always));
  t->edit.put(Vertex(6), t->pointAt(0.97, 0.25));
  t->edit.put(Vertex(7), t->pointAt(0.97, 0.25));
  t->edit.put(Vertex(8), t->pointAt(0.745, 0.05));
  FaceMeasures measures;
  measures.update(t->mesh);
  const double middle = stepToMiddle(t->mesh, Vertex(2)).x();
  const double bound = left - 0.5 * Tuning::NearestOnBackbone * (0.75 - 0.25 - 0.18);
  ASSERT_GT(middle, bound + 0.01);
  EXPECT_NEAR(lloydSlide(t->mesh, measures, Vertex(2)), bound, 1e-9);
}

TEST(LocalRepair, AVertexComesBackIntoItsRing)
{
  const auto t = meshes::patch(4);
  t->edit.put(Vertex(12), t->pointAt(0.72, 0.31)); // beyond the edge 8-13: folded
  EXPECT_LT(starQuality(t->mesh, Vertex(12)), 0);
  EXPECT_TRUE(improveByMove(t->edit, Vertex(12)));
  EXPECT_GT(starQuality(t->mesh, Vertex(12)), 0.7) << "45 degrees are .785";
  EXPECT_FALSE(improveByMove(t->edit, Vertex(0))) << "corners stay";
}

/// Of a tube's vertices, all put anywhere, one is moved to where it is better, forty times over:
/// how often it stays folded, and how often it then is farther from a neighbour than it was, and
/// than these are from each other.
std::array<int, 2> foldedAndFarOnTube(bool staysInRing)
{
  std::array<int, 2> count = { { 0, 0 } };
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> anywhere(0.05, 0.95);
  const auto onTube = [](double u, double v) {
    return Vec3(std::cos(5.8 * u), std::sin(5.8 * u), 6. * v);
  };
  for (int i = 0; i < 40; ++i)
  {
    const auto t = meshes::patchOf(6, onTube);
    for (const Vertex u : t->mesh.vertices())
    {
      if (t->mesh.isFree(u))
      {
        t->edit.put(u, t->pointAt(anywhere(engine), anywhere(engine)));
      }
    }
    const Vertex v(7 * (1 + i % 5) + 1 + i / 5 % 5);
    std::vector<Vec3> places = { t->mesh.position(v) };
    t->mesh.forEachNeighbour(v, [&](Vertex u) { places.push_back(t->mesh.position(u)); });
    double farthest = 0;
    for (const Vec3& p : places)
    {
      for (const Vec3& q : places)
      {
        farthest = std::max(farthest, (p - q).norm());
      }
    }
    improveByMove(t->edit, v, staysInRing);
    if (starQuality(t->mesh, v) < 0)
    {
      ++count[0];
      count[1] += std::any_of(places.begin() + 1, places.end(),
        [&](const Vec3& p) { return (p - t->mesh.position(v)).norm() > farthest + 1e-9; });
    }
  }
  return count;
}

TEST(LocalRepair, WhatStaysFoldedStaysInItsRing)
{
  const auto [folded, far] = foldedAndFarOnTube(true);
  EXPECT_GT(folded, 0);
  EXPECT_EQ(far, 0);
  EXPECT_GT(foldedAndFarOnTube(false)[1], 0) << "or this could not fail";
}

TEST(LocalRepair, SettlingMakesAllGoodOrSaysNo)
{
  const auto t = meshes::patch(6);
  jitter(*t, 6, 0.35);
  std::vector<Vertex> free;
  std::vector<Face> all;
  for (const Vertex v : t->mesh.vertices())
  {
    if (t->mesh.isFree(v))
    {
      free.push_back(v);
    }
  }
  for (const Face f : t->mesh.faces())
  {
    all.push_back(f);
  }
  const double before = worstOf(t->mesh);
  EXPECT_LT(before, 0.5);
  EXPECT_TRUE(settle(t->edit, free, all, 0.6, 0.5, 20));
  EXPECT_GE(worstOf(t->mesh), 0.5);
  EXPECT_FALSE(settle(t->edit, free, all, 1.2, 1.1, 3)) << "not all can be equilateral";
}

// Over a notch in the side of a flat square lie two triangles that are no surface. Every swap on
// the way back leaves one that is as folded.
TEST(LocalRepair, WhatCoversANotchIsSwappedAway)
{
  const auto t = meshes::patchOf(5, [](double u, double v) {
    const double notch = 2. * std::clamp(1.5 - 5. * std::abs(u - 0.5), 0., 1.) * 0.2;
    return Vec3(u, v + (1. - v) * notch, 0.);
  });
  ASSERT_EQ(repairTriangles(t->edit, 0., true, false, 10), 0);
  const std::vector<Triangle> before = t->mesh.triangles();
  for (const auto& [a, b] : { std::pair(2, 9), { 2, 8 }, { 3, 10 }, { 3, 9 }, { 3, 8 } })
  {
    t->edit.flip(t->edgeBetween(a, b));
  }
  double area = 0;
  for (const Face f : t->mesh.faces())
  {
    area += t->mesh.faceArea(f);
  }
  EXPECT_GT(area, 1.1) << "of a square with a notch";
  EXPECT_LT(worstOf(t->mesh), -0.5);
  EXPECT_EQ(repairTriangles(t->edit, 0., true, false, 10), 0);
  EXPECT_EQ(t->mesh.triangles().size(), before.size());
  EXPECT_GT(worstOf(t->mesh), 0.);
}

TEST(LocalRepair, TrianglesAndValencesAreRepaired)
{
  const auto t = meshes::patch(6);
  jitter(*t, 6, 0.45);
  EXPECT_LT(worstOf(t->mesh), 0.4);
  EXPECT_EQ(repairTriangles(t->edit, 0.45, true, true, 10), 0);
  EXPECT_GE(worstOf(t->mesh), 0.45);

  const auto u = meshes::patch(8);
  u->edit.flip(u->edgeBetween(30, 40));
  u->edit.flip(u->edgeBetween(40, 50)); // of valence 4 now
  const auto irregular = [&]() {
    int count = 0;
    for (const Vertex v : u->mesh.vertices())
    {
      count += u->mesh.isFree(v) && irregularity(u->mesh.valence(v) - 6) > 0;
    }
    return count;
  };
  const int before = irregular();
  ASSERT_GT(before, 0);
  const double worst = worstOf(u->mesh);
  EXPECT_GT(repairValences(u->edit, 0.5, 5), 0);
  EXPECT_LT(irregular(), before);
  EXPECT_GE(worstOf(u->mesh), std::min(0.5, worst)) << "and no angle is the price";
}

TEST(LocalRepair, EqualizedTrianglesAreAlike)
{
  const auto t = meshes::patch(6);
  jitter(*t, 6, 0.3);
  std::vector<Vertex> free;
  for (const Vertex v : t->mesh.vertices())
  {
    if (t->mesh.isFree(v))
    {
      free.push_back(v);
    }
  }
  const auto variation = [&]() {
    double squares = 0;
    for (const Face f : t->mesh.faces())
    {
      squares += std::pow(t->mesh.faceArea(f) - 1. / 72., 2);
    }
    return squares;
  };
  const double before = variation();
  const Vec3 held = t->mesh.position(Vertex(24));
  equalizeTriangles(t->edit, free, 0.3, 10, [](Vertex v) { return v != Vertex(24); });
  EXPECT_LT(variation(), 0.2 * before);
  EXPECT_EQ(t->mesh.position(Vertex(24)), held) << "what is not accepted stays";
}

TEST(SurfaceError, IsTheDistanceOfTheSurfacesPoints)
{
  const auto flat = meshes::patch(4);
  const SurfaceError none(flat->mesh);
  for (const Vertex v : flat->mesh.vertices())
  {
    EXPECT_LT(none.at(v).sum, 1e-28);
  }
  // One point of the surface, off every vertex, stands out by 0.1: 1 / 16 of it lies on no vertex.
  const auto t = meshes::patch(4,
    [](double x, double y) { return std::abs(x - 0.5625) + std::abs(y - 0.5) < 1e-9 ? 0.1 : 0.; });
  const SurfaceError error(t->mesh);
  double largest = 0;
  for (const Vertex v : t->mesh.vertices())
  {
    largest = std::max(largest, error.at(v).largest);
  }
  EXPECT_NEAR(largest, 0.01, 1e-12) << "squared";
  const SurfaceError::Measure about = error.about(Vertex(12));
  EXPECT_NEAR(about.sum, 0.01, 1e-12);
  EXPECT_LT((t->atlas->surface().points[about.farthest] - Vec3(0.5625, 0.5, 0.1)).norm(), 1e-14);
}

TEST(SurfaceError, MovesLowerIt)
{
  // A roof whose ridge runs between two columns of vertices
  const auto t = meshes::patch(8, [](double x, double) { return -0.6 * std::abs(x - 0.46875); });
  const auto total = [&]() {
    const SurfaceError error(t->mesh);
    double sum = 0;
    for (const Vertex v : t->mesh.vertices())
    {
      sum += error.at(v).sum;
    }
    return sum;
  };
  const double before = total();
  const double worst = worstOf(t->mesh);
  constexpr double angle = 0.6;
  EXPECT_GT(reduceSurfaceError(t->edit, angle, 1.), 0);
  EXPECT_LT(total(), 0.6 * before);
  EXPECT_GE(worstOf(t->mesh), std::min(angle, worst) - 1e-6);
}

TEST(SurfaceProximity, KnowsDistancesAndSides)
{
  const auto t = meshes::cube(200, false);
  const SurfaceProximity proximity(t->mesh);
  const SurfaceDistances largest = proximity.largest();
  EXPECT_LT(largest.faces, 1e-9) << "no triangle of the cube cuts an edge off";
  EXPECT_LT(largest.creases, 1e-9);
  for (const Face f : t->mesh.faces())
  {
    EXPECT_TRUE(proximity.facesOutwards(f));
  }
  // A vertex of a face goes to the opposite face.
  Vertex v;
  for (const Vertex u : t->mesh.vertices())
  {
    v = t->mesh.isFree(u) && t->mesh.position(u).z() > 1 - 1e-9 ? u : v;
  }
  ASSERT_TRUE(v.valid());
  const std::vector<Face> faces = facesAbout(t->mesh, { v });
  const SurfaceDistances small = { 0.01, 0.01 };
  EXPECT_TRUE(proximity.isNear(faces, small));
  ProximityGuard guard(t->mesh, proximity, small);
  EXPECT_TRUE(guard.allows(v));
  const SurfacePoint before = t->mesh.state(v);
  SurfacePoint below = before;
  below.position.z() = -1;
  t->edit.put(v, below);
  EXPECT_FALSE(proximity.isNear(faces, small));
  EXPECT_FALSE(guard.allows(v));
  EXPECT_GT(proximity.distanceAbout(v), 0.4);
  t->edit.put(v, before);
  EXPECT_TRUE(guard.allows(v));
}

TEST(SelfIntersections, CountsPairsAsVerticesMove)
{
  const auto t = meshes::cube(400, true);
  SelfIntersections intersections(t->mesh);
  EXPECT_TRUE(intersections.faces().empty());
  Vertex top;
  for (const Vertex v : t->mesh.vertices())
  {
    top = t->mesh.isFree(v) && (!top.valid() || t->mesh.position(v).z() > t->mesh.position(top).z())
      ? v
      : top;
  }
  const std::vector<Face> faces = facesAbout(t->mesh, { top });
  SurfacePoint below = t->mesh.state(top);
  below.position.z() = -1.5; // a needle through the opposite side
  const bool isThrough = t->edit.tryPut(top, below, [&]() {
    EXPECT_GE(intersections.count(faces), 3);
    intersections.update(faces);
    EXPECT_GE(intersections.faces().size(), 4U);
    return false;
  });
  EXPECT_FALSE(isThrough);
  intersections.update(faces);
  EXPECT_EQ(intersections.count(faces), 0);
  EXPECT_TRUE(intersections.faces().empty());
}

TEST(SelfIntersections, SwapsBetweenHeldCornersMakeNone)
{
  for (const bool isHeld : { false, true })
  {
    const auto t = meshes::foldedPatch(isHeld);
    const auto at = [](int i, int j) { return meshes::FoldedRow * j + i; };
    const Edge above = t->edgeBetween(at(3, 4), at(4, 5));
    const Edge below = t->edgeBetween(at(3, 3), at(4, 4));
    EXPECT_TRUE(swapStaysApart(t->mesh, above) && swapStaysApart(t->mesh, below));
    EXPECT_TRUE(t->edit.swap(below));
    EXPECT_EQ(swapStaysApart(t->mesh, above), !isHeld);
    EXPECT_EQ(t->edit.swap(above), !isHeld);
    EXPECT_EQ(SelfIntersections(t->mesh).faces().empty(), isHeld);
    EXPECT_TRUE(swapStaysApart(t->mesh, below)) << "what does already may stay so, or part";
  }
}

TEST(SelfIntersections, AreTheSurfacesWhereItHasThem)
{
  const auto t = meshes::patch(8);
  t->edit.put(Vertex(40), t->pointAt(0.8, 0.5)); // far out of its ring: triangles lie over others
  t->edit.put(Vertex(41), t->pointAt(0.4, 0.5));
  const std::size_t before = SelfIntersections(t->mesh).faces().size();
  ASSERT_GT(before, 0U);
  const meshes::Snapshot folded(t->mesh);
  KnownOverlaps everywhere;
  everywhere.ofSurface.emplace(std::vector<Box>{ { Vec3::Constant(-2), Vec3::Constant(2) } });
  EXPECT_EQ(resolveSelfIntersections(t->edit, 8, everywhere), 0);
  EXPECT_EQ(everywhere.left, 0) << "which is known then";
  EXPECT_TRUE(meshes::Snapshot(t->mesh) == folded) << "nothing is to be parted";
  KnownOverlaps nothing;
  EXPECT_EQ(resolveSelfIntersections(t->edit, 8, nothing), 0);
  EXPECT_TRUE(SelfIntersections(t->mesh).faces().empty()) << "the surface is flat";
}

TEST(LocalEmbedding, UndoesFoldsAndTakesBackWhatDoesNotHelp)
{
  const auto t = meshes::patch(8);
  FailedEmbeddings failed;
  EXPECT_EQ(unfold(t->edit, true, failed), 0) << "nothing to undo";
  t->edit.put(Vertex(40), t->pointAt(0.8, 0.5)); // far out of its ring
  t->edit.put(Vertex(41), t->pointAt(0.4, 0.5));
  std::vector<Face> folded;
  for (const Face f : t->mesh.faces())
  {
    if (faceQuality(t->mesh, f) < Tuning::AngleOfFold)
    {
      folded.push_back(f);
    }
  }
  ASSERT_FALSE(folded.empty());
  EXPECT_EQ(groupsOf(t->mesh, folded).size(), 1U);
  const meshes::Snapshot before(t->mesh);
  int looks = 0;
  const auto nothing = [&](FailedEmbeddings& known) {
    return embedAbout(
      t->edit, folded, 2, true, known, [&](const std::vector<Face>&) { return ++looks; },
      [](int, int) { return false; });
  };
  FailedEmbeddings inVain;
  EXPECT_TRUE(nothing(inVain).empty());
  EXPECT_TRUE(meshes::Snapshot(t->mesh) == before);
  EXPECT_GT(looks, 0);
  looks = 0;
  EXPECT_TRUE(nothing(inVain).empty());
  EXPECT_EQ(looks, 0) << "what failed is not tried again";
  t->edit.put(Vertex(41), t->pointAt(0.5, 0.6));
  EXPECT_TRUE(nothing(inVain).empty());
  EXPECT_GT(looks, 0) << "but where something moved";
  t->edit.put(Vertex(41), t->pointAt(0.4, 0.5));
  EXPECT_EQ(unfold(t->edit, true, failed), 1);
  EXPECT_GT(worstOf(t->mesh), 0.3);
}

TEST(LocalEmbedding, UnfoldsForHalfOfWhatIsLeftAtMost)
{
  const auto t = meshes::patch(8);
  t->edit.put(Vertex(40), t->pointAt(0.8, 0.5)); // far out of its ring
  FailedEmbeddings failed;
  int& budget = failed.budget(t->mesh);
  EXPECT_EQ(budget, Tuning::EmbeddingBudget * Tuning::FewTriangles) << "more than the mesh has";
  budget = 0;
  const meshes::Snapshot folded(t->mesh);
  EXPECT_EQ(unfold(t->edit, true, failed), 0);
  EXPECT_TRUE(meshes::Snapshot(t->mesh) == folded);
  budget = 1000;
  EXPECT_EQ(unfold(t->edit, true, failed), 1);
  EXPECT_EQ(failed.budget(t->mesh), budget) << "it is asked for once";
  EXPECT_LT(budget, 1000);
  EXPECT_GT(budget, 0);
}

TEST(FailedMoves, AreKnownUntilSomethingAboutTheVertexChanges)
{
  const auto t = meshes::patch(8);
  const Vertex v(40);
  const std::uint64_t before = fingerprintOf(t->mesh, v);
  FailedMoves<2> failed;
  EXPECT_FALSE(failed.contains(v, 0, before));
  failed.add(t->mesh, v, 0, before);
  EXPECT_TRUE(failed.contains(v, 0, before));
  EXPECT_FALSE(failed.contains(v, 1, before)) << "in another way";
  EXPECT_FALSE(failed.contains(Vertex(41), 0, before)) << "another vertex";

  Vertex neighbour;
  t->mesh.forEachNeighbour(v, [&](Vertex u) { neighbour = u; });
  const auto changes = [&](const auto& change) {
    std::uint64_t now = before;
    t->edit.attempt([&] {
      change();
      now = fingerprintOf(t->mesh, v);
      return false;
    });
    EXPECT_EQ(fingerprintOf(t->mesh, v), before) << "taken back";
    return now != before;
  };
  const auto nudged = [&](Vertex u) {
    const Vec3& p = t->mesh.position(u);
    return t->pointAt(p.x() + 1e-9, p.y());
  };
  EXPECT_TRUE(changes([&] { t->edit.put(v, nudged(v)); }));
  EXPECT_TRUE(changes([&] { t->edit.put(neighbour, nudged(neighbour)); }));
  EXPECT_TRUE(changes([&] {
    Halfedge h;
    t->mesh.forEachCorner(v, [&](Halfedge g) { h = g; });
    t->edit.flip(t->mesh.edge(h));
  }));
  EXPECT_FALSE(changes([&] { t->edit.put(Vertex(0), nudged(Vertex(0))); })) << "far away";
}

TEST(FailedMoves, SpareTheSameAttemptAgain)
{
  const auto t = meshes::patch(8);
  const Vertex v(40);
  while (improveByMove(t->edit, v))
  {
  }
  const std::uint64_t best = fingerprintOf(t->mesh, v);
  EXPECT_TRUE(t->edit.failedMoves().contains(v, 0, best));
  EXPECT_FALSE(t->edit.failedMoves().contains(v, 1, best)) << "that way was not tried";
  t->edit.put(v, t->pointAt(0.52, 0.51));
  EXPECT_TRUE(improveByMove(t->edit, v)) << "from here it is not known";
}

// Placed in the middle of their neighbours, vertices leave what is deeper than wide: a shallow
// hollow is as good as before, a pocket would be lost.
TEST(LocalEmbedding, DoesNotLeaveAPocket)
{
  for (const double depth : { 0.05, 0.5, 3. })
  {
    const auto t = meshes::patch(8, [=](double x, double y) {
      return -depth * std::exp(-100. * Vec2(x - 0.5, y - 0.5).squaredNorm());
    });
    const std::vector<Vertex> vertices = withRings(t->mesh, { Vertex(40) }, 2);
    const meshes::Snapshot before(t->mesh);
    const bool isKept = t->edit.attempt(
      [&]() { return embed(t->edit, vertices, facesAbout(t->mesh, vertices), true); });
    EXPECT_EQ(isKept, depth < 0.1) << depth;
    EXPECT_EQ(meshes::Snapshot(t->mesh) == before, depth > 0.1) << depth;
    EXPECT_NEAR(t->mesh.position(Vertex(40)).z(), -depth, 0.1 * depth);
  }
}

TEST(LocalEmbedding, GroupsHangTogetherAtVertices)
{
  const auto t = meshes::patch(4);
  std::vector<Face> faces = facesAbout(t->mesh, { Vertex(6) });
  for (const Face f : facesAbout(t->mesh, { Vertex(24) }))
  {
    faces.push_back(f);
  }
  makeUnique(faces);
  const auto groups = groupsOf(t->mesh, faces);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0], facesAbout(t->mesh, { Vertex(6) }));
  EXPECT_EQ(groups[1], facesAbout(t->mesh, { Vertex(24) }));
}

TEST(SpacingRegions, GrowthFallsWithTheDistance)
{
  const SpacingRegion region = { Vec3(0.5, 0.5, 0), 0.1, 2. };
  EXPECT_DOUBLE_EQ(region.growthAt(0.), 2.);
  EXPECT_DOUBLE_EQ(region.growthAt(0.1), 2.) << "the plateau is half of the growth, in spacings";
  EXPECT_DOUBLE_EQ(region.growthAt(0.2), 1.5);
  EXPECT_DOUBLE_EQ(region.growthAt(region.reach()), 1.);
  const auto t = meshes::patch(4);
  const SurfacePlace at = t->placeAt(0.5, 0.5);
  SpacingRegions regions;
  regions.add(t->atlas->surface(), Face(at.face), region);
  EXPECT_DOUBLE_EQ(regions.growthAt(Face(at.face), Vec3(0.5, 0.5, 0)), 2.);
  EXPECT_DOUBLE_EQ(regions.growthAt(Face(t->placeAt(0.7, 0.5).face), Vec3(0.7, 0.5, 0)), 1.5);
  EXPECT_DOUBLE_EQ(regions.growthAt(Face(t->placeAt(0.9, 0.5).face), Vec3(0.9, 0.5, 0)), 1.);
  t->mesh.coarsen(regions);
  EXPECT_DOUBLE_EQ(t->mesh.density(Vertex(12)), 0.25) << "twice the spacing";
  EXPECT_DOUBLE_EQ(t->mesh.density(Vertex(0)), 1.);
}

TEST(SpacingRegions, SpacingShrinksTheSameWay)
{
  const SpacingRegion region = { Vec3(0.5, 0.5, 0), 0.2, 0.5 };
  EXPECT_DOUBLE_EQ(region.growthAt(0.), 0.5);
  EXPECT_DOUBLE_EQ(region.growthAt(0.05), 0.5);
  EXPECT_DOUBLE_EQ(region.growthAt(0.15), 0.75);
  EXPECT_DOUBLE_EQ(region.growthAt(region.reach()), 1.);
  EXPECT_DOUBLE_EQ(region.reach(), 0.25);
  const auto t = meshes::patch(4);
  const Face middle(t->placeAt(0.5, 0.5).face);
  SpacingRegions regions;
  regions.add(t->atlas->surface(), middle, region);
  regions.add(t->atlas->surface(), middle, { region.centre, region.spacing, 0.75 });
  t->mesh.refine(regions);
  EXPECT_DOUBLE_EQ(t->mesh.fineness(Vertex(12)), 0.5) << "the finest counts";
  EXPECT_DOUBLE_EQ(t->mesh.density(Vertex(12)), 4.) << "half the spacing";
  EXPECT_DOUBLE_EQ(t->mesh.density(Vertex(0)), 1.);
  EXPECT_DOUBLE_EQ(t->mesh.fineness(Vertex(0)), 1.);
  SpacingRegions coarse;
  coarse.add(t->atlas->surface(), middle, { region.centre, region.spacing, 2. });
  t->mesh.coarsen(coarse);
  EXPECT_DOUBLE_EQ(t->mesh.density(Vertex(12)), 1.) << "of both, one makes up for the other";
}
