// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's maps are the CPU's: the same faces, and the same values where the faces are the same.
#include "ImageRegression.h"
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
int failures = 0;

void check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++failures;
  }
}

void enableAll(vtkGeometryMapRenderer* maps)
{
  for (const char* name : { "Position", "Normal", "Heat", "Quad", "Region" })
  {
    maps->GetMapSelection()->EnableArray(name);
  }
}

vtkImageData* imageOf(vtkGeometryMapRenderer* maps, unsigned int chart)
{
  return vtkImageData::SafeDownCast(maps->GetOutput()->GetPartition(chart, 0));
}

bool shareAPoint(vtkPolyData* chart, vtkIdType f, vtkIdType g)
{
  vtkIdType n = 0;
  const vtkIdType* p = nullptr;
  chart->GetPolys()->GetCellAtId(f, n, p);
  const std::set<vtkIdType> first(p, p + n);
  chart->GetPolys()->GetCellAtId(g, n, p);
  return std::any_of(p, p + n, [&](vtkIdType q) { return first.count(q) > 0; });
}

/// Compares all maps of one size.
void compare(vtkPartitionedDataSetCollection* atlas, vtkRenderWindow* window, int size,
  const std::string& what, bool folded = false)
{
  vtkNew<vtkGeometryMapRenderer> cpu;
  cpu->SetInputDataObject(atlas);
  cpu->SetBackendToCPU();
  cpu->SetMapSize(size);
  enableAll(cpu);
  cpu->Update();
  vtkNew<vtkGeometryMapRenderer> gpu;
  gpu->SetInputDataObject(atlas);
  gpu->SetBackendToOpenGL();
  gpu->SetRenderWindow(window);
  gpu->SetMapSize(size);
  enableAll(gpu);
  gpu->Update();
  check(std::string(gpu->GetBackendName()).find("OpenGL") == 0, what + ": OpenGL drew the maps");
  check(std::string(cpu->GetBackendName()) == "CPU", what + ": the CPU drew the maps");
  for (unsigned int c = 0; c < 2; ++c)
  {
    vtkImageData* a = imageOf(cpu, c);
    vtkImageData* b = imageOf(gpu, c);
    if (!a || !b)
    {
      check(false, what + ": both have maps");
      return;
    }
    auto* chart = vtkPolyData::SafeDownCast(atlas->GetPartitionAsDataObject(c, 0));
    auto* fa = vtkIntArray::SafeDownCast(a->GetPointData()->GetArray("FaceIndex"));
    auto* fb = vtkIntArray::SafeDownCast(b->GetPointData()->GetArray("FaceIndex"));
    const vtkIdType n = a->GetNumberOfPoints();
    vtkIdType different = 0;
    vtkIdType far = 0;
    for (vtkIdType p = 0; p < n; ++p)
    {
      if (fa->GetValue(p) != fb->GetValue(p))
      {
        ++different;
        far += shareAPoint(chart, fa->GetValue(p), fb->GetValue(p)) ? 0 : 1;
      }
    }
    std::cout << what << ", chart " << c << ", " << a->GetDimensions()[0] << " x "
              << a->GetDimensions()[1] << ": " << different << " of " << n << " faces differ\n";
    check(different <= n / 1000, what + ": faces equal on 99.9 % of the pixels");
    check(far == 0, what + ": other faces are neighbours");
    for (const char* name :
      { "AreaDistortion", "GaussianCurvature", "MeanCurvature", "Position", "Normal", "Heat",
        "Quad", "Region", "MinimumCurvature", "MaximumCurvature", "TotalCurvature" })
    {
      vtkDataArray* u = a->GetPointData()->GetArray(name);
      vtkDataArray* v = b->GetPointData()->GetArray(name);
      // Not linear: H^2 - K cancels where the surface is like a sphere, and the root makes more of
      // what is left; so does the normalisation, where the normals of a fold's two sides cancel.
      const bool cancels = std::string(name) == "MinimumCurvature" ||
        std::string(name) == "MaximumCurvature" || (folded && std::string(name) == "Normal");
      double largest = 0.;
      double worst = 0.;
      for (vtkIdType p = 0; p < n; ++p)
      {
        for (int k = 0; k < u->GetNumberOfComponents(); ++k)
        {
          largest = std::max(largest, std::abs(u->GetComponent(p, k)));
          if (fa->GetValue(p) == fb->GetValue(p))
          {
            worst = std::max(worst, std::abs(u->GetComponent(p, k) - v->GetComponent(p, k)));
          }
        }
      }
      check(worst <= (cancels ? 1e-3 : 1e-5) * largest,
        what + ": " + name + " agrees (off by " + std::to_string(worst / largest) + ")");
    }
  }
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
  const auto before = testing::takePicture(window);
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(synthetic::makeAtlas());
  maps->SetRenderWindow(window);
  maps->SetMapSize(64);
  maps->Update();
  check(
    std::string(maps->GetBackendName()).find("OpenGL") == 0, "AUTO draws in the caller's window");
  window->Render();
  const auto after = testing::takePicture(window);
  const auto* p = static_cast<unsigned char*>(before->GetScalarPointer());
  const auto* q = static_cast<unsigned char*>(after->GetScalarPointer());
  check(std::equal(p, p + 3 * 100 * 80, q) && p[2] > 200, "the picture is as before");
}
} // namespace

int TestGeometryMapOpenGL(int argc, char* argv[])
{
  const std::string platform = testing::argument(argc, argv, "--platform", "OSMESA");
  if (platform == "GLX")
  {
    vtkNew<vtkRenderWindow> window;
    window->SetMultiSamples(0);
    window->Render();
    compareAll(window, window->GetClassName());
    testSharedWindow(window);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetPlatform(
    platform == "EGL" ? vtkHeadlessRenderWindow::EGL : vtkHeadlessRenderWindow::OSMESA);
  window->SetMultiSamples(0);
  compareAll(window, platform);
  testSharedWindow(window);
  compare(synthetic::makeAtlas(), nullptr, 200, "a window of its own");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
