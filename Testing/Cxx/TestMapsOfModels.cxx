// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Maps of real models: OpenGL and the CPU agree, they integrate to the charts' areas, and all of
// the catalogue looks like the baselines. (After a change of the atlas, charts are others: look at
// the new pictures, and run this test once with STIPPLE_WRITE_BASELINES set.)
//
// --models FOLDER: where the models are; --platform OSMESA, EGL or GLX: what draws.
#include "Check.h"
#include "Curvature.h"
#include "ImageRegression.h"
#include "MapComparison.h"
#include "MapContactSheet.h"
#include "ModelFile.h"
#include "PolyDataConversion.h"
#include "SyntheticCharts.h"

#include "vtkConformalAtlas.h"
#include "vtkHeadlessRenderWindow.h"

namespace
{
using test::check;

void testIntegral(vtkPartitionedDataSetCollection* charts, const std::string& model)
{
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(charts);
  maps->SetBackendToCPU();
  maps->SetMapSize(512);
  maps->Update();
  double worst = 0.;
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    vtkImageData* image = test::imageOf(maps, c);
    vtkDataArray* array = image->GetPointData()->GetArray("AreaDistortion");
    double sum = 0.;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      sum += array->GetComponent(i, 0);
    }
    sum *= image->GetSpacing()[0] * image->GetSpacing()[1];
    const double area =
      stipple::fromPolyData(vtkPolyData::SafeDownCast(charts->GetPartitionAsDataObject(c, 0)))
        .area();
    worst = std::max(worst, std::abs(sum / area - 1.));
  }
  std::cout << model << ": the area map's integral is off by at most " << 100. * worst << " %\n";
  check(worst < 0.005, model + ": maps integrate to the charts' areas");
}

/// The faces whose normal is on one side of the plane z = 0, projected onto it.
vtkSmartPointer<vtkPolyData> projectedChart(const stipple::TriangleSurface& surface, double side)
{
  const stipple::Curvature curvature = stipple::computeCurvature(surface);
  std::vector<int> local(surface.points.size(), -1);
  std::vector<stipple::Vec3> points;
  std::vector<int> ids;
  std::vector<stipple::Triangle> triangles;
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    if (side * surface.faceNormal(f).z() > 0.2)
    {
      stipple::Triangle t;
      for (int k = 0; k < 3; ++k)
      {
        const int p = surface.triangles[f][k];
        if (local[p] < 0)
        {
          local[p] = static_cast<int>(points.size());
          points.push_back(surface.points[p]);
          ids.push_back(p);
        }
        t[k] = local[p];
      }
      triangles.push_back(t);
    }
  }
  const auto flat = [side](const stipple::Vec3& p) { return stipple::Vec2(side * p.x(), p.y()); };
  stipple::Vec2 low = flat(points[0]);
  stipple::Vec2 high = low;
  for (const stipple::Vec3& p : points)
  {
    low = low.cwiseMin(flat(p));
    high = high.cwiseMax(flat(p));
  }
  const double scale = 1. / (high - low).maxCoeff();
  auto chart = stipple::toPolyData(points, triangles);
  const auto n = static_cast<vtkIdType>(points.size());
  const auto uv = synthetic::makeArray<vtkDoubleArray>("UV", 2, n);
  const auto id = synthetic::makeArray<vtkIdTypeArray>("SurfacePointId", 1, n);
  const auto mean = synthetic::makeArray<vtkDoubleArray>("MeanCurvature", 1, n);
  const auto gaussian = synthetic::makeArray<vtkDoubleArray>("GaussianCurvature", 1, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const stipple::Vec2 p = scale * (flat(points[i]) - low);
    uv->SetTuple2(i, p.x(), p.y());
    id->SetValue(i, ids[i]);
    mean->SetValue(i, curvature.mean[ids[i]]);
    gaussian->SetValue(i, curvature.gaussian[ids[i]]);
  }
  const auto cells = static_cast<vtkIdType>(triangles.size());
  const auto source = synthetic::makeArray<vtkIdTypeArray>("SourceCellId", 1, cells);
  const auto distortion = synthetic::makeArray<vtkDoubleArray>("AreaDistortion", 1, cells);
  for (vtkIdType f = 0; f < cells; ++f)
  {
    const stipple::Triangle& t = triangles[f];
    source->SetValue(f, f);
    distortion->SetValue(f,
      2. * stipple::triangleArea(points[t[0]], points[t[1]], points[t[2]]) / scale / scale /
        stipple::orient2(flat(points[t[0]]), flat(points[t[1]]), flat(points[t[2]])));
  }
  const auto extent = synthetic::makeArray<vtkDoubleArray>("ChartExtent", 2, 1);
  extent->SetTuple2(0, scale * (high - low).x(), scale * (high - low).y());
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ uv, id, mean, gaussian })
  {
    chart->GetPointData()->AddArray(array);
  }
  chart->GetCellData()->AddArray(source);
  chart->GetCellData()->AddArray(distortion);
  chart->GetFieldData()->AddArray(extent);
  return chart;
}

