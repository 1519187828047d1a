// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Regions that are to become charts, on a grid of unit squares where all is known: what cuts
// separate, and how triangles change hands.
#include "ChartRegions.h"
#include "GreedyMerge.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace stipple;

namespace
{
/// A grid of unit squares, each cut along its diagonal from low (x, y), with cuts between squares
/// whose `label` differs. Point (i, j) is j (width + 1) + i; square (i, j) has the triangles
/// 2 (j width + i), the lower, and the next.
struct Grid
{
  int width;
  int height;
  CutSurface surface;

  template <typename Label>
  Grid(int w, int h, const Label& label)
    : width(w)
    , height(h)
  {
    TriangleSurface s;
    for (int j = 0; j <= h; ++j)
    {
      for (int i = 0; i <= w; ++i)
      {
        s.points.emplace_back(i, j, 0);
      }
    }
    for (int j = 0; j < h; ++j)
    {
      for (int i = 0; i < w; ++i)
      {
        const int a = this->point(i, j);
        const int b = this->point(i, j + 1);
        s.triangles.push_back({ a, a + 1, b + 1 });
        s.triangles.push_back({ a, b + 1, b });
      }
    }
    s.connect();
    this->surface = shapes::cutSurface(s);
    for (const Halfedge g : this->surface.halfedges())
    {
      const Halfedge across = this->surface.twin[g];
      if (across.valid() && this->labelOf(faceOf(g), label) != this->labelOf(faceOf(across), label))
      {
        this->surface.setCut(g, true);
      }
    }
  }
  int point(int i, int j) const { return j * (this->width + 1) + i; }
  template <typename Label>
  int labelOf(Face face, const Label& label) const
  {
    return label(face.index() / 2 % this->width, face.index() / 2 / this->width);
  }
  /// From one point to the next, which an edge joins to it.
  Halfedge halfedge(int p, int q) const
  {
    for (const Halfedge h : this->surface.halfedges())
    {
      if (this->surface.tail(h) == Vertex(p) && this->surface.head(h) == Vertex(q))
      {
        return h;
      }
    }
    ADD_FAILURE() << "no edge from " << p << " to " << q;
    return {};
  }
  int numberOfInnerCuts() const
  {
    int count = 0;
    for (const Halfedge h : this->surface.halfedges())
    {
      count += this->surface.cut[h] && !this->surface.isBoundary(h);
    }
    return count / 2;
  }
};

int columns(int i, int)
{
  return i;
}

/// Every triangle is in its owner's list, and nowhere else.
void expectConsistent(const ChartRegions& regions)
{
  std::set<Face> seen;
  for (int r = 0; r < regions.size(); ++r)
  {
    for (const Face f : regions.faces(r))
    {
      EXPECT_EQ(regions.owner(f), r);
      EXPECT_TRUE(seen.insert(f).second);
    }
  }
  EXPECT_EQ(static_cast<int>(seen.size()), regions.surface().numberOfFaces());
}
}

TEST(ChartRegions, AreWhatCutsSeparate)
{
  Grid grid(4, 3, [](int i, int) { return i > 0; });
  const ChartRegions regions(grid.surface);
  ASSERT_EQ(regions.size(), 2);
  expectConsistent(regions);
  EXPECT_DOUBLE_EQ(regions.area(0), 3.);
  EXPECT_DOUBLE_EQ(regions.area(1), 9.);
  EXPECT_EQ(regions.owner(Face(0)), 0) << "regions are counted by their smallest triangles";
  EXPECT_EQ(regions.numberOfInputTriangles(0), 6);
  EXPECT_TRUE(regions.mesh(1).isDisk());
  EXPECT_EQ(regions.mesh(1).numberOfVertices(), 16);
  EXPECT_EQ(regions.neighbours(0), std::vector<int>{ 1 });
  EXPECT_EQ(regions.neighbours(1), std::vector<int>{ 0 });
  const Halfedge seam = grid.halfedge(grid.point(1, 1), grid.point(1, 2));
  EXPECT_EQ(regions.ownerAcross(seam), 1);
  EXPECT_EQ(regions.ownerAcross(grid.surface.twin[seam]), 0);
  EXPECT_EQ(regions.ownerAcross(grid.halfedge(grid.point(0, 0), grid.point(1, 0))), -1);
  EXPECT_FALSE(regions.isStopped());
}

TEST(ChartRegions, AskWhetherToStop)
{
  Grid grid(2, 2, columns);
  bool wants = false;
  const ChartRegions regions(grid.surface, [&wants]() { return wants; });
  EXPECT_FALSE(regions.isStopped());
  wants = true;
  EXPECT_TRUE(regions.isStopped());
}

