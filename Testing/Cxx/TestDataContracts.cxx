// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What Documentation/Design.md promises of the data between the stages, checked on the output of
// every stage: names, types, number of components and meaning.
#include "Check.h"

#include "vtkCDTRemesh.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkRemeshOptimizer.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCylinderSource.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"
#include "vtkTriangleFilter.h"

#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <string>

namespace
{
using test::check;

vtkDataArray* array(
  vtkFieldData* data, const char* name, int type, int components, vtkIdType tuples)
{
  vtkDataArray* a = data->GetArray(name);
  check(a != nullptr, std::string("there is an array ") + name);
  if (a)
  {
    check(a->GetDataType() == type,
      std::string(name) + " is of type " + vtkImageScalarTypeNameMacro(type));
    check(a->GetNumberOfComponents() == components, std::string(name) + " has its components");
    check(a->GetNumberOfTuples() == tuples, std::string(name) + " has a value everywhere");
  }
  return a;
}

template <typename DataSet>
DataSet* part(vtkPartitionedDataSetCollection* collection, unsigned int i)
{
  vtkPartitionedDataSet* set = collection->GetPartitionedDataSet(i);
  check(set && set->GetNumberOfPartitions() == 1, "one data set a chart");
  return set ? DataSet::SafeDownCast(set->GetPartitionAsDataObject(0)) : nullptr;
}

/// A surface, and what is known of it.
struct Model
{
  vtkSmartPointer<vtkPolyData> surface; ///< with a height at its points and a label at its cells
  std::array<double, 3> constraint;     ///< a place on it
  bool sharp;                           ///< has sharp edges
  int euler;
};

vtkSmartPointer<vtkPolyData> withArrays(vtkPolyData* surface)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->CopyStructure(surface);
  vtkNew<vtkFloatArray> height;
  height->SetName("Height");
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    height->InsertNextValue(static_cast<float>(data->GetPoint(p)[1]));
  }
  data->GetPointData()->AddArray(height);
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    label->InsertNextValue(static_cast<int>(c));
  }
  data->GetCellData()->AddArray(label);
  return data;
}

/// Closed, with sharp rims.
Model cylinderModel()
{
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(24);
  cylinder->SetHeight(3);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cylinder->GetOutputPort());
  vtkNew<vtkLinearSubdivisionFilter> finer;
  finer->SetInputConnection(triangles->GetOutputPort());
  finer->SetNumberOfSubdivisions(2);
  finer->Update();
  return { withArrays(finer->GetOutput()), { { 0.5, 0.21, 0. } }, true, 2 };
}

/// Open and smooth: a sheet in waves.
Model sheetModel()
{
  constexpr int Side = 40;
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(Side, Side);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkPolyData* sheet = triangles->GetOutput();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType p = 0; p < sheet->GetNumberOfPoints(); ++p)
  {
    double x[3];
    sheet->GetPoint(p, x);
    points->InsertNextPoint(x[0], x[1], 0.1 * std::sin(7. * x[0]) * std::cos(5. * x[1]));
  }
  sheet->SetPoints(points);
  std::array<double, 3> middle;
  sheet->GetPoint(sheet->GetNumberOfPoints() / 2, middle.data());
  return { withArrays(sheet), middle, false, 1 };
}

double cellArea(vtkPolyData* mesh, vtkIdType cell)
{
  vtkIdType n;
  const vtkIdType* p;
  mesh->GetPolys()->GetCellAtId(cell, n, p);
  double x[3][3];
  for (int k = 0; k < 3; ++k)
  {
    mesh->GetPoint(p[k], x[k]);
  }
  return vtkTriangle::TriangleArea(x[0], x[1], x[2]);
}

