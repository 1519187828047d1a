// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkQuadRemesh and vtkSemiRegularSubdivision: what their arrays say, on surfaces made by hand.
#include "Check.h"
#include "SyntheticAtlas.h"

#include "vtkAtlasMeshAlgorithm.h"
#include "vtkCDTRemesh.h"
#include "vtkCellArray.h"
#include "vtkExecutive.h"
#include "vtkGeometryRemesher.h"
#include "vtkPoints.h"
#include "vtkQuadRemesh.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSemiRegularSubdivision.h"
#include "vtkTestErrorObserver.h"

#include <array>
#include <cmath>
#include <set>

namespace
{
using namespace stipple;
using test::check;

void connect(vtkAtlasMeshAlgorithm* filter, synthetic::MadeAtlas& atlas, vtkPolyData* input)
{
  filter->SetInputData(0, input);
  filter->SetInputData(1, atlas.charts.Get());
  filter->SetInputData(2, atlas.graphData);
}

/// What a filter says when it is updated and fails.
std::string errorOf(vtkAlgorithm* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executives;
  const auto id = filter->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto executivesId = filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executives);
  filter->Update();
  filter->RemoveObserver(id);
  filter->GetExecutive()->RemoveObserver(executivesId);
  return observer->GetErrorMessage();
}

/// Every point's position is that of its place on the surface, and its attributes are.
void checkPlaces(const std::string& name, const synthetic::MadeAtlas& atlas, vtkPolyData* mesh)
{
  vtkDataArray* chart = mesh->GetPointData()->GetArray("ChartId");
  vtkDataArray* cell = mesh->GetPointData()->GetArray("ChartCellId");
  vtkDataArray* bary = mesh->GetPointData()->GetArray("BarycentricCoordinates");
  vtkDataArray* height = mesh->GetPointData()->GetArray("Height");
  vtkDataArray* material = mesh->GetCellData()->GetArray("Material");
  check(chart && cell && bary && height && material, name + ": arrays");
  check(material && material->GetNumberOfTuples() == mesh->GetNumberOfCells(),
    name + ": a value a cell");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vec3 b;
    Vec3 p;
    bary->GetTuple(i, b.data());
    mesh->GetPoint(i, p.data());
    const int face = atlas.surface.chartBegin[static_cast<int>(chart->GetTuple1(i))] +
      static_cast<int>(cell->GetTuple1(i));
    check((atlas.surface.position(face, b) - p).norm() < 1e-12, name + ": on the surface");
    check(std::abs(height->GetTuple1(i) - (p.x() + 2. * p.y() + 3. * p.z())) < 1e-12,
      name + ": attributes");
  }
}

void checkSubdivision()
{
  synthetic::Builder b;
  synthetic::cube(b, 1, false);
  synthetic::MadeAtlas& atlas = b.finish();
  vtkNew<vtkCDTRemesh> mesher;
  connect(mesher.Get(), atlas, toPolyData(synthetic::sample(atlas, 80), atlas.surface));
  vtkNew<vtkRemeshOptimizer> optimizer;
  mesher->Update();
  connect(optimizer.Get(), atlas, mesher->GetOutput(0));
  optimizer->Update();
  vtkPolyData* base = optimizer->GetOutput(0);
  vtkNew<vtkSemiRegularSubdivision> subdivision;
  connect(subdivision.Get(), atlas, base);
  check(subdivision->GetNumberOfSubdivisions() == 2, "subdivision: the default");
  subdivision->Update();
  vtkPolyData* mesh = subdivision->GetOutput(0);
  checkPlaces("subdivision", atlas, mesh);
  const vtkIdType n = base->GetNumberOfPoints();
  // Of a closed surface without handles: V = 2 + F / 2.
  check(mesh->GetNumberOfPolys() == 16 * base->GetNumberOfPolys() &&
      mesh->GetNumberOfPoints() == 2 + mesh->GetNumberOfPolys() / 2,
    "subdivision: sixteen triangles for one");
  TriangleSurface surface = fromPolyData(mesh);
  surface.connect();
  check(surface.topology() == atlas.surface.topology(), "subdivision: topology");
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    const Vec3 normal = surface.faceNormal(f);
    const Vec3 outward = surface.point(f, 0) + surface.point(f, 1) + surface.point(f, 2);
    check(normal.cwiseAbs().maxCoeff() > 1. - 1e-9 && normal.dot(outward) > 0,
      "subdivision: no triangle cuts an edge of the cube off, or is folded");
  }
  vtkDataArray* level = mesh->GetPointData()->GetArray("SubdivisionLevel");
  vtkDataArray* parents = mesh->GetPointData()->GetArray("ParentPointIds");
  vtkDataArray* baseCell = mesh->GetCellData()->GetArray("BaseCellId");
  check(level && parents && baseCell, "subdivision: arrays of the hierarchy");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double l = level->GetTuple1(i);
    const double* p = parents->GetTuple2(i);
    const int first = static_cast<int>(p[0]);
    const int second = static_cast<int>(p[1]);
    check((i < n) == (l == 0) && (i < n) == (first < 0), "subdivision: levels");
    if (first >= 0)
    {
      check(first != second && first < i && second < i &&
          std::max(level->GetTuple1(first), level->GetTuple1(second)) < l,
        "subdivision: parents come before");
    }
  }
  check(baseCell->GetRange()[0] == 0 && baseCell->GetRange()[1] == base->GetNumberOfPolys() - 1,
    "subdivision: base cells");
  check(subdivision->GetOutput(1)->GetNumberOfLines() == 12, "subdivision: the cube's edges");
  const TriangleSurface without = fromPolyData(mesh);
  subdivision->SetInputData(3, optimizer->GetOutput(1));
  subdivision->Update();
  check(fromPolyData(subdivision->GetOutput(0)).points == without.points,
    "subdivision: lines where nothing was simplified say nothing new");
  vtkNew<vtkPolyData> lines;
  lines->DeepCopy(optimizer->GetOutput(1));
  lines->GetCellData()->GetArray("BackboneId")->SetComponent(3, 0, 1e6);
  subdivision->SetInputData(3, lines);
  check(errorOf(subdivision).find("BackboneId of line 3") != std::string::npos,
    "subdivision: a backbone that is none");
  lines->GetCellData()->GetArray("BackboneId")->SetComponent(3, 0, 2.);
  lines->Modified();
  check(errorOf(subdivision).find("two lines of backbone 2") != std::string::npos,
    "subdivision: a backbone twice");
  subdivision->RemoveAllInputConnections(3);
  subdivision->SetNumberOfSubdivisions(0);
  subdivision->Update();
  check(subdivision->GetOutput(0)->GetNumberOfPoints() == n, "subdivision: none");
}

