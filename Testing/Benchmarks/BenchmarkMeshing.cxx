// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Remeshing as a whole, and what a slider that moves costs, next to CGAL's isotropic_remeshing.
#include "BenchmarkModels.h"

#include "vtkCDTRemesh.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryRemesher.h"
#include "vtkIdList.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

SurfaceMesh toSurfaceMesh(vtkPolyData* data)
{
  SurfaceMesh mesh;
  double p[3];
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, p);
    mesh.add_vertex({ p[0], p[1], p[2] });
  }
  vtkNew<vtkIdList> cell;
  for (vtkIdType c = 0; c < data->GetNumberOfPolys(); ++c)
  {
    data->GetCellPoints(c, cell);
    const auto v = [&](int k) { return SurfaceMesh::Vertex_index(cell->GetId(k)); };
    mesh.add_face(v(0), v(1), v(2));
  }
  return mesh;
}

/// isotropic_remeshing with five iterations, at the edge length that equilateral triangles of
/// range(0) points have. It does not keep the number of points: see `points`.
void cgalIsotropicRemeshing(benchmark::State& state)
{
  const auto model = benchmarks::readModel("bunny00");
  if (!model)
  {
    state.SkipWithError(benchmarks::NoModel);
    return;
  }
  namespace PMP = CGAL::Polygon_mesh_processing;
  const SurfaceMesh input = toSurfaceMesh(model);
  const double area = CGAL::to_double(PMP::area(input));
  const double length =
    std::sqrt(area / (2. * static_cast<double>(state.range(0))) * 4. / std::sqrt(3.));
  double points = 0;
  for (auto _ : state)
  {
    SurfaceMesh mesh = input;
    PMP::isotropic_remeshing(faces(mesh), length, mesh, PMP::parameters::number_of_iterations(5));
    points = static_cast<double>(mesh.number_of_vertices());
  }
  state.counters["points"] = points;
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