void checkCharts(vtkPartitionedDataSetCollection* charts, vtkPolyData* input)
{
  std::map<vtkIdType, std::array<double, 3>> place;
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* chart = part<vtkPolyData>(charts, c);
    const vtkIdType points = chart->GetNumberOfPoints();
    const vtkIdType cells = chart->GetNumberOfCells();
    check(chart->GetPoints()->GetDataType() == VTK_DOUBLE, "chart points are double");
    vtkDataArray* uv = array(chart->GetPointData(), "UV", VTK_DOUBLE, 2, points);
    check(chart->GetPointData()->GetTCoords() == uv, "UV are the active texture coordinates");
    vtkDataArray* id = array(chart->GetPointData(), "SurfacePointId", VTK_ID_TYPE, 1, points);
    array(chart->GetPointData(), "GaussianCurvature", VTK_DOUBLE, 1, points);
    array(chart->GetPointData(), "MeanCurvature", VTK_DOUBLE, 1, points);
    vtkDataArray* height = array(chart->GetPointData(), "Height", VTK_FLOAT, 1, points);
    vtkDataArray* source = array(chart->GetCellData(), "SourceCellId", VTK_ID_TYPE, 1, cells);
    vtkDataArray* distortion = array(chart->GetCellData(), "AreaDistortion", VTK_DOUBLE, 1, cells);
    vtkDataArray* label = array(chart->GetCellData(), "Label", VTK_INT, 1, cells);
    vtkDataArray* extent = array(chart->GetFieldData(), "ChartExtent", VTK_DOUBLE, 2, 1);
    const double w = extent->GetComponent(0, 0);
    const double h = extent->GetComponent(0, 1);
    check(std::max(w, h) == 1. && std::min(w, h) > 0, "the larger side of the rectangle is 1");
    for (vtkIdType p = 0; p < points; ++p)
    {
      const double u = uv->GetComponent(p, 0);
      const double v = uv->GetComponent(p, 1);
      check(u >= 0 && u <= w && v >= 0 && v <= h, "UV inside the rectangle");
      std::array<double, 3> x;
      chart->GetPoint(p, x.data());
      check(
        std::abs(height->GetComponent(p, 0) - x[1]) < 1e-5, "input point arrays are interpolated");
      const auto [slot, fresh] =
        place.try_emplace(static_cast<vtkIdType>(id->GetComponent(p, 0)), x);
      check(slot->second == x, "one place for every SurfacePointId");
    }
    double plane = 0;
    for (vtkIdType f = 0; f < cells; ++f)
    {
      vtkIdType n;
      const vtkIdType* p;
      chart->GetPolys()->GetCellAtId(f, n, p);
      double a[2];
      double b[2];
      double d[2];
      uv->GetTuple(p[0], a);
      uv->GetTuple(p[1], b);
      uv->GetTuple(p[2], d);
      const double area = 0.5 * ((b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]));
      check(area > 0, "triangles are counterclockwise in the plane");
      plane += area;
      const double ratio = cellArea(chart, f) / area;
      check(std::abs(distortion->GetComponent(f, 0) - ratio) <= 1e-9 * ratio,
        "AreaDistortion is A3D / A2D");
      const auto cell = static_cast<vtkIdType>(source->GetComponent(f, 0));
      check(cell >= 0 && cell < input->GetNumberOfCells(), "SourceCellId is an input cell");
      check(label->GetComponent(f, 0) == static_cast<double>(cell),
        "input cell arrays follow SourceCellId");
    }
    check(std::abs(plane - w * h) < 1e-9, "a chart fills its rectangle");
  }
}

