// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Typed ids, and the halfedges that a triangle surface numbers with them.
#include "ElementIds.h"
#include "TriangleSurface.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <unordered_set>

using namespace stipple;

namespace
{
/// Two triangles that share the edge from 0 to 2.
TriangleSurface square()
{
  TriangleSurface s;
  s.points = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 4, 0 }, { 0, 4, 0 } };
  s.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  s.connect();
  return s;
}
}

TEST(ElementIds, AreNotEachOther)
{
  static_assert(!std::is_convertible_v<int, Face> && !std::is_convertible_v<Face, int>);
  static_assert(!std::is_convertible_v<Face, Vertex> && !std::is_constructible_v<Face, Vertex>);
  static_assert(sizeof(Halfedge) == sizeof(int) && std::is_trivially_copyable_v<Halfedge>);
  EXPECT_FALSE(Face().valid());
  EXPECT_TRUE(Face(0).valid());
  EXPECT_EQ(Face(7).index(), 7);
  EXPECT_LT(Face(3), Face(4));
  EXPECT_FALSE(Face(3) < Face(3));
  EXPECT_NE(Face(3), Face(4));
  const std::unordered_set<Face> set = { Face(3), Face(4), Face(3) };
  EXPECT_EQ(set.size(), 2U);
}

TEST(ElementIds, RangesAndArrays)
{
  ElementArray<Face, double> area(3, 0.5);
  area[Face(1)] = 2;
  double sum = 0;
  int count = 0;
  for (const Face f : area.ids())
  {
    EXPECT_EQ(f.index(), count++);
    sum += area[f];
  }
  EXPECT_EQ(sum, 3);
  EXPECT_EQ(ElementRange<Face>(4, 9).size(), 5);
}

TEST(ElementIds, ArraysGrowAndCompareLikeVectors)
{
  ElementArray<Vertex, int> a;
  EXPECT_TRUE(a.empty());
  EXPECT_EQ(a.ids().size(), 0);
  a.push_back(4);
  a.resize(3, 7);
  EXPECT_EQ(a[Vertex(0)], 4);
  EXPECT_EQ(a[Vertex(2)], 7);
  ElementArray<Vertex, int> b(3, 7);
  EXPECT_FALSE(a == b);
  b[Vertex(0)] = 4;
  EXPECT_TRUE(a == b);
  a.assign(2, 1);
  EXPECT_EQ(std::vector<int>(a.begin(), a.end()), (std::vector<int>{ 1, 1 }));
  a.clear();
  EXPECT_EQ(a.size(), 0U);
}

TEST(ElementIds, WhoCountsWithIntsReadsAndWritesIdsAsInts)
{
  ElementArray<Halfedge, Halfedge> twin(2);
  static_assert(std::is_same_v<decltype(twin[std::size_t(0)]), int&>);
  EXPECT_EQ(twin[1], -1) << "none";
  twin[1] = 5;
  EXPECT_EQ(twin[Halfedge(1)], Halfedge(5));
  EXPECT_EQ(twin[Halfedge(0)], Halfedge());
  const auto& read = twin;
  EXPECT_EQ(read[1], 5);
  ElementArray<Face, double> area(2, 0.25);
  area[1] = 3;
  EXPECT_EQ(area[Face(1)], 3);
}

TEST(ElementIds, HalfedgesOfATriangleSurface)
{
  const TriangleSurface s = square();
  EXPECT_EQ(s.halfedges().size(), 6);
  const Face second(1);
  for (int k = 0; k < 3; ++k)
  {
    const Halfedge h = halfedgeOf(second, k);
    EXPECT_EQ(faceOf(h), second);
    EXPECT_EQ(cornerOf(h), k);
    EXPECT_EQ(nextHalfedge(h), halfedgeOf(second, nextCorner(k)));
    EXPECT_EQ(previousHalfedge(nextHalfedge(h)), h);
    EXPECT_EQ(s.tail(h), s.vertex(second, k));
    EXPECT_EQ(s.head(h), s.vertex(second, nextCorner(k)));
    EXPECT_EQ(previousCorner(nextCorner(k)), k);
  }
  EXPECT_EQ(halfedgesOf(second).size(), 3);
  const Halfedge diagonal = halfedgeOf(second, 0); // from 0 to 2
  EXPECT_EQ(s.twin[diagonal], halfedgeOf(Face(0), 2));
  EXPECT_EQ(s.twin[s.twin[diagonal]], diagonal);
  EXPECT_FALSE(s.isBoundary(diagonal));
  EXPECT_TRUE(s.isBoundary(halfedgeOf(Face(0), 0)));
  EXPECT_DOUBLE_EQ(s.edgeLength(diagonal), 5);
  EXPECT_DOUBLE_EQ(s.faceArea(second), 6);
  const auto first = s.vertexHalfedges();
  EXPECT_EQ(findHalfedge(s, first, Vertex(0), Vertex(2)), diagonal);
  EXPECT_FALSE(findHalfedge(s, first, Vertex(1), Vertex(3)).valid());
}

TEST(ElementIds, EdgesOfThreeTrianglesHaveNoTwin)
{
  TriangleSurface s = square();
  s.points.push_back({ 0, 0, 1 });
  s.triangles.push_back({ 0, 2, 4 });
  s.connect();
  EXPECT_EQ(s.twin[halfedgeOf(Face(1), 0)], NonManifoldTwin);
  EXPECT_FALSE(s.twin[halfedgeOf(Face(1), 0)].valid());
  EXPECT_FALSE(s.topology().manifold);
}
