// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A surface of few triangles, and cuts that come back from it: the same pieces, however they hang
// together.
#include "ChartMesh.h"
#include "ChartPartition.h"
#include "Shapes.h"
#include "SurfaceCoarsening.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace stipple;

namespace
{
struct Shape
{
  const char* name;
  TriangleSurface surface;
};

std::vector<Shape> allShapes()
{
  std::vector<Shape> result = { { "sphere", shapes::sphere(1., 4) },
    { "torus", shapes::torus(1., .4, 60, 30) }, { "slab", shapes::perforatedSlab(2, 2, 6) },
    { "grid", shapes::grid(40) }, { "saddle", shapes::saddle(40) },
    { "cylinder", shapes::cylinder(1., 3., 40, 40) }, { "cube", shapes::cube(16) } };
  for (Shape& shape : result)
  {
    shape.surface.connect();
  }
  return result;
}

/// Marks edges whose triangles meet at more than half a right angle.
void markCreases(CutSurface& surface)
{
  for (const Halfedge h : surface.halfedges())
  {
    if (!surface.isBoundary(h))
    {
      const Vec3 here = surface.faceNormal(faceOf(h));
      surface.setSharp(h, here.dot(surface.faceNormal(faceOf(surface.twin[h]))) < std::sqrt(.5));
    }
  }
}

double lengthOf(const CutSurface& surface, const ElementArray<Halfedge, char>& mark)
{
  double sum = 0;
  for (const Halfedge h : surface.halfedges())
  {
    sum += mark[h] && surface.twin[h] < h ? surface.edgeLength(h) : 0.;
  }
  return sum;
}

/// Euler characteristic and boundary loops of every piece, in ascending order.
std::vector<std::pair<int, int>> pieces(
  const CutSurface& surface, const ElementArray<Halfedge, char>& cuts)
{
  CutSurface copy = surface;
  for (const Halfedge h : copy.halfedges())
  {
    copy.setCut(h, cuts[h] != 0);
    EXPECT_TRUE(copy.isBoundary(h) || cuts[h] == cuts[copy.twin[h]]);
  }
  std::vector<std::pair<int, int>> result;
  for (std::vector<Face>& faces : chartFaces(copy))
  {
    const ChartMesh mesh = extractChart(copy, std::move(faces));
    result.emplace_back(mesh.euler, mesh.boundaryLoops);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Cuts between random patches: those that grow from so many triangles.
void cutIntoPatches(CutSurface& surface, int number, std::mt19937& random)
{
  ElementArray<Face, int> patch(surface.triangles.size(), -1);
  std::vector<Face> front;
  for (int i = 0; i < number; ++i)
  {
    const Face f(static_cast<int>(random() % surface.triangles.size()));
    patch[f] = i;
    front.push_back(f);
  }
  while (!front.empty())
  {
    const std::size_t i = random() % front.size();
    const Face f = front[i];
    front[i] = front.back();
    front.pop_back();
    for (const Halfedge h : halfedgesOf(f))
    {
      const Halfedge twin = surface.twin[h];
      if (twin.valid() && patch[faceOf(twin)] < 0)
      {
        patch[faceOf(twin)] = patch[f];
        front.push_back(faceOf(twin));
      }
    }
  }
  for (const Halfedge h : surface.halfedges())
  {
    surface.setCut(h, !surface.isBoundary(h) && patch[faceOf(h)] != patch[faceOf(surface.twin[h])]);
  }
}
}

TEST(SurfaceCoarsening, KeepsTopologyAndShape)
{
  for (const Shape& shape : allShapes())
  {
    SCOPED_TRACE(shape.name);
    CutSurface fine = shapes::cutSurface(shape.surface);
    markCreases(fine);
    const int wanted = fine.numberOfFaces() / 6;
    const SurfaceCoarsening coarsening(fine, wanted);
    const CutSurface& coarse = coarsening.coarse();
    EXPECT_LE(coarse.numberOfFaces(), wanted);
    EXPECT_GE(coarse.numberOfFaces(), wanted - 2) << "and no fewer than asked for";
    EXPECT_TRUE(coarse.topology() == fine.topology());
    EXPECT_TRUE(coarse.twin == halfedgeTwins(coarse.triangles));
    EXPECT_NEAR(coarse.area(), fine.area(), .06 * fine.area());
    EXPECT_NEAR(
      lengthOf(coarse, coarse.sharp), lengthOf(fine, fine.sharp), .02 * lengthOf(fine, fine.sharp));
    EXPECT_NEAR(
      lengthOf(coarse, coarse.cut), lengthOf(fine, fine.cut), .02 * lengthOf(fine, fine.cut));
    for (const Face f : coarse.faces())
    {
      EXPECT_GT(coarse.faceArea(f), 0.);
      EXPECT_EQ(coarse.sourceCell[static_cast<std::size_t>(f.index())], f.index());
    }
  }
}

TEST(SurfaceCoarsening, KeepsCornersAndWhatUsersName)
{
  CutSurface fine = shapes::cutSurface(shapes::cube(16));
  markCreases(fine);
  // Edge by edge, round one face: none of its points may go.
  int kept = 0;
  for (const Halfedge h : fine.halfedges())
  {
    if (fine.sharp[h] && fine.point(fine.tail(h)).z() == 1. && fine.point(fine.head(h)).z() == 1.)
    {
      fine.setKeep(h, Keep::Edges);
      ++kept;
    }
  }
  const SurfaceCoarsening coarsening(fine, 10);
  const CutSurface& coarse = coarsening.coarse();
  int keptThere = 0;
  int corners = 0;
  for (const Halfedge h : coarse.halfedges())
  {
    keptThere += coarse.keep[h] == Keep::Edges;
  }
  for (const Vec3& p : coarse.points)
  {
    corners += (p - p.array().round().matrix()).norm() < 1e-12;
  }
  EXPECT_EQ(kept, 2 * 4 * 16);
  EXPECT_EQ(keptThere, kept);
  EXPECT_EQ(corners, 8);
  EXPECT_LT(coarse.numberOfFaces(), fine.numberOfFaces() / 4);
}

TEST(SurfaceCoarsening, LeavesTetrahedraAndWhatItIsToldToStopIn)
{
  TriangleSurface two = shapes::sphere(1., 2);
  const int n = two.numberOfVertices();
  for (const Vec3& p : { Vec3(3, 0, 0), Vec3(4, 0, 0), Vec3(3, 1, 0), Vec3(3, 0, 1) })
  {
    two.points.push_back(p);
  }
  for (const Triangle& t :
    { Triangle{ 0, 2, 1 }, Triangle{ 0, 1, 3 }, Triangle{ 0, 3, 2 }, Triangle{ 1, 2, 3 } })
  {
    two.triangles.push_back({ n + t[0], n + t[1], n + t[2] });
  }
  two.connect();
  const CutSurface fine = shapes::cutSurface(two);
  const SurfaceCoarsening coarsening(fine, 1);
  EXPECT_TRUE(coarsening.coarse().topology() == fine.topology());
  EXPECT_GE(coarsening.coarse().numberOfFaces(), 8) << "two tetrahedra at least";
  const SurfaceCoarsening stopped(fine, 1, [] { return true; });
  EXPECT_EQ(stopped.coarse().numberOfFaces(), fine.numberOfFaces());
}

TEST(SurfaceCoarsening, CutsComeBackWithTheSamePieces)
{
  std::mt19937 random(7);
  for (const Shape& shape : allShapes())
  {
    SCOPED_TRACE(shape.name);
    CutSurface fine = shapes::cutSurface(shape.surface);
    markCreases(fine);
    const SurfaceCoarsening coarsening(fine, fine.numberOfFaces() / 8);
    for (const int number : { 1, 2, 5, 12 })
    {
      CutSurface coarse = coarsening.coarse();
      cutIntoPatches(coarse, number, random);
      const auto there = pieces(coarse, coarse.cut);
      const auto here = pieces(fine, coarsening.prolong(coarse));
      EXPECT_TRUE(there == here) << number << " patches";
    }
  }
}

TEST(SurfaceCoarsening, SlitsComeBackInOnePiece)
{
  // A torus cut open along one closed line and slits: an annulus, whatever is slit into it.
  const CutSurface fine = shapes::cutSurface(shapes::torus(1., .4, 60, 30));
  const SurfaceCoarsening coarsening(fine, 900);
  CutSurface coarse = coarsening.coarse();
  std::mt19937 random(3);
  // Random walks that cut: a connected graph of cuts, loops and dead ends.
  Halfedge h(11);
  for (int step = 0; step < 60; ++step)
  {
    coarse.setCut(h, true);
    h = nextHalfedge(h);
    for (auto turns = random() % 4; turns > 0; --turns)
    {
      h = nextHalfedge(coarse.twin[h]);
    }
  }
  EXPECT_TRUE(pieces(coarse, coarse.cut) == pieces(fine, coarsening.prolong(coarse)));
}

TEST(SurfaceCoarsening, CutsThroughTrianglesGoToTheEdgesBesideThem)
{
  TriangleSurface grid = shapes::grid(40);
  grid.connect();
  const CutSurface fine = shapes::cutSurface(grid);
  const SurfaceCoarsening coarsening(fine, 400);
  CutSurface coarse = coarsening.coarse();
  ChartPartitionOptions options;
  options.numberOfCharts = 4;
  std::vector<FlatChart> charts;
  ASSERT_TRUE(partitionSurface(coarse, options, charts, {}).ok());
  ASSERT_GT(coarse.numberOfFaces(), coarsening.coarse().numberOfFaces()) << "cut through";
  const auto disks = pieces(fine, coarsening.prolong(coarse));
  EXPECT_EQ(disks.size(), charts.size());
}

TEST(SurfaceCoarsening, LargeSurfacesAreCutByIt)
{
  // 20,480 triangles: charts of nearly the same area, disks, no denser than asked for.
  CutSurface surface = shapes::cutSurface(shapes::sphere(1., 5));
  const double area = surface.area();
  ChartPartitionOptions options;
  options.numberOfCharts = 6;
  std::vector<FlatChart> charts;
  ASSERT_TRUE(partitionSurface(surface, options, charts, {}).ok());
  ASSERT_EQ(charts.size(), 6U);
  double sum = 0;
  for (const FlatChart& chart : charts)
  {
    EXPECT_TRUE(chart.mesh.isDisk());
    EXPECT_LE(chart.map.densityRatio, options.maximumDensityRatio);
    double own = 0;
    for (const Face f : chart.mesh.faces)
    {
      own += surface.faceArea(f);
    }
    EXPECT_NEAR(own, area / 6, .3 * area / 6);
    sum += own;
  }
  EXPECT_NEAR(sum, area, 1e-9 * area);
}
