// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Cuts that relieve dense places, and what becomes of surfaces that no cut makes flat.
#include "AtlasConstants.h"
#include "ChartPartition.h"
#include "DensityCuts.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace stipple;

namespace
{
FlatChart flatten(const ChartRegions& regions, int region)
{
  FlatChart chart;
  chart.mesh = regions.mesh(region);
  chart.map = mapToRectangle(regions.surface(), chart.mesh, {});
  return chart;
}

/// A tube about the z axis without its lid at z = 0.
CutSurface sleeve(double height, int n, int m)
{
  TriangleSurface s = shapes::cylinder(1, height, n, m);
  s.triangles.erase(std::remove_if(s.triangles.begin(), s.triangles.end(),
                      [&](const Triangle& t) {
                        return std::all_of(
                          t.begin(), t.end(), [&](int p) { return s.points[p].z() == 0; });
                      }),
    s.triangles.end());
  s.connect();
  return shapes::cutSurface(s);
}
}

TEST(DensityCuts, BoundTheRatio)
{
  CutSurface s = sleeve(8, 32, 60);
  ChartRegions regions(s);
  ASSERT_EQ(regions.size(), 1);
  regions.splitChords(0);
  const FlatChart before = flatten(regions, 0);
  ASSERT_TRUE(before.map.valid);
  ASSERT_GT(before.map.densityRatio, 100) << "the sleeve's end is dense";
  ASSERT_TRUE(cutToDensePlaces(regions, 0, before, 100));
  EXPECT_TRUE(regions.isReshaped(0));
  regions.splitChords(0);
  const FlatChart after = flatten(regions, 0);
  EXPECT_TRUE(after.mesh.isDisk()) << "a cut from inside to the boundary leaves a disk";
  EXPECT_LT(after.map.densityRatio, before.map.densityRatio / 10);
  EXPECT_EQ(s.topology(), sleeve(8, 32, 60).topology());
  EXPECT_FALSE(cutToDensePlaces(regions, 0, after, after.map.densityRatio * 1e6))
    << "nothing is too dense";
}

TEST(DensityCuts, LeaveLessThanTheBoundDoes)
{
  EXPECT_LT(AtlasConstants::DenseSliver, NegligibleArea)
    << "else cuts would leave charts too dense";
  EXPECT_LT(std::exp(-2 * Pi * AtlasConstants::DeepSleeve), 1e-16);
}

TEST(DensityCuts, OpenASleeveThatNoMapCanHold)
{
  for (const double height : { 20., 60. })
  {
    CutSurface s = sleeve(height, 12, static_cast<int>(4 * height));
    ChartRegions regions(s);
    const FlatChart chart = flatten(regions, 0);
    const bool deep = height > 6 * 2 * 3.1416;
    EXPECT_EQ(cutDeepSleeve(regions, chart), deep) << height;
    const ChartMesh after = regions.mesh(0);
    EXPECT_TRUE(after.isDisk());
    // Both sides of the cut join the boundary.
    const double sides = static_cast<double>(after.boundary.size() - chart.mesh.boundary.size());
    EXPECT_NEAR(sides, deep ? 2 * 4 * height : 0, 2 * 12);
  }
}

class Slender : public testing::TestWithParam<shapes::Named>
{
};

