// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The schedule of the optimisation, and what goes before and after it: spacing in acute corners,
// and vertices off the surface.
#include "AcuteCorners.h"
#include "EdgeSwaps.h"
#include "LeastSquaresPlacement.h"
#include "MeshOptimizer.h"
#include "OptimizerMeshes.h"
#include "Tuning.h"
#include "VertexStar.h"

#include "vtkSMPTools.h"

using namespace stipple;
using meshes::Snapshot;
using meshes::worstOf;
using Swaps = OptimizerOptions::Swaps;
using Moves = OptimizerOptions::Moves;

namespace
{
/// The standard deviation of the triangles' areas over their mean.
double variationOfAreas(const OptimizedMesh& mesh)
{
  double sum = 0;
  double squares = 0;
  for (const Face f : mesh.faces())
  {
    sum += mesh.faceArea(f);
    squares += mesh.faceArea(f) * mesh.faceArea(f);
  }
  const double n = mesh.faces().size();
  return std::sqrt(squares * n / (sum * sum) - 1.);
}

OptimizerOptions options(Swaps swaps, Moves moves)
{
  OptimizerOptions result;
  result.swaps = swaps;
  result.moves = moves;
  return result;
}

void optimize(meshes::TestMesh& t, const OptimizerOptions& options)
{
  EXPECT_TRUE(optimizeMesh(t.mesh, options, {}).ok());
}
}

TEST(MeshOptimizer, SpreadsVerticesOverTheSphere)
{
  const auto t = meshes::cube(400, true);
  EXPECT_LT(worstOf(t->mesh), 0.4);
  EXPECT_GT(variationOfAreas(t->mesh), 0.25);
  optimize(*t, {});
  EXPECT_GT(worstOf(t->mesh), 0.62) << "35 degrees";
  EXPECT_LT(variationOfAreas(t->mesh), 0.1);
  int regular = 0;
  for (const Vertex v : t->mesh.vertices())
  {
    regular += t->mesh.valence(v) == 6;
    EXPECT_GE(t->mesh.valence(v), 5);
    EXPECT_LE(t->mesh.valence(v), 7);
    EXPECT_NEAR(t->mesh.position(v).norm(), 1., 0.01) << "on the surface, whose edges are chords";
  }
  EXPECT_GT(regular, 320);
}

TEST(MeshOptimizer, KeepsFeatures)
{
  const auto t = meshes::cube(200, false);
  const auto chains = t->mesh.chains();
  optimize(*t, {});
  EXPECT_EQ(t->mesh.chains(), chains);
  EXPECT_GT(worstOf(t->mesh), 0.45);
  for (const Vertex v : t->mesh.vertices())
  {
    int onPlanes = 0;
    for (int k = 0; k < 3; ++k)
    {
      onPlanes += std::abs(std::abs(t->mesh.position(v)[k]) - 1.) < 1e-12;
    }
    EXPECT_EQ(onPlanes, t->mesh.isFree(v) ? 1 : t->mesh.freedom(v) == Freedom::Backbone ? 2 : 3);
  }
  for (const auto& chain : chains)
  {
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      EXPECT_TRUE(
        t->mesh.isCrease(t->edgeBetween(chain[i - 1].vertex.index(), chain[i].vertex.index())));
    }
  }
}

TEST(MeshOptimizer, DoesOnlyWhatItIsTold)
{
  const auto start = meshes::cube(300, true);
  const Snapshot before(start->mesh);
  OptimizerOptions none;
  none.iterations = 0;
  optimize(*start, none);
  EXPECT_TRUE(Snapshot(start->mesh) == before);

  const auto moved = meshes::cube(300, true);
  optimize(*moved, options(Swaps::None, Moves::Lloyd));
  EXPECT_EQ(Snapshot(moved->mesh).triangles, before.triangles);
  EXPECT_NE(Snapshot(moved->mesh).vertices, before.vertices);

  for (const Swaps swaps : { Swaps::Regularity, Swaps::Aspect })
  {
    const auto swapped = meshes::cube(300, true);
    const auto disturbed = meshes::cube(300, true);
    for (const auto* some : { &swapped, &disturbed })
    {
      for (const Edge e : (*some)->mesh.edges())
      {
        if (e.index() % 5 == 0)
        {
          (*some)->edit.swap(e);
        }
      }
    }
    optimize(*swapped, options(swaps, Moves::None));
    EXPECT_NE(Snapshot(swapped->mesh).triangles, before.triangles);
    EXPECT_EQ(Snapshot(swapped->mesh).vertices, before.vertices);
    if (swaps == Swaps::Aspect)
    {
      EXPECT_LT(aspectSwaps(swapped->edit, 1), 15) << "hardly any edge is left to swap";
      EXPECT_GT(aspectSwaps(disturbed->edit, 1), 40);
    }
  }
}

