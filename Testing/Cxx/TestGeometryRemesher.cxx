// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The whole pipeline as one filter: which stages a change executes again, exact counts, errors.
#include "vtkGeometryRemesher.h"

#include "vtkCDTRemesh.h"
#include "vtkCallbackCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSphereSource.h"

#include <array>
#include <iostream>
#include <string>

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

void increment(vtkObject*, unsigned long, void* counter, void*)
{
  ++*static_cast<int*>(counter);
}

/// Counts how often each stage of a remesher executes.
class Executions
{
public:
  explicit Executions(vtkGeometryRemesher* remesher)
  {
    const std::array<vtkAlgorithm*, 6> stages = { remesher->GetAtlas(), remesher->GetMapRenderer(),
      remesher->GetControlMap(), remesher->GetSampler(), remesher->GetMesher(),
      remesher->GetOptimizer() };
    for (std::size_t i = 0; i < stages.size(); ++i)
    {
      vtkNew<vtkCallbackCommand> observer;
      observer->SetCallback(increment);
      observer->SetClientData(&this->Counts[i]);
      stages[i]->AddObserver(vtkCommand::StartEvent, observer);
    }
  }
  /// How often the stages executed since the last call: atlas, maps, control, sampler, mesher,
  /// optimiser.
  std::array<int, 6> take()
  {
    const std::array<int, 6> counts = this->Counts;
    this->Counts = {};
    return counts;
  }

private:
  std::array<int, 6> Counts = {};
};

std::string text(const std::array<int, 6>& counts)
{
  std::string s;
  for (int c : counts)
  {
    s += std::to_string(c) + " ";
  }
  return s;
}
}

int TestGeometryRemesher(int, char*[])
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputConnection(sphere->GetOutputPort());
  remesher->SetNumberOfPoints(800);
  remesher->SetImportanceToMean();
  Executions executions(remesher);

  const auto expect = [&](const std::array<int, 6>& wanted, const std::string& after) {
    remesher->Update();
    const std::array<int, 6> counts = executions.take();
    check(counts == wanted, after + " executes " + text(wanted) + "and not " + text(counts));
    check(remesher->GetOutput()->GetNumberOfPoints() == remesher->GetNumberOfPoints(),
      "exact count after " + after);
  };
  expect({ 1, 1, 1, 1, 1, 1 }, "the first update");
  expect({ 0, 0, 0, 0, 0, 0 }, "nothing new");
  remesher->SetGamma(0.5);
  expect({ 0, 0, 1, 1, 1, 1 }, "another gamma");
  remesher->SetMinimumDensity(0.3);
  expect({ 0, 0, 1, 1, 1, 1 }, "another minimum density");
  remesher->SetNumberOfPoints(801);
  expect({ 0, 0, 0, 1, 1, 1 }, "one point more");
  remesher->SetNumberOfIterations(7);
  expect({ 0, 0, 0, 0, 0, 1 }, "other iterations");
  remesher->SetFeatureAngle(30);
  expect({ 1, 1, 1, 1, 1, 1 }, "another feature angle");
  sphere->SetRadius(2);
  expect({ 1, 1, 1, 1, 1, 1 }, "another input");

  // Bad settings end in one error and an empty mesh; good ones work again afterwards.
  int errors = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(increment);
  observer->SetClientData(&errors);
  remesher->AddObserver(vtkCommand::ErrorEvent, observer);
  remesher->SetNumberOfPoints(1);
  remesher->Update();
  check(errors == 1, "too few points are one error");
  check(remesher->GetOutput()->GetNumberOfPoints() == 0, "an error leaves no mesh");
  remesher->SetNumberOfPoints(500);
  remesher->Update();
  check(errors == 1 && remesher->GetOutput()->GetNumberOfPoints() == 500,
    "and is forgotten afterwards");

  // No input cells: no output, no error.
  vtkNew<vtkGeometryRemesher> empty;
  empty->AddObserver(vtkCommand::ErrorEvent, observer);
  vtkNew<vtkPolyData> nothing;
  empty->SetInputData(nothing);
  empty->Update();
  check(errors == 1 && empty->GetOutput()->GetNumberOfPoints() == 0, "an empty input is no error");
  return failures == 0 ? 0 : 1;
}
