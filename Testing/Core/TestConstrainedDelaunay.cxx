// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Constrained Delaunay triangulation, and the complex that stitching swaps edges in.
#include "ConstrainedDelaunay.h"
#include "TriangleComplex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace stipple;

namespace
{
double area(const std::vector<Vec2>& points, const std::vector<Triangle>& triangles)
{
  double sum = 0;
  for (const Triangle& t : triangles)
  {
    sum += 0.5 * orient2(points[t[0]], points[t[1]], points[t[2]]);
  }
  return sum;
}

std::pair<int, int> ordered(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

std::set<std::pair<int, int>> edges(const std::vector<Triangle>& triangles)
{
  std::set<std::pair<int, int>> result;
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.insert(ordered(t[k], t[(k + 1) % 3]));
    }
  }
  return result;
}

/// A square with collinear points on its sides, a lattice inside (all cocircular), and pairs 1e-12
/// apart.
struct Square
{
  std::vector<Vec2> points;
  std::vector<std::array<int, 2>> segments;
  Square()
  {
    const std::array<Vec2, 4> corner = { { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } };
    for (int side = 0; side < 4; ++side)
    {
      for (int i = 0; i < 8; ++i)
      {
        this->points.push_back(corner[side] + i / 8. * (corner[(side + 1) % 4] - corner[side]));
      }
    }
    for (int i = 0; i < 32; ++i)
    {
      this->segments.push_back({ { i, (i + 1) % 32 } });
    }
    for (int j = 1; j < 8; ++j)
    {
      for (int i = 1; i < 8; ++i)
      {
        this->points.emplace_back(i / 8., j / 8.);
        this->points.emplace_back(i / 8. + 1e-12, j / 8.);
      }
    }
  }
};
}

TEST(ConstrainedDelaunay, TakesCollinearCocircularAndNearlyCoincidentPoints)
{
  const Square square;
  std::vector<Triangle> triangles;
  ASSERT_EQ(constrainedDelaunay(square.points, square.segments, triangles).kind,
    DelaunayConflict::Kind::None);
  EXPECT_NEAR(area(square.points, triangles), 1., 1e-12);
  EXPECT_EQ(
    static_cast<int>(triangles.size()), 2 * static_cast<int>(square.points.size()) - 2 - 32);
  for (const Triangle& t : triangles)
  {
    EXPECT_GT(orient2(square.points[t[0]], square.points[t[1]], square.points[t[2]]), 0.);
  }
}

TEST(ConstrainedDelaunay, KeepsSegmentsAndDropsWhatLiesOutside)
{
  // An L: the notch is outside, though the hull covers it.
  const std::vector<Vec2> points = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 },
    { 0.9, 0.2 }, { 0.1, 0.5 }, { 0.5, 0.9 } };
  const std::vector<std::array<int, 2>> segments = { { { 0, 1 } }, { { 1, 2 } }, { { 2, 3 } },
    { { 3, 4 } }, { { 4, 5 } }, { { 5, 0 } }, { { 7, 2 } } };
  std::vector<Triangle> triangles;
  ASSERT_EQ(constrainedDelaunay(points, segments, triangles).kind, DelaunayConflict::Kind::None);
  EXPECT_NEAR(area(points, triangles), 3., 1e-12);
  const auto found = edges(triangles);
  for (const auto& s : segments)
  {
    EXPECT_EQ(found.count(ordered(s[0], s[1])), 1u);
  }
}

TEST(ConstrainedDelaunay, NamesConflicts)
{
  const std::vector<Vec2> points = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 1, 1 } };
  std::vector<Triangle> triangles;
  auto conflict = constrainedDelaunay(points, { { { 0, 2 } } }, triangles);
  EXPECT_EQ(conflict.kind, DelaunayConflict::Kind::OnSegment);
  EXPECT_EQ(conflict.first, 4);
  conflict = constrainedDelaunay(
    { points[0], points[1], points[2], points[3] }, { { { 0, 2 } }, { { 1, 3 } } }, triangles);
  EXPECT_EQ(conflict.kind, DelaunayConflict::Kind::Crossing);
  conflict = constrainedDelaunay({ points[0], points[1], points[2], points[1] }, {}, triangles);
  EXPECT_EQ(conflict.kind, DelaunayConflict::Kind::Duplicate);
  EXPECT_EQ(conflict.first, 3);
  EXPECT_EQ(conflict.second, 1);
  conflict = constrainedDelaunay({ { 0, 0 }, { 1, 0 }, { 2, 0 } }, {}, triangles);
  EXPECT_EQ(conflict.kind, DelaunayConflict::Kind::Degenerate);
}

TEST(TriangleComplex, FourFlipsOfAnEdgeGiveItBack)
{
  TriangleComplex c;
  c.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 1, 4, 2 }, { 0, 5, 3 } };
  c.twin = halfedgeTwins(c.triangles);
  c.label.assign(c.twin.size(), Label());
  const auto before = edges(c.triangles);
  c.flip(Halfedge(0));
  EXPECT_EQ(edges(c.triangles).count({ 0, 1 }), 0u);
  EXPECT_EQ(edges(c.triangles).count({ 2, 3 }), 1u);
  EXPECT_EQ(c.twin, halfedgeTwins(c.triangles));
  for (int i = 0; i < 3; ++i)
  {
    c.flip(Halfedge(0));
  }
  EXPECT_EQ(edges(c.triangles), before);
}

