// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Two made-up charts that keep the contract of vtkConformalAtlas and share a seam, for tests of the
// stages behind it.
#ifndef SyntheticCharts_h
#define SyntheticCharts_h

#include "SyntheticMapChart.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace synthetic
{
template <typename Array>
vtkSmartPointer<Array> makeArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// Chart 0 is the sheet, chart 1 its mirror image behind the sheet's far edge, which is the seam.
inline vtkSmartPointer<vtkPolyData> makeChart(
  int index, int n, int m, double width, double height, double jitter = 0.3)
{
  const Sheet sheet = makeSheet(n, m, width, height, jitter, index + 1);
  const auto numberOfPoints = static_cast<vtkIdType>(sheet.points.size());
  const auto numberOfCells = static_cast<vtkIdType>(sheet.chart.triangles.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto uv = makeArray<vtkDoubleArray>("UV", 2, numberOfPoints);
  const auto id = makeArray<vtkIdTypeArray>("SurfacePointId", 1, numberOfPoints);
  const auto mean = makeArray<vtkDoubleArray>("MeanCurvature", 1, numberOfPoints);
  const auto gaussian = makeArray<vtkDoubleArray>("GaussianCurvature", 1, numberOfPoints);
  const auto heat = makeArray<vtkFloatArray>("Heat", 1, numberOfPoints);
  const auto quad = makeArray<vtkDoubleArray>("Quad", 4, numberOfPoints);
  for (vtkIdType p = 0; p < numberOfPoints; ++p)
  {
    const stipple::Vec2& q = sheet.chart.uv[p];
    const double s = q.x() / width;
    const double t = q.y() / height;
    const stipple::Vec3 x = index == 0 ? sheetPoint(s, t) : sheetPoint(1. - s, t);
    points->InsertNextPoint(index == 0 ? x.x() : 4. - x.x(), x.y(), x.z());
    uv->SetTuple2(p, q.x(), q.y());
    const vtkIdType i = p % (n + 1);
    const vtkIdType j = p / (n + 1);
    // Points of chart 1 follow those of chart 0, but for the seam's, which are those of its last
    // column.
    id->SetValue(p, index == 0 ? p : (i == 0 ? j * (n + 1) + n : numberOfPoints + j * n + i - 1));
    mean->SetValue(p, 2. * std::sin(5. * s) + t);
    gaussian->SetValue(p, 3. * std::cos(4. * t) * s - 1.);
    heat->SetValue(p, static_cast<float>(10. * s + t));
    quad->SetTuple4(p, s, t, s * t, 1.);
  }
  vtkNew<vtkCellArray> cells;
  const auto source = makeArray<vtkIdTypeArray>("SourceCellId", 1, numberOfCells);
  const auto distortion = makeArray<vtkDoubleArray>("AreaDistortion", 1, numberOfCells);
  const auto region = makeArray<vtkIntArray>("Region", 1, numberOfCells);
  for (vtkIdType f = 0; f < numberOfCells; ++f)
  {
    const auto& t = sheet.chart.triangles[f];
    const vtkIdType corners[3] = { t[0], t[1], t[2] };
    cells->InsertNextCell(3, corners);
    source->SetValue(f, index * 100000 + f);
    stipple::Vec3 x[3];
    for (int k = 0; k < 3; ++k)
    {
      points->GetPoint(corners[k], x[k].data());
    }
    distortion->SetValue(f,
      2. * stipple::triangleArea(x[0], x[1], x[2]) /
        stipple::orient2(sheet.chart.uv[t[0]], sheet.chart.uv[t[1]], sheet.chart.uv[t[2]]));
    region->SetValue(f, static_cast<int>(f % 7));
  }
  auto chart = vtkSmartPointer<vtkPolyData>::New();
  chart->SetPoints(points);
  chart->SetPolys(cells);
  chart->GetPointData()->SetTCoords(uv);
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(id), static_cast<vtkDataArray*>(mean),
         static_cast<vtkDataArray*>(gaussian), static_cast<vtkDataArray*>(heat),
         static_cast<vtkDataArray*>(quad) })
  {
    chart->GetPointData()->AddArray(array);
  }
  chart->GetCellData()->AddArray(source);
  chart->GetCellData()->AddArray(distortion);
  chart->GetCellData()->AddArray(region);
  const auto extent = makeArray<vtkDoubleArray>("ChartExtent", 2, 1);
  extent->SetTuple2(0, width, height);
  chart->GetFieldData()->AddArray(extent);
  return chart;
}

inline vtkSmartPointer<vtkPartitionedDataSetCollection> makeAtlas(
  int n = 40, int m = 30, double jitter = 0.3)
{
  auto atlas = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  atlas->SetPartition(0, 0, makeChart(0, n, m, 1., 0.6, jitter));
  atlas->SetPartition(1, 0, makeChart(1, n, m, 0.5, 1., jitter));
  return atlas;
}
} // namespace synthetic

#endif
