// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's maps are the CPU's: the same faces, and the same values where the faces are the same.
#include "Check.h"
#include "ImageRegression.h"
#include "MapComparison.h"
#include "SyntheticCharts.h"

#include "vtkDataArraySelection.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <set>

namespace
{
using test::check;

/// Compares all maps of one size.
void compare(vtkPartitionedDataSetCollection* atlas, vtkRenderWindow* window, int size,
  const std::string& what, bool folded = false)
{
  test::MapComparison options;
  options.size = size;
  options.more = { "Heat", "Quad", "Region" };
  options.folded = folded;
  test::compareMaps(atlas, window, what, options, check);
}

void compareAll(vtkRenderWindow* window, const std::string& what)
{
  const auto atlas = synthetic::makeAtlas(80, 60);
  for (const int size : { 37, 300, 1000 })
  {
    compare(atlas, window, size, what);
  }
  // Pixel centres lie exactly on edges.
  compare(synthetic::makeAtlas(64, 64, 0.), window, 32, what + ", points at centres");
  compare(synthetic::makeAtlas(60, 100, 0.), window, 90, what + ", edges through centres");
  // Triangles that overlap: the smaller one in space is on top.
  compare(synthetic::makeAtlas(40, 30, 0.8), window, 200, what + ", folds", true);
  // Triangles much smaller than pixels.
  compare(synthetic::makeAtlas(300, 300), window, 100, what + ", tiny triangles");
}

/// Maps and pictures from one window do not disturb each other.
void testSharedWindow(vtkRenderWindow* window)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.2, 0.9);
  window->AddRenderer(renderer);
  window->SetSize(100, 80);
  window->Render();
  const auto before = test::takePicture(window);
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(synthetic::makeAtlas());
  maps->SetRenderWindow(window);
  maps->SetMapSize(64);
  maps->Update();
  check(
    std::string(maps->GetBackendName()).find("OpenGL") == 0, "AUTO draws in the caller's window");
  window->Render();
  const auto after = test::takePicture(window);
  const auto* p = static_cast<unsigned char*>(before->GetScalarPointer());
  const auto* q = static_cast<unsigned char*>(after->GetScalarPointer());
  check(std::equal(p, p + 3 * 100 * 80, q) && p[2] > 200, "the picture is as before");
}
} // namespace

int TestGeometryMapOpenGL(int argc, char* argv[])
{
  const std::string platform = test::argument(argc, argv, "--platform", "OSMESA");
  if (platform == "GLX")
  {
    vtkNew<vtkRenderWindow> window;
    window->SetMultiSamples(0);
    window->Render();
    compareAll(window, window->GetClassName());
    testSharedWindow(window);
    return test::exitStatus();
  }
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetPlatform(
    platform == "EGL" ? vtkHeadlessRenderWindow::EGL : vtkHeadlessRenderWindow::OSMESA);
  window->SetMultiSamples(0);
  compareAll(window, platform);
  testSharedWindow(window);
  compare(synthetic::makeAtlas(), nullptr, 200, "a window of its own");
  return test::exitStatus();
}
