// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells of a chart's plane that have as much surface as others.
#include "GradedLattice.h"
#include "OptimizerMeshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using namespace stipple;

namespace
{
/// A flat sheet as one chart: its parameters are (x, y) of a unit square, its points map(x, y).
template <typename Map>
std::unique_ptr<meshes::TestMesh> sheet(const Map& map, int n)
{
  const auto at = [&map, n](int i, int j) {
    return map(static_cast<double>(i) / n, static_cast<double>(j) / n);
  };
  auto t = meshes::openChart(at, n, Vec2(1, 1));
  t->read();
  return t;
}

/// Of the cells that are inside of the rectangle.
std::vector<std::array<Vec2, 2>> boxesOf(const GradedLattice& lattice)
{
  std::vector<std::array<Vec2, 2>> boxes;
  for (const auto& cell : lattice.cells)
  {
    const Vec2& low = lattice.nodes[cell[0]];
    const Vec2& high = lattice.nodes[cell[2]];
    EXPECT_EQ(lattice.nodes[cell[1]], Vec2(high.x(), low.y()));
    EXPECT_EQ(lattice.nodes[cell[3]], Vec2(low.x(), high.y()));
    for (const int n : cell)
    {
      EXPECT_LE(lattice.spacing[n], (high - low).minCoeff() + 1e-12);
    }
    if (low.minCoeff() >= 0 && high.maxCoeff() <= 1)
    {
      boxes.push_back({ { low, high } });
    }
  }
  return boxes;
}
}

