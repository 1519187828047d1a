// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Loops about what is thin and smooth.
#include "GirthSizes.h"
#include "SamplingConstants.h"
#include "SyntheticControl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace synthetic;

namespace
{
using Shape = std::function<Vec3(double, double)>;

/// The sizes on a surface over the unit square, with all sides of it where others are.
std::vector<FeatureSize> sizesOn(int m, int n, const Shape& position, double spacing)
{
  Builder builder;
  builder.addGrid(m, n, [&](int i, int j) {
    return position(static_cast<double>(i % m) / m, static_cast<double>(j % n) / n);
  });
  synthetic::MadeAtlas& made = builder.finish();
  stipple::Atlas::Pointer atlas;
  const Status status = stipple::Atlas::read(made.charts, made.graphData, atlas);
  EXPECT_TRUE(status.ok()) << status.message();
  return girthSizes(*atlas, [=](const SurfacePlace&) { return spacing; });
}

/// About the z axis, of radius 1 and that of the tube.
Shape torusOf(double tube)
{
  return [=](double u, double v) {
    const double a = 2. * Pi * u;
    const double b = 2. * Pi * v;
    return Vec3((1. + tube * std::cos(b)) * std::cos(a), (1. + tube * std::cos(b)) * std::sin(a),
      tube * std::sin(b));
  };
}
}

TEST(GirthSizes, GoAroundAThinRing)
{
  const double tube = 0.05;
  const double girth = 2. * Pi * tube;
  const std::vector<FeatureSize> sizes = sizesOn(180, 24, torusOf(tube), 0.1);
  // Edges of 0.1, of which 228 wanted vertices' cells cover the ring.
  const double area = 4. * Pi * Pi * tube;
  const double places = SamplingConstants::PlacesOfGirth * area * 2. / std::sqrt(3.) / 0.01;
  EXPECT_GT(static_cast<double>(sizes.size()), 0.9 * places) << "nearly wherever it was looked";
  for (const FeatureSize& s : sizes)
  {
    // A polygon of 24 sides is .3 % shorter than the circle; longest loops are helices.
    EXPECT_GT(s.size, 0.98 * girth / SamplingConstants::EdgesOfLoop);
    EXPECT_LT(s.size, 1.1 * girth / SamplingConstants::EdgesOfLoop);
    EXPECT_EQ(s.spacing, 0.1);
    EXPECT_NEAR(std::hypot(std::hypot(s.position.x(), s.position.y()) - 1., s.position.z()), tube,
      0.02 * tube);
  }
}

TEST(GirthSizes, LeaveAloneWhatIsWideOrOpen)
{
  // Loops of nine edges of the spacing are looked for: this tube's is longer, its ring's, too.
  EXPECT_TRUE(sizesOn(90, 40, torusOf(0.3), 0.2).empty());
  // A ridge that bends as much as the thin ring does, but does not close.
  Builder builder;
  builder.addGrid(100, 100, [](int i, int j) {
    const double x = 0.02 * i - 1.;
    return Vec3(x, 0.02 * j - 1., 0.3 * std::exp(-400. * x * x));
  });
  synthetic::MadeAtlas& made = builder.finish();
  stipple::Atlas::Pointer atlas;
  ASSERT_TRUE(stipple::Atlas::read(made.charts, made.graphData, atlas).ok());
  EXPECT_TRUE(girthSizes(*atlas, [](const SurfacePlace&) { return 0.2; }).empty());
}

TEST(GirthSizes, AreTheSameInAllScales)
{
  const auto scaled = [](double scale) {
    const Shape shape = torusOf(0.05);
    std::vector<FeatureSize> sizes = sizesOn(
      90, 16, [=](double u, double v) { return Vec3(scale * shape(u, v)); }, scale * 0.1);
    for (FeatureSize& s : sizes)
    {
      s.size /= scale;
    }
    return sizes;
  };
  const std::vector<FeatureSize> unit = scaled(1.);
  const std::vector<FeatureSize> large = scaled(4096.);
  ASSERT_FALSE(unit.empty());
  ASSERT_EQ(unit.size(), large.size());
  for (std::size_t i = 0; i < unit.size(); ++i)
  {
    EXPECT_EQ(unit[i].size, large[i].size);
  }
}
