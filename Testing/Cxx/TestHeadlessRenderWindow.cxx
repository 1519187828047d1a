// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A window without a display really draws, resizes, lives beside another one, and says so if it
// cannot.
#include "Check.h"
#include "ImageRegression.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"

namespace
{
using test::check;

vtkSmartPointer<vtkRenderer> makeScene(int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetColor(0.9, 0.6, 0.3);
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(0.2, 0.3, 0.4);
  renderer->AddActor(actor);
  return renderer;
}

void testDrawing(int platform, const char* name, int argc, char* argv[])
{
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetPlatform(platform);
  window->SetMultiSamples(0);
  window->SetSize(300, 300);
  window->AddRenderer(makeScene(24));
  window->Render();
  check(std::string(window->GetPlatformName()) == name, "the platform is the one asked for");
  check(*window->GetRendererName() != '\0', "the renderer has a name");
  check(window->SupportsOpenGL() == 1, "OpenGL is supported");
  check(
    test::compareWindow(window, "HeadlessRenderWindow", argc, argv), "the picture is the baseline");

  window->SetSize(200, 120);
  window->Render();
  const auto smaller = test::takePicture(window);
  check(
    smaller->GetDimensions()[0] == 200 && smaller->GetDimensions()[1] == 120, "the window resizes");

  // Another window, of its own context, in between.
  vtkNew<vtkHeadlessRenderWindow> other;
  other->SetPlatform(platform);
  other->SetMultiSamples(0);
  other->SetSize(300, 300);
  other->AddRenderer(makeScene(24));
  window->SetSize(300, 300);
  other->Render();
  window->Render();
  check(window->IsCurrent() && !other->IsCurrent(), "the last window that drew is current");
  check(
    test::compareWindow(other, "HeadlessRenderWindow", argc, argv), "a second window draws too");
  check(test::compareWindow(window, "HeadlessRenderWindow", argc, argv), "and the first one still");

  // A context that was given up comes back.
  window->Finalize();
  check(!window->IsCurrent(), "a finalized window is not current");
  check(test::compareWindow(window, "HeadlessRenderWindow", argc, argv),
    "a finalized window draws again");

  // One triangle less in each ring is another picture: the comparison is not blind.
  vtkNew<vtkHeadlessRenderWindow> wrong;
  wrong->SetPlatform(platform);
  wrong->SetMultiSamples(0);
  wrong->SetSize(300, 300);
  wrong->AddRenderer(makeScene(23));
  char folder[] = "-T";
  char elsewhere[] = "Testing/Temporary/Wrong";
  char data[] = "-D";
  std::string dataFolder = test::argument(argc, argv, "-D", ".");
  char* arguments[] = { argv[0], data, dataFolder.data(), folder, elsewhere };
  if (!std::getenv("STIPPLE_WRITE_BASELINES"))
  {
    std::cerr << "(a difference is expected here)\n";
    check(
      !test::compareWindow(wrong, "HeadlessRenderWindow", 5, arguments), "a coarser mesh differs");
  }
}

/// Two kinds of contexts take turns in one process.
void testTurns(int argc, char* argv[])
{
  vtkNew<vtkHeadlessRenderWindow> window[2];
  for (int k = 0; k < 2; ++k)
  {
    window[k]->SetPlatform(k == 0 ? vtkHeadlessRenderWindow::OSMESA : vtkHeadlessRenderWindow::EGL);
    window[k]->SetMultiSamples(0);
    window[k]->SetSize(300, 300);
    window[k]->AddRenderer(makeScene(24));
  }
  for (const int k : { 0, 1, 0, 1, 1, 0 })
  {
    window[k]->Render();
    check(window[k]->IsCurrent() && !window[1 - k]->IsCurrent(), "one context at a time");
    check(test::compareWindow(window[k], "HeadlessRenderWindow", argc, argv), "they take turns");
  }
}

void testFailure(int platform)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkHeadlessRenderWindow> window;
  window->AddObserver(vtkCommand::ErrorEvent, errors);
  window->SetPlatform(platform);
  window->SetSize(300, 300);
  window->AddRenderer(makeScene(8));
  check(window->SupportsOpenGL() == 0, "no OpenGL where there cannot be any");
  check(!errors->GetError(), "asking for support is no error");
  window->Render();
  check(errors->GetError() &&
      errors->GetErrorMessage().find("There is no OpenGL without a display") != std::string::npos,
    "Render says why it draws nothing");
  check(*window->GetPlatformName() == '\0', "there is no platform");
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, 9, 9, 1, pixels, 0);
  check(std::string(window->ReportCapabilities()).find("There is no OpenGL") == 0,
    "the report says why");
}
} // namespace

int TestHeadlessRenderWindow(int argc, char* argv[])
{
  // --platform EGL or OSMESA: what this program can have; --without: what it cannot.
  const std::string platform = test::argument(argc, argv, "--platform", "OSMESA");
  const std::string without = test::argument(argc, argv, "--without", "");
  if (platform == "EGL")
  {
    testDrawing(vtkHeadlessRenderWindow::EGL, "EGL", argc, argv);
    testDrawing(vtkHeadlessRenderWindow::AUTO, "EGL", argc, argv);
  }
  else
  {
    testDrawing(vtkHeadlessRenderWindow::OSMESA, "OSMesa", argc, argv);
    testDrawing(vtkHeadlessRenderWindow::AUTO, "OSMesa", argc, argv);
    // EGL may be in reach too (Mesa's drivers share their dispatch with OSMesa).
    vtkNew<vtkHeadlessRenderWindow> egl;
    egl->SetPlatformToEGL();
    if (egl->SupportsOpenGL())
    {
      testDrawing(vtkHeadlessRenderWindow::EGL, "EGL", argc, argv);
      testTurns(argc, argv);
    }
    else
    {
      std::cout << "Without EGL: " << egl->GetOpenGLSupportMessage() << "\n";
    }
  }
  if (without == "OSMESA")
  {
    testFailure(vtkHeadlessRenderWindow::OSMESA);
  }
  return test::exitStatus();
}