TEST(EdgeSwaps, AspectSwapsDoNotCutThroughRidges)
{
  // Two triangles about a ridge, with a base of 1.2 and .72 high, whose tops are .95 apart in
  // space: these would make fatter triangles over the gap, but thinner ones on the surface.
  const auto swapsOf = [](double depth) {
    const auto t = meshes::patchOf(1, [depth](double u, double v) {
      return Vec3(0.6 * (u + v), 0.475 * (u - v), -depth * std::abs(u - v));
    });
    return aspectSwaps(t->edit, 1);
  };
  EXPECT_EQ(swapsOf(0.541), 0);
  EXPECT_EQ(swapsOf(0.), 1) << "a flat one as wide";
}

TEST(MeshOptimizer, LaplacianMovesEvenOutAreasOrDensities)
{
  // About the point at the top, vertices are wanted at twice the spacing.
  const auto meanAreas = [](Moves moves) {
    const auto t = meshes::cube(600, true);
    const Vec3 top(0, 0, 1);
    Vertex highest(0);
    for (const Vertex v : t->mesh.vertices())
    {
      highest = t->mesh.position(v).z() > t->mesh.position(highest).z() ? v : highest;
    }
    SpacingRegions regions;
    regions.add(t->atlas->surface(), Face(t->mesh.place(highest).face), { top, 0.2, 3. });
    t->mesh.coarsen(regions);
    optimize(*t, options(Swaps::Regularity, moves));
    std::array<double, 2> sum = { { 0, 0 } };
    std::array<int, 2> count = { { 0, 0 } };
    for (const Face f : t->mesh.faces())
    {
      const bool isNear = (t->mesh.position(t->mesh.corners(f)[0]) - top).norm() < 0.35;
      sum[isNear] += t->mesh.faceArea(f);
      ++count[isNear];
    }
    return sum[1] / count[1] / (sum[0] / count[0]);
  };
  EXPECT_NEAR(meanAreas(Moves::Area), 1., 0.15);
  EXPECT_GT(meanAreas(Moves::Density), 1.5);
}

TEST(MeshOptimizer, IsTheSameForAnyNumberOfThreads)
{
  const auto run = [](int threads) {
    const auto t = meshes::cube(1500, true); // enough for several tasks
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&]() { optimize(*t, {}); });
    return Snapshot(t->mesh);
  };
  EXPECT_TRUE(run(1) == run(2));
}

TEST(MeshOptimizer, ReportsAndStops)
{
  const auto t = meshes::cube(100, true);
  std::vector<double> told;
  EXPECT_TRUE(optimizeMesh(t->mesh, {}, [&](double f) {
    told.push_back(f);
    return true;
  }).ok());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  told.erase(std::unique(told.begin(), told.end()), told.end()); // far places are looked for at 1
  EXPECT_EQ(told.size(), 43U) << "every round, and the end";
  EXPECT_EQ(told.front(), 0.);
  EXPECT_EQ(told.back(), 1.);
  int asked = 0;
  EXPECT_TRUE(optimizeMesh(t->mesh, {}, [&](double) { return ++asked < 5; }).isAbort());
  EXPECT_EQ(asked, 5);
  for (const Face f : t->mesh.faces())
  {
    EXPECT_TRUE(t->mesh.isSound(f)) << "what was done is a mesh";
  }
}

TEST(MeshOptimizer, AsksBetweenItsLastRepairs)
{
  const auto t = meshes::patchOf(12, [](double x, double y) { return Vec3(x, y, x * y); });
  int askedAtTheEnd = 0;
  EXPECT_TRUE(optimizeMesh(t->mesh, {}, [&](double done) {
    askedAtTheEnd += done == 1. ? 1 : 0;
    return true;
  }).ok());
  EXPECT_GE(askedAtTheEnd, 5);
}