void checkGraph(vtkPolyData* graph, bool isSharp)
{
  const vtkIdType points = graph->GetNumberOfPoints();
  const vtkIdType cells = graph->GetNumberOfCells();
  array(graph->GetPointData(), "SurfacePointId", VTK_ID_TYPE, 1, points);
  array(graph->GetPointData(), "IsCorner", VTK_INT, 1, points);
  array(graph->GetPointData(), "ChartId", VTK_INT, 1, points);
  array(graph->GetPointData(), "ChartCellId", VTK_ID_TYPE, 1, points);
  array(graph->GetPointData(), "BarycentricCoordinates", VTK_DOUBLE, 3, points);
  vtkDataArray* type = array(graph->GetCellData(), "BackboneType", VTK_INT, 1, cells);
  array(graph->GetCellData(), "Keep", VTK_INT, 1, cells);
  vtkDataArray* closed = array(graph->GetCellData(), "Closed", VTK_INT, 1, cells);
  check(graph->GetNumberOfVerts() == 1, "one vertex cell for the one constraint");
  check(type->GetComponent(0, 0) == 3, "the vertex cell is of type constraint");
  bool sharp = false;
  for (vtkIdType i = 0; i < graph->GetNumberOfLines(); ++i)
  {
    vtkIdType n;
    const vtkIdType* p;
    graph->GetLines()->GetCellAtId(i, n, p);
    const vtkIdType cell = graph->GetNumberOfVerts() + i;
    sharp = sharp || type->GetComponent(cell, 0) == 0;
    check((closed->GetComponent(cell, 0) != 0) <= (p[0] == p[n - 1]),
      "a closed backbone repeats its first point");
  }
  check(sharp == isSharp, "sharp edges are backbones, if there are any");
}

void checkImages(vtkPartitionedDataSetCollection* images, vtkPartitionedDataSetCollection* charts,
  const char* scalar, int type)
{
  check(images->GetNumberOfPartitionedDataSets() == charts->GetNumberOfPartitionedDataSets(),
    "an image a chart");
  for (unsigned int c = 0; c < images->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* image = part<vtkImageData>(images, c);
    auto* chart = part<vtkPolyData>(charts, c);
    const double* extent = chart->GetFieldData()->GetArray("ChartExtent")->GetTuple2(0);
    int size[3];
    image->GetDimensions(size);
    const double* spacing = image->GetSpacing();
    const double* origin = image->GetOrigin();
    for (int k = 0; k < 2; ++k)
    {
      check(std::abs(spacing[k] * size[k] - extent[k]) < 1e-12, "pixels tile the rectangle");
      check(std::abs(origin[k] - 0.5 * spacing[k]) < 1e-12,
        "the first pixel is centred half a pixel inside");
    }
    check(size[2] == 1, "maps are flat");
    vtkDataArray* values =
      array(image->GetPointData(), scalar, type, 1, image->GetNumberOfPoints());
    vtkDataArray* face =
      array(image->GetPointData(), "FaceIndex", VTK_INT, 1, image->GetNumberOfPoints());
    vtkDataArray* distortion = image->GetPointData()->GetArray("AreaDistortion");
    double sum = 0;
    for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
    {
      const double f = face->GetComponent(p, 0);
      check(f >= 0 && f < static_cast<double>(chart->GetNumberOfCells()),
        "FaceIndex is a triangle of the chart");
      check(values->GetComponent(p, 0) >= 0 || std::string(scalar) != "Control",
        "densities are not negative");
      sum += distortion->GetComponent(p, 0) * spacing[0] * spacing[1];
    }
    double area = 0;
    for (vtkIdType f = 0; f < chart->GetNumberOfCells(); ++f)
    {
      area += cellArea(chart, f);
    }
    check(std::abs(sum / area - 1) < 0.02,
      "AreaDistortion integrates to the area of chart " + std::to_string(c) + ": " +
        std::to_string(sum / area));
  }
}

