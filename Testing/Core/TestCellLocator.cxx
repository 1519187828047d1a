// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells by place, at any scale.
#include "CellLocator.h"
#include "PolyDataConversion.h"
#include "TriangleDistance.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

using namespace stipple;

namespace
{
TriangleSurface sphere(int resolution, double scale)
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  TriangleSurface surface = fromPolyData(source->GetOutput());
  for (Vec3& p : surface.points)
  {
    p *= scale;
  }
  return surface;
}

const double Scales[] = { 1., std::ldexp(1., -60), 1e-9, 1e-3, 0.3, 1e4, std::ldexp(1., 60) };
}

TEST(CellLocator, FindsTheNearestPlaceAtAnyScale)
{
  for (const double scale : Scales)
  {
    const TriangleSurface surface = sphere(12, scale);
    const CellLocator locator(surface.points, surface.triangles);
    for (const Vec3& at : { Vec3(0.3, 0.1, 0.2), Vec3(-0.6, 0.5, 0.4), Vec3(0.1, -2, 0.7) })
    {
      const Vec3 p = scale * at;
      double least = std::numeric_limits<double>::max();
      for (const Face f : surface.faces())
      {
        least = std::min(least,
          squaredDistanceToTriangle(
            p, surface.point(f, 0), surface.point(f, 1), surface.point(f, 2)));
      }
      const CellLocator::Place place = locator.nearest(p);
      const Face f(static_cast<int>(place.cell));
      EXPECT_NEAR(place.squaredDistance / least, 1, 1e-9) << scale;
      EXPECT_NEAR((place.position - p).squaredNorm() / least, 1, 1e-9) << scale;
      EXPECT_NEAR(squaredDistanceToTriangle(
                    p, surface.point(f, 0), surface.point(f, 1), surface.point(f, 2)) /
          least,
        1, 1e-9)
        << scale;
    }
  }
}

TEST(CellLocator, FindsTheFirstHitAtAnyScale)
{
  for (const double scale : Scales)
  {
    const TriangleSurface surface = sphere(40, scale);
    const CellLocator locator(surface.points, surface.triangles);
    double t = 0;
    const CellLocator::Place hit =
      locator.firstHit(scale * Vec3(2, 0.02, 0.03), scale * Vec3(-2, 0.02, 0.03), t);
    ASSERT_GE(hit.cell, 0) << scale;
    EXPECT_NEAR(hit.position.x() / scale, 0.5, 0.01);
    EXPECT_NEAR(t, 1.5 / 4, 0.003);
    EXPECT_LT(locator.firstHit(scale * Vec3(2, 2, 0), scale * Vec3(-2, 2, 0), t).cell, 0);
  }
}

TEST(CellLocator, SmallModelsTakeNoLonger)
{
  // VTK's own takes some thousand times as long where cells are shorter than a thousandth.
  const auto secondsAt = [](double scale) {
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i)
    {
      const TriangleSurface surface = sphere(80, scale);
      const auto begin = std::chrono::steady_clock::now();
      const CellLocator locator(surface.points, surface.triangles);
      for (const Vec3& p : surface.points)
      {
        EXPECT_GE(locator.nearest(1.1 * p).cell, 0);
      }
      least = std::min(
        least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return least;
  };
  EXPECT_LT(secondsAt(1e-3), 20 * secondsAt(1) + 0.1);
}
