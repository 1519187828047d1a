// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The atlas of the bunny (75,000 triangles), and of the bunny subdivided to 1.2 million, next to
// CGAL's isotropic_remeshing of the bunny.
#include "BenchmarkModels.h"
#include "CgalRemeshing.h"

#include "vtkConformalAtlas.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkPartitionedDataSetCollection.h"

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
  const benchmarks::CgalRemeshing remeshing(model, 5000);
  for (auto _ : state)
  {
    state.counters["points"] = remeshing.run();
  }
}
BENCHMARK(cgalIsotropicRemeshing)->Unit(benchmark::kMillisecond)->UseRealTime();

/// range(0): subdivisions; range(1): charts asked for.
void atlas(benchmark::State& state)
{
  vtkSmartPointer<vtkPolyData> model = benchmarks::readModel("bunny00");
  if (!model)
  {
    state.SkipWithError(benchmarks::NoModel);
    return;
  }
  if (state.range(0) > 0)
  {
    vtkNew<vtkLoopSubdivisionFilter> subdivision;
    subdivision->SetInputData(model);
    subdivision->SetNumberOfSubdivisions(static_cast<int>(state.range(0)));
    subdivision->Update();
    model = subdivision->GetOutput();
  }
  vtkNew<vtkConformalAtlas> filter;
  filter->SetInputData(model);
  filter->SetNumberOfCharts(static_cast<int>(state.range(1)));
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.counters["triangles"] = static_cast<double>(model->GetNumberOfPolys());
  state.counters["charts"] = filter->GetOutput()->GetNumberOfPartitionedDataSets();
}
BENCHMARK(atlas)
  ->Args({ 0, 1 })
  ->Args({ 0, 6 })
  ->Args({ 2, 1 })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
}

BENCHMARK_MAIN();
