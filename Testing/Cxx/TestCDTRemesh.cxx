// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkCDTRemesh: exactly the samples as vertices, the surface's topology and orientation, backbones
// as edges, attributes.
#include "Check.h"
#include "SyntheticAtlas.h"

#include "vtkCDTRemesh.h"
#include "vtkCellArray.h"
#include "vtkSMPTools.h"

#include <cstring>
#include <set>

namespace
{
using test::check;

std::pair<int, int> ordered(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

vtkSmartPointer<vtkCDTRemesh> makeFilter(
  const synthetic::MadeAtlas& atlas, const std::vector<stipple::Sample>& samples)
{
  auto filter = vtkSmartPointer<vtkCDTRemesh>::New();
  filter->SetInputData(0, stipple::toPolyData(samples, atlas.surface));
  filter->SetInputData(1, atlas.charts.Get());
  filter->SetInputData(2, atlas.graphData);
  return filter;
}

void checkMesh(const std::string& name, synthetic::Builder& builder, int n, unsigned int seed = 1)
{
  synthetic::MadeAtlas& atlas = builder.finish();
  check(builder.ok(), name + ": the synthetic atlas is sound");
  const auto samples = synthetic::sample(atlas, n, seed);
  auto filter = makeFilter(atlas, samples);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput(0);
  const stipple::AtlasSurface& surface = atlas.surface;

  check(mesh->GetNumberOfPoints() == static_cast<vtkIdType>(samples.size()),
    name + ": one point a sample");
  stipple::TriangleSurface result = stipple::fromPolyData(mesh);
  result.connect();
  check(result.topology() == surface.topology(), name + ": the surface's topology");
  check(result.topology().manifold, name + ": manifold");
  std::set<std::pair<int, int>> edges;
  double cosine = 0;
  int inner = 0;
  double volume = 0;
  for (int f = 0; f < result.numberOfFaces(); ++f)
  {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int a = result.triangles[f][k];
      const int b = result.triangles[f][(k + 1) % 3];
      edges.insert(ordered(a, b));
      longest = std::max(longest, (result.points[a] - result.points[b]).norm());
    }
    check(result.faceArea(f) > 1e-7 * longest * longest, name + ": no degenerate triangle");
    const stipple::Sample& s = samples[result.triangles[f][0]];
    if (s.kind == stipple::SampleKind::Interior) // others lie on creases, between faces of several
                                                 // normals
    {
      ++inner;
      cosine += result.faceNormal(f).dot(surface.faceNormal(s.face));
    }
    volume += result.point(f, 0).dot(result.point(f, 1).cross(result.point(f, 2)));
  }
  check(cosine >= 0.7 * inner, name + ": oriented like the surface");
  if (surface.topology().boundaryLoops == 0)
  {
    double wanted = 0;
    for (int f = 0; f < surface.numberOfFaces(); ++f)
    {
      wanted += surface.point(f, 0).dot(surface.point(f, 1).cross(surface.point(f, 2)));
    }
    check(volume > 0.5 * wanted, name + ": encloses a volume on the same side");
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto p = surface.position(samples[i].face, samples[i].bary);
    check(
      (result.points[i] - p).norm() < 1e-12, name + ": vertices lie exactly where the samples do");
  }

  vtkPolyData* lines = filter->GetOutput(1);
  check(lines->GetNumberOfLines() == static_cast<vtkIdType>(atlas.graph.backbones.size()),
    name + ": one line a backbone");
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType l = 0; l < lines->GetNumberOfLines(); ++l)
  {
    lines->GetLines()->GetCellAtId(l, size, ids);
    for (vtkIdType k = 1; k < size; ++k)
    {
      check(edges.count(ordered(static_cast<int>(ids[k - 1]), static_cast<int>(ids[k]))) == 1,
        name + ": neighbours on a backbone are joined by an edge");
    }
  }

