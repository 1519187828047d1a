// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Halftoning: error diffusion by the pixel, and what a slider that moves costs, from the control
// map to the samples.
#include "BenchmarkModels.h"

#include "ErrorDiffusion.h"

#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryRemesher.h"

#include <benchmark/benchmark.h>

#include <functional>
#include <vector>

namespace
{
/// One map of 512 x 512 pixels at the level 1 / range(0).
void errorDiffusion(benchmark::State& state)
{
  constexpr int size = 512;
  const std::vector<float> wanted(size * size, 1.f / static_cast<float>(state.range(0)));
  std::vector<int> samples;
  for (auto _ : state)
  {
    stipple::diffuseErrors(wanted.data(), size, size, {}, samples);
    benchmark::DoNotOptimize(samples.data());
  }
  state.counters["ns_per_pixel"] = benchmark::Counter(1e-9 * size * size,
    benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(errorDiffusion)->Arg(256)->Arg(64)->Arg(16)->Arg(4)->Unit(benchmark::kMillisecond);

using Change = std::function<void(vtkControlMap*, int)>;

/// The bunny at 5,000 points: changes the control map and asks for new samples and halftones.
void change(benchmark::State& state, int importance, double gradation, const Change& f)
{
  const auto mesh = benchmarks::readModel("bunny00");
  if (!mesh)
  {
    state.SkipWithError(benchmarks::NoModel);
    return;
  }
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(mesh);
  remesher->SetNumberOfPoints(5000);
  remesher->SetImportance(importance);
  remesher->SetGradation(gradation);
  remesher->Update();
  vtkControlMap* control = remesher->GetControlMap();
  int count = 0;
  benchmarks::withThreads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state)
    {
      f(control, ++count);
      remesher->GetSampler()->Update();
    }
  });
  state.counters["megapixels"] =
    1e-6 * benchmarks::pixelsOf(remesher->GetSampler()->GetHalftones());
  state.counters["samples"] =
    static_cast<double>(remesher->GetSampler()->GetOutput()->GetNumberOfPoints());
}

void turnGamma(vtkControlMap* control, int count)
{
  control->SetGamma(count % 2 ? 0.5 : 0.6);
}

BENCHMARK_CAPTURE(change, gamma, vtkControlMap::MEAN, 0., turnGamma)
  ->Arg(1)
  ->Arg(2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(change, gammaWithGradation, vtkControlMap::MEAN, 2., turnGamma)
  ->Arg(2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(change, importance, vtkControlMap::MEAN, 0.,
  [](vtkControlMap* control, int count) {
    control->SetImportance(count % 2 ? vtkControlMap::TOTAL : vtkControlMap::MEAN);
  })
  ->Arg(2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(change, stroke, vtkControlMap::UNIFORM, 0.,
  [](vtkControlMap* control, int count) {
    control->AddStroke(-0.5 + 0.001 * (count % 1000), 0.1, 0., 0.1, 0.02);
  })
  ->Arg(2)
  ->Iterations(50)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
}

BENCHMARK_MAIN();