void checkQuads()
{
  synthetic::Builder b;
  synthetic::cube(b, 8, true);
  synthetic::MadeAtlas& atlas = b.finish();
  vtkNew<vtkQuadRemesh> quads;
  const std::vector<Sample> samples = synthetic::sample(atlas, 1500);
  connect(quads.Get(), atlas, toPolyData(samples, atlas.surface));
  quads->Update();
  vtkPolyData* mesh = quads->GetOutput(0);
  checkPlaces("quads", atlas, mesh);
  check(mesh->GetNumberOfPoints() == static_cast<vtkIdType>(samples.size()),
    "quads: as many points as samples");
  std::set<std::pair<vtkIdType, vtkIdType>> halfedges;
  vtkIdType size;
  const vtkIdType* ids;
  int count[5] = { 0, 0, 0, 0, 0 };
  for (vtkIdType c = 0; c < mesh->GetNumberOfPolys(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, size, ids);
    check(size == 3 || size == 4, "quads: quads and triangles");
    ++count[size];
    for (vtkIdType k = 0; k < size; ++k)
    {
      check(halfedges.insert({ ids[k], ids[(k + 1) % size] }).second, "quads: oriented, manifold");
    }
  }
  for (const auto& h : halfedges)
  {
    check(halfedges.count({ h.second, h.first }) == 1, "quads: no crack along seams");
  }
  check(count[4] > count[3], "quads: most cells are quads");
  vtkNew<vtkPolyData> nothing;
  connect(quads.Get(), atlas, nothing);
  quads->Update();
  check(quads->GetOutput(0)->GetNumberOfPoints() == 0, "quads: nothing in, nothing out");
}

/// Hills with slopes on the border: the conformal map makes some small, and the sheet's corners
/// none of the rectangle's.
void checkQuadsOfHills()
{
  constexpr int N = 60;
  const auto height = [](double x, double y) {
    return 5. * std::sin(0.13 * x + 0.05 * y) + 4. * std::sin(0.16 * y - 0.07 * x + 2.8) +
      2. * std::sin(0.31 * x + 0.23 * y + 2.) +
      22. * std::exp(-0.02 * (std::pow(x - 20, 2) + std::pow(y - 36, 2)));
  };
  double highest = -1e300;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int j = 0; j <= N; ++j)
  {
    for (int i = 0; i <= N; ++i)
    {
      points->InsertNextPoint(i, j, height(i, j));
      highest = std::max(highest, height(i, j));
    }
  }
  for (vtkIdType j = 0; j < N; ++j)
  {
    for (vtkIdType i = 0; i < N; ++i)
    {
      const vtkIdType a = j * (N + 1) + i;
      for (const auto& t : { std::array<vtkIdType, 3>{ a, a + 1, a + N + 2 },
             std::array<vtkIdType, 3>{ a, a + N + 2, a + N + 1 } })
      {
        cells->InsertNextCell(3, t.data());
      }
    }
  }
  vtkNew<vtkPolyData> sheet;
  sheet->SetPoints(points);
  sheet->SetPolys(cells);
  for (const int number : { 700, 1500, 3000 })
  {
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(sheet);
    remesher->SetNumberOfPoints(number);
    remesher->SetPatternToQuads();
    remesher->Update();
    vtkPolyData* mesh = remesher->GetOutput();
    const std::string name = "quads of hills, " + std::to_string(number) + ": ";
    for (const auto& [x, y] :
      { std::pair(0, 0), std::pair(N, 0), std::pair(0, N), std::pair(N, N) })
    {
      double nearest = 1e300;
      for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
      {
        const double* at = mesh->GetPoint(p);
        nearest = std::min(nearest, std::hypot(at[0] - x, at[1] - y));
      }
      check(nearest < 1e-9, name + "corners are kept, not " + std::to_string(nearest) + " away");
    }
    double bounds[6];
    mesh->GetBounds(bounds);
    check(bounds[5] > highest - 2., name + "the summit is " + std::to_string(bounds[5]));
  }
}
}

int TestPatterns(int, char*[])
{
  checkSubdivision();
  checkQuads();
  checkQuadsOfHills();
  return test::exitStatus();
}
