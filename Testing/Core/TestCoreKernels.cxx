// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The small things that everything stands on: outcomes, sentences, the feature graph as data.
#include "AtlasSurface.h"
#include "BoxGrid.h"
#include "CoincidentPoints.h"
#include "CompressedRows.h"
#include "FeatureGraph.h"
#include "MessageText.h"
#include "Progress.h"
#include "TriangleIntersections.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace stipple;

TEST(Status, IsOneOfThree)
{
  EXPECT_TRUE(Status::success().ok());
  EXPECT_EQ(Status::success().message(), "");
  const Status error = Status::error("point 3 is not finite");
  EXPECT_FALSE(error.ok());
  EXPECT_FALSE(error.isAbort());
  EXPECT_EQ(error.message(), "point 3 is not finite");
  EXPECT_FALSE(Status::aborted().ok());
  EXPECT_TRUE(Status::aborted().isAbort());
}

TEST(Progress, NobodyStopsAndTheCallbackMay)
{
  EXPECT_TRUE(report({}, 0.5));
  double seen = -1;
  const Progress until = [&seen](double fraction) {
    seen = fraction;
    return fraction < 0.5;
  };
  EXPECT_TRUE(report(until, 0.25));
  EXPECT_EQ(seen, 0.25);
  EXPECT_FALSE(report(until, 0.75));
}

TEST(CoincidentPoints, FirstOfThoseAtTheVerySamePlace)
{
  constexpr double None = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(1, 2, 3);
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(None, 2, 3);
  points->InsertNextPoint(1, 2, 3 + 1e-15);
  points->InsertNextPoint(-0., 0, -0.);
  points->InsertNextPoint(1, 2, 3);
  points->InsertNextPoint(None, 2, 3);
  vtkNew<vtkPolyData> data;
  EXPECT_TRUE(firstAtPlace(data).empty());
  data->SetPoints(points);
  EXPECT_EQ(firstAtPlace(data), (std::vector<vtkIdType>{ 0, 1, 2, 3, 1, 0, 2 }));
}

TEST(MessageText, KeepsTheSentenceOnly)
{
  EXPECT_EQ(sentenceOf("ERROR: In a/b.cxx, line 12\nvtkX (0x55d0c0ffee): Too few points.\n\n"),
    "Too few points.");
  EXPECT_EQ(sentenceOf("Warning: In b.cxx, line 1\nvtkX (0x1): two\nlines\r\n"), "two lines");
  EXPECT_EQ(sentenceOf("Generic Warning: In b.cxx, line 1\nof nobody\n"), "of nobody");
  // Not VTK's: as it is, also what looks like an address further on.
  EXPECT_EQ(sentenceOf("cannot read 'a (0x1): b'"), "cannot read 'a (0x1): b'");
  EXPECT_EQ(
    sentenceOf("ERROR: In b.cxx, line 1\nsee vtkX (0x1): there\n"), "see vtkX (0x1): there");
  EXPECT_EQ(sentenceOf("ERROR: without a second line"), "ERROR: without a second line");
  EXPECT_EQ(sentenceOf(" \n\n"), "");
}

TEST(CompressedRows, KeepTheOrderWithinRows)
{
  const std::vector<std::pair<int, char>> told = { { 2, 'a' }, { 0, 'b' }, { 2, 'c' }, { 3, 'd' },
    { 0, 'e' }, { 2, 'f' } };
  CompressedRows<char> rows(5, [&](const auto& add) {
    for (const auto& [row, value] : told)
    {
      add(row, value);
    }
  });
  ASSERT_EQ(rows.numberOfRows(), 5u);
  const auto text = [&](
                      std::size_t row) { return std::string(rows[row].begin(), rows[row].end()); };
  EXPECT_EQ(text(0), "be");
  EXPECT_EQ(text(1), "");
  EXPECT_EQ(text(2), "acf");
  EXPECT_EQ(text(3), "d");
  EXPECT_EQ(rows[4].size(), 0u);
  *rows[3].begin() = 'g';
  const std::vector<char> all = rows.takeValues();
  EXPECT_EQ(std::string(all.begin(), all.end()), "beacfg");
  EXPECT_EQ(CompressedRows<int>().numberOfRows(), 0u);
}

TEST(MessageText, NumbersAreAsExactAsTheyAreKnown)
{
  EXPECT_EQ(twoDigits(4321.), 4300.);
  EXPECT_EQ(twoDigits(1'249'000.), 1'200'000.);
  EXPECT_EQ(twoDigits(7.4), 7.);
  EXPECT_EQ(twoDigits(99.6), 100.);
  EXPECT_EQ(countText(1'200'000.), "1200000");
  EXPECT_EQ(countText(2.5e20), "2.5e+20");
  EXPECT_EQ(countText(0.), "0");
  EXPECT_EQ(countOf(1, "loop", "loops"), "1 loop");
  EXPECT_EQ(countOf(0, "loop", "loops"), "0 loops");
}