void testBaseline(vtkPolyData* mesh, const std::string& model, int argc, char* argv[])
{
  stipple::TriangleSurface surface;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    surface.points.emplace_back(mesh->GetPoint(i));
  }
  for (vtkIdType f = 0; f < mesh->GetNumberOfCells(); ++f)
  {
    vtkIdType n = 0;
    const vtkIdType* p = nullptr;
    mesh->GetPolys()->GetCellAtId(f, n, p);
    surface.triangles.push_back(
      { static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2]) });
  }
  surface.connect();
  vtkNew<vtkPartitionedDataSetCollection> charts;
  charts->SetPartition(0, 0, projectedChart(surface, 1.));
  charts->SetPartition(1, 0, projectedChart(surface, -1.));
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(charts);
  maps->SetBackendToCPU();
  maps->SetMapSize(100);
  maps->GetMapSelection()->EnableArray("Position");
  maps->GetMapSelection()->EnableArray("Normal");
  maps->Update();
  stipple::ContactSheetOptions options;
  options.maps = { "AreaDistortion", "FaceIndex", "GaussianCurvature", "MeanCurvature",
    "MinimumCurvature", "MaximumCurvature", "TotalCurvature", "Position", "Normal" };
  options.tile = 100;
  options.labels = false;
  const auto sheet = stipple::mapContactSheet(maps->GetOutput(), options);
  check(sheet && test::comparePicture(sheet, "Maps-" + model, argc, argv),
    model + ": every map is the baseline");
}
}

int TestMapsOfModels(int argc, char* argv[])
{
  const std::string folder = test::argument(argc, argv, "--models", "");
  const std::string platform = test::argument(argc, argv, "--platform", "OSMESA");
  vtkSmartPointer<vtkRenderWindow> window;
  if (platform == "GLX")
  {
    window = vtkSmartPointer<vtkRenderWindow>::New();
  }
  else
  {
    const auto headless = vtkSmartPointer<vtkHeadlessRenderWindow>::New();
    headless->SetPlatform(
      platform == "EGL" ? vtkHeadlessRenderWindow::EGL : vtkHeadlessRenderWindow::OSMESA);
    window = headless;
  }
  window->SetMultiSamples(0);
  window->Render();
  for (const std::string model : { "fandisk", "bunny00" })
  {
    const auto mesh = test::readOff(folder + "/" + model + ".off");
    check(mesh != nullptr, "read " + model);
    if (!mesh)
    {
      continue;
    }
    vtkNew<vtkConformalAtlas> atlas;
    atlas->SetInputData(mesh);
    atlas->Update();
    auto* charts = vtkPartitionedDataSetCollection::SafeDownCast(atlas->GetOutputDataObject(0));
    check(charts->GetNumberOfPartitionedDataSets() > 0, model + " has charts");
    test::compareMaps(charts, window, platform + ", " + model, {}, check);
    if (platform == "OSMESA")
    {
      testIntegral(charts, model);
      testBaseline(mesh, model, argc, argv);
    }
  }
  return test::exitStatus();
}
