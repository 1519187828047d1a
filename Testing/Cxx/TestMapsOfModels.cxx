// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Maps of real models: OpenGL and the CPU agree, they integrate to the charts' areas, and all of
// the catalogue looks like the baselines. (After a change of the atlas, charts are others: look at
// the new pictures, and run this test once with STIPPLE_WRITE_BASELINES set.)
//
// --models FOLDER: where the models are; --platform OSMESA, EGL or GLX: what draws.
#include "ImageRegression.h"
#include "MapComparison.h"
#include "MapPicture.h"
#include "ModelFile.h"

#include "vtkConformalAtlas.h"
#include "vtkHeadlessRenderWindow.h"

namespace
{
int failures = 0;

void check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++failures;
  }
}

double areaOf(vtkPolyData* chart)
{
  double area = 0.;
  for (vtkIdType f = 0; f < chart->GetNumberOfCells(); ++f)
  {
    vtkIdType n = 0;
    const vtkIdType* ids = nullptr;
    chart->GetPolys()->GetCellAtId(f, n, ids);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      chart->GetPoint(ids[k], p[k]);
    }
    const double u[3] = { p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2] };
    const double v[3] = { p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2] };
    area += 0.5 *
      std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }
  return area;
}

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
    vtkImageData* image = testing::imageOf(maps, c);
    vtkDataArray* array = image->GetPointData()->GetArray("AreaDistortion");
    double sum = 0.;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      sum += array->GetComponent(i, 0);
    }
    sum *= image->GetSpacing()[0] * image->GetSpacing()[1];
    const double area = areaOf(vtkPolyData::SafeDownCast(charts->GetPartitionAsDataObject(c, 0)));
    worst = std::max(worst, std::abs(sum / area - 1.));
  }
  std::cout << model << ": the area map's integral is off by at most " << 100. * worst << " %\n";
  check(worst < 0.005, model + ": maps integrate to the charts' areas");
}

void testBaseline(
  vtkPartitionedDataSetCollection* charts, const std::string& model, int argc, char* argv[])
{
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(charts);
  maps->SetBackendToCPU();
  maps->SetMapSize(96);
  maps->GetMapSelection()->EnableArray("Position");
  maps->GetMapSelection()->EnableArray("Normal");
  maps->Update();
  stipple::ContactSheetOptions options;
  options.maps = { "AreaDistortion", "FaceIndex", "GaussianCurvature", "MeanCurvature",
    "MinimumCurvature", "MaximumCurvature", "TotalCurvature", "Position", "Normal" };
  options.tile = 96;
  options.maximumCharts = 4;
  options.labels = false;
  const auto sheet = stipple::mapContactSheet(maps->GetOutput(), options);
  check(sheet && testing::comparePicture(sheet, "Maps-" + model, argc, argv),
    model + ": every map is the baseline");
}
}

int TestMapsOfModels(int argc, char* argv[])
{
  const std::string folder = testing::argument(argc, argv, "--models", "");
  const std::string platform = testing::argument(argc, argv, "--platform", "OSMESA");
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
    const auto mesh = testing::readOff(folder + "/" + model + ".off");
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
    testing::compareMaps(charts, window, platform + ", " + model, {}, check);
    if (platform == "OSMESA")
    {
      testIntegral(charts, model);
      testBaseline(charts, model, argc, argv);
    }
  }
  return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
