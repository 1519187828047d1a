// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Remeshing as a whole, and what a slider that moves costs, next to CGAL's isotropic_remeshing.
#include "BenchmarkModels.h"
#include "CgalRemeshing.h"

#include "vtkCDTRemesh.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryRemesher.h"

#include <benchmark/benchmark.h>

namespace
{
void cgalIsotropicRemeshing(benchmark::State& state)
{
  const auto model = benchmarks::readModel("bunny00");
  if (!model)
  {
    state.SkipWithError(benchmarks::NoModel);
    return;
  }
  const benchmarks::CgalRemeshing remeshing(model, static_cast<double>(state.range(0)));
  for (auto _ : state)
  {
    state.counters["points"] = remeshing.run();
  }
}
BENCHMARK(cgalIsotropicRemeshing)->Arg(5000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// All stages, from the input to the optimised mesh.
void firstRemesh(benchmark::State& state)
{
  const auto model = benchmarks::readModel("bunny00");
  if (!model)
  {
    state.SkipWithError(benchmarks::NoModel);
    return;
  }
  for (auto _ : state)
  {
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(model);
    remesher->SetNumberOfPoints(static_cast<int>(state.range(0)));
    remesher->Update();
    state.counters["points"] = static_cast<double>(remesher->GetOutput()->GetNumberOfPoints());
  }
}
BENCHMARK(firstRemesh)->Arg(5000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A new gamma, to the optimised mesh.
void remeshAfterGamma(benchmark::State& state)
{
  const auto model = benchmarks::readModel("bunny00");
  if (!model)
  {
    state.SkipWithError(benchmarks::NoModel);
    return;
  }
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(model);
  remesher->SetNumberOfPoints(static_cast<int>(state.range(0)));
  remesher->SetImportanceToTotal();
  remesher->Update();
  int count = 0;
  double seconds[3] = { 0, 0, 0 };
  for (auto _ : state)
  {
    remesher->SetGamma(++count % 2 ? 0.5 : 0.6);
    remesher->Update();
    seconds[0] += remesher->GetStageSeconds(vtkGeometryRemesher::SAMPLING);
    seconds[1] += remesher->GetStageSeconds(vtkGeometryRemesher::MESHING);
    seconds[2] += remesher->GetStageSeconds(vtkGeometryRemesher::OPTIMISATION);
  }
  state.counters["sampling_ms"] = 1e3 * seconds[0] / count;
  state.counters["meshing_ms"] = 1e3 * seconds[1] / count;
  state.counters["optimisation_ms"] = 1e3 * seconds[2] / count;
}
BENCHMARK(remeshAfterGamma)->Arg(5000)->Arg(50000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Constrained Delaunay triangulation, lift and stitching of samples that are there.
void triangulateAndLift(benchmark::State& state)
{
  const auto model = benchmarks::readModel("bunny00");
  if (!model)
  {
    state.SkipWithError(benchmarks::NoModel);
    return;
  }
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(model);
  remesher->SetNumberOfPoints(static_cast<int>(state.range(0)));
  remesher->Update();
  for (auto _ : state)
  {
    remesher->GetMesher()->Modified();
    remesher->GetMesher()->Update();
  }
}
BENCHMARK(triangulateAndLift)->Arg(3000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK_MAIN();