void checkProvenance(vtkPolyData* data, vtkPartitionedDataSetCollection* charts, double scale)
{
  const vtkIdType n = data->GetNumberOfPoints();
  vtkDataArray* chartId = array(data->GetPointData(), "ChartId", VTK_INT, 1, n);
  vtkDataArray* cellId = array(data->GetPointData(), "ChartCellId", VTK_ID_TYPE, 1, n);
  vtkDataArray* bary = array(data->GetPointData(), "BarycentricCoordinates", VTK_DOUBLE, 3, n);
  vtkDataArray* uv = array(data->GetPointData(), "UV", VTK_DOUBLE, 2, n);
  vtkDataArray* source = array(data->GetPointData(), "SourceCellId", VTK_ID_TYPE, 1, n);
  array(data->GetPointData(), "SampleKind", VTK_INT, 1, n);
  array(data->GetPointData(), "BackboneId", VTK_INT, 1, n);
  array(data->GetPointData(), "ArcLength", VTK_DOUBLE, 1, n);
  for (vtkIdType p = 0; p < n; ++p)
  {
    auto* chart = part<vtkPolyData>(charts, static_cast<unsigned int>(chartId->GetComponent(p, 0)));
    const auto cell = static_cast<vtkIdType>(cellId->GetComponent(p, 0));
    vtkIdType size;
    const vtkIdType* corner;
    chart->GetPolys()->GetCellAtId(cell, size, corner);
    double x[3];
    data->GetPoint(p, x);
    double u[2] = { uv->GetComponent(p, 0), uv->GetComponent(p, 1) };
    for (int k = 0; k < 3; ++k)
    {
      const double b = bary->GetComponent(p, k);
      check(b >= 0 && b <= 1, "barycentric coordinates inside the triangle");
      for (int i = 0; i < 3; ++i)
      {
        x[i] -= b * chart->GetPoint(corner[k])[i];
      }
      for (int i = 0; i < 2; ++i)
      {
        u[i] -= b * chart->GetPointData()->GetArray("UV")->GetComponent(corner[k], i);
      }
    }
    check(vtkMath::Norm(x) < 1e-12 * scale, "the point is where its triangle and coordinates say");
    check(std::hypot(u[0], u[1]) < 1e-12, "and so is its UV");
    check(source->GetComponent(p, 0) ==
        chart->GetCellData()->GetArray("SourceCellId")->GetComponent(cell, 0),
      "SourceCellId is that of the chart's triangle");
  }
}