TEST(ChartRegions, SplitsStayInTheirRegionAndAreNoted)
{
  Grid grid(2, 2, columns);
  ChartRegions regions(grid.surface);
  for (const int r : { 0, 1 })
  {
    EXPECT_TRUE(regions.isReshaped(r)) << "new regions are marked";
    regions.clearChanges(r);
  }
  CutSurface& s = grid.surface;
  const Halfedge h = grid.halfedge(grid.point(1, 0), grid.point(1, 1));
  const Halfedge g = s.twin[h];
  const int oldHead = s.head(h).index();
  const int apex = s.head(nextHalfedge(h)).index();
  const int faces = s.numberOfFaces();
  const int p = regions.splitEdge(h, 0.25);
  EXPECT_LT((s.points[p] - Vec3(1, 0.25, 0)).norm(), 1e-15);
  EXPECT_EQ(s.numberOfFaces(), faces + 2);
  expectConsistent(regions);
  EXPECT_EQ(regions.ownerAcross(h), 1) << "the seam runs on";
  for (const int r : { 0, 1 })
  {
    EXPECT_DOUBLE_EQ(regions.area(r), 2.);
    EXPECT_EQ(regions.faces(r).size(), 5U);
    EXPECT_EQ(regions.numberOfInputTriangles(r), 4);
    EXPECT_FALSE(regions.isReshaped(r)) << "a split takes nothing from a region";
    ASSERT_EQ(regions.splits(r).size(), 1U);
  }
  const ChartRegions::Split& left = regions.splits(0).front();
  EXPECT_EQ(left.halfedge, h);
  EXPECT_EQ(left.t, 0.25);
  EXPECT_EQ(s.triangle(left.added), (Triangle{ p, oldHead, apex }));
  const ChartRegions::Split& right = regions.splits(1).front();
  EXPECT_EQ(right.halfedge, g);
  EXPECT_EQ(right.t, 0.75);
  EXPECT_EQ(s.triangle(right.added)[0], p);
  // On the surface's boundary there is one side.
  regions.splitEdge(grid.halfedge(grid.point(0, 0), grid.point(1, 0)), 0.5);
  EXPECT_EQ(regions.splits(0).size(), 2U);
  EXPECT_EQ(regions.splits(1).size(), 1U);
  regions.clearChanges(0);
  EXPECT_TRUE(regions.splits(0).empty());
  expectConsistent(regions);
}

TEST(ChartRegions, SlitsAreClosed)
{
  Grid grid(6, 4, [](int i, int) { return i < 4; });
  ChartRegions regions(grid.surface);
  const int seam = grid.numberOfInnerCuts();
  regions.clearChanges(0);
  regions.clearChanges(1);
  regions.closeSlits(0);
  EXPECT_FALSE(regions.isReshaped(0)) << "there is none";
  // From the boundary inwards, with a fork at (2, 2).
  const std::array<std::array<int, 4>, 4> slits = { { { { 2, 0, 2, 1 } }, { { 2, 1, 2, 2 } },
    { { 2, 2, 1, 2 } }, { { 2, 2, 3, 2 } } } };
  for (const auto& [i, j, k, l] : slits)
  {
    const Halfedge h = grid.halfedge(grid.point(i, j), grid.point(k, l));
    regions.cutOpen(h);
    EXPECT_TRUE(grid.surface.cut[h] && grid.surface.cut[grid.surface.twin[h]]);
  }
  EXPECT_EQ(grid.numberOfInnerCuts(), seam + 4);
  EXPECT_TRUE(regions.isReshaped(0));
  EXPECT_FALSE(regions.isReshaped(1));
  EXPECT_TRUE(regions.mesh(0).isDisk()) << "slits leave a disk";
  regions.clearChanges(0);
  regions.closeSlits(1);
  EXPECT_EQ(grid.numberOfInnerCuts(), seam + 4) << "they are the other region's";
  regions.closeSlits(0);
  EXPECT_EQ(grid.numberOfInnerCuts(), seam);
  EXPECT_TRUE(regions.isReshaped(0));
}

TEST(ChartRegions, CutsThatMakeADiskAreNoSlits)
{
  // A region about another one, cut open between the two.
  Grid grid(6, 6, [](int i, int j) { return i / 2 == 1 && j / 2 == 1; });
  ChartRegions regions(grid.surface);
  EXPECT_FALSE(regions.mesh(0).isDisk());
  regions.cutOpen(grid.halfedge(grid.point(0, 3), grid.point(1, 3)));
  regions.cutOpen(grid.halfedge(grid.point(1, 3), grid.point(2, 3)));
  EXPECT_TRUE(regions.mesh(0).isDisk());
  const int cuts = grid.numberOfInnerCuts();
  regions.closeSlits(0);
  EXPECT_EQ(grid.numberOfInnerCuts(), cuts);
}

