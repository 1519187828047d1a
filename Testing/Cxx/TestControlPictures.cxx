// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture of Documentation/Sampling.md: what each option of the control map does to 5,000
// samples of the bunny. Samples may change in detail with the atlas: compared at a coarse look. (To
// renew it, look at the new one and run this test with STIPPLE_WRITE_BASELINES set.)
//
// --models FOLDER: where the models are.
#include "Check.h"
#include "ImageRegression.h"
#include "ModelFile.h"

#include "vtkCamera.h"
#include "vtkControlMap.h"
#include "vtkGeometryRemesher.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRemeshOptimizer.h"
#include "vtkRenderer.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using test::check;

using Setting = std::function<void(vtkGeometryRemesher*)>;

/// Twelve of them, in rows of four from the top.
std::vector<Setting> settings()
{
  const auto curvature = [](double gamma) {
    return [=](vtkGeometryRemesher* r) {
      r->SetImportanceToMean();
      r->SetGamma(gamma);
    };
  };
  const auto stripes = [](vtkGeometryRemesher* r) {
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(240, 1, 1);
    picture->AllocateScalars(VTK_FLOAT, 1);
    for (int i = 0; i < 240; ++i)
    {
      picture->SetScalarComponentFromDouble(i, 0, 0, 0, i / 30 % 2 == 0 ? 1. : 0.05);
    }
    r->SetImportanceToImage();
    r->SetImportanceImage(picture);
  };
  return { [](vtkGeometryRemesher*) {}, curvature(0.5), curvature(1.), curvature(2.),
    [=](vtkGeometryRemesher* r) {
      curvature(2.)(r);
      r->GetControlMap()->SetMinimumDensity(0.3);
    },
    [=](vtkGeometryRemesher* r) {
      curvature(1.)(r);
      vtkNew<vtkPiecewiseFunction> function;
      function->AddPoint(0., 1.);
      function->AddPoint(0.4, 0.05);
      function->AddPoint(1., 0.05);
      r->GetControlMap()->SetTransferFunction(function);
    },
    [=](vtkGeometryRemesher* r) {
      curvature(2.)(r);
      r->SetGradation(5.);
    },
    [=](vtkGeometryRemesher* r) {
      curvature(1.)(r);
      r->GetControlMap()->SetBandPass(0.5, 2.);
    },
    [](vtkGeometryRemesher* r) {
      r->GetControlMap()->AddStroke(-0.29, 0.22, 0.28, 0.22, 6.); // on the head
      r->GetControlMap()->AddStroke(0.25, -0.1, 0.35, 0.3, -1.);  // on the haunch
    },
    stripes,
    [=](vtkGeometryRemesher* r) {
      stripes(r);
      r->GetControlMap()->SetImageProjectionToZAxis();
    },
    [](vtkGeometryRemesher* r) { r->SetImportanceToL2(); } };
}

/// The mean over squares of some pixels.
std::vector<double> coarse(vtkImageData* image, int square)
{
  const int* size = image->GetDimensions();
  const int columns = size[0] / square;
  const int rows = size[1] / square;
  std::vector<double> mean(static_cast<std::size_t>(columns) * rows, 0.);
  for (int y = 0; y < rows * square; ++y)
  {
    for (int x = 0; x < columns * square; ++x)
    {
      mean[y / square * columns + x / square] +=
        image->GetScalarComponentAsDouble(x, y, 0, 0) / (square * square);
    }
  }
  return mean;
}
}

int TestControlPictures(int argc, char* argv[])
{
  const auto mesh =
    test::readOff(test::argument(argc, argv, "--models", "") + std::string("/bunny00.off"));
  if (!mesh)
  {
    std::cerr << "FAILED: read bunny00\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(mesh);
  remesher->SetNumberOfPoints(5000);
  remesher->GetOptimizer()->SetSmoothingToNone();
  remesher->GetOptimizer()->SetConnectivityToNone();
  remesher->SetNumberOfIterations(0);
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(960, 720);
  const std::vector<Setting> all = settings();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    remesher->SetImportanceToUniform();
    remesher->SetGamma(1.);
    remesher->GetControlMap()->SetMinimumDensity(0.02);
    remesher->GetControlMap()->SetTransferFunction(nullptr);
    remesher->SetGradation(0.);
    remesher->GetControlMap()->SetBandPass(0., 0.);
    remesher->GetControlMap()->RemoveAllStrokes();
    remesher->GetControlMap()->SetImageProjectionToChart();
    all[i](remesher);
    remesher->Update();
    const auto samples = vtkSmartPointer<vtkPolyData>::New();
    samples->ShallowCopy(remesher->GetOutputDataObject(5));
    check(samples->GetNumberOfPoints() == 5000, "panel " + std::to_string(i) + ": 5,000 samples");
    const double x = static_cast<double>(i % 4) / 4.;
    const double y = static_cast<double>(2 - i / 4) / 3.;
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(x, y, x + 0.25, y + 1. / 3.);
    renderer->SetBackground(1., 1., 1.);
    vtkNew<vtkPolyDataMapper> surface;
    surface->SetInputConnection(normals->GetOutputPort());
    surface->SetResolveCoincidentTopologyToPolygonOffset();
    surface->SetRelativeCoincidentTopologyPolygonOffsetParameters(4., 4.);
    vtkNew<vtkActor> body;
    body->SetMapper(surface);
    body->GetProperty()->SetColor(0.85, 0.88, 0.93);
    renderer->AddActor(body);
    vtkNew<vtkPolyDataMapper> dots;
    dots->SetInputData(samples);
    dots->ScalarVisibilityOff();
    vtkNew<vtkActor> points;
    points->SetMapper(dots);
    points->GetProperty()->SetColor(0.1, 0.15, 0.4);
    points->GetProperty()->SetPointSize(2.f);
    points->GetProperty()->LightingOff();
    renderer->AddActor(points);
    renderer->ResetCamera();
    renderer->GetActiveCamera()->Zoom(1.5);
    renderer->ResetCameraClippingRange();
    window->AddRenderer(renderer);
  }
  window->Render();
  const auto picture = test::takePicture(window);
  const std::string name = "ControlMaps";
  if (std::getenv("STIPPLE_WRITE_BASELINES"))
  {
    check(test::comparePicture(picture, name, argc, argv), "write the picture");
    return test::exitStatus();
  }
  const std::string folder = test::argument(argc, argv, "-D", ".");
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((folder + "/Baseline/" + name + ".png").c_str());
  reader->Update();
  const std::vector<double> now = coarse(picture, 24);
  const std::vector<double> then = coarse(reader->GetOutput(), 24);
  check(now.size() == then.size(), "the size of the picture");
  double difference = 0.;
  for (std::size_t i = 0; i < std::min(now.size(), then.size()); ++i)
  {
    difference += std::abs(now[i] - then[i]) / static_cast<double>(now.size());
  }
  std::cout << "mean difference " << difference << "\n";
  if (difference > 3.)
  {
    test::writePicture(picture, test::argument(argc, argv, "-T", ".") + ("/" + name + ".png"));
    check(false, "the picture has changed");
  }
  return test::exitStatus();
}
