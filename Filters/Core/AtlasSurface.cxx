// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AtlasSurface.h"

#include "UserArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace stipple
{
double AtlasSurface::areaDistortion(Face face) const
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

namespace
{
const char* const ChartsRemedy = "pass output port 0 of vtkConformalAtlas";

/// Reads one chart after the other.
class ChartReader
{
public:
  ChartReader(AtlasSurface& surface, const Stop& stop)
    : S(surface)
    , WantsStop(stop)
  {
  }

  /// Makes room for all charts.
  Status prepare(vtkPartitionedDataSetCollection* charts)
  {
    const unsigned int n = charts ? charts->GetNumberOfPartitionedDataSets() : 0;
    vtkIdType points = 0;
    vtkIdType triangles = 0;
    for (unsigned int c = 0; c < n; ++c)
    {
      vtkPolyData* chart = chartOf(charts, c);
      if (!chart)
      {
        return Status::error(
          "Chart " + std::to_string(c) + " is no vtkPolyData: " + ChartsRemedy + ".");
      }
      points += chart->GetNumberOfPoints();
      triangles += chart->GetNumberOfPolys();
      this->S.charts.emplace_back(chart);
    }
    int numberOfPoints = 0;
    int numberOfTriangles = 0;
    if (Status status = checkedCount(points, "points of charts", numberOfPoints); !status.ok())
    {
      return status;
    }
    if (Status status = checkedCount(triangles, "triangles of charts", numberOfTriangles);
        !status.ok())
    {
      return status;
    }
    // Without some of its charts, an atlas has ids beyond the number of points that are left; but
    // an array that no sane id needs is not made.
    constexpr int Always = 1000000;
    constexpr double MostTimes = 100;
    this->IdLimit = static_cast<int>(
      std::clamp<double>(MostTimes * numberOfPoints, Always, MaximumNumberOfElements));
    this->S.points.reserve(numberOfPoints);
    this->S.triangles.reserve(numberOfTriangles);
    this->S.chartPoints.reserve(numberOfTriangles);
    this->S.faceChart.reserve(numberOfTriangles);
    this->S.sourceCell.reserve(numberOfTriangles);
    this->S.uv.reserve(3 * static_cast<std::size_t>(numberOfTriangles));
    return Status::success();
  }

  Status read(Chart c)
  {
    vtkPolyData* chart = this->S.charts[c.index()];
    const std::string owner = "Chart " + std::to_string(c.index());
    const vtkIdType numberOfPoints = chart->GetNumberOfPoints();
    vtkDataArray* uv = nullptr;
    vtkDataArray* ids = nullptr;
    vtkDataArray* source = nullptr;
    vtkDataArray* extent = nullptr;
    for (const Status& status :
      { findArray(chart->GetPointData(), "UV", 2, numberOfPoints, owner, ChartsRemedy, uv),
        findArray(
          chart->GetPointData(), "SurfacePointId", 1, numberOfPoints, owner, ChartsRemedy, ids),
        findArray(chart->GetCellData(), "SourceCellId", 1, chart->GetNumberOfCells(), owner,
          ChartsRemedy, source),
        findArray(chart->GetFieldData(), "ChartExtent", 2, 1, owner, ChartsRemedy, extent),
        checkCells(chart->GetPolys(), numberOfPoints, "chart " + std::to_string(c.index())) })
    {
      if (!status.ok())
      {
        return status;
      }
    }
    const Vec2 size(extent->GetComponent(0, 0), extent->GetComponent(0, 1));
    if (!(size.x() > 0.) || !(size.y() > 0.) || !size.allFinite())
    {
      return Status::error("The ChartExtent of chart " + std::to_string(c.index()) +
        " is not positive: " + ChartsRemedy + ".");
    }
    this->S.extent.push_back(size);
    if (Status status = this->S.flatFaces.read(chart->GetFieldData(), owner); !status.ok())
    {
      return status;
    }
    if (Status status = this->readPoints(chart, ids, uv, c); !status.ok())
    {
      return status;
    }
    return this->readTriangles(chart, source, c);
  }

private:
  static std::string nameOf(const char* element, vtkIdType i, Chart c)
  {
    return element + std::to_string(i) + " of chart " + std::to_string(c.index());
  }

  Status readPoints(vtkPolyData* chart, vtkDataArray* ids, vtkDataArray* uv, Chart c)
  {
    const vtkIdType n = chart->GetNumberOfPoints();
    this->SurfaceId.resize(n);
    this->Parameter.resize(n);
    for (vtkIdType p = 0; p < n; ++p)
    {
      const int id = indexBelow(ids->GetComponent(p, 0), this->IdLimit);
      if (id < 0)
      {
        return badId(ids, p, nameOf("point ", p, c), this->IdLimit);
      }
      if (id >= this->S.numberOfVertices())
      {
        this->S.points.resize(id + 1, Vec3::Zero());
      }
      chart->GetPoint(p, this->S.points[id].data());
      uv->GetTuple(p, this->Parameter[p].data());
      if (!this->S.points[id].allFinite() || !this->Parameter[p].allFinite())
      {
        return Status::error("The position or UV of " + nameOf("point ", p, c) +
          " is not finite: " + ChartsRemedy + ".");
      }
      this->SurfaceId[p] = id;
    }
    return Status::success();
  }

  Status readTriangles(vtkPolyData* chart, vtkDataArray* source, Chart c)
  {
    vtkCellArray* cells = chart->GetPolys();
    const vtkIdType before = chart->GetNumberOfVerts() + chart->GetNumberOfLines();
    vtkIdType size;
    const vtkIdType* corner;
    for (vtkIdType f = 0; f < cells->GetNumberOfCells(); ++f)
    {
      if (isTimeToAsk(static_cast<std::size_t>(f)) && isAsked(this->WantsStop))
      {
        return Status::aborted();
      }
      cells->GetCellAtId(f, size, corner);
      if (size != 3)
      {
        return Status::error(nameOf("Cell ", f, c) + " is no triangle: " + ChartsRemedy + ".");
      }
      const int cell = indexBelow(source->GetComponent(before + f, 0), VTK_INT_MAX);
      if (cell < 0)
      {
        return badId(source, before + f, nameOf("cell ", f, c), VTK_INT_MAX);
      }
      Triangle triangle;
      Triangle local;
      for (int k = 0; k < 3; ++k)
      {
        local[k] = static_cast<int>(corner[k]);
        triangle[k] = this->SurfaceId[corner[k]];
        this->S.uv.push_back(this->Parameter[corner[k]]);
      }
      this->S.triangles.push_back(triangle);
      this->S.chartPoints.push_back(local);
      this->S.faceChart.push_back(c);
      this->S.sourceCell.push_back(cell);
    }
    this->S.chartBegin.push_back(this->S.numberOfFaces());
    return Status::success();
  }

  AtlasSurface& S;
  const Stop& WantsStop;
  int IdLimit = 0;
  std::vector<int> SurfaceId; // by point of the chart
  std::vector<Vec2> Parameter;
};
}

Status readAtlas(vtkPartitionedDataSetCollection* charts, AtlasSurface& surface, const Stop& stop)
{
  surface = {};
  surface.chartBegin.push_back(0);
  ChartReader reader(surface, stop);
  Status status = reader.prepare(charts);
  for (int c = 0; status.ok() && c < static_cast<int>(surface.charts.size()); ++c)
  {
    status = reader.read(Chart(c));
  }
  if (!status.ok())
  {
    surface = {};
    return status;
  }
  surface.points.shrink_to_fit();
  surface.connect();
  return isAsked(stop) ? Status::aborted() : Status::success();
}
}
