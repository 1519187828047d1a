// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The pipeline's stages, joined.
#include "RemesherStages.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArraySelection.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

using stipple::RemesherStages;

namespace
{
std::set<std::string> enabledMaps(RemesherStages& stages)
{
  vtkDataArraySelection* maps = stages.MapRenderer->GetMapSelection();
  std::set<std::string> result;
  for (int i = 0; i < maps->GetNumberOfArrays(); ++i)
  {
    if (maps->GetArraySetting(i))
    {
      result.insert(maps->GetArrayName(i));
    }
  }
  return result;
}

/// Of what an algorithm is made, all that it comes of.
std::set<vtkAlgorithm*> upstreamOf(vtkAlgorithm* algorithm)
{
  std::set<vtkAlgorithm*> result;
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    if (algorithm->GetNumberOfInputConnections(port) > 0)
    {
      vtkAlgorithm* producer = algorithm->GetInputConnection(port, 0)->GetProducer();
      result.insert(producer);
      result.merge(upstreamOf(producer));
    }
  }
  return result;
}

TEST(RemesherStages, EveryMeshComesOfTheSameSamples)
{
  RemesherStages stages;
  for (const int pattern : { vtkGeometryRemesher::TRIANGLES, vtkGeometryRemesher::QUADS,
         vtkGeometryRemesher::SEMIREGULAR })
  {
    const std::set<vtkAlgorithm*> upstream = upstreamOf(stages.last(pattern));
    for (const int stage : { vtkGeometryRemesher::ATLAS, vtkGeometryRemesher::MAPS,
           vtkGeometryRemesher::CONTROL, vtkGeometryRemesher::SAMPLING })
    {
      EXPECT_EQ(upstream.count(stages.InOrder[stage]), 1u)
        << pattern << " " << RemesherStages::nameOf(stage);
    }
    EXPECT_EQ(upstream.count(stages.Mesher), pattern == vtkGeometryRemesher::QUADS ? 0u : 1u);
    EXPECT_EQ(
      upstream.count(stages.Optimizer), pattern == vtkGeometryRemesher::SEMIREGULAR ? 1u : 0u);
  }
  EXPECT_EQ(stages.last(vtkGeometryRemesher::TRIANGLES), stages.Optimizer);
  EXPECT_EQ(stages.last(vtkGeometryRemesher::QUADS), stages.QuadMesher);
  EXPECT_EQ(stages.last(vtkGeometryRemesher::SEMIREGULAR), stages.Subdivider);
}

TEST(RemesherStages, ProgressGoesOnFromStageToStage)
{
  const auto expectWhole = [](const std::vector<int>& algorithms, int pattern) {
    RemesherStages stages;
    stages.Pattern = pattern;
    double reached = 0;
    for (const int algorithm : algorithms)
    {
      const auto [begin, end] = stages.progressOf(algorithm);
      EXPECT_DOUBLE_EQ(begin, reached) << RemesherStages::nameOf(algorithm);
      EXPECT_GT(end, begin) << RemesherStages::nameOf(algorithm);
      reached = end;
    }
    EXPECT_DOUBLE_EQ(reached, 1.);
  };
  expectWhole({ 0, 1, 2, 3, 4, 5 }, vtkGeometryRemesher::TRIANGLES);
  expectWhole({ 0, 1, 2, 3, RemesherStages::QuadMeshing, 5 }, vtkGeometryRemesher::QUADS);
  expectWhole({ 0, 1, 2, 3, 4, 5, RemesherStages::Subdivision }, vtkGeometryRemesher::SEMIREGULAR);
}

TEST(RemesherStages, MapsAreThoseOfTheImportance)
{
  RemesherStages stages;
  stages.MapRenderer->GetMapSelection()->DisableAllArrays();
  stages.MapRenderer->GetMapSelection()->EnableArray("Position"); // a caller's own
  const std::set<std::string> always = { "AreaDistortion", "FaceIndex", "Position" };
  const auto selected = [&](const std::set<std::string>& more) {
    stages.selectMaps();
    std::set<std::string> wanted = always;
    wanted.insert(more.begin(), more.end());
    EXPECT_EQ(enabledMaps(stages), wanted);
  };
  stages.ControlMap->SetImportanceToUniform();
  selected({});
  stages.ControlMap->SetImportanceToL2();
  selected({ "MeanCurvature", "GaussianCurvature" });
  stages.ControlMap->SetImportanceToMean();
  selected({ "MeanCurvature" });
  stages.ControlMap->SetImportanceToArray();
  stages.ControlMap->SetImportanceArrayName("Heat");
  stages.ControlMap->SetSizeArrayName("Length");
  selected({ "Heat", "Length" });
  // What a caller selected is not taken back with what was added.
  stages.ControlMap->SetSizeArrayName(nullptr);
  stages.ControlMap->SetImportanceToImage();
  stages.ControlMap->SetImageProjection(vtkControlMap::Z_AXIS);
  selected({});
  stages.ControlMap->SetImportanceToUniform();
  selected({});
}

TEST(RemesherStages, WhatWasMadeIsPutBackAsItWas)
{
  RemesherStages stages;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(20);
  sphere->Update();
  stages.Atlas->SetInputDataObject(0, sphere->GetOutput());
  stages.selectMaps();
  const auto make = [&](int points) {
    stages.MapRenderer->SetNumberOfSamples(points);
    stages.ControlMap->SetNumberOfSamples(points);
    stages.Sampler->SetNumberOfSamples(points);
    stages.Optimizer->Update();
  };
  EXPECT_FALSE(stages.putBack(RemesherStages::Made())) << "nothing was made";
  make(200);
  stages.NumberOfOverlaps = 7;
  const RemesherStages::Made made = stages.made();
  stages.NumberOfOverlaps = 9;
  const int least = stages.Sampler->GetMinimumNumberOfSamples();
  vtkNew<vtkPolyData> first;
  first->DeepCopy(stages.Optimizer->GetOutput());
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(4);
  places->InsertNextTuple4(0.5, 0., 0., 0.05);
  stages.ControlMap->SetSizePlaces(places);
  make(300);
  ASSERT_EQ(stages.Optimizer->GetOutput()->GetNumberOfPoints(), 300);

  const auto expectFirst = [&] {
    vtkPolyData* mesh = stages.Optimizer->GetOutput();
    ASSERT_EQ(mesh->GetNumberOfPoints(), first->GetNumberOfPoints());
    ASSERT_EQ(mesh->GetNumberOfCells(), first->GetNumberOfCells());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        ASSERT_EQ(mesh->GetPoint(i)[k], first->GetPoint(i)[k]) << i;
      }
    }
  };
  ASSERT_TRUE(stages.putBack(made));
  expectFirst();
  EXPECT_EQ(stages.NumberOfOverlaps, 7);
  EXPECT_EQ(stages.Sampler->GetMinimumNumberOfSamples(), least);
  EXPECT_EQ(stages.Sampler->GetOutput()->GetNumberOfPoints(), 200);
  EXPECT_EQ(stages.ControlMap->GetSizePlaces()->GetNumberOfTuples(), 0);
  // Who asks an algorithm for it once more gets it.
  stages.Optimizer->Update();
  expectFirst();

  stages.Atlas->SetNumberOfCharts(9);
  make(200);
  EXPECT_FALSE(stages.putBack(made)) << "on other charts";
}
}
