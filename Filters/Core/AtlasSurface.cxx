// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AtlasSurface.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace stipple
{
double AtlasSurface::areaDistortion(int face) const
{
  const double plane = 0.5 *
    std::abs(orient2(this->cornerUV(face, 0), this->cornerUV(face, 1), this->cornerUV(face, 2)));
  return plane > 0 ? this->faceArea(face) / plane : 0.;
}

vtkPolyData* chartOf(vtkPartitionedDataSetCollection* charts, unsigned int c)
{
  vtkPartitionedDataSet* set = charts->GetPartitionedDataSet(c);
  return set && set->GetNumberOfPartitions() > 0
    ? vtkPolyData::SafeDownCast(set->GetPartitionAsDataObject(0))
    : nullptr;
}

Status readAtlas(vtkPartitionedDataSetCollection* charts, AtlasSurface& s)
{
  s = {};
  s.chartBegin.push_back(0);
  const unsigned int n = charts ? charts->GetNumberOfPartitionedDataSets() : 0;
  for (unsigned int c = 0; c < n; ++c)
  {
    vtkPolyData* chart = chartOf(charts, c);
    vtkDataArray* uv = chart ? chart->GetPointData()->GetArray("UV") : nullptr;
    vtkDataArray* ids = chart ? chart->GetPointData()->GetArray("SurfacePointId") : nullptr;
    vtkDataArray* source = chart ? chart->GetCellData()->GetArray("SourceCellId") : nullptr;
    vtkDataArray* extent = chart ? chart->GetFieldData()->GetArray("ChartExtent") : nullptr;
    if (!uv || !ids || !source || !extent)
    {
      return Status::error("Chart " + std::to_string(c) +
        " is no vtkPolyData with the arrays UV, SurfacePointId, SourceCellId and ChartExtent: pass "
        "output "
        "port 0 of vtkConformalAtlas.");
    }
    const vtkIdType numberOfPoints = chart->GetNumberOfPoints();
    std::vector<int> surfaceId(numberOfPoints);
    for (vtkIdType p = 0; p < numberOfPoints; ++p)
    {
      const int id = static_cast<int>(ids->GetComponent(p, 0));
      surfaceId[p] = id;
      if (id >= static_cast<int>(s.points.size()))
      {
        s.points.resize(id + 1, Vec3::Zero());
      }
      chart->GetPoint(p, s.points[id].data());
    }
    vtkCellArray* cells = chart->GetPolys();
    for (vtkIdType f = 0; f < cells->GetNumberOfCells(); ++f)
    {
      vtkIdType size;
      const vtkIdType* corner;
      cells->GetCellAtId(f, size, corner);
      if (size != 3)
      {
        return Status::error("Cell " + std::to_string(f) + " of chart " + std::to_string(c) +
          " is no triangle: pass output port 0 of vtkConformalAtlas.");
      }
      Triangle triangle;
      Triangle local;
      for (int k = 0; k < 3; ++k)
      {
        local[k] = static_cast<int>(corner[k]);
        triangle[k] = surfaceId[corner[k]];
        Vec2 p;
        uv->GetTuple(corner[k], p.data());
        s.uv.push_back(p);
      }
      s.triangles.push_back(triangle);
      s.chartPoints.push_back(local);
      s.faceChart.push_back(static_cast<int>(c));
      s.sourceCell.push_back(static_cast<int>(source->GetComponent(f, 0)));
    }
    s.chartBegin.push_back(s.numberOfFaces());
    s.extent.emplace_back(extent->GetComponent(0, 0), extent->GetComponent(0, 1));
    s.charts.push_back(chart);
  }
  s.connect();
  return Status::success();
}
}
