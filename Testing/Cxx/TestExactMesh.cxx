// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The mesh has exactly the number of points asked for, every constraint is one of them, and it is a
// valid triangulation of the surface: on random draws of shape, number, features and constraints,
// and for every number from the least one on.
//
// --models FOLDER: where the models are. --draws N, --span N: more of both, to look for what fails.
#include "Check.h"
#include "ImageRegression.h"
#include "ModelFile.h"
#include "PolyDataConversion.h"
#include "SmallShapes.h"
#include "TriangleSurface.h"

#include "vtkCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkExecutive.h"
#include "vtkGeometryRemesher.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{
using test::check;

int refused = 0; // numbers that were refused with another one

class Remesher
{
public:
  Remesher()
  {
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  }
  /// What is wrong with the mesh of n points, or nothing.
  std::string remesh(int n)
  {
    this->Errors->Clear();
    this->Filter->SetNumberOfPoints(n);
    this->Filter->Update();
    if (this->Errors->GetError())
    {
      return this->Errors->GetErrorMessage();
    }
    vtkPolyData* mesh = this->Filter->GetOutput();
    if (mesh->GetNumberOfPoints() != n)
    {
      return std::to_string(mesh->GetNumberOfPoints()) + " points";
    }
    stipple::TriangleSurface surface = stipple::fromPolyData(mesh);
    surface.connect();
    const stipple::SurfaceTopology topology = surface.topology();
    vtkConformalAtlas* atlas = this->Filter->GetAtlas();
    if (!topology.manifold || topology.components != atlas->GetNumberOfComponents() ||
      topology.boundaryLoops != atlas->GetNumberOfBoundaryLoops() ||
      topology.euler != atlas->GetEulerCharacteristic())
    {
      return "another topology: " + std::to_string(topology.components) + " components, " +
        std::to_string(topology.boundaryLoops) + " loops, Euler " + std::to_string(topology.euler);
    }
    std::vector<std::array<int, 3>> triangles;
    for (std::array<int, 3> t : surface.triangles)
    {
      std::sort(t.begin(), t.end());
      triangles.push_back(t);
    }
    std::sort(triangles.begin(), triangles.end());
    if (std::adjacent_find(triangles.begin(), triangles.end()) != triangles.end())
    {
      return "a triangle twice";
    }
    return this->missedConstraint(surface);
  }

  vtkNew<vtkGeometryRemesher> Filter;
  vtkNew<vtkTest::ErrorObserver> Errors;
  std::vector<stipple::Vec3> Constraints;

private:
  std::string missedConstraint(const stipple::TriangleSurface& surface) const
  {
    const double diagonal = surface.boundingBoxDiagonal();
    for (const stipple::Vec3& p : this->Constraints)
    {
      double nearest = std::numeric_limits<double>::max();
      for (const stipple::Vec3& q : surface.points)
      {
        nearest = std::min(nearest, (p - q).norm());
      }
      if (nearest > 1e-9 * diagonal)
      {
        return "a constraint is " + std::to_string(nearest / diagonal) + " diagonals from a point";
      }
    }
    return {};
  }
};

/// What is wrong with the mesh of n points, or nothing. A number that charts cannot have is not
/// wrong, if the error says so and names a greater one that works.
std::string remeshOrNamed(Remesher& r, int n)
{
  const std::string wrong = r.remesh(n);
  if (r.Filter->GetErrorCode() != vtkGeometryRemesher::TOO_FEW_POINTS)
  {
    return wrong;
  }
  ++refused;
  const int other = r.Filter->GetLeastNumberOfPoints();
  if (wrong.find("at least " + std::to_string(other)) == std::string::npos)
  {
    return "the sentence names another number than " + std::to_string(other) + ": " + wrong;
  }
  const std::string still = other > n ? r.remesh(other) : "not more";
  return still.empty() ? still
                       : wrong + "; but with " + std::to_string(other) + " points: " + still;
}

/// Places on the surface: inside triangles, on edges, at points, some next to each other.
std::vector<stipple::Vec3> drawConstraints(vtkPolyData* mesh, int count, std::mt19937& engine)
{
  const auto random = [&] { return engine() / 4294967296.; };
  const stipple::TriangleSurface surface = stipple::fromPolyData(mesh);
  std::vector<stipple::Vec3> result;
  while (static_cast<int>(result.size()) < count)
  {
    const int face = static_cast<int>(engine() % surface.triangles.size());
    if (surface.faceArea(face) <= 0)
    {
      continue;
    }
    stipple::Vec3 bary(random(), random(), random());
    const unsigned int kind = engine() % 5;
    if (kind == 0) // a point
    {
      bary = stipple::Vec3::Zero();
    }
    if (kind <= 1) // on an edge
    {
      bary[engine() % 3] = 0;
    }
    bary[engine() % 3] += 1e-3; // for none to be all zero
    bary /= bary.sum();
    result.push_back(surface.position(face, bary));
    if (kind == 4) // and one close by
    {
      bary += 1e-3 * random() * (stipple::Vec3(1., 1., 1.) / 3. - bary);
      result.push_back(surface.position(face, bary));
    }
  }
  return result;
}

