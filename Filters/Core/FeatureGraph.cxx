// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGraph.h"

#include "AtlasSurface.h"
#include "RegionArrays.h"
#include "UserArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>

namespace stipple
{
namespace
{
template <typename ArrayT>
vtkNew<ArrayT> namedArray(const char* name, int components = 1)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}
}

std::vector<int> FeatureGraph::nodes() const
{
  std::vector<int> result;
  for (const Backbone& b : this->backbones)
  {
    if (!b.closed)
    {
      result.push_back(b.points.front());
      result.push_back(b.points.back());
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

vtkSmartPointer<vtkPolyData> toPolyData(
  const FeatureGraph& graph, const std::vector<Vec3>& surfacePoints)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto surfacePointId = namedArray<vtkIdTypeArray>("SurfacePointId");
  auto isCorner = namedArray<vtkIntArray>("IsCorner");
  auto chartId = namedArray<vtkIntArray>("ChartId");
  auto chartCellId = namedArray<vtkIdTypeArray>("ChartCellId");
  auto bary = namedArray<vtkDoubleArray>("BarycentricCoordinates", 3);
  auto type = namedArray<vtkIntArray>("BackboneType");
  auto keep = namedArray<vtkIntArray>("Keep");
  auto closed = namedArray<vtkIntArray>("Closed");
  auto width = namedArray<vtkDoubleArray>("Width");
  auto pitch = namedArray<vtkDoubleArray>("Pitch");

  vtkNew<vtkCellArray> verts;
  for (const ConstraintPoint& c : graph.constraints)
  {
    const vtkIdType id = points->InsertNextPoint(c.position.data());
    verts->InsertNextCell(1, &id);
    surfacePointId->InsertNextValue(-1);
    isCorner->InsertNextValue(0);
    chartId->InsertNextValue(c.chart);
    chartCellId->InsertNextValue(c.chartCell);
    bary->InsertNextTuple(c.bary.data());
    type->InsertNextValue(static_cast<int>(BackboneType::Constraint));
    keep->InsertNextValue(static_cast<int>(c.keep));
    closed->InsertNextValue(0);
    width->InsertNextValue(0.);
    pitch->InsertNextValue(0.);
  }
  std::map<int, vtkIdType> pointOf;
  vtkNew<vtkCellArray> lines;
  const double none[3] = { 0, 0, 0 };
  for (const Backbone& b : graph.backbones)
  {
    std::vector<vtkIdType> ids;
    for (int p : b.points)
    {
      auto [slot, fresh] = pointOf.try_emplace(p, points->GetNumberOfPoints());
      if (fresh)
      {
        points->InsertNextPoint(surfacePoints[p].data());
        surfacePointId->InsertNextValue(p);
        isCorner->InsertNextValue(
          p < static_cast<int>(graph.isCorner.size()) && graph.isCorner[p] ? 1 : 0);
        chartId->InsertNextValue(-1);
        chartCellId->InsertNextValue(-1);
        bary->InsertNextTuple(none);
      }
      ids.push_back(slot->second);
    }
    if (b.closed)
    {
      ids.push_back(ids.front());
    }
    lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    type->InsertNextValue(static_cast<int>(b.type));
    keep->InsertNextValue(static_cast<int>(b.keep));
    closed->InsertNextValue(b.closed ? 1 : 0);
    width->InsertNextValue(b.width);
    pitch->InsertNextValue(b.pitch);
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(points);
  output->SetVerts(verts);
  output->SetLines(lines);
  output->GetPointData()->AddArray(surfacePointId);
  output->GetPointData()->AddArray(isCorner);
  output->GetPointData()->AddArray(chartId);
  output->GetPointData()->AddArray(chartCellId);
  output->GetPointData()->AddArray(bary);
  output->GetCellData()->AddArray(type);
  output->GetCellData()->AddArray(keep);
  output->GetCellData()->AddArray(closed);
  output->GetCellData()->AddArray(width);
  output->GetCellData()->AddArray(pitch);
  if (!graph.regionArray.empty())
  {
    setRegionArrayName(output, graph.regionArray);
  }
  return output;
}

namespace
{
const char* const GraphRemedy = "pass output port 1 of vtkConformalAtlas";

/// What is to be kept of a cell.
Status readKeep(vtkDataArray* keeps, vtkIdType cell, const std::string& name, Keep& keep)
{
  constexpr int Keeps = static_cast<int>(Keep::Edges) + 1;
  const int kept = indexBelow(keeps->GetComponent(cell, 0), Keeps);
  if (kept < 0)
  {
    return badId(keeps, cell, name, Keeps);
  }
  keep = static_cast<Keep>(kept);
  return Status::success();
}

/// Reads the vertex cells.
Status readConstraints(
  vtkPolyData* data, vtkDataArray* keeps, const AtlasSurface& surface, FeatureGraph& graph)
{
  const std::string owner = "The feature graph, which has constraint points,";
  const vtkIdType n = data->GetNumberOfPoints();
  vtkDataArray* chartId = nullptr;
  vtkDataArray* chartCellId = nullptr;
  vtkDataArray* bary = nullptr;
  for (const Status& status :
    { findArray(data->GetPointData(), "ChartId", 1, n, owner, GraphRemedy, chartId),
      findArray(data->GetPointData(), "ChartCellId", 1, n, owner, GraphRemedy, chartCellId),
      findArray(data->GetPointData(), "BarycentricCoordinates", 3, n, owner, GraphRemedy, bary) })
  {
    if (!status.ok())
    {
      return status;
    }
  }
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < data->GetNumberOfVerts(); ++i)
  {
    data->GetVerts()->GetCellAtId(i, size, ids);
    const std::string name = "constraint " + std::to_string(i) + " of the feature graph";
    if (size < 1)
    {
      return Status::error("There is no point in " + name + ": " + GraphRemedy + ".");
    }
    ConstraintPoint c;
    data->GetPoint(ids[0], c.position.data());
    c.chart = indexBelow(chartId->GetComponent(ids[0], 0), surface.numberOfCharts());
    if (c.chart < 0)
    {
      return badId(chartId, ids[0], name, surface.numberOfCharts());
    }
    const int cells = surface.faces(Chart(c.chart)).size();
    c.chartCell = indexBelow(chartCellId->GetComponent(ids[0], 0), cells);
    if (c.chartCell < 0)
    {
      return badId(chartCellId, ids[0], name, cells);
    }
    bary->GetTuple(ids[0], c.bary.data());
    if (!isBarycentric(c.bary))
    {
      return Status::error("The BarycentricCoordinates of " + name +
        " are no numbers from 0 that sum to 1: " + GraphRemedy + ".");
    }
    if (Status status = readKeep(keeps, i, name, c.keep); !status.ok())
    {
      return status;
    }
    graph.constraints.push_back(c);
  }
  return Status::success();
}
}

Status readFeatureGraph(vtkPolyData* lines, const AtlasSurface& surface, FeatureGraph& graph)
{
  graph = {};
  if (!lines || lines->GetNumberOfCells() == 0)
  {
    return Status::success();
  }
  const std::string owner = "The feature graph";
  const vtkIdType numberOfPoints = lines->GetNumberOfPoints();
  const vtkIdType numberOfCells = lines->GetNumberOfCells();
  vtkDataArray* surfacePointId = nullptr;
  vtkDataArray* isCorner = nullptr;
  vtkDataArray* type = nullptr;
  vtkDataArray* closed = nullptr;
  vtkDataArray* keep = nullptr;
  vtkDataArray* width = nullptr;
  vtkDataArray* pitch = nullptr;
  for (const Status& status :
    { findArray(lines->GetPointData(), "SurfacePointId", 1, numberOfPoints, owner, GraphRemedy,
        surfacePointId),
      findArray(lines->GetPointData(), "IsCorner", 1, numberOfPoints, owner, GraphRemedy, isCorner),
      findArray(lines->GetCellData(), "BackboneType", 1, numberOfCells, owner, GraphRemedy, type),
      findArray(lines->GetCellData(), "Closed", 1, numberOfCells, owner, GraphRemedy, closed),
      findArray(lines->GetCellData(), "Keep", 1, numberOfCells, owner, GraphRemedy, keep),
      lines->GetCellData()->HasArray("Width")
        ? findArray(lines->GetCellData(), "Width", 1, numberOfCells, owner, GraphRemedy, width)
        : Status::success(),
      lines->GetCellData()->HasArray("Pitch")
        ? findArray(lines->GetCellData(), "Pitch", 1, numberOfCells, owner, GraphRemedy, pitch)
        : Status::success(),
      checkCells(lines->GetVerts(), numberOfPoints, "the feature graph's constraints"),
      checkCells(lines->GetLines(), numberOfPoints, "the feature graph") })
  {
    if (!status.ok())
    {
      return status;
    }
  }
  if (Status status = readConstraints(lines, keep, surface, graph); !status.ok())
  {
    return status;
  }
  graph.isCorner.assign(surface.points.size(), 0);
  vtkIdType n;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    const std::string name = "backbone " + std::to_string(i) + " of the feature graph";
    const vtkIdType cell = lines->GetNumberOfVerts() + i;
    lines->GetLines()->GetCellAtId(i, n, ids);
    Backbone b;
    const int kind = indexBelow(type->GetComponent(cell, 0), 3);
    if (kind < 0)
    {
      return badId(type, cell, name, 3);
    }
    b.type = static_cast<BackboneType>(kind);
    if (Status status = readKeep(keep, cell, name, b.keep); !status.ok())
    {
      return status;
    }
    b.closed = closed->GetComponent(cell, 0) != 0;
    b.width = width ? width->GetComponent(cell, 0) : 0.;
    b.pitch = pitch ? pitch->GetComponent(cell, 0) : 0.;
    for (const auto& [length, what] : { std::pair(b.width, "Width"), std::pair(b.pitch, "Pitch") })
    {
      if (!(length >= 0))
      {
        return Status::error(
          "The " + std::string(what) + " of " + name + " is no length: " + GraphRemedy + ".");
      }
    }
    if (n < (b.closed ? 3 : 2))
    {
      return Status::error(
        "The " + name + " has " + std::to_string(n) + " points: " + GraphRemedy + ".");
    }
    for (vtkIdType k = 0; k < (b.closed ? n - 1 : n); ++k)
    {
      const int p = indexBelow(surfacePointId->GetComponent(ids[k], 0), surface.numberOfVertices());
      if (p < 0)
      {
        return badId(surfacePointId, ids[k], name, surface.numberOfVertices());
      }
      b.points.push_back(p);
      graph.isCorner[p] = isCorner->GetComponent(ids[k], 0) != 0;
    }
    graph.backbones.push_back(std::move(b));
  }
  graph.regionArray = regionArrayName(lines);
  return Status::success();
}
}
