// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Thin shells with round rims: a crease runs along the rim where edges are long beside it.
#include "PolyDataConversion.h"

#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkDataArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSurfaceQuality.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace stipple;

namespace
{
/// A disc of radius 1, so thick, whose rim is round, on a wavy surface.
vtkSmartPointer<vtkPolyData> leaf(double thickness)
{
  constexpr int Around = 160;
  constexpr int Rings = 40; // of a face
  constexpr int OfRim = 10;
  std::vector<Vec3> profile; // radius and height
  for (int i = 1; i < Rings; ++i)
  {
    profile.emplace_back(static_cast<double>(i) / Rings, -thickness / 2, 0);
  }
  for (int i = 0; i <= OfRim; ++i)
  {
    const double a = Pi * (static_cast<double>(i) / OfRim - 0.5);
    profile.emplace_back(1 + thickness / 2 * std::cos(a), thickness / 2 * std::sin(a), 0);
  }
  for (int i = Rings - 1; i > 0; --i)
  {
    profile.emplace_back(static_cast<double>(i) / Rings, thickness / 2, 0);
  }
  TriangleSurface s;
  const auto add = [&](double x, double y, double z) {
    s.points.emplace_back(x, y, z + 0.15 * std::sin(3 * x) * std::cos(4 * y));
  };
  for (const Vec3& p : profile)
  {
    for (int k = 0; k < Around; ++k)
    {
      add(p.x() * std::cos(2 * Pi * k / Around), p.x() * std::sin(2 * Pi * k / Around), p.y());
    }
  }
  const int bottom = static_cast<int>(s.points.size());
  const int top = bottom + 1;
  const int last = bottom - Around;
  add(0, 0, -thickness / 2);
  add(0, 0, thickness / 2);
  for (int k = 0; k < Around; ++k)
  {
    const int next = (k + 1) % Around;
    s.triangles.push_back({ { bottom, next, k } });
    s.triangles.push_back({ { top, last + k, last + next } });
    for (int ring = 0; ring < last; ring += Around)
    {
      s.triangles.push_back({ { ring + k, ring + next, ring + Around + k } });
      s.triangles.push_back({ { ring + next, ring + Around + next, ring + Around + k } });
    }
  }
  return toPolyData(s.points, s.triangles);
}

struct Figures
{
  double angle = 0;       ///< the smallest, degrees
  vtkIdType creases = 0;  ///< lines of the mesh
  vtkIdType features = 0; ///< lines of the feature graph that have a width
  double width = 0;       ///< of the last of them
};

Figures remesh(double thickness, int points, double widest)
{
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(leaf(thickness));
  remesher->SetNumberOfPoints(points);
  remesher->GetAtlas()->SetRoundedEdgeWidth(widest);
  remesher->Update();
  EXPECT_EQ(remesher->GetOutput()->GetNumberOfPoints(), points);
  vtkNew<vtkSurfaceQuality> quality;
  quality->SetInputConnection(remesher->GetOutputPort());
  quality->Update();
  Figures result;
  result.angle = quality->GetFigure("angle_min");
  result.creases = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1))->GetNumberOfLines();
  auto* graph = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(3));
  vtkDataArray* widths = graph->GetCellData()->GetArray("Width");
  for (vtkIdType i = 0; widths && i < widths->GetNumberOfTuples(); ++i)
  {
    if (widths->GetComponent(i, 0) > 0)
    {
      ++result.features;
      result.width = widths->GetComponent(i, 0);
    }
  }
  return result;
}
}

TEST(RoundedRims, AreCreasesToCoarseMeshes)
{
  const Figures with = remesh(0.01, 1500, 0.02);
  EXPECT_GT(with.features, 0);
  EXPECT_NEAR(with.width, 100. * Pi / 180. * 0.005, 0.001) << "where it turns by 100 degrees";
  EXPECT_GT(with.creases, 0);
  EXPECT_GE(with.angle, 33.);
  const Figures without = remesh(0.01, 1500, 0.);
  EXPECT_EQ(without.features, 0);
  EXPECT_EQ(without.creases, 0);
  EXPECT_LT(without.angle, 10.) << "there is no need for creases then";
}

TEST(RoundedRims, AreNoneToFineMeshes)
{
  const Figures fine = remesh(0.025, 20000, 0.02);
  EXPECT_GT(fine.features, 0);
  EXPECT_EQ(fine.creases, 0) << "edges are as long as a third of the rim";
  EXPECT_GE(fine.angle, 30.);
}