TEST(MessageText, TopologiesDifferByWhatIsSaid)
{
  SurfaceTopology sphere;
  sphere.components = 1;
  sphere.euler = 2;
  sphere.manifold = true;
  SurfaceTopology other = sphere;
  EXPECT_EQ(differenceOf(other, sphere), "");
  other.manifold = false;
  EXPECT_EQ(differenceOf(other, sphere), "not manifold");
  other.components = 2; // a sphere and a torus
  EXPECT_EQ(differenceOf(other, sphere), "2 components instead of 1, not manifold");
  other = sphere;
  other.euler = 1;
  other.boundaryLoops = 1;
  EXPECT_EQ(differenceOf(other, sphere),
    "Euler characteristic 1 instead of 2, 1 boundary loop instead of 0");
}

namespace
{
/// A closed seam about points 2, 4, 6 and an open crease from corner 0 to 2, over seven points; a
/// constraint.
FeatureGraph someGraph()
{
  FeatureGraph graph;
  graph.backbones = { { BackboneType::Seam, true, { 2, 4, 6 } },
    { BackboneType::Sharp, false, { 0, 1, 2 } } };
  graph.isCorner = { 1, 0, 1, 0, 0, 0, 0 };
  graph.constraints = { { Vec3(1, 2, 3), 4, 5, Vec3(0.25, 0.25, 0.5) } };
  return graph;
}

/// As far as graphs are read against it: those points, and six triangles in the last of five
/// charts.
AtlasSurface someSurface()
{
  AtlasSurface surface;
  surface.points.resize(7, Vec3::Zero());
  surface.extent.resize(5, Vec2(1, 1));
  surface.chartBegin = { 0, 0, 0, 0, 0, 6 };
  return surface;
}

std::vector<Vec3> somePoints()
{
  std::vector<Vec3> points;
  for (int i = 0; i < 7; ++i)
  {
    points.emplace_back(i, i * i, 1);
  }
  return points;
}
}

TEST(FeatureGraph, SegmentsAndNodes)
{
  const FeatureGraph graph = someGraph();
  EXPECT_EQ(graph.backbones[0].numberOfSegments(), 3);
  EXPECT_EQ(graph.backbones[0].segmentEnd(2), 2);
  EXPECT_EQ(graph.backbones[1].numberOfSegments(), 2);
  EXPECT_EQ(graph.nodes(), (std::vector<int>{ 0, 2 }));
}

TEST(FeatureGraph, IsReadAsItWasWritten)
{
  const FeatureGraph graph = someGraph();
  const auto data = toPolyData(graph, somePoints());
  ASSERT_EQ(data->GetNumberOfLines(), 2);
  ASSERT_EQ(data->GetNumberOfVerts(), 1);
  FeatureGraph read;
  ASSERT_TRUE(readFeatureGraph(data, someSurface(), read).ok());
  ASSERT_EQ(read.backbones.size(), 2U);
  for (std::size_t b = 0; b < 2; ++b)
  {
    EXPECT_EQ(read.backbones[b].type, graph.backbones[b].type);
    EXPECT_EQ(read.backbones[b].closed, graph.backbones[b].closed);
    EXPECT_EQ(read.backbones[b].points, graph.backbones[b].points);
  }
  EXPECT_EQ(read.isCorner, graph.isCorner);
  ASSERT_EQ(read.constraints.size(), 1U);
  EXPECT_EQ(read.constraints[0].position, Vec3(1, 2, 3));
  EXPECT_EQ(read.constraints[0].chart, 4);
  EXPECT_EQ(read.constraints[0].chartCell, 5);
  EXPECT_EQ(read.constraints[0].bary, Vec3(0.25, 0.25, 0.5));
}

TEST(FeatureGraph, SaysWhichArraysItNeeds)
{
  FeatureGraph read;
  EXPECT_TRUE(readFeatureGraph(nullptr, someSurface(), read).ok());
  EXPECT_TRUE(read.backbones.empty());
  for (const char* name : { "SurfacePointId", "IsCorner" })
  {
    const auto data = toPolyData(someGraph(), somePoints());
    data->GetPointData()->RemoveArray(name);
    EXPECT_NE(readFeatureGraph(data, someSurface(), read).message().find(name), std::string::npos);
  }
  for (const char* name : { "BackboneType", "Keep", "Closed" })
  {
    const auto data = toPolyData(someGraph(), somePoints());
    data->GetCellData()->RemoveArray(name);
    EXPECT_NE(readFeatureGraph(data, someSurface(), read).message().find(name), std::string::npos);
  }
  const auto data = toPolyData(someGraph(), somePoints());
  data->GetCellData()->RemoveArray("Width");
  data->GetCellData()->RemoveArray("Pitch");
  EXPECT_TRUE(readFeatureGraph(data, someSurface(), read).ok()) << "all are creases then";
  EXPECT_EQ(read.backbones.front().width, 0.);
  EXPECT_EQ(read.backbones.front().pitch, 0.);
  data->GetPointData()->RemoveArray("ChartCellId");
  EXPECT_NE(
    readFeatureGraph(data, someSurface(), read).message().find("ChartCellId"), std::string::npos);
}

