// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Polygons in another order are the same polygons, and take fewer vertices.
#include "DrawingOrder.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <numeric>
#include <random>
#include <vector>

namespace stipple
{
namespace
{
using Polygons = std::vector<std::vector<vtkIdType>>;

Polygons polygonsOf(vtkCellArray* cells)
{
  Polygons result;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCellAtId(c, size, ids);
    result.emplace_back(ids, ids + size);
  }
  return result;
}

/// A grid of n x n squares in the plane of two axes, each a quad or two triangles, in random order.
vtkSmartPointer<vtkPolyData> shuffledGrid(int n, int second)
{
  vtkNew<vtkPoints> points;
  for (int y = 0; y <= n; ++y)
  {
    for (int x = 0; x <= n; ++x)
    {
      double place[3] = { -5. * x, 7, 7 };
      place[second] = y;
      points->InsertNextPoint(place);
    }
  }
  Polygons polygons;
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      const vtkIdType a = y * (n + 1) + x;
      const vtkIdType b = a + n + 1;
      if ((x + y) % 2 == 0)
      {
        polygons.push_back({ a, a + 1, b + 1, b });
      }
      else
      {
        polygons.push_back({ a, a + 1, b });
        polygons.push_back({ a + 1, b + 1, b });
      }
    }
  }
  std::shuffle(polygons.begin(), polygons.end(), std::mt19937(7));
  vtkNew<vtkCellArray> cells;
  for (const std::vector<vtkIdType>& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

/// How often a vertex is transformed by who keeps the latest 32.
int numberOfTransforms(const Polygons& polygons)
{
  std::deque<vtkIdType> kept;
  int number = 0;
  for (const std::vector<vtkIdType>& polygon : polygons)
  {
    for (const vtkIdType id : polygon)
    {
      if (std::find(kept.begin(), kept.end(), id) == kept.end())
      {
        ++number;
        kept.push_back(id);
        if (kept.size() > 32)
        {
          kept.pop_front();
        }
      }
    }
  }
  return number;
}
}

TEST(DrawingOrder, SamePolygonsFewerVertices)
{
  for (const int second : { 1, 2 })
  {
    const auto mesh = shuffledGrid(40, second);
    Polygons before = polygonsOf(mesh->GetPolys());
    Polygons after = polygonsOf(inDrawingOrder(mesh));
    EXPECT_LT(numberOfTransforms(after), 2. * static_cast<double>(mesh->GetNumberOfPoints()));
    EXPECT_GT(numberOfTransforms(before), 2.5 * static_cast<double>(mesh->GetNumberOfPoints()));
    EXPECT_NE(before, after);
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    EXPECT_EQ(before, after) << "each as it was, its first vertex and its turn kept";
  }
}

TEST(DrawingOrder, NothingAndWhatHasNoSizeAreFine)
{
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(inDrawingOrder(nothing)->GetNumberOfCells(), 0);
  const auto mesh = shuffledGrid(2, 1);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    mesh->GetPoints()->SetPoint(p, 1e300, -1e300, 3);
  }
  mesh->GetPoints()->Modified();
  EXPECT_EQ(polygonsOf(inDrawingOrder(mesh)), polygonsOf(mesh->GetPolys()));
  mesh->GetPoints()->SetPoint(0, -1e308, 1e308, 1e308); // doubles have no room for its size
  mesh->GetPoints()->SetPoint(1, 1e308, -1e308, -1e308);
  mesh->GetPoints()->Modified();
  EXPECT_EQ(inDrawingOrder(mesh)->GetNumberOfCells(), mesh->GetNumberOfPolys());
}
}