namespace
{
constexpr double Slope = 0.1;
constexpr double Bend = 0.5;

/// A flat patch with one triangle at its first corner.
std::unique_ptr<meshes::TestMesh> corner(int m, const std::function<Vec3(double, double)>& position)
{
  auto t = meshes::patchOf(m, position);
  t->edit.flip(t->edgeBetween(0, m + 2));
  return t;
}

/// A flat patch whose sides leave the origin along y = -+(Slope x + Bend x^2): at a small angle,
/// that opens. At its other corners they meet at 85 degrees and more.
std::unique_ptr<meshes::TestMesh> horn(int m)
{
  const auto rise = [](double x) { return Slope * x + Bend * x * x; };
  return corner(m, [=](double u, double v) { return Vec3(u + v, rise(v) - rise(u), 0); });
}
}

TEST(AcuteCorners, SpacingGrowsUntilTheSidesAreFarEnoughApart)
{
  const auto t = horn(24);
  const OptimizedMesh& mesh = t->mesh;
  double area = 0;
  for (const Face f : mesh.faces())
  {
    area += mesh.faceArea(f);
  }
  const double spacing = std::sqrt(2. / std::sqrt(3.) * area / mesh.vertices().size());
  const Face tip(mesh.place(Vertex(0)).face);
  double last = 1;
  for (const double angle : { 0.26, 0.3, 0.34 })
  {
    // The sides are `angle` apart as seen from the origin where y / x = tan(angle / 2).
    const double x = (std::tan(0.5 * angle) - Slope) / Bend;
    double arc = 0;
    constexpr int Steps = 1000;
    for (int i = 0; i < Steps; ++i)
    {
      const double slope = Slope + 2. * Bend * x * (i + 0.5) / Steps;
      arc += x / Steps * std::sqrt(1. + slope * slope);
    }
    const double distance = arc / spacing;
    ASSERT_GT(distance, 1.) << "or there were nothing to find";
    ASSERT_LT(distance, Tuning::FarthestOpening);
    const SpacingRegions regions = AcuteCorners(mesh, angle).regions(mesh);
    ASSERT_EQ(regions.size(), 1U) << "no other corner is acute";
    const double growth = regions.growthAt(tip, Vec3::Zero());
    EXPECT_GT(growth, 1. + Tuning::ShareOfOpening * (distance - 1.) - 0.01) << angle;
    EXPECT_LT(growth, 1. + Tuning::ShareOfOpening * (distance - 1. + Tuning::StepOfOpening) + 0.01);
    EXPECT_GT(growth, last);
    last = growth;
  }
}

TEST(AcuteCorners, WhatACornerLacksIsAskedForOnTop)
{
  const auto t = horn(24);
  const Face tip(t->mesh.place(Vertex(0)).face);
  const auto growth = [&](const AcuteCorners& corners) {
    return corners.regions(t->mesh).growthAt(tip, Vec3::Zero());
  };
  // The mesh is as it was: its corner is sharper than both.
  AcuteCorners corners(t->mesh, 0.26);
  const double first = growth(corners);
  corners.correct(t->mesh);
  const double second = growth(corners);
  EXPECT_GT(second, first);
  for (int i = 0; i < 100; ++i)
  {
    corners.correct(t->mesh);
  }
  const double most = growth(corners);
  EXPECT_GE(most, second);
  EXPECT_LE(most, 1. + Tuning::ShareOfOpening * (Tuning::FarthestOpening - 1.))
    << "not without end";
}

TEST(AcuteCorners, StayWhereGrowthIsNoHelpOrNotNeeded)
{
  const auto t = horn(24);
  EXPECT_EQ(AcuteCorners(t->mesh, 2. * std::atan(Slope)).regions(t->mesh).size(), 0U)
    << "they are open";
  EXPECT_EQ(AcuteCorners(t->mesh, 0.8).regions(t->mesh).size(), 0U) << "they open too far out";
  const auto square = corner(24, [](double u, double v) { return Vec3(u, v, 0); });
  EXPECT_EQ(AcuteCorners(square->mesh, 1.5).regions(square->mesh).size(), 0U);
  const auto wedge = corner(24, [](double u, double v) { return Vec3(u + v, 0.2 * (v - u), 0); });
  EXPECT_EQ(AcuteCorners(wedge->mesh, 0.5).regions(wedge->mesh).size(), 0U)
    << "straight sides never open";
}

