// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers of points whose edges are as long as asked for.
#include "EdgeLengthSearch.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace stipple;

namespace
{
struct Found
{
  int points = 0;
  int trials = 0;
};

/// Of a surface with these lengths by number, of which no mesh has fewer than `fewest` points.
Found search(int first, const std::function<double(int)>& of, int fewest = 1)
{
  EdgeLengthSearch s(1.);
  s.add(first, first, of(first));
  Found result = { 0, 1 };
  while (s.next() > 0)
  {
    const int asked = s.next();
    const int got = std::max(asked, fewest);
    s.add(asked, got, of(got));
    ++result.trials;
  }
  result.points = s.found();
  return result;
}
}

TEST(EdgeLengthSearch, IsOverWhereTheFirstIsRight)
{
  for (const double length : { 0.951, 1., 1.049 })
  {
    const Found f = search(500, [&](int) { return length; });
    EXPECT_EQ(f.trials, 1) << length;
    EXPECT_EQ(f.points, 500) << length;
  }
}

TEST(EdgeLengthSearch, CorrectsByTheRootOfTheNumber)
{
  for (const double factor : { 0.3, 0.7, 0.9, 1.2, 3. })
  {
    const Found f = search(1000, [&](int n) { return factor * std::sqrt(1000. / n); });
    EXPECT_EQ(f.trials, 2) << factor;
    EXPECT_NEAR(f.points / (1000. * factor * factor), 1., 0.01) << factor;
  }
}

TEST(EdgeLengthSearch, FollowsOtherLaws)
{
  // Features keep their edges whatever the number; or points are all in one place.
  for (const double power : { 0.3, 0.8 })
  {
    const auto of = [&](int n) { return 0.6 * std::pow(1000. / n, power); };
    const Found f = search(1000, of);
    EXPECT_LE(f.trials, 5) << power;
    EXPECT_NEAR(of(f.points), 1., EdgeLengthSearch::Tolerance) << power;
  }
}

TEST(EdgeLengthSearch, TakesTheNearestWhereNoneIsRight)
{
  // There are no meshes of fewer points.
  const auto of = [](int n) { return 0.5 * std::sqrt(1000. / n); };
  const Found least = search(1000, of, 600);
  EXPECT_EQ(least.points, 600);
  EXPECT_EQ(least.trials, 2) << "fewer need not be asked for";
  // Lengths jump past the one that is wanted.
  const auto jumps = [](int n) { return n < 400 ? 1.2 : 0.7; };
  const Found nearest = search(1000, jumps);
  EXPECT_LT(nearest.points, 400);
  EXPECT_LE(nearest.trials, 5);
}

TEST(MedianEdgeLength, IsThatOfEachEdgeOnce)
{
  EXPECT_EQ(medianEdgeLength(TriangleSurface()), 0.);
  // Sides of 1, 2.5, 2.8 and 3.0, and a diagonal of 3.6: were it counted twice, the longest side
  // would be the middle one.
  TriangleSurface kite;
  kite.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 3, 2, 0 }, { 0, 2.5, 0 } };
  kite.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  kite.connect();
  EXPECT_DOUBLE_EQ(medianEdgeLength(kite), std::sqrt(8.));
  TriangleSurface square;
  square.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  square.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  square.connect();
  EXPECT_DOUBLE_EQ(medianEdgeLength(square), 1.);
  TriangleSurface tetrahedron = square;
  tetrahedron.triangles = { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 3 }, { 1, 2, 3 } };
  tetrahedron.connect();
  EXPECT_DOUBLE_EQ(medianEdgeLength(tetrahedron), 1.) << "four sides, two diagonals";
}