namespace
{
void expectBoxesOfAllSizesToBeFound(double leastSize)
{
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto anyBox = [&]() {
    // Sizes of six orders, and points; small ones are many in one place.
    const double size = uniform(0, 1) < 0.05 ? 0 : std::pow(10., uniform(-5, 1));
    const Vec3 low = std::sqrt(size) * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    return Box{ low, low + size * Vec3(uniform(0, 1), uniform(0, 1), 1) };
  };
  std::vector<Box> boxes(600);
  std::generate(boxes.begin(), boxes.end(), anyBox);
  BoxGrid grid(boxes, leastSize);
  EXPECT_GE(grid.meanSize(), leastSize);
  const auto expectAll = [&]() {
    std::set<std::array<int, 2>> expected;
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    {
      std::vector<int> near;
      grid.forEachNear(boxes[i], [&](int j) { near.push_back(j); });
      std::sort(near.begin(), near.end());
      std::vector<int> overlapping;
      for (int j = 0; j < static_cast<int>(boxes.size()); ++j)
      {
        if (boxes[i].overlaps(boxes[j]))
        {
          overlapping.push_back(j);
          if (i < j)
          {
            expected.insert({ { i, j } });
          }
        }
      }
      ASSERT_EQ(near, overlapping) << "each once";
    }
    for (int i = 0; i < 100; ++i)
    {
      const Box other = anyBox(); // some overlap none
      ASSERT_EQ(grid.hasNear(other), std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
        return box.overlaps(other);
      }));
    }
    std::vector<std::array<int, 2>> pairs = grid.pairs([](int, int) { return true; });
    for (std::array<int, 2>& pair : pairs)
    {
      std::sort(pair.begin(), pair.end());
    }
    std::sort(pairs.begin(), pairs.end());
    ASSERT_TRUE(std::equal(pairs.begin(), pairs.end(), expected.begin(), expected.end()));
    EXPECT_GT(pairs.size(), 1000U);
  };
  expectAll();
  for (std::size_t i = 0; i < boxes.size(); i += 3)
  {
    boxes[i] = anyBox();
    grid.move(static_cast<int>(i), boxes[i]);
  }
  expectAll();
  for (int i = 0; i < 50; ++i)
  {
    boxes.push_back(anyBox());
    grid.add(boxes.back());
  }
  EXPECT_EQ(grid.size(), 650);
  expectAll();
}

}

TEST(BoxGrid, FindsBoxesOfAllSizesThatOverlapWhileTheyMove)
{
  expectBoxesOfAllSizesToBeFound(0.);
  expectBoxesOfAllSizesToBeFound(0.1);
  expectBoxesOfAllSizesToBeFound(100.); // larger than all of them
  EXPECT_TRUE(BoxGrid().pairs([](int, int) { return true; }).empty());
}

TEST(Geometry, NearestCornersNeedNotHaveTheLargestCoordinate)
{
  const Vec3 a(0, 0, 0);
  const Vec3 b(10, 0, 0);
  const Vec3 c(0, 1, 0);
  EXPECT_EQ(nearestCorner(Vec3(0.4, 0.45, 0.15), a, b, c), 0);
  EXPECT_EQ(nearestCorner(Vec3(0.2, 0.6, 0.2), a, b, c), 1);
  EXPECT_EQ(nearestCorner(Vec3(0.3, 0.35, 0.35), a, b, c), 0);
  EXPECT_EQ(nearestCorner(Vec3(0.1, 0.2, 0.7), a, b, c), 2);
  EXPECT_EQ(nearestCorner(Vec3(0.5, 0.5, 0), a, b, c), 0) << "of two, the first";
}

TEST(TriangleIntersections, AreNoSharedCornersAndEdges)
{
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 2, 2, 0 },
    { 0.5, 0.5, -1 }, { 0.5, 0.5, 1 }, { 3, 0.5, 1 }, { 0.5, 0.5, 0 }, { 1, 0.2, 0 } };
  const std::vector<Triangle> flat = { { 0, 1, 2 }, { 2, 1, 3 } };
  EXPECT_TRUE(placesOfIntersections(points, flat)->empty()) << "they share an edge";
  const std::vector<Triangle> hinged = { { 0, 1, 2 }, { 0, 5, 6 } };
  EXPECT_TRUE(placesOfIntersections(points, hinged)->empty()) << "they share a corner";
  const std::vector<Triangle> pierced = { { 0, 1, 2 }, { 0, 4, 5 }, { 4, 6, 5 } };
  EXPECT_EQ(placesOfIntersections(points, pierced)->size(), 2U) << "one of them at a corner, too";
  const std::vector<Triangle> touched = { { 0, 1, 2 }, { 7, 5, 6 } };
  const std::vector<Box> places = placesOfIntersections(points, touched).value();
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].low, Vec3(0.5, 0.5, 0));
  EXPECT_EQ(places[0].high, Vec3(2, 0.5, 0));
  const std::vector<Triangle> lying = { { 0, 1, 2 }, { 0, 8, 3 } };
  EXPECT_EQ(placesOfIntersections(points, lying)->size(), 1U) << "in one plane";
}