/// Splitting what is too dense went on for ever.
TEST_P(Slender, PartitionComesToAnEnd)
{
  const TriangleSurface& shape = GetParam().surface;
  CutSurface s = shapes::cutSurface(shape);
  std::vector<FlatChart> charts;
  const Status status = partitionSurface(s, {}, charts, {});
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_LT(charts.size(), shape.triangles.size());
  EXPECT_EQ(s.topology(), shape.topology());
  EXPECT_NEAR(s.area(), shape.area(), 1e-9 * shape.area());
  for (const FlatChart& c : charts)
  {
    EXPECT_TRUE(c.mesh.isDisk());
    EXPECT_TRUE(c.map.valid);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Slender,
  testing::Values(shapes::Named{ "ChimneyOfNeedles", shapes::cylinder(1, 300, 12, 12) },
    shapes::Named{ "Chimney", shapes::cylinder(1, 300, 12, 150) },
    shapes::Named{ "Spikes", shapes::cone(1, 500, 7, 20) }),
  [](const auto& info) { return info.param.name; });

TEST(DensityCuts, AFlatStripIsOneChartHoweverSlender)
{
  for (const double length : { 30., 3000., 30000. })
  {
    TriangleSurface strip;
    const int n = 60;
    for (int i = 0; i <= n; ++i)
    {
      strip.points.emplace_back(length * i / n, 0, 0);
      strip.points.emplace_back(length * i / n, 1, 0);
      if (i < n)
      {
        strip.triangles.push_back({ 2 * i, 2 * i + 2, 2 * i + 3 });
        strip.triangles.push_back({ 2 * i, 2 * i + 3, 2 * i + 1 });
      }
    }
    strip.connect();
    CutSurface s = shapes::cutSurface(strip);
    std::vector<FlatChart> charts;
    ASSERT_TRUE(partitionSurface(s, {}, charts, {}).ok());
    ASSERT_EQ(charts.size(), 1U) << length;
    EXPECT_LT(charts[0].map.densityRatio, 1.5) << "a rectangle is mapped to a rectangle";
  }
}

/// Thin strips at the sides of an octagon, more than a rectangle has corners, lie flat on the
/// rectangle's sides, with angles that are less than rounding: no samples are told apart there.
TEST(DensityCuts, StripsOfNoAreaAreResolved)
{
  const double w = 0.0005;
  TriangleSurface s;
  s.points = { Vec3::Zero() };
  std::vector<int> rim;
  for (int side = 0; side < 8; ++side)
  {
    const double angle = Pi / 4 * side;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    const Vec3 along(-out.y(), out.x(), 0);
    const auto row = [&](double x) {
      const int first = static_cast<int>(s.points.size());
      for (const double y : { -w, 0., w })
      {
        s.points.push_back(Vec3(x * out + y * along));
      }
      return first;
    };
    int last = row(1);
    rim.insert(rim.end(), { last, last + 1, last + 2, static_cast<int>(s.points.size()) });
    s.points.push_back(Vec3(out + std::tan(Pi / 8) * along));
    for (int i = 1; i <= 40; ++i)
    {
      const int next = row(1 + 2 * w * i);
      for (const int k : { 0, 1 })
      {
        s.triangles.push_back({ last + k, next + k, next + k + 1 });
        s.triangles.push_back({ last + k, next + k + 1, last + k + 1 });
      }
      last = next;
    }
  }
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    s.triangles.push_back({ 0, rim[i], rim[(i + 1) % rim.size()] });
  }
  s.connect();
  CutSurface whole = shapes::cutSurface(s);
  ChartRegions regions(whole);
  regions.splitChords(0);
  const FlatChart chart = flatten(regions, 0);
  ASSERT_TRUE(chart.map.valid);
  EXPECT_LT(densityQuantile(chart.map, NegligibleArea), 100) << "strips have no area to speak of";
  EXPECT_GT(chart.map.densityRatio, 1e6);

  CutSurface cut = shapes::cutSurface(s);
  std::vector<FlatChart> charts;
  const Status status = partitionSurface(cut, {}, charts, {});
  ASSERT_TRUE(status.ok()) << status.message();
  for (const FlatChart& c : charts)
  {
    EXPECT_TRUE(c.map.valid);
    EXPECT_LE(c.map.densityRatio, 100);
    for (const Triangle& t : c.mesh.triangles)
    {
      const Vec2& p = c.map.uv[t[0]];
      const Vec2 u = c.map.uv[t[1]] - p;
      const Vec2 v = c.map.uv[t[2]] - p;
      EXPECT_GT(cross2(u, v), 1e-12 * u.norm() * v.norm());
    }
  }
}
