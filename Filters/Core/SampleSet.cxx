// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleSet.h"

#include "AtlasSurface.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

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
  for (vtkIdType i = 0; i < n; ++i)
  {
    const int chart = surface.faceChart[face[i]];
    chartId->SetValue(i, chart);
    chartCellId->SetValue(i, face[i] - surface.chartBegin[chart]);
    barycentric->SetTuple(i, bary[i].data());
    uv->SetTuple(i, surface.parameter(face[i], bary[i]).data());
    source->SetValue(i, surface.sourceCell[face[i]]);
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

Status readSamples(vtkPolyData* vertices, const AtlasSurface& surface, std::vector<Sample>& samples)
{
  samples.clear();
  if (!vertices || vertices->GetNumberOfPoints() == 0)
  {
    return Status::success();
  }
  vtkPointData* data = vertices->GetPointData();
  vtkDataArray* kind = data->GetArray("SampleKind");
  vtkDataArray* chartId = data->GetArray("ChartId");
  vtkDataArray* chartCellId = data->GetArray("ChartCellId");
  vtkDataArray* bary = data->GetArray("BarycentricCoordinates");
  vtkDataArray* backbone = data->GetArray("BackboneId");
  vtkDataArray* arcLength = data->GetArray("ArcLength");
  vtkDataArray* surfacePoint = data->GetArray("SurfacePointId");
  if (!kind || !chartId || !chartCellId || !bary || !backbone || !arcLength || !surfacePoint)
  {
    return Status::error(
      "The samples lack one of the arrays SampleKind, ChartId, ChartCellId, "
      "BarycentricCoordinates, "
      "BackboneId, ArcLength, SurfacePointId: pass output port 0 of vtkErrorDiffusionSampler.");
  }
  samples.resize(vertices->GetNumberOfPoints());
  for (vtkIdType i = 0; i < vertices->GetNumberOfPoints(); ++i)
  {
    Sample& s = samples[i];
    s.kind = static_cast<SampleKind>(static_cast<int>(kind->GetComponent(i, 0)));
    const int chart = static_cast<int>(chartId->GetComponent(i, 0));
    if (chart < 0 || chart >= surface.numberOfCharts())
    {
      return Status::error("Sample " + std::to_string(i) + " lies in chart " +
        std::to_string(chart) + ", which these charts do not have.");
    }
    s.face = surface.chartBegin[chart] + static_cast<int>(chartCellId->GetComponent(i, 0));
    if (s.face < surface.chartBegin[chart] || s.face >= surface.chartBegin[chart + 1])
    {
      return Status::error("Sample " + std::to_string(i) + " lies in no triangle of its chart.");
    }
    bary->GetTuple(i, s.bary.data());
    s.backbone = static_cast<int>(backbone->GetComponent(i, 0));
    s.arcLength = arcLength->GetComponent(i, 0);
    s.surfacePoint = static_cast<int>(surfacePoint->GetComponent(i, 0));
  }
  return Status::success();
}
}