TEST(ChartRegions, AreDividedAndMerged)
{
  Grid grid(3, 2, [](int, int) { return 0; });
  ChartRegions regions(grid.surface);
  ASSERT_EQ(regions.size(), 1);
  const auto inColumn = [&](int region, int column) {
    std::vector<char> side;
    for (const Face f : regions.faces(region))
    {
      side.push_back(grid.labelOf(f, columns) == column);
    }
    return side;
  };
  EXPECT_EQ(regions.divide(0, inColumn(0, 1)), 1);
  EXPECT_EQ(regions.size(), 2);
  EXPECT_EQ(grid.numberOfInnerCuts(), 4);
  EXPECT_EQ(regions.faces(1).size(), 4U);
  EXPECT_EQ(regions.divide(0, inColumn(0, 2)), 2);
  EXPECT_EQ(grid.numberOfInnerCuts(), 4) << "the two were not neighbours";
  EXPECT_EQ(regions.neighbours(1), (std::vector<int>{ 0, 2 }));
  EXPECT_EQ(regions.neighbours(2), std::vector<int>{ 1 });
  expectConsistent(regions);

  regions.clearChanges(0);
  regions.clearChanges(1);
  regions.splitEdge(grid.halfedge(grid.point(3, 0), grid.point(3, 1)), 0.5);
  const std::vector<Face> right = regions.faces(2);
  regions.merge(0, 1, regions.arcs(0, 1).front());
  EXPECT_EQ(regions.size(), 2);
  expectConsistent(regions);
  EXPECT_EQ(regions.faces(1), right) << "the last takes the number that became free";
  EXPECT_EQ(regions.splits(1).size(), 1U) << "with what happened to it";
  EXPECT_TRUE(regions.isReshaped(1));
  EXPECT_TRUE(regions.isReshaped(0));
  EXPECT_EQ(grid.numberOfInnerCuts(), 2) << "only the cuts between the two are closed";
  EXPECT_DOUBLE_EQ(regions.area(0), 4.);
  regions.merge(0, 1, regions.arcs(0, 1).front());
  EXPECT_EQ(regions.size(), 1);
  EXPECT_EQ(grid.numberOfInnerCuts(), 0);
  expectConsistent(regions);
}

TEST(ChartRegions, ShareTheirTrianglesOutAnew)
{
  Grid grid(4, 2, [](int i, int) { return i > 0; });
  ChartRegions regions(grid.surface);
  regions.clearChanges(0);
  regions.clearChanges(1);
  std::vector<char> side;
  for (const int region : { 0, 1 })
  {
    for (const Face f : regions.faces(region))
    {
      side.push_back(grid.labelOf(f, columns) >= 2);
    }
  }
  const std::vector<Halfedge> opened = regions.shareOut(0, 1, side);
  expectConsistent(regions);
  EXPECT_DOUBLE_EQ(regions.area(0), 4.);
  EXPECT_DOUBLE_EQ(regions.area(1), 4.);
  EXPECT_TRUE(regions.isReshaped(0) && regions.isReshaped(1));
  ASSERT_EQ(opened.size(), 2U);
  for (const Halfedge h : opened)
  {
    EXPECT_EQ(regions.owner(faceOf(h)), 0);
    EXPECT_EQ(regions.ownerAcross(h), 1);
    EXPECT_TRUE(grid.surface.cut[h]);
    EXPECT_EQ(grid.surface.point(grid.surface.tail(h)).x(), 2.);
    EXPECT_EQ(grid.surface.point(grid.surface.head(h)).x(), 2.);
  }
  EXPECT_EQ(grid.numberOfInnerCuts(), 4) << "who moves a seam closes the old one";
}

TEST(ChartRegions, BoundariesAreWalkedInOrder)
{
  Grid grid(4, 3, [](int i, int) { return i > 0; });
  const ChartRegions regions(grid.surface);
  const Halfedge first = grid.halfedge(grid.point(0, 0), grid.point(1, 0));
  std::vector<int> points;
  Halfedge h = first;
  do
  {
    EXPECT_EQ(regions.owner(faceOf(h)), 0);
    EXPECT_TRUE(grid.surface.cut[h]);
    points.push_back(grid.surface.tail(h).index());
    h = grid.surface.nextOnBoundary(h);
  } while (h != first && points.size() < 100);
  const auto at = [&](int i, int j) { return grid.point(i, j); };
  EXPECT_EQ(points,
    (std::vector<int>{
      at(0, 0), at(1, 0), at(1, 1), at(1, 2), at(1, 3), at(0, 3), at(0, 2), at(0, 1) }));
}

