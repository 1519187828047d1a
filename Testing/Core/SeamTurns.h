// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How straight the seams between charts are.
#ifndef stipple_test_SeamTurns_h
#define stipple_test_SeamTurns_h

#include "FeatureGraph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test
{
/// Mean turn in degrees of the seams over the points of a surface, resampled at a step.
inline double meanTurnOfSeams(
  const stipple::FeatureGraph& graph, const std::vector<stipple::Vec3>& points, double step)
{
  using stipple::Vec3;
  double sum = 0;
  int turns = 0;
  for (const stipple::Backbone& b : graph.backbones)
  {
    if (b.type != stipple::BackboneType::Seam)
    {
      continue;
    }
    std::vector<Vec3> line;
    double next = 0;
    for (int s = 0; s < b.numberOfSegments(); ++s)
    {
      const Vec3& p = points[b.points[s]];
      const Vec3& q = points[b.segmentEnd(s)];
      const double length = (q - p).norm();
      for (; next < length; next += step)
      {
        line.push_back(p + (q - p) * (next / length));
      }
      next -= length;
    }
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
    {
      const Vec3 u = (line[i] - line[i - 1]).normalized();
      const Vec3 v = (line[i + 1] - line[i]).normalized();
      sum += std::acos(std::clamp(u.dot(v), -1., 1.)) * 57.29577951308232;
      ++turns;
    }
  }
  EXPECT_GT(turns, 10);
  return sum / turns;
}
}

#endif
