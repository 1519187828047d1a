// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Creases that are rounded off, on sheets that are bent about a line.
#include "FeatureDetection.h"
#include "FeatureGraphBuilder.h"
#include "RoundedEdges.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

using namespace stipple;

namespace
{
constexpr int Steps = 30; ///< along the bend

/// A sheet in two halves of length 1 that meet in a bend, in so many edges of equal turn, of so
/// many degrees; as long as wide. shift moves turn from the first half of the bend to the second.
TriangleSurface bentSheet(
  double degrees, double radius, int edges,
  const std::function<double(int)>& shift = [](int) { return 0.; })
{
  TriangleSurface sheet;
  constexpr int Flat = 8; // steps of a half
  const int columns = 2 * Flat + edges;
  for (int j = 0; j <= Steps; ++j)
  {
    const double y = 2. * j / Steps;
    // Rows of the bend are chords: as long as the arc.
    const double chord = radius * degrees * Pi / 180 / edges;
    Vec3 at(0, y, 0);
    double heading = 0;
    for (int i = 0; i < columns; ++i)
    {
      sheet.points.push_back(at);
      const bool isInBend = i >= Flat && i < Flat + edges - 1;
      if (i >= Flat && i < Flat + edges)
      {
        const double part = 1 + (2 * (i - Flat) < edges - 1 ? -1 : 1) * shift(j);
        heading += degrees * Pi / 180 / edges * part;
      }
      at += (isInBend ? chord : 1. / Flat) * Vec3(std::cos(heading), 0, std::sin(heading));
    }
  }
  for (int j = 0; j < Steps; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const int a = j * columns + i;
      const int c = a + columns;
      // Diagonals run both ways.
      if ((i + j) % 3 == 0)
      {
        sheet.triangles.push_back({ { a, a + 1, c + 1 } });
        sheet.triangles.push_back({ { a, c + 1, c } });
      }
      else
      {
        sheet.triangles.push_back({ { a, a + 1, c } });
        sheet.triangles.push_back({ { a + 1, c + 1, c } });
      }
    }
  }
  sheet.connect();
  return sheet;
}

RoundedEdgeOptions wide(double width)
{
  RoundedEdgeOptions options;
  options.width = width;
  return options;
}

double lengthOf(const CutSurface& surface, const std::vector<Halfedge>& edges)
{
  double length = 0;
  for (const Halfedge h : edges)
  {
    length += surface.edgeLength(h);
  }
  return length;
}

/// How many points of the edges have so many of them.
int pointsWith(const CutSurface& surface, const std::vector<Halfedge>& edges, std::size_t valence)
{
  std::multiset<int> ends;
  for (const Halfedge h : edges)
  {
    ends.insert(surface.tail(h).index());
    ends.insert(surface.head(h).index());
  }
  int count = 0;
  for (auto p = ends.begin(); p != ends.end(); p = ends.upper_bound(*p))
  {
    count += ends.count(*p) == valence ? 1 : 0;
  }
  return count;
}
}

TEST(RoundedEdges, AreInTheMiddleOfBends)
{
  for (const int edges : { 3, 6, 7, 12 })
  {
    const CutSurface sheet = shapes::cutSurface(bentSheet(180, 0.02, edges));
    const std::vector<Halfedge> found = findRoundedEdges(sheet, wide(0.2));
    ASSERT_EQ(found.size(), static_cast<std::size_t>(Steps)) << edges << " edges";
    EXPECT_NEAR(lengthOf(sheet, found), 2., 1e-9);
    EXPECT_EQ(pointsWith(sheet, found, 1), 2) << "one line";
    for (const Halfedge h : found)
    {
      // Half of the turn is done where the bend is at its farthest.
      EXPECT_NEAR(sheet.point(sheet.tail(h)).z(), 0.02, 0.02 * Pi / edges) << edges << " edges";
      EXPECT_GT(sheet.point(sheet.tail(h)).x(), 1.);
    }
  }
}

TEST(RoundedEdges, TurnByTheAngleWithinTheWidth)
{
  const auto found = [](double degrees, double radius, double angle) {
    RoundedEdgeOptions options = wide(0.2);
    options.angle = angle;
    return findRoundedEdges(shapes::cutSurface(bentSheet(degrees, radius, 9)), options).size();
  };
  EXPECT_EQ(found(120, 0.02, 100), static_cast<std::size_t>(Steps));
  EXPECT_EQ(found(90, 0.02, 100), 0U);
  EXPECT_EQ(found(90, 0.02, 80), static_cast<std::size_t>(Steps));
  EXPECT_EQ(found(180, 0.06, 100), static_cast<std::size_t>(Steps)) << "a band of .19";
  EXPECT_EQ(found(180, 0.1, 100), 0U) << "a band of .31: it turns beside .2, too";
  // A plane has none, nor has a rod that turns everywhere.
  for (TriangleSurface shape : { shapes::grid(8), shapes::cylinder(0.05, 2, 24, 40) })
  {
    shape.connect();
    EXPECT_TRUE(findRoundedEdges(shapes::cutSurface(shape), wide(0.2)).empty());
  }
}

