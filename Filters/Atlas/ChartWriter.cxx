// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartWriter.h"

#include "AtlasConstants.h"
#include "CellLocator.h"
#include "PolyDataConversion.h"
#include "SurfaceArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
/// A point quantity of the repaired surface, extended to inserted points.
std::vector<double> atAllPoints(std::vector<double> values, const CutSurface& surface)
{
  for (const CutSurface::EdgePoint& e : surface.inserted)
  {
    values.push_back((1 - e.t) * values[e.a] + e.t * values[e.b]);
  }
  return values;
}

/// Makes arrays active for what they are active for in the input, texture coordinates aside: a
/// chart's are its parameters.
void activate(vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
  {
    vtkAbstractArray* active = from->GetAbstractAttribute(attribute);
    if (active && active->GetName() && !isReservedArrayName(active->GetName()) &&
      attribute != vtkDataSetAttributes::TCOORDS)
    {
      to->SetActiveAttribute(active->GetName(), attribute);
    }
  }
}

template <typename ArrayT>
vtkNew<ArrayT> addArray(vtkFieldData* data, const char* name, int components, vtkIdType tuples)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  data->AddArray(array);
  return array;
}
}

Status writeCharts(vtkPolyData* input, const RepairedSurface& repaired, const CutSurface& surface,
  const std::vector<FlatChart>& flat, const Curvature& curvature, const FlatFaceCells& flatFaces,
  vtkPartitionedDataSetCollection* output, const Progress& progress)
{
  const auto arrays = pointArrays(input, repaired, surface);
  const std::vector<double> gaussian = atAllPoints(curvature.gaussian, surface);
  const std::vector<double> mean = atAllPoints(curvature.mean, surface);
  output->SetNumberOfPartitionedDataSets(static_cast<unsigned int>(flat.size()));
  for (std::size_t c = 0; c < flat.size(); ++c)
  {
    if (!report(progress, static_cast<double>(c) / static_cast<double>(flat.size())))
    {
      return Status::aborted();
    }
    const ChartMesh& mesh = flat[c].mesh;
    const ConformalMap& map = flat[c].map;
    const vtkIdType n = mesh.numberOfVertices();
    std::vector<Vec3> points(n);
    for (vtkIdType v = 0; v < n; ++v)
    {
      points[v] = surface.points[mesh.vertices[v]];
    }
    const vtkSmartPointer<vtkPolyData> chart = toPolyData(points, mesh.triangles);
    vtkPointData* pointData = chart->GetPointData();
    vtkCellData* cellData = chart->GetCellData();

    vtkNew<vtkIdList> pointIds;
    pointIds->SetNumberOfIds(n);
    for (vtkIdType v = 0; v < n; ++v)
    {
      pointIds->SetId(v, mesh.vertices[v]);
    }
    for (const auto& array : arrays)
    {
      auto part = emptyLike(array);
      part->SetNumberOfTuples(n);
      array->GetTuples(pointIds, part);
      pointData->AddArray(part);
    }
    auto uv = addArray<vtkDoubleArray>(pointData, "UV", 2, n);
    auto surfacePointId = addArray<vtkIdTypeArray>(pointData, "SurfacePointId", 1, n);
    auto gaussianCurvature = addArray<vtkDoubleArray>(pointData, "GaussianCurvature", 1, n);
    auto meanCurvature = addArray<vtkDoubleArray>(pointData, "MeanCurvature", 1, n);
    for (vtkIdType v = 0; v < n; ++v)
    {
      uv->SetTuple(v, map.uv[v].data());
      surfacePointId->SetValue(v, mesh.vertices[v]);
      gaussianCurvature->SetValue(v, gaussian[mesh.vertices[v]]);
      meanCurvature->SetValue(v, mean[mesh.vertices[v]]);
    }
    activate(input->GetPointData(), pointData);
    pointData->SetActiveTCoords("UV");

    const vtkIdType cells = static_cast<vtkIdType>(mesh.faces.size());
    vtkNew<vtkIdList> cellIds;
    cellIds->SetNumberOfIds(cells);
    auto sourceCellId = addArray<vtkIdTypeArray>(cellData, "SourceCellId", 1, cells);
    auto distortion = addArray<vtkDoubleArray>(cellData, "AreaDistortion", 1, cells);
    std::set<int> sources;
    for (vtkIdType f = 0; f < cells; ++f)
    {
      const Triangle& t = mesh.triangles[f];
      const int source = surface.sourceCell[mesh.faces[f].index()];
      cellIds->SetId(f, source);
      sourceCellId->SetValue(f, source);
      if (!flatFaces.empty())
      {
        sources.insert(source);
      }
      const double plane = 0.5 * orient2(map.uv[t[0]], map.uv[t[1]], map.uv[t[2]]);
      distortion->SetValue(f, map.area[f] / plane);
    }
    for (vtkAbstractArray* source : usersArrays(input->GetCellData()))
    {
      auto part = emptyLike(source);
      part->SetNumberOfTuples(cells);
      source->GetTuples(cellIds, part);
      cellData->AddArray(part);
    }
    activate(input->GetCellData(), cellData);
    auto extent = addArray<vtkDoubleArray>(chart->GetFieldData(), "ChartExtent", 2, 1);
    extent->SetTuple(0, map.extent.data());
    flatFaces.write(sources, chart->GetFieldData());
    auto ratio = addArray<vtkDoubleArray>(chart->GetFieldData(), "DensityRatio", 1, 1);
    ratio->SetValue(0, map.densityRatio);

    vtkNew<vtkPartitionedDataSet> set;
    set->SetNumberOfPartitions(1);
    set->SetPartition(0, chart);
    output->SetPartitionedDataSet(static_cast<unsigned int>(c), set);
  }
  return Status::success();
}

