// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataConversion.h"

#include "UserArrays.h"

#include "PolygonTriangulation.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace stipple
{
Status readPolyData(vtkPolyData* data, TriangleSurface& surface, std::vector<int>* sourceCell)
{
  const vtkIdType n = data->GetNumberOfPoints();
  const std::string owner = "the input";
  int count = 0;
  for (const Status& status :
    { checkedCount(n, "points", count), checkedCount(data->GetNumberOfPolys(), "polygons", count),
      checkCells(data->GetPolys(), n, owner), checkCells(data->GetStrips(), n, owner) })
  {
    if (!status.ok())
    {
      return status;
    }
  }
  surface = fromPolyData(data, sourceCell);
  return checkedCount(static_cast<vtkIdType>(surface.triangles.size()), "triangles", count);
}

TriangleSurface fromPolyData(vtkPolyData* data, std::vector<int>* sourceCell)
{
  TriangleSurface surface;
  surface.points.resize(data->GetNumberOfPoints());
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    data->GetPoint(p, surface.points[p].data());
  }
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
    surface.triangles.push_back({ static_cast<int>(a), static_cast<int>(b), static_cast<int>(c) });
    if (sourceCell)
    {
      sourceCell->push_back(static_cast<int>(cell));
    }
  };
  vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  vtkIdType size;
  const vtkIdType* ids;
  std::vector<Vec3> polygon;
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i, ++cell)
  {
    data->GetPolys()->GetCellAtId(i, size, ids);
    if (size == 3)
    {
      add(ids[0], ids[1], ids[2], cell);
      continue;
    }
    polygon.clear();
    for (vtkIdType k = 0; k < size; ++k)
    {
      polygon.push_back(surface.points[ids[k]]);
    }
    for (const Triangle& t : triangulatePolygon(polygon))
    {
      add(ids[t[0]], ids[t[1]], ids[t[2]], cell);
    }
  }
  for (vtkIdType i = 0; i < data->GetNumberOfStrips(); ++i, ++cell)
  {
    data->GetStrips()->GetCellAtId(i, size, ids);
    for (vtkIdType k = 2; k < size; ++k)
    {
      add(ids[k - 2], ids[k - 1 + k % 2], ids[k - k % 2], cell);
    }
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> toPolyData(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataTypeToDouble();
  vtkpoints->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    vtkpoints->SetPoint(static_cast<vtkIdType>(p), points[p].data());
  }
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(3 * static_cast<vtkIdType>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      connectivity->SetValue(static_cast<vtkIdType>(3 * t + k), triangles[t][k]);
    }
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, connectivity);
  output->SetPoints(vtkpoints);
  output->SetPolys(cells);
  return output;
}
}