TEST(RoundedEdges, DependOnNoScale)
{
  TriangleSurface sheet = bentSheet(180, 0.02, 7);
  const std::vector<Halfedge> found = findRoundedEdges(shapes::cutSurface(sheet), wide(0.2));
  for (const double scale : { 1e-9, 1e9 })
  {
    TriangleSurface other = sheet;
    for (Vec3& p : other.points)
    {
      p = scale * Vec3(p.z(), -p.x(), p.y() + 3);
    }
    EXPECT_EQ(findRoundedEdges(shapes::cutSurface(other), wide(0.2 * scale)), found) << scale;
  }
}

TEST(RoundedEdges, AreJoinedWhereTheMiddleChangesRows)
{
  // Of six edges the third is in the middle at first, and the fourth from half way on.
  const CutSurface sheet =
    shapes::cutSurface(bentSheet(180, 0.02, 6, [](int j) { return j < Steps / 2 ? -0.1 : 0.1; }));
  const std::vector<Halfedge> found = findRoundedEdges(sheet, wide(0.2));
  EXPECT_EQ(pointsWith(sheet, found, 1), 2);
  EXPECT_EQ(pointsWith(sheet, found, 3), 0);
  EXPECT_NEAR(lengthOf(sheet, found), 2., 0.1);
  EXPECT_GE(found.size(), static_cast<std::size_t>(Steps));
}

TEST(RoundedEdges, AreJoinedInsideAlone)
{
  // The middle is in one row or the next by chance, also where the sheet ends.
  unsigned int state = 1;
  const auto chance = [&] { return (state = 1664525 * state + 1013904223) >> 16; };
  for (int trial = 0; trial < 200; ++trial)
  {
    std::vector<double> shift(Steps + 1);
    for (double& s : shift)
    {
      s = chance() % 2 == 0 ? -0.1 : 0.1;
    }
    const CutSurface sheet =
      shapes::cutSurface(bentSheet(180, 0.02, 6, [&](int j) { return shift[j]; }));
    for (const Halfedge h : findRoundedEdges(sheet, wide(0.2)))
    {
      ASSERT_TRUE(h.valid());
      EXPECT_FALSE(sheet.isBoundary(h));
    }
  }
}

TEST(RoundedEdges, AreLong)
{
  const CutSurface sheet = shapes::cutSurface(bentSheet(180, 0.02, 7));
  RoundedEdgeOptions options = wide(0.2);
  options.minimumLength = 1.9;
  EXPECT_EQ(findRoundedEdges(sheet, options).size(), static_cast<std::size_t>(Steps));
  options.minimumLength = 2.1;
  EXPECT_TRUE(findRoundedEdges(sheet, options).empty());
}

TEST(RoundedEdges, AreNotLookedForBeyondFeatures)
{
  // Two right angles are a bend, but not if they are creases.
  CutSurface sheet = shapes::cutSurface(bentSheet(180, 0.02, 2));
  EXPECT_EQ(findRoundedEdges(sheet, wide(0.2)).size(), static_cast<std::size_t>(Steps));
  FeatureDetectionOptions detection;
  detectFeatures(sheet, detection);
  for (const Halfedge h : sheet.halfedges())
  {
    EXPECT_FALSE(sheet.isRounded(h));
  }
  EXPECT_EQ(std::count(sheet.sharp.begin(), sheet.sharp.end(), 1), 4 * Steps);
}

TEST(RoundedEdges, AreMarkedAndMeasured)
{
  CutSurface sheet = shapes::cutSurface(bentSheet(180, 0.01, 18));
  FeatureDetectionOptions detection;
  detectFeatures(sheet, detection);
  ASSERT_EQ(std::count(sheet.sharp.begin(), sheet.sharp.end(), CutSurface::Rounded), 2 * Steps);
  Halfedge rounded;
  for (const Halfedge h : sheet.halfedges())
  {
    rounded = sheet.isRounded(h) ? h : rounded;
  }
  sheet.splitEdge(rounded, 0.3);
  EXPECT_EQ(std::count(sheet.sharp.begin(), sheet.sharp.end(), CutSurface::Rounded), 2 * Steps + 2);
  FeatureGraph graph = buildFeatureGraph(sheet, 60);
  measureRoundedEdges(sheet, roundedEdgeOptions(sheet, detection), graph);
  int lines = 0;
  for (const Backbone& b : graph.backbones)
  {
    EXPECT_EQ(b.type == BackboneType::Sharp, b.width > 0);
    if (b.type == BackboneType::Sharp)
    {
      ++lines;
      EXPECT_EQ(b.numberOfSegments(), Steps + 1);
      // 100 degrees, but for a row on either side.
      EXPECT_NEAR(b.width, 0.01 * 100 * Pi / 180, 2 * 0.01 * Pi / 18);
    }
  }
  EXPECT_EQ(lines, 1);
  detection.roundedWidth = 0;
  CutSurface other = shapes::cutSurface(bentSheet(180, 0.01, 18));
  detectFeatures(other, detection);
  EXPECT_EQ(std::count(other.sharp.begin(), other.sharp.end(), 0), other.numberOfHalfedges());
}