void testRandomDraws(int draws)
{
  std::mt19937 engine(1);
  const auto random = [&] { return engine() / 4294967296.; };
  const auto shapes = test::makeShapes();
  const int kinds[] = { vtkControlMap::UNIFORM, vtkControlMap::MEAN, vtkControlMap::ARRAY };
  Remesher r;
  vtkGeometryRemesher* filter = r.Filter;
  filter->GetControlMap()->SetImportanceArrayName("Weight");
  unsigned int shape = 0;
  int constrained = 0;
  for (int draw = 0; draw < draws; ++draw)
  {
    if (draw % 4 == 0)
    {
      shape = engine() % shapes.size();
      filter->SetInputDataObject(shapes[shape]);
      const double angles[] = { 20., 40., 60., 180. };
      filter->SetFeatureAngle(angles[engine() % 4]);
      filter->SetNumberOfCharts(1 + static_cast<int>(engine() % 6));
      r.Constraints = drawConstraints(shapes[shape], static_cast<int>(engine() % 12), engine);
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      for (const stipple::Vec3& p : r.Constraints)
      {
        points->InsertNextPoint(p.data());
      }
      filter->GetAtlas()->SetConstraints(r.Constraints.empty() ? nullptr : points.Get());
      constrained += r.Constraints.empty() ? 0 : 1;
    }
    filter->SetImportance(kinds[engine() % 3]);
    filter->SetNumberOfIterations(engine() % 2 == 0 ? 0 : 5);
    r.remesh(1);
    const int least = filter->GetLeastNumberOfPoints();
    const int n = least +
      (draw % 2 == 0 ? static_cast<int>(engine() % 24)
                     : static_cast<int>(std::pow(10., 1. + 2. * random())));
    const std::string wrong = remeshOrNamed(r, n);
    check(wrong.empty(),
      "draw " + std::to_string(draw) + ": shape " + std::to_string(shape) + ", " +
        std::to_string(n) + " points (least " + std::to_string(least) + "), " +
        std::to_string(r.Constraints.size()) + " constraints, feature angle " +
        std::to_string(filter->GetFeatureAngle()) + ", " +
        std::to_string(filter->GetNumberOfCharts()) + " charts, importance " +
        std::to_string(filter->GetImportance()) + ", " +
        std::to_string(filter->GetNumberOfIterations()) + " iterations: " + wrong);
  }
  check(draws < 100 || constrained > draws / 8, "half of the draws have constraints");
  check(refused <= draws / 200, "few numbers are refused: " + std::to_string(refused));
}

/// Every number from the least on.
void testSmallNumbers(const std::string& folder, const std::vector<std::string>& models, int span,
  const std::vector<int>& charts)
{
  for (const std::string& model : models)
  {
    const auto mesh = test::readOff(folder + "/" + model + ".off");
    if (!check(mesh != nullptr, "read " + model))
    {
      continue;
    }
    Remesher r;
    r.Filter->SetInputDataObject(mesh);
    r.Filter->SetNumberOfIterations(0);
    for (int k : charts)
    {
      r.Filter->SetNumberOfCharts(k);
      for (int importance : { vtkControlMap::UNIFORM, vtkControlMap::MEAN })
      {
        r.Filter->SetImportance(importance);
        const std::string refused = r.remesh(1);
        const int least = r.Filter->GetLeastNumberOfPoints();
        check(refused.find("at least " + std::to_string(least)) != std::string::npos,
          model + ": the error names the least number: " + refused);
        for (int n = least; n <= least + span; ++n)
        {
          const std::string wrong = remeshOrNamed(r, n);
          check(wrong.empty(),
            model + ", " + std::to_string(k) + " charts, importance " + std::to_string(importance) +
              ", " + std::to_string(n) + " points (least " + std::to_string(least) + "): " + wrong);
        }
      }
    }
  }
}
}

int TestExactMesh(int argc, char* argv[])
{
  const std::string folder = test::argument(argc, argv, "--models", "");
  testRandomDraws(std::stoi(test::argument(argc, argv, "--draws", "400")));
  const int span = std::stoi(test::argument(argc, argv, "--span", "20"));
  testSmallNumbers(folder, { "fandisk", "armadillo", "blade" }, span, { 1, 5 });
  testSmallNumbers(folder, { "elephant" }, span, { 4 });
  return test::exitStatus();
}
