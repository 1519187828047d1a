// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleSet.h"

#include "Atlas.h"
#include "UserArrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <iterator>

namespace stipple
{
namespace
{
template <typename ArrayT>
vtkNew<ArrayT> pointArray(vtkPolyData* data, const char* name, int components, vtkIdType size)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  data->GetPointData()->AddArray(array);
  return array;
}
}

void addProvenance(vtkPolyData* mesh, const AtlasSurface& surface, const std::vector<int>& face,
  const std::vector<Vec3>& bary)
{
  const vtkIdType n = static_cast<vtkIdType>(face.size());
  auto chartId = pointArray<vtkIntArray>(mesh, "ChartId", 1, n);
  auto chartCellId = pointArray<vtkIdTypeArray>(mesh, "ChartCellId", 1, n);
  auto barycentric = pointArray<vtkDoubleArray>(mesh, "BarycentricCoordinates", 3, n);
  auto uv = pointArray<vtkDoubleArray>(mesh, "UV", 2, n);
  auto source = pointArray<vtkIdTypeArray>(mesh, "SourceCellId", 1, n);
  FlatFaceLocator locator(surface.flatFaces);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const int chart = surface.faceChart[face[i]];
    chartId->SetValue(i, chart);
    chartCellId->SetValue(i, face[i] - surface.chartBegin[chart]);
    barycentric->SetTuple(i, bary[i].data());
    uv->SetTuple(i, surface.parameter(face[i], bary[i]).data());
    source->SetValue(
      i, locator.cellAt(surface.sourceCell[face[i]], surface.position(face[i], bary[i])));
  }
}

vtkSmartPointer<vtkPolyData> toPolyData(
  const std::vector<Sample>& samples, const AtlasSurface& surface)
{
  const vtkIdType n = static_cast<vtkIdType>(samples.size());
  auto output = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  vtkNew<vtkCellArray> verts;
  auto kind = pointArray<vtkIntArray>(output, "SampleKind", 1, n);
  std::vector<int> face(n);
  std::vector<Vec3> bary(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    face[i] = samples[i].face;
    bary[i] = samples[i].bary;
    points->SetPoint(i, surface.position(face[i], bary[i]).data());
    verts->InsertNextCell(1, &i);
    kind->SetValue(i, static_cast<int>(samples[i].kind));
  }
  output->SetPoints(points);
  output->SetVerts(verts);
  addProvenance(output, surface, face, bary);
  auto backbone = pointArray<vtkIntArray>(output, "BackboneId", 1, n);
  auto arcLength = pointArray<vtkDoubleArray>(output, "ArcLength", 1, n);
  auto surfacePoint = pointArray<vtkIdTypeArray>(output, "SurfacePointId", 1, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    backbone->SetValue(i, samples[i].backbone);
    arcLength->SetValue(i, samples[i].arcLength);
    surfacePoint->SetValue(i, samples[i].surfacePoint);
  }
  return output;
}

Status readSamples(vtkPolyData* vertices, const Atlas& atlas, std::vector<Sample>& samples)
{
  samples.clear();
  if (!vertices || vertices->GetNumberOfPoints() == 0)
  {
    return Status::success();
  }
  const std::string owner = "The data set of samples";
  const std::string remedy = "pass output port 0 of vtkErrorDiffusionSampler";
  const vtkIdType n = vertices->GetNumberOfPoints();
  enum Array
  {
    Kind,
    ChartId,
    ChartCell,
    Barycentric,
    BackboneOf,
    ArcLength,
    SurfacePoint
  };
  constexpr const char* Names[] = { "SampleKind", "ChartId", "ChartCellId",
    "BarycentricCoordinates", "BackboneId", "ArcLength", "SurfacePointId" };
  vtkDataArray* array[std::size(Names)];
  for (std::size_t a = 0; a < std::size(Names); ++a)
  {
    if (Status status = findArray(
          vertices->GetPointData(), Names[a], a == Barycentric ? 3 : 1, n, owner, remedy, array[a]);
        !status.ok())
    {
      return status;
    }
  }
  int count = 0;
  if (Status status = checkedCount(n, "samples", count); !status.ok())
  {
    return status;
  }
  const AtlasSurface& surface = atlas.surface();
  const int numberOfBackbones = static_cast<int>(atlas.traces().size());
  samples.resize(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    Sample& s = samples[i];
    const auto index = [&](Array a, int size) {
      return indexBelow(array[a]->GetComponent(i, 0), size);
    };
    const auto bad = [&](Array a, int size) {
      samples.clear();
      return badId(array[a], i, "sample " + std::to_string(i), size);
    };
    const int kind = index(Kind, 4);
    if (kind < 0)
    {
      return bad(Kind, 4);
    }
    s.kind = static_cast<SampleKind>(kind);
    const int chart = index(ChartId, surface.numberOfCharts());
    if (chart < 0)
    {
      return bad(ChartId, surface.numberOfCharts());
    }
    const int cells = surface.faces(Chart(chart)).size();
    const int cell = index(ChartCell, cells);
    if (cell < 0)
    {
      return bad(ChartCell, cells);
    }
    s.face = surface.chartBegin[chart] + cell;
    array[Barycentric]->GetTuple(i, s.bary.data());
    s.backbone = index(BackboneOf, numberOfBackbones);
    if (s.kind == SampleKind::Backbone && s.backbone < 0)
    {
      return bad(BackboneOf, numberOfBackbones);
    }
    s.arcLength = array[ArcLength]->GetComponent(i, 0);
    s.surfacePoint = index(SurfacePoint, surface.numberOfVertices());
    if (s.kind == SampleKind::Corner &&
      (s.surfacePoint < 0 || !atlas.vertexHalfedges()[Vertex(s.surfacePoint)].valid()))
    {
      return bad(SurfacePoint, surface.numberOfVertices());
    }
    if (!isBarycentric(s.bary) || !std::isfinite(s.arcLength))
    {
      samples.clear();
      return Status::error("The BarycentricCoordinates of sample " + std::to_string(i) +
        " are no numbers from 0 that sum to 1, or its ArcLength is not finite: " + remedy + ".");
    }
  }
  return Status::success();
}
}