  vtkDataArray* height = mesh->GetPointData()->GetArray("Height");
  vtkDataArray* label = mesh->GetPointData()->GetArray("Label");
  vtkDataArray* material = mesh->GetCellData()->GetArray("Material");
  check(height && label && material, name + ": attributes arrive");
  if (height && label && material)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const auto& p = result.points[i];
      check(std::abs(height->GetTuple1(i) - (p.x() + 2. * p.y() + 3. * p.z())) < 1e-12,
        name + ": a linear field is reproduced");
      check(
        label->GetTuple1(i) == 7 || label->GetTuple1(i) == 3, name + ": labels are not blended");
    }
    std::vector<double> area(surface.numberOfCharts(), 0);
    std::vector<double> wanted(surface.numberOfCharts(), 0);
    for (int f = 0; f < result.numberOfFaces(); ++f)
    {
      area[static_cast<int>(material->GetTuple1(f))] += result.faceArea(f);
    }
    for (int f = 0; f < surface.numberOfFaces(); ++f)
    {
      wanted[surface.faceChart[f]] += surface.faceArea(f);
    }
    for (std::size_t c = 0; c < area.size(); ++c)
    {
      check(std::abs(area[c] - wanted[c]) < 0.15 * wanted[c],
        name + ": cell data come from under the triangles");
    }
  }
  check(mesh->GetPointData()->GetArray("BarycentricCoordinates") &&
      mesh->GetPointData()->GetArray("SampleKind") && mesh->GetPointData()->GetArray("UV") &&
      mesh->GetPointData()->GetArray("SourceCellId") &&
      mesh->GetPointData()->GetArray("BackboneId") && mesh->GetPointData()->GetArray("ArcLength"),
    name + ": provenance arrays");
}

std::vector<vtkIdType> connectivity(vtkPolyData* mesh)
{
  std::vector<vtkIdType> result;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, size, ids);
    result.insert(result.end(), ids, ids + size);
  }
  return result;
}
}

int TestCDTRemesh(int, char*[])
{
  {
    synthetic::Builder b;
    synthetic::bumpyGrid(b, 2, 20);
    checkMesh("grid", b, 700);
  }
  {
    synthetic::Builder b;
    synthetic::bumpyGrid(b, 2, 20, true);
    checkMesh("creased grid", b, 500);
  }
  for (int n : { 30, 60, 500 }) // few samples: welding repeats edges, and swaps resolve them
  {
    for (unsigned int seed = 1; seed <= 5; ++seed)
    {
      synthetic::Builder b;
      synthetic::cube(b, 12, true);
      checkMesh("sphere of " + std::to_string(n), b, n, seed);
    }
  }
  for (int n : { 8, 100, 800 }) // 8: the corners alone
  {
    synthetic::Builder b;
    synthetic::cube(b, 1, false);
    checkMesh("cube of " + std::to_string(n), b, n);
  }
  for (int n : { 60, 600 })
  {
    synthetic::Builder b;
    synthetic::torus(b, 60, 30);
    checkMesh("torus of " + std::to_string(n), b, n);
  }

  // The same bytes for any number of threads.
  synthetic::Builder b;
  synthetic::cube(b, 12, true);
  synthetic::MadeAtlas& atlas = b.finish();
  const auto samples = synthetic::sample(atlas, 400);
  std::vector<std::vector<vtkIdType>> results;
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    auto filter = makeFilter(atlas, samples);
    filter->Update();
    results.push_back(connectivity(filter->GetOutput(0)));
  }
  check(results[0] == results[1], "one and two threads give the same triangles");

  // Nothing in, nothing out; bad input is refused with an empty output.
  auto filter = makeFilter(atlas, {});
  filter->Update();
  check(filter->GetOutput(0)->GetNumberOfPoints() == 0, "no samples: empty, without an error");
  vtkObject::GlobalWarningDisplayOff();
  const std::vector<stipple::Sample> few(samples.begin(), samples.begin() + 5);
  filter = makeFilter(atlas, few);
  filter->Update();
  check(filter->GetOutput(0)->GetNumberOfPoints() == 0, "nodes without a sample are refused");
  auto wrong = makeFilter(atlas, samples);
  wrong->SetInputData(0, atlas.graphData);
  wrong->Update();
  check(wrong->GetOutput(0)->GetNumberOfPoints() == 0, "points that are no samples are refused");
  return test::exitStatus();
}
