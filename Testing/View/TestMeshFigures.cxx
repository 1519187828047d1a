// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the window's bars count.
#include "MeshFigures.h"

#include "PolyDataConversion.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace stipple;

TEST(MeshFigures, CountValencesInsideAlone)
{
  // A hexagon of six triangles, whose six corners have two each.
  TriangleSurface hexagon;
  hexagon.points.emplace_back(0, 0, 0);
  for (int k = 0; k < 6; ++k)
  {
    hexagon.points.emplace_back(std::cos(Pi / 3 * k), std::sin(Pi / 3 * k), 0);
    hexagon.triangles.push_back({ { 0, 1 + k, 1 + (k + 1) % 6 } });
  }
  const MeshFigures figures = measureFigures(toPolyData(hexagon.points, hexagon.triangles));
  EXPECT_EQ(figures.valences[3], 1) << "the middle";
  EXPECT_EQ(std::accumulate(figures.valences.begin(), figures.valences.end(), 0.), 1);
  EXPECT_EQ(figures.quality.percentValence6, 100) << "as the figures beside the bars say";
  EXPECT_EQ(figures.angles[6] + figures.angles[5], 18) << "60 degrees, up to rounding";
}
