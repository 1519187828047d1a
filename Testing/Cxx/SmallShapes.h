// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Small surfaces of many kinds, for tests that draw at random.
#ifndef SmallShapes_h
#define SmallShapes_h

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace test
{
/// Every point of the mesh gets a weight for the importance ARRAY.
inline void addWeight(vtkPolyData* mesh)
{
  vtkNew<vtkDoubleArray> weight;
  weight->SetName("Weight");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    weight->InsertNextValue(std::exp(2. * p[0]) * (p[1] > 0.2 ? 1. : 0.));
  }
  mesh->GetPointData()->AddArray(weight);
}

/// u and v run over [0, 1); closed directions wrap around.
template <typename F>
vtkSmartPointer<vtkPolyData> makeGrid(int m, int n, bool wrapU, bool wrapV, F position)
{
  const int points = wrapU ? m : m + 1;
  const int lines = wrapV ? n : n + 1;
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (int j = 0; j < lines; ++j)
  {
    for (int i = 0; i < points; ++i)
    {
      const std::array<double, 3> p =
        position(static_cast<double>(i) / m, static_cast<double>(j) / n);
      coordinates->InsertNextPoint(p.data());
    }
  }
  vtkNew<vtkCellArray> cells;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < m; ++i)
    {
      const auto at = [&](int a, int b) {
        return static_cast<vtkIdType>(b % lines) * points + a % points;
      };
      const vtkIdType quad[4] = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
      cells->InsertNextCell(4, quad);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(coordinates);
  mesh->SetPolys(cells);
  return mesh;
}

/// A box of quads with sharp edges, without its top if open.
inline vtkSmartPointer<vtkPolyData> makeBox(int n, bool open)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int side = 0; side < (open ? 5 : 6); ++side)
  {
    const int axis = (side + 2) % 3;
    const double level = side < 3 ? 0. : 1.;
    const vtkIdType first = points->GetNumberOfPoints();
    for (int k = 0; k < (n + 1) * (n + 1); ++k)
    {
      double p[3];
      p[axis] = level;
      p[(axis + 1) % 3] = static_cast<double>(k % (n + 1)) / n;
      p[(axis + 2) % 3] = static_cast<double>(k / (n + 1)) / n;
      points->InsertNextPoint(p);
    }
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const vtkIdType a = first + j * (n + 1) + i;
        vtkIdType quad[4] = { a, a + 1, a + n + 2, a + n + 1 };
        if (side < 3)
        {
          std::reverse(quad, quad + 4);
        }
        cells->InsertNextCell(4, quad);
      }
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh; // the atlas welds it
}

/// Closed and open ones, with and without sharp edges, all with weights.
inline std::vector<vtkSmartPointer<vtkPolyData>> makeShapes()
{
  using Point = std::array<double, 3>;
  const double turn = 2. * vtkMath::Pi();
  std::vector<vtkSmartPointer<vtkPolyData>> shapes;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(14);
  sphere->Update();
  shapes.emplace_back(sphere->GetOutput());
  shapes.push_back(makeBox(5, false));
  shapes.push_back(makeBox(4, true));
  shapes.push_back(makeGrid(24, 12, true, true, [=](double u, double v) { // torus
    const double r = 1. + 0.35 * std::cos(turn * v);
    return Point{ r * std::cos(turn * u), r * std::sin(turn * u), 0.35 * std::sin(turn * v) };
  }));
  shapes.push_back(makeGrid(16, 10, true, false, [=](double u, double v) { // open tube, waisted
    const double r = 0.3 + 0.5 * std::pow(v - 0.5, 2);
    return Point{ r * std::cos(turn * u), r * std::sin(turn * u), v };
  }));
  shapes.push_back(makeGrid(12, 12, false, false, [](double u, double v) { // folded sheet
    return Point{ u, v, 0.4 * std::abs(u - 0.5) + 0.1 * std::sin(9. * v) };
  }));
  shapes.push_back(makeGrid(20, 3, false, false, [](double u, double v) { // long strip
    return Point{ 8. * u, 0.3 * v, 0.2 * std::sin(6. * u) };
  }));
  shapes.push_back(makeGrid(10, 1, true, false, [=](double u, double v) { // ten sharp edges
    return Point{ std::cos(turn * u), std::sin(turn * u), v };
  }));
  for (const auto& shape : shapes)
  {
    addWeight(shape);
  }
  return shapes;
}
}

#endif
