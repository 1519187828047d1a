// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The number of samples is the number asked for: on a thousand random draws of shape, number,
// importance, gamma, features and constraints, and from 100 to 500,000 on real models.
//
// --models FOLDER: where the models are.
#include "Check.h"
#include "ImageRegression.h"
#include "ModelFile.h"
#include "SmallShapes.h"

#include "vtkCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkExecutive.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkIntArray.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace
{
using test::check;

/// From the surface to the samples.
class Pipeline
{
public:
  Pipeline()
  {
    this->Maps->SetInputConnection(0, this->Atlas->GetOutputPort(0));
    this->Maps->SetBackendToCPU();
    this->Maps->GetMapSelection()->EnableArray("Weight");
    this->Control->SetInputConnection(0, this->Maps->GetOutputPort(0));
    this->Control->SetInputConnection(1, this->Atlas->GetOutputPort(0));
    this->Control->SetImportanceArrayName("Weight");
    this->Sampler->SetInputConnection(0, this->Control->GetOutputPort(0));
    this->Sampler->SetInputConnection(1, this->Atlas->GetOutputPort(0));
    this->Sampler->SetInputConnection(2, this->Atlas->GetOutputPort(1));
    for (vtkAlgorithm* stage :
      std::initializer_list<vtkAlgorithm*>{ this->Atlas, this->Maps, this->Control, this->Sampler })
    {
      stage->AddObserver(vtkCommand::ErrorEvent, this->Errors);
      stage->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    }
  }
  /// Number of samples, or -1 on an error.
  vtkIdType sample(int n)
  {
    this->Errors->Clear();
    this->Maps->SetNumberOfSamples(n);
    this->Sampler->SetNumberOfSamples(n);
    this->Sampler->Update();
    return this->Errors->GetError() ? -1 : this->Sampler->GetOutput()->GetNumberOfPoints();
  }

  vtkNew<vtkConformalAtlas> Atlas;
  vtkNew<vtkGeometryMapRenderer> Maps;
  vtkNew<vtkControlMap> Control;
  vtkNew<vtkErrorDiffusionSampler> Sampler;
  vtkNew<vtkTest::ErrorObserver> Errors;
};

std::string describe(int draw, int shape, int n, Pipeline& p)
{
  return "draw " + std::to_string(draw) + " (shape " + std::to_string(shape) + ", N " +
    std::to_string(n) + ", importance " + std::to_string(p.Control->GetImportance()) + ", gamma " +
    std::to_string(p.Control->GetGamma()) + ", feature angle " +
    std::to_string(p.Atlas->GetFeatureAngle()) + ")" +
    (p.Errors->GetError() ? ": " + p.Errors->GetErrorMessage() : "");
}

void testRandomDraws(int draws)
{
  std::mt19937 engine(2002);
  const auto random = [&] { return engine() / 4294967296.; };
  const auto shapes = test::makeShapes();
  const int kinds[] = { vtkControlMap::UNIFORM, vtkControlMap::MEAN, vtkControlMap::GAUSSIAN,
    vtkControlMap::MAXIMUM, vtkControlMap::TOTAL, vtkControlMap::L2, vtkControlMap::ARRAY };
  int tooFew = 0;
  Pipeline p;
  int shape = 0;
  for (int draw = 0; draw < draws; ++draw)
  {
    if (draw % 8 == 0) // another surface; in between its atlas serves again
    {
      shape = static_cast<int>(engine() % shapes.size());
      p.Atlas->SetInputDataObject(shapes[shape]);
      const double angles[] = { 20., 40., 60., 180. };
      p.Atlas->SetFeatureAngle(angles[engine() % 4]);
      p.Atlas->SetNumberOfCharts(1 + static_cast<int>(engine() % 6));
      vtkNew<vtkPoints> constraints;
      for (unsigned int k = engine() % 6; k > 0; --k)
      {
        const double* at = shapes[shape]->GetPoint(engine() % shapes[shape]->GetNumberOfPoints());
        constraints->InsertNextPoint(
          at[0] + 0.1 * random(), at[1] + 0.1 * random(), at[2] + 0.1 * random());
      }
      p.Atlas->SetConstraints(constraints->GetNumberOfPoints() > 0 ? constraints.Get() : nullptr);
    }
    p.Control->SetImportance(kinds[engine() % 7]);
    p.Control->SetGamma(0.25 * static_cast<double>(engine() % 13));
    p.Control->SetMinimumDensity(engine() % 3 == 0 ? 0. : 0.1 * random());
    p.Control->SetGradation(engine() % 10 == 0 ? 5. * random() : 0.);
    int n = static_cast<int>(std::pow(10., 1. + 3.3 * random()));
    vtkIdType got = p.sample(n);
    const int least = p.Sampler->GetMinimumNumberOfSamples();
    if (n < least)
    {
      ++tooFew;
      check(got < 0 &&
          p.Errors->GetErrorMessage().find("at least " + std::to_string(least)) !=
            std::string::npos,
        "too few is an error that names the least number: " + describe(draw, shape, n, p));
      n = least;
      got = p.sample(n);
    }
    if (!check(got == n, std::to_string(got) + " samples: " + describe(draw, shape, n, p)))
    {
      continue;
    }
    // Constraints are among them: moved to the surface, so that only their number can be told.
    auto* kind =
      vtkIntArray::SafeDownCast(p.Sampler->GetOutput()->GetPointData()->GetArray("SampleKind"));
    vtkIdType constrained = 0;
    for (vtkIdType i = 0; i < n; ++i)
    {
      constrained += kind->GetValue(i) == 3;
    }
    check(constrained <=
        (p.Atlas->GetConstraints() ? p.Atlas->GetConstraints()->GetNumberOfPoints() : 0),
      "no constraint of our own: " + describe(draw, shape, n, p));
  }
  std::cout << draws << " draws, " << tooFew << " of them below the least number\n";
  check(tooFew > draws / 100 && tooFew < draws / 2, "draws on both sides of the least number");
}

void testModels(const std::string& folder)
{
  for (const std::string model : { "fandisk", "elephant", "bunny00", "armadillo" })
  {
    const auto mesh = test::readOff(folder + "/" + model + ".off");
    if (!check(mesh != nullptr, "read " + model))
    {
      continue;
    }
    test::addWeight(mesh);
    Pipeline p;
    p.Atlas->SetInputDataObject(mesh);
    for (int importance : { vtkControlMap::UNIFORM, vtkControlMap::MEAN })
    {
      p.Control->SetImportance(importance);
      for (int n : { 100, 1000, 5000, 50000, 500000 })
      {
        vtkIdType got = p.sample(n);
        const int least = p.Sampler->GetMinimumNumberOfSamples();
        if (n < least)
        {
          std::cout << model << " needs " << least << " samples\n";
          check(n == 100, model + ": only a hundred is too few");
          n = least;
          got = p.sample(n);
        }
        check(got == n,
          model + ": " + std::to_string(got) + " samples for " + std::to_string(n) + " " +
            p.Errors->GetErrorMessage());
      }
    }
  }
}
}

int TestExactNumber(int argc, char* argv[])
{
  testRandomDraws(1000);
  testModels(test::argument(argc, argv, "--models", ""));
  return test::exitStatus();
}