TEST(AcuteCorners, TheOptimizerObeysThem)
{
  const auto smallestAtTip = [](double angle) {
    const auto t = horn(24);
    OptimizerOptions o;
    o.acuteCornerAngle = angle;
    optimize(*t, o);
    return starQuality(t->mesh, Vertex(0));
  };
  const double without = smallestAtTip(0);
  EXPECT_LT(without, 0.32);
  EXPECT_GT(smallestAtTip(0.34), 0.34);
}

namespace
{
double volume(const OptimizedMesh& mesh, const std::vector<Vec3>& position)
{
  double sum = 0;
  for (const Triangle& t : mesh.triangles())
  {
    sum += position[t[0]].dot(position[t[1]].cross(position[t[2]])) / 6.;
  }
  return sum;
}

std::vector<Vec3> positionsOf(const OptimizedMesh& mesh)
{
  std::vector<Vec3> result;
  for (const Vertex v : mesh.vertices())
  {
    result.push_back(mesh.position(v));
  }
  return result;
}
}

TEST(LeastSquares, LiftsASpheresVerticesUntilTheVolumeIsRight)
{
  const auto t = meshes::cube(200, true);
  optimize(*t, {});
  const AtlasSurface& surface = t->atlas->surface();
  double exact = 0; // of the surface, whose triangles are flat, too
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    exact += surface.point(f, 0).dot(surface.point(f, 1).cross(surface.point(f, 2))) / 6.;
  }
  const std::vector<Vec3> placed = leastSquaresPositions(t->mesh);
  const double before = exact - volume(t->mesh, positionsOf(t->mesh));
  EXPECT_GT(before, 0.1) << "vertices on the sphere leave all else inside";
  EXPECT_LT(std::abs(exact - volume(t->mesh, placed)), 0.2 * before);
  for (const Vertex v : t->mesh.vertices())
  {
    const Vec3 step = placed[v.index()] - t->mesh.position(v);
    EXPECT_GT(step.dot(t->mesh.normal(v)), 0.);
    EXPECT_LT(step.cross(t->mesh.normal(v)).norm(), 1e-14) << "along the normal";
  }
}

TEST(LeastSquares, LeavesWhatFitsAndWhatMustStay)
{
  const auto flat = meshes::patch(4);
  const std::vector<Vec3> same = leastSquaresPositions(flat->mesh);
  for (const Vertex v : flat->mesh.vertices())
  {
    EXPECT_LT((same[v.index()] - flat->mesh.position(v)).norm(), 1e-15);
  }
  // A dome: all but its rim rises.
  const auto dome =
    meshes::patch(6, [](double x, double y) { return 2. * x * (1. - x) * y * (1. - y); });
  const std::vector<Vec3> placed = leastSquaresPositions(dome->mesh);
  double highest = 0;
  for (const Vertex v : dome->mesh.vertices())
  {
    const double rise = placed[v.index()].z() - dome->mesh.position(v).z();
    highest = std::max(highest, rise);
    if (!dome->mesh.isFree(v))
    {
      EXPECT_EQ(placed[v.index()], dome->mesh.position(v));
    }
  }
  EXPECT_GT(highest, 1e-4);
}

TEST(LeastSquares, TurnsNoTriangle)
{
  // Waves as long as edges, and thin triangles: what rises by a third of an edge turns them.
  const auto t = meshes::patch(
    6, [](double x, double y) { return 0.4 * std::sin(31. * x) * std::cos(29. * y); });
  std::mt19937 engine(5);
  for (const Vertex v : t->mesh.vertices())
  {
    if (t->mesh.isFree(v))
    {
      const Vec3 p = t->mesh.position(v);
      const double dx = 0.07 * (engine() / 2147483648. - 1.);
      t->edit.put(v, t->pointAt(p.x() + dx, p.y() + 0.07 * (engine() / 2147483648. - 1.)));
    }
  }
  const std::vector<Vec3> placed = leastSquaresPositions(t->mesh);
  double farthest = 0;
  for (const Face f : t->mesh.faces())
  {
    const auto [a, b, c] = t->mesh.corners(f);
    const Vec3 n = (placed[b.index()] - placed[a.index()])
                     .cross(placed[c.index()] - placed[a.index()])
                     .normalized();
    EXPECT_GE(n.dot(t->mesh.faceNormal(f)), Tuning::LeastTurnedCosine);
    farthest = std::max(farthest, (placed[a.index()] - t->mesh.position(a)).norm());
  }
  EXPECT_GT(farthest, 0.) << "something was placed";
}