std::set<int> nearestCells(const RepairedSurface& repaired, vtkPoints* points)
{
  std::set<int> cells;
  const CellLocator locator(repaired.surface.points, repaired.surface.triangles);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vec3 x;
    points->GetPoint(i, x.data());
    if (x.allFinite()) // locateConstraints() tells what is not
    {
      cells.insert(repaired.sourceCell[static_cast<int>(locator.nearest(x).cell)]);
    }
  }
  return cells;
}

Status locateConstraints(const CutSurface& surface, const std::vector<FlatChart>& flat,
  vtkPoints* points, std::vector<ConstraintPoint>& constraints)
{
  ElementArray<Face, int> chartOf(surface.triangles.size());
  ElementArray<Face, int> cellOf(surface.triangles.size());
  for (std::size_t c = 0; c < flat.size(); ++c)
  {
    for (std::size_t i = 0; i < flat[c].mesh.faces.size(); ++i)
    {
      chartOf[flat[c].mesh.faces[i]] = static_cast<int>(c);
      cellOf[flat[c].mesh.faces[i]] = static_cast<int>(i);
    }
  }
  const CellLocator locator(surface.points, surface.triangles);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    ConstraintPoint c;
    Vec3 x;
    points->GetPoint(i, x.data());
    if (!x.allFinite())
    {
      return Status::error(
        "Constraint " + std::to_string(i) + " has a coordinate that is not a finite number.");
    }
    const CellLocator::Place nearest = locator.nearest(x);
    const Face f(static_cast<int>(nearest.cell));
    c.position = nearest.position;
    c.bary = clampedBarycentric(barycentricInSpace(
      c.position, surface.point(f, 0), surface.point(f, 1), surface.point(f, 2)));
    c.chart = chartOf[f];
    c.chartCell = cellOf[f];
    constraints.push_back(c);
  }
  return Status::success();
}

Status locateChartConstraints(const CutSurface& surface, const std::vector<FlatChart>& flat,
  vtkDoubleArray* places, std::vector<ConstraintPoint>& constraints)
{
  if (places->GetNumberOfComponents() != 3)
  {
    return Status::error("Chart constraints need three components, chart, u and v, not " +
      std::to_string(places->GetNumberOfComponents()) + ".");
  }
  for (vtkIdType i = 0; i < places->GetNumberOfTuples(); ++i)
  {
    const double chart = places->GetTypedComponent(i, 0);
    const Vec2 p(places->GetTypedComponent(i, 1), places->GetTypedComponent(i, 2));
    // The triangle that has the place most inside.
    ConstraintPoint best;
    double mostInside = -std::numeric_limits<double>::infinity();
    if (chart >= 0 && chart < static_cast<double>(flat.size()))
    {
      best.chart = static_cast<int>(chart);
      const ChartMesh& mesh = flat[best.chart].mesh;
      const std::vector<Vec2>& uv = flat[best.chart].map.uv;
      for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
      {
        const Triangle& t = mesh.triangles[f];
        const Vec3 bary = barycentric(p, uv[t[0]], uv[t[1]], uv[t[2]]);
        if (bary.minCoeff() > mostInside)
        {
          mostInside = bary.minCoeff();
          best.bary = bary;
          best.chartCell = static_cast<int>(f);
        }
      }
    }
    if (!(mostInside > -Constants::OutsideOfChart))
    {
      return Status::error("Chart constraint " + std::to_string(i) + ", u " +
        std::to_string(p.x()) + ", v " + std::to_string(p.y()) + ", is not in a chart " +
        std::to_string(chart) + "; there are " + std::to_string(flat.size()) + " charts.");
    }
    best.bary = clampedBarycentric(best.bary);
    best.position = surface.position(flat[best.chart].mesh.faces[best.chartCell], best.bary);
    constraints.push_back(best);
  }
  return Status::success();
}

void constrainPoints(const CutSurface& surface, const std::vector<FlatChart>& flat,
  const std::vector<int>& points, std::vector<ConstraintPoint>& constraints)
{
  if (points.empty())
  {
    return;
  }
  std::vector<char> wanted(surface.points.size(), 0);
  for (int p : points)
  {
    wanted[p] = 1;
  }
  for (std::size_t c = 0; c < flat.size(); ++c)
  {
    const ChartMesh& mesh = flat[c].mesh;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int p = mesh.vertices[mesh.triangles[i][k]];
        if (wanted[p])
        {
          wanted[p] = 0;
          constraints.push_back({ surface.points[p], static_cast<int>(c), static_cast<int>(i),
            Vec3::Unit(k), Keep::Nothing });
        }
      }
    }
  }
}
}