TEST(GradedLattice, AreaIsSpreadOverTheTriangles)
{
  const auto t = sheet([](double x, double y) { return Vec3(x * x, y, 0); }, 7);
  for (const double parts : { 1., 50., 3000. })
  {
    const AreaPoints area = spreadArea(t->atlas->surface(), 0, parts);
    EXPECT_NEAR(area.total, 1, 1e-12);
    EXPECT_EQ(area.extent, Vec2(1, 1));
    ASSERT_EQ(area.places.size(), area.areas.size());
    double sum = 0;
    double left = 0;
    for (std::size_t i = 0; i < area.areas.size(); ++i)
    {
      EXPECT_LE(area.areas[i], area.total / parts + 1e-15);
      EXPECT_GT(area.places[i].minCoeff(), 0);
      EXPECT_LT(area.places[i].maxCoeff(), 1);
      sum += area.areas[i];
      left += area.places[i].x() < 3. / 7 ? area.areas[i] : 0;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(left, 9. / 49, 1e-12) << "each triangle has its own";
  }
}

TEST(GradedLattice, AlikeCellsAreSquaresAroundTheMiddle)
{
  const auto t = sheet([](double x, double y) { return Vec3(3 * x, 3 * y, 0); }, 5);
  const AreaPoints area = spreadArea(t->atlas->surface(), 0, 5000);
  const double side = 1 / 7.4;
  const GradedLattice lattice = gradedLattice(area, 9 * side * side);
  const auto boxes = boxesOf(lattice);
  EXPECT_EQ(boxes.size(), 49U);
  Vec2 low(1, 1);
  Vec2 high(0, 0);
  for (const auto& box : boxes)
  {
    EXPECT_NEAR((box[1] - box[0]).x(), side, 1e-12);
    EXPECT_NEAR((box[1] - box[0]).y(), side, 1e-12);
    low = low.cwiseMin(box[0]);
    high = high.cwiseMax(box[1]);
  }
  EXPECT_LT((low + high - Vec2(1, 1)).norm(), 1e-12);
}

TEST(GradedLattice, NoCellHasMuchMoreThanIsWanted)
{
  // A conformal map, with nearly a thousand times as much area at one side as at the other.
  const double rate = std::log(30.);
  const auto t = sheet(
    [rate](double x, double y) {
      const double r = std::exp(rate * x);
      return Vec3(r * std::cos(rate * y), r * std::sin(rate * y), 0);
    },
    150);
  const auto areaOf = [rate](const Vec2& low, const Vec2& high) {
    return 0.5 * rate * (std::exp(2 * rate * high.x()) - std::exp(2 * rate * low.x())) *
      (high.y() - low.y());
  };
  const double total = areaOf(Vec2(0, 0), Vec2(1, 1));
  const AreaPoints area = spreadArea(t->atlas->surface(), 0, 32 * 500);
  EXPECT_NEAR(area.total, total, 1e-3 * total);
  const auto boxes = boxesOf(gradedLattice(area, total / 500));
  EXPECT_GT(boxes.size(), 350U);
  EXPECT_LT(boxes.size(), 1000U);
  double covered = 0;
  std::map<double, int> widths;
  for (const auto& [low, high] : boxes)
  {
    covered += areaOf(low, high);
    ++widths[std::round(std::log2(high.x() - low.x()))];
    EXPECT_LT(areaOf(low, high), 2.2 * total / 500);
    EXPECT_NEAR((high - low).x(), (high - low).y(), 1e-12) << "squares, where the map is conformal";
  }
  EXPECT_GT(covered, 0.8 * total);
  EXPECT_GE(widths.size(), 3U) << "of many sizes";
}

TEST(GradedLattice, CellsFollowADensity)
{
  // Sixteen times as many are wanted in the right half of a plane.
  const auto t = sheet([](double x, double y) { return Vec3(x, y, 0); }, 40);
  const AtlasSurface& surface = t->atlas->surface();
  std::vector<double> wanted;
  for (const Vec3& p : surface.points)
  {
    wanted.push_back(p.x() < 0.5 ? 1 : 16);
  }
  DensityField density;
  density.setAtPoints(wanted);
  const AreaPoints area = spreadArea(surface, 0, 16 * 6000, density);
  const auto boxes = boxesOf(gradedLattice(area, area.total / 6000));
  const auto meanArea = [&boxes](double low, double high) {
    double sum = 0;
    int number = 0;
    for (const auto& [a, b] : boxes)
    {
      const bool isThere = a.x() >= low && b.x() <= high;
      sum += isThere ? (b - a).prod() : 0;
      number += isThere ? 1 : 0;
    }
    return sum / number;
  };
  EXPECT_NEAR(std::log2(meanArea(0, 0.5) / meanArea(0.5, 1)), 4, 0.7);
  EXPECT_EQ(spreadArea(surface, 0, 100, DensityField()).areas, spreadArea(surface, 0, 100).areas);
}

TEST(GradedLattice, CellsAreSquareOnTheSurface)
{
  // Where the map squashes eightfold, cells are long in the plane.
  for (const Vec2& stretch : { Vec2(8, 1), Vec2(1, 8) })
  {
    const auto t = sheet(
      [&stretch](double x, double y) { return Vec3(stretch.x() * x, stretch.y() * y, 0); }, 20);
    const AreaPoints area = spreadArea(t->atlas->surface(), 0, 16 * 800);
    for (const auto& [low, high] : boxesOf(gradedLattice(area, 8. / 800)))
    {
      const Vec2 sides = (high - low).cwiseProduct(stretch);
      EXPECT_LE(sides.maxCoeff(), 2 * sides.minCoeff());
    }
  }
}

TEST(GradedLattice, ThinAndEmptyCharts)
{
  // A strip of 1e9 to 1, as a square.
  const auto t = sheet([](double x, double y) { return Vec3(1e9 * x, y, 0); }, 3);
  const AreaPoints area = spreadArea(t->atlas->surface(), 0, 16 * 100);
  const GradedLattice lattice = gradedLattice(area, area.total / 100);
  EXPECT_GT(lattice.cells.size(), 40U);
  EXPECT_LT(lattice.cells.size(), 400U);
  EXPECT_TRUE(gradedLattice(area, 0).cells.empty());
  EXPECT_TRUE(gradedLattice(AreaPoints(), 1).cells.empty());
}

TEST(PointBins, FindWhatIsThere)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vec2> points;
  for (int i = 0; i < 300; ++i) // crowded about the origin
  {
    points.emplace_back(std::pow(uniform(random), 4), 0.3 * std::pow(uniform(random), 2));
  }
  const PointBins bins(points);
  for (int i = 0; i < 200; ++i)
  {
    const Vec2 place(3 * uniform(random) - 1, 3 * uniform(random) - 1);
    const Vec2 size(uniform(random), uniform(random));
    std::vector<int> found;
    bins.forEachIn(place, place + size, [&found](int p) { found.push_back(p); });
    std::sort(found.begin(), found.end());
    std::vector<int> expected;
    double least = 1e300;
    for (int p = 0; p < 300; ++p)
    {
      if ((points[p] - place).minCoeff() >= 0 && (place + size - points[p]).minCoeff() >= 0)
      {
        expected.push_back(p);
      }
      least = std::min(least, (points[p] - place).squaredNorm());
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(bins.squaredDistance(place), least);
  }
  const PointBins none({});
  none.forEachIn(Vec2(0, 0), Vec2(1, 1), [](int) { ADD_FAILURE(); });
  EXPECT_EQ(none.squaredDistance(Vec2(0, 0)), std::numeric_limits<double>::infinity());
}