TEST(ChartRegions, ArcsAreTheSeamsOfTwoRegions)
{
  // 0: the left column and the square at the bottom; 2: the right column and the one at the top;
  // between them a square of its own, so that two seams part them.
  Grid grid(3, 3, [](int i, int j) { return i == 1 ? (j == 0 ? 0 : j == 1 ? 1 : 2) : i; });
  const ChartRegions regions(grid.surface);
  ASSERT_EQ(regions.size(), 3);
  const int left = regions.owner(Face(0));
  const int right = regions.owner(Face(2 * 2));
  const int middle = regions.owner(Face(2 * 4));
  const std::vector<SeamArc> arcs = regions.arcs(left, right);
  ASSERT_EQ(arcs.size(), 2U);
  for (const SeamArc& arc : arcs)
  {
    EXPECT_FALSE(arc.closed);
    ASSERT_EQ(arc.halfedges.size(), 1U);
    EXPECT_EQ(regions.owner(faceOf(arc.halfedges[0])), left);
    EXPECT_EQ(regions.ownerAcross(arc.halfedges[0]), right);
  }
  EXPECT_LT(arcs[0].halfedges[0], arcs[1].halfedges[0]);
  // The left region goes about two sides of the middle one: one seam, in order.
  const std::vector<SeamArc> about = regions.arcs(left, middle);
  ASSERT_EQ(about.size(), 1U);
  ASSERT_EQ(about[0].halfedges.size(), 2U);
  EXPECT_EQ(grid.surface.head(about[0].halfedges[0]), grid.surface.tail(about[0].halfedges[1]));
  EXPECT_EQ(grid.surface.tail(about[0].halfedges[0]), Vertex(grid.point(2, 1)));
  EXPECT_EQ(grid.surface.head(about[0].halfedges[1]), Vertex(grid.point(1, 2)));
  EXPECT_EQ(regions.neighbours(middle).size(), 2U);
}

TEST(ChartRegions, ASeamAboutARegionIsClosed)
{
  Grid grid(4, 4, [](int i, int j) { return i % 3 != 0 && j % 3 != 0; });
  const ChartRegions regions(grid.surface);
  ASSERT_EQ(regions.size(), 2);
  for (const int a : { 0, 1 })
  {
    const std::vector<SeamArc> arcs = regions.arcs(a, 1 - a);
    ASSERT_EQ(arcs.size(), 1U);
    EXPECT_TRUE(arcs[0].closed);
    ASSERT_EQ(arcs[0].halfedges.size(), 8U);
    EXPECT_EQ(
      arcs[0].halfedges[0], *std::min_element(arcs[0].halfedges.begin(), arcs[0].halfedges.end()));
    for (std::size_t i = 0; i < 8; ++i)
    {
      EXPECT_EQ(
        grid.surface.head(arcs[0].halfedges[i]), grid.surface.tail(arcs[0].halfedges[(i + 1) % 8]));
      EXPECT_EQ(regions.owner(faceOf(arcs[0].halfedges[i])), a);
    }
  }
}

TEST(GreedyMerge, TakesThePairOfLeastAreaFirst)
{
  // Columns of widths 4, 2, 1 and 1: the last two are merged first, and what comes of it with its
  // neighbour.
  Grid grid(8, 1, [](int i, int) { return i < 4 ? 0 : i < 6 ? 1 : i < 7 ? 2 : 3; });
  ChartRegions regions(grid.surface);
  ASSERT_EQ(regions.size(), 4);
  std::vector<double> areas;
  std::vector<std::pair<int, int>> foreseen;
  int questions = 0;
  const Status status = GreedyMerge(regions).run(
    1,
    [&](int a, int b) -> std::optional<SeamArc> {
      ++questions;
      EXPECT_EQ(foreseen.front(), std::make_pair(a, b)) << "told before";
      if (regions.area(a) + regions.area(b) > 6)
      {
        return {}; // the widest stays by itself
      }
      return regions.arcs(a, b).front();
    },
    [&](int a, int) { areas.push_back(regions.area(a)); },
    [&](const std::vector<std::pair<int, int>>& pairs) {
      foreseen = pairs;
      for (const auto& [a, b] : pairs)
      {
        EXPECT_LT(a, b);
        EXPECT_FALSE(regions.arcs(a, b).empty()) << "neighbours";
      }
    },
    {});
  EXPECT_TRUE(status.ok());
  EXPECT_EQ(areas, (std::vector<double>{ 2., 4. }));
  EXPECT_EQ(regions.size(), 2);
  EXPECT_EQ(questions, 3);
  EXPECT_TRUE(GreedyMerge(regions).run(1, {}, {}, {}, [](double) { return false; }).isAbort());
}