void checkMesh(
  vtkPolyData* mesh, vtkPolyData* lines, vtkPartitionedDataSetCollection* charts, int n, int euler)
{
  check(mesh->GetNumberOfPoints() == n, "as many points as samples");
  checkProvenance(mesh, charts, mesh->GetLength());
  array(mesh->GetPointData(), "Height", VTK_FLOAT, 1, n);
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    vtkIdType size;
    const vtkIdType* p;
    mesh->GetPolys()->GetCellAtId(f, size, p);
    check(size == 3, "the mesh is of triangles");
    for (int k = 0; k < 3; ++k)
    {
      check(edges.insert({ p[k], p[(k + 1) % 3] }).second,
        "every directed edge once: manifold and oriented");
    }
  }
  vtkIdType rim = 0;
  for (const auto& [a, b] : edges)
  {
    rim += edges.count({ b, a }) == 0;
  }
  const vtkIdType numberOfEdges = (static_cast<vtkIdType>(edges.size()) + rim) / 2;
  check(n - numberOfEdges + mesh->GetNumberOfPolys() == euler, "Euler characteristic");
  check((rim > 0) == (euler == 1), "open or closed like the input");
  array(lines->GetCellData(), "BackboneType", VTK_INT, 1, lines->GetNumberOfCells());
  array(lines->GetCellData(), "Closed", VTK_INT, 1, lines->GetNumberOfCells());
  array(lines->GetCellData(), "BackboneId", VTK_INT, 1, lines->GetNumberOfCells());
  vtkDataArray* type = lines->GetCellData()->GetArray("BackboneType");
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    vtkIdType size;
    const vtkIdType* p;
    lines->GetLines()->GetCellAtId(i, size, p);
    for (vtkIdType k = 0; k + 1 < size && type->GetComponent(i, 0) < 2; ++k)
    {
      check(edges.count({ p[k], p[k + 1] }) || edges.count({ p[k + 1], p[k] }),
        "feature lines are mesh edges");
    }
  }
}
void checkPipeline(const Model& model)
{
  constexpr int n = 900;
  vtkPolyData* input = model.surface;
  vtkNew<vtkPoints> constraints;
  constraints->InsertNextPoint(model.constraint.data());
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(input);
  atlas->SetNumberOfCharts(3);
  atlas->SetConstraints(constraints);
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputConnection(atlas->GetOutputPort(0));
  maps->SetMapSize(512);
  vtkNew<vtkControlMap> control;
  control->SetInputConnection(maps->GetOutputPort());
  vtkNew<vtkErrorDiffusionSampler> sampler;
  sampler->SetInputConnection(0, control->GetOutputPort());
  sampler->SetInputConnection(1, atlas->GetOutputPort(0));
  sampler->SetInputConnection(2, atlas->GetOutputPort(1));
  sampler->SetNumberOfSamples(n);
  vtkNew<vtkCDTRemesh> mesher;
  mesher->SetInputConnection(0, sampler->GetOutputPort(0));
  mesher->SetInputConnection(1, atlas->GetOutputPort(0));
  mesher->SetInputConnection(2, atlas->GetOutputPort(1));
  vtkNew<vtkRemeshOptimizer> optimizer;
  optimizer->SetInputConnection(0, mesher->GetOutputPort(0));
  optimizer->SetInputConnection(1, atlas->GetOutputPort(0));
  optimizer->SetInputConnection(2, atlas->GetOutputPort(1));
  optimizer->SetInputConnection(3, control->GetOutputPort());
  optimizer->Update();

  const auto collection = [](vtkAlgorithm* a, int port) {
    return vtkPartitionedDataSetCollection::SafeDownCast(a->GetOutputDataObject(port));
  };
  const auto polyData = [](vtkAlgorithm* a, int port) {
    return vtkPolyData::SafeDownCast(a->GetOutputDataObject(port));
  };
  vtkPartitionedDataSetCollection* charts = collection(atlas, 0);
  check(charts->GetNumberOfPartitionedDataSets() >= 3, "at least the charts asked for");
  checkCharts(charts, input);
  checkGraph(polyData(atlas, 1), model.sharp);
  checkImages(collection(maps, 0), charts, "AreaDistortion", VTK_FLOAT);
  checkImages(collection(maps, 0), charts, "MeanCurvature", VTK_FLOAT);
  checkImages(collection(control, 0), charts, "Control", VTK_FLOAT);
  vtkPolyData* samples = polyData(sampler, 0);
  check(samples->GetNumberOfPoints() == n, "exactly the samples asked for");
  checkProvenance(samples, charts, samples->GetLength());
  array(samples->GetPointData(), "SurfacePointId", VTK_ID_TYPE, 1, n);
  checkImages(collection(sampler, 1), charts, "Halftone", VTK_UNSIGNED_CHAR);
  checkMesh(polyData(mesher, 0), polyData(mesher, 1), charts, n, model.euler);
  checkMesh(polyData(optimizer, 0), polyData(optimizer, 1), charts, n, model.euler);

  // The constraint is a vertex of the final mesh, on the facet next to where it was asked for.
  vtkDataArray* kind = polyData(optimizer, 0)->GetPointData()->GetArray("SampleKind");
  int constrained = 0;
  for (vtkIdType p = 0; p < n; ++p)
  {
    if (kind->GetComponent(p, 0) == 3)
    {
      ++constrained;
      const double* x = polyData(optimizer, 0)->GetPoint(p);
      const auto& c = model.constraint;
      check(std::abs(x[1] - c[1]) < 1e-6 && std::hypot(x[0] - c[0], x[2] - c[2]) < 0.01,
        "the constraint stays");
    }
  }
  check(constrained == 1, "one constraint, one vertex");
}
}

int TestDataContracts(int, char*[])
{
  checkPipeline(cylinderModel());
  checkPipeline(sheetModel());
  return test::exitStatus();
}