TEST(TriangleComplex, TakesAVertexOutOfAChain)
{
  // A hexagon about vertex 6, through which a chain runs from 0 to 3.
  TriangleComplex c;
  for (int i = 0; i < 6; ++i)
  {
    c.triangles.push_back({ 6, i, (i + 1) % 6 });
  }
  c.twin = halfedgeTwins(c.triangles);
  c.label.assign(c.twin.size(), Label());
  ElementArray<Vertex, Halfedge> outgoing(7);
  for (Halfedge h : c.halfedges())
  {
    const auto edge = ordered(c.tail(h).index(), c.head(h).index());
    if (edge.second == 6 && (edge.first == 0 || edge.first == 3))
    {
      c.label[h] = Label(5);
    }
    else if (c.isBoundary(h))
    {
      c.label[h] = Label(100 + c.tail(h).index());
    }
    outgoing[c.tail(h)] = h;
  }
  std::vector<std::array<Label, 2>> merged;
  ASSERT_TRUE(c.removeFromChain(
    Vertex(6), outgoing, [](Vertex, Vertex, Vertex) { return 0.; }, merged));
  EXPECT_TRUE(merged.empty());
  c.compact();
  EXPECT_EQ(c.triangles.size(), 4u);
  EXPECT_EQ(c.twin, halfedgeTwins(c.triangles));
  int chain = 0;
  for (Halfedge h : c.halfedges())
  {
    if (ordered(c.tail(h).index(), c.head(h).index()) == ordered(0, 3))
    {
      EXPECT_EQ(c.label[h], Label(5));
      ++chain;
    }
    else
    {
      EXPECT_EQ(c.label[h].index() >= 100, c.isBoundary(h));
    }
  }
  EXPECT_EQ(chain, 2);
}

namespace
{
/// Vertex 6 amid 0 to 5, with a chain from 0 by 6 to 3 and two edges to vertex 1: between them lies
/// vertex 7, which touches nothing else. Halfedge 0 of face i leaves 6 for the i-th vertex about
/// it.
TriangleComplex starWithTwoEdgesToOneVertex()
{
  TriangleComplex c;
  const std::array<int, 8> ring = { { 0, 1, 7, 1, 2, 3, 4, 5 } };
  for (int i = 0; i < 8; ++i)
  {
    c.triangles.push_back({ 6, ring[i], ring[(i + 1) % 8] });
  }
  c.twin.assign(24, Halfedge());
  c.label.assign(24, Label());
  const auto edge = [](int face, int corner) { return halfedgeOf(Face(face), corner); };
  for (int i = 0; i < 8; ++i)
  {
    c.glue(edge(i, 2), edge((i + 1) % 8, 0));
    c.label[edge(i, 1)] = Label(100 + i);
  }
  c.glue(edge(1, 1), edge(2, 1)); // the edge from 1 to 7
  c.label[edge(1, 1)] = c.label[edge(2, 1)] = Label();
  for (int i : { 0, 5 })
  {
    c.label[edge(i, 0)] = c.label[c.twin[edge(i, 0)]] = Label(5);
  }
  return c;
}
}

TEST(TriangleComplex, KeepsWhatTwoEdgesToOneVertexEnclose)
{
  TriangleComplex c = starWithTwoEdgesToOneVertex();
  ASSERT_TRUE(c.isSound());
  ElementArray<Vertex, Halfedge> outgoing(8);
  for (Halfedge h : c.halfedges())
  {
    outgoing[c.tail(h)] = h;
  }
  std::vector<std::array<Label, 2>> merged;
  ASSERT_TRUE(c.removeFromChain(
    Vertex(6), outgoing, [](Vertex, Vertex, Vertex) { return 0.; }, merged));
  c.compact();
  EXPECT_TRUE(c.isSound());
  EXPECT_EQ(c.triangles.size(), 6u); // 2 V - 2 - boundary, with V = 7
  std::set<int> used;
  int chain = 0;
  int boundary = 0;
  for (Halfedge h : c.halfedges())
  {
    used.insert(c.tail(h).index());
    boundary += c.isBoundary(h) ? 1 : 0;
    chain +=
      c.label[h] == Label(5) && ordered(c.tail(h).index(), c.head(h).index()) == ordered(0, 3) ? 1
                                                                                               : 0;
  }
  EXPECT_EQ(used, std::set<int>({ 0, 1, 2, 3, 4, 5, 7 }));
  EXPECT_EQ(boundary, 6);
  EXPECT_EQ(chain, 2);
}

TEST(TriangleComplex, StarThatDoesNotCloseIsEmpty)
{
  TriangleComplex c = starWithTwoEdgesToOneVertex();
  EXPECT_EQ(c.star(Halfedge(0)).size(), 8u);
  // Turning left from the edge to 2 leads back to itself: a star that never comes round to the edge
  // to 0.
  c.twin[halfedgeOf(Face(4), 2)] = halfedgeOf(Face(4), 0);
  EXPECT_FALSE(c.isSound());
  EXPECT_TRUE(c.star(Halfedge(0)).empty());
  ElementArray<Vertex, Halfedge> outgoing(8, Halfedge(0));
  std::vector<std::array<Label, 2>> merged;
  EXPECT_FALSE(c.removeFromChain(
    Vertex(6), outgoing, [](Vertex, Vertex, Vertex) { return 0.; }, merged));
  // A twin at another vertex.
  c = starWithTwoEdgesToOneVertex();
  c.twin[halfedgeOf(Face(4), 2)] = halfedgeOf(Face(6), 1);
  EXPECT_FALSE(c.isSound());
  EXPECT_TRUE(c.star(Halfedge(0)).empty());
}
