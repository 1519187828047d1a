// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Geometry maps: all of the catalogue for the fandisk with 800 pixels along the longer side of
// every chart, and one map of 512 x 512 pixels, on the CPU and on OpenGL.
#include "BenchmarkModels.h"

#include "vtkConformalAtlas.h"
#include "vtkDataArraySelection.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkHeadlessRenderWindow.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace
{
struct Backend
{
  int backend;
  int platform; ///< of a headless window, for OpenGL
};

/// Draws the maps of a model again and again; range(0) is the number of threads.
void maps(benchmark::State& state, const char* model, int size,
  const std::vector<const char*>& names, const Backend& backend)
{
  const auto mesh = benchmarks::readModel(model);
  if (!mesh)
  {
    state.SkipWithError(benchmarks::NoModel);
    return;
  }
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(mesh);
  atlas->Update();
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkGeometryMapRenderer> renderer;
  renderer->SetInputConnection(atlas->GetOutputPort(0));
  renderer->SetMapSize(size);
  renderer->SetBackend(backend.backend);
  if (backend.backend == vtkGeometryMapRenderer::OPENGL)
  {
    window->SetPlatform(backend.platform);
    renderer->SetRenderWindow(window);
  }
  vtkDataArraySelection* selection = renderer->GetMapSelection();
  const auto draw = [&](bool on) {
    selection->DisableAllArrays();
    for (const char* name : names)
    {
      selection->SetArraySetting(name, on);
    }
    if (!on)
    {
      selection->EnableArray("FaceIndex");
      renderer->SetMapSize(size + 1); // what was drawn is forgotten
    }
    else
    {
      renderer->SetMapSize(size);
    }
    renderer->Update();
  };
  draw(true);
  if (renderer->GetOutput()->GetNumberOfPartitionedDataSets() == 0)
  {
    state.SkipWithError("these maps cannot be drawn so");
    return;
  }
  benchmarks::withThreads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state)
    {
      state.PauseTiming();
      draw(false);
      state.ResumeTiming();
      draw(true);
    }
  });
  state.SetLabel(renderer->GetBackendName());
  state.counters["megapixels"] = 1e-6 * benchmarks::pixelsOf(renderer->GetOutput());
  state.counters["maps"] = static_cast<double>(names.size());
}

const std::vector<const char*> Catalogue = { "AreaDistortion", "FaceIndex", "GaussianCurvature",
  "MeanCurvature", "MinimumCurvature", "MaximumCurvature", "TotalCurvature", "Position", "Normal" };
const std::vector<const char*> Default = { "AreaDistortion", "FaceIndex", "GaussianCurvature",
  "MeanCurvature", "MinimumCurvature", "MaximumCurvature", "TotalCurvature" };

#define stippleBenchmarkMaps(name, ...)                                                            \
  BENCHMARK_CAPTURE(maps, name, __VA_ARGS__)                                                       \
    ->Arg(1)                                                                                       \
    ->Arg(2)                                                                                       \
    ->Unit(benchmark::kMillisecond)                                                                \
    ->UseRealTime()

const Backend CPU = { vtkGeometryMapRenderer::CPU, 0 };
const Backend OSMesa = { vtkGeometryMapRenderer::OPENGL, vtkHeadlessRenderWindow::OSMESA };
const Backend EGL = { vtkGeometryMapRenderer::OPENGL, vtkHeadlessRenderWindow::EGL };
stippleBenchmarkMaps(fandisk800AllCPU, "fandisk", 800, Catalogue, CPU);
stippleBenchmarkMaps(fandisk800AllOSMesa, "fandisk", 800, Catalogue, OSMesa);
stippleBenchmarkMaps(fandisk800AllEGL, "fandisk", 800, Catalogue, EGL);
stippleBenchmarkMaps(fandisk800DefaultCPU, "fandisk", 800, Default, CPU);
}

BENCHMARK_MAIN();
