// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGraph.h"

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
  auto closed = namedArray<vtkIntArray>("Closed");

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
    closed->InsertNextValue(0);
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
    closed->InsertNextValue(b.closed ? 1 : 0);
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
  output->GetCellData()->AddArray(closed);
  return output;
}

Status readFeatureGraph(vtkPolyData* lines, FeatureGraph& graph)
{
  graph = {};
  if (!lines || lines->GetNumberOfCells() == 0)
  {
    return Status::success();
  }
  vtkDataArray* surfacePointId = lines->GetPointData()->GetArray("SurfacePointId");
  vtkDataArray* isCorner = lines->GetPointData()->GetArray("IsCorner");
  vtkDataArray* type = lines->GetCellData()->GetArray("BackboneType");
  vtkDataArray* closed = lines->GetCellData()->GetArray("Closed");
  if (!surfacePointId || !isCorner || !type || !closed)
  {
    return Status::error("The feature graph lacks one of the arrays SurfacePointId, IsCorner, "
                         "BackboneType, Closed: pass output port 1 of vtkConformalAtlas.");
  }
  const vtkIdType numberOfVerts = lines->GetNumberOfVerts();
  if (numberOfVerts > 0)
  {
    vtkDataArray* chartId = lines->GetPointData()->GetArray("ChartId");
    vtkDataArray* chartCellId = lines->GetPointData()->GetArray("ChartCellId");
    vtkDataArray* bary = lines->GetPointData()->GetArray("BarycentricCoordinates");
    if (!chartId || !chartCellId || !bary)
    {
      return Status::error(
        "The constraint points of the feature graph lack one of the arrays ChartId, "
        "ChartCellId, BarycentricCoordinates: pass output port 1 of vtkConformalAtlas.");
    }
    vtkCellArray* verts = lines->GetVerts();
    for (vtkIdType i = 0; i < verts->GetNumberOfCells(); ++i)
    {
      vtkIdType n;
      const vtkIdType* ids;
      verts->GetCellAtId(i, n, ids);
      ConstraintPoint c;
      lines->GetPoint(ids[0], c.position.data());
      c.chart = static_cast<int>(chartId->GetComponent(ids[0], 0));
      c.chartCell = static_cast<int>(chartCellId->GetComponent(ids[0], 0));
      bary->GetTuple(ids[0], c.bary.data());
      graph.constraints.push_back(c);
    }
  }
  vtkCellArray* cells = lines->GetLines();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType n;
    const vtkIdType* ids;
    cells->GetCellAtId(i, n, ids);
    Backbone b;
    b.type = static_cast<BackboneType>(static_cast<int>(type->GetComponent(numberOfVerts + i, 0)));
    b.closed = closed->GetComponent(numberOfVerts + i, 0) != 0;
    for (vtkIdType k = 0; k < (b.closed ? n - 1 : n); ++k)
    {
      const int p = static_cast<int>(surfacePointId->GetComponent(ids[k], 0));
      b.points.push_back(p);
      if (p >= static_cast<int>(graph.isCorner.size()))
      {
        graph.isCorner.resize(p + 1, 0);
      }
      graph.isCorner[p] = isCorner->GetComponent(ids[k], 0) != 0;
    }
    graph.backbones.push_back(std::move(b));
  }
  return Status::success();
}
}
