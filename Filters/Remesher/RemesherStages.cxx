// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RemesherStages.h"

#include "vtkDataArraySelection.h"
#include "vtkGeometryRemesher.h"

#include <algorithm>
#include <utility>

namespace stipple
{
RemesherStages::RemesherStages()
{
  this->InOrder = { { this->Atlas, this->MapRenderer, this->ControlMap, this->Sampler, this->Mesher,
    this->Optimizer, this->QuadMesher, this->Subdivider } };
  vtkAlgorithmOutput* charts = this->Atlas->GetOutputPort(0);
  vtkAlgorithmOutput* graph = this->Atlas->GetOutputPort(1);
  this->MapRenderer->SetInputConnection(0, charts);
  this->ControlMap->SetInputConnection(0, this->MapRenderer->GetOutputPort(0));
  this->ControlMap->SetInputConnection(1, charts);
  this->Sampler->SetInputConnection(0, this->ControlMap->GetOutputPort(0));
  this->Sampler->SetInputConnection(1, charts);
  this->ControlMap->SetInputConnection(2, graph);
  this->Sampler->SetInputConnection(2, graph);
  this->Mesher->SetInputConnection(0, this->Sampler->GetOutputPort(0));
  this->Mesher->SetInputConnection(1, charts);
  this->Mesher->SetInputConnection(2, graph);
  this->Optimizer->SetInputConnection(0, this->Mesher->GetOutputPort(0));
  this->Optimizer->SetInputConnection(1, charts);
  this->Optimizer->SetInputConnection(2, graph);
  this->Optimizer->SetInputConnection(3, this->ControlMap->GetOutputPort(0));
  this->QuadMesher->SetInputConnection(0, this->Sampler->GetOutputPort(0));
  this->QuadMesher->SetInputConnection(1, charts);
  this->QuadMesher->SetInputConnection(2, graph);
  this->QuadMesher->SetInputConnection(3, this->ControlMap->GetOutputPort(0));
  this->Subdivider->SetInputConnection(0, this->Optimizer->GetOutputPort(0));
  this->Subdivider->SetInputConnection(1, charts);
  this->Subdivider->SetInputConnection(2, graph);
  this->Subdivider->SetInputConnection(3, this->Optimizer->GetOutputPort(1));
}

int RemesherStages::stageOf(int algorithm)
{
  return algorithm == QuadMeshing ? vtkGeometryRemesher::MESHING
    : algorithm == Subdivision    ? vtkGeometryRemesher::OPTIMISATION
                                  : algorithm;
}

const char* RemesherStages::nameOf(int algorithm)
{
  static constexpr std::array<const char*, NumberOfAlgorithms> Names = { { "atlas", "map renderer",
    "control map", "sampler", "mesher", "optimizer", "quad mesher", "subdivision" } };
  return Names[algorithm];
}

std::array<double, 2> RemesherStages::progressOf(int algorithm) const
{
  static constexpr std::array<double, NumberOfStages + 1> Begin = { { 0., 0.3, 0.4, 0.45, 0.6, 0.7,
    1. } };
  const int stage = stageOf(algorithm);
  std::array<double, 2> range = { { Begin[stage], Begin[stage + 1] } };
  if (this->Pattern == vtkGeometryRemesher::SEMIREGULAR &&
    stage == vtkGeometryRemesher::OPTIMISATION)
  {
    // The base mesh is small.
    constexpr double OfBase = 0.1;
    range[algorithm == Subdivision ? 0 : 1] = range[0] + OfBase * (range[1] - range[0]);
  }
  return range;
}

vtkAlgorithm* RemesherStages::last(int pattern) const
{
  return this->InOrder[pattern == vtkGeometryRemesher::QUADS ? QuadMeshing
      : pattern == vtkGeometryRemesher::SEMIREGULAR          ? Subdivision
                                                             : vtkGeometryRemesher::OPTIMISATION];
}

bool RemesherStages::hasOneEdgeLength() const
{
  vtkControlMap* c = this->ControlMap;
  return this->Pattern == vtkGeometryRemesher::TRIANGLES && c->GetEdgeLength() > 0. &&
    !c->GetSizeArrayName() && c->GetCurvaturePoints() == 0. && c->GetSizeMinimum() == 0. &&
    c->GetSizeMaximum() == 0. && c->GetImportance() == vtkControlMap::UNIFORM &&
    c->GetNumberOfStrokes() == 0;
}

std::vector<std::string> RemesherStages::neededMaps() const
{
  const char* name = this->ControlMap->GetImportanceArrayName();
  const bool projected = this->ControlMap->GetImageProjection() != vtkControlMap::CHART;
  std::vector<std::string> maps{ "AreaDistortion", "FaceIndex" };
  switch (const int importance = this->ControlMap->GetImportance())
  {
    case vtkControlMap::MEAN:
    case vtkControlMap::GAUSSIAN:
    case vtkControlMap::MINIMUM:
    case vtkControlMap::MAXIMUM:
    case vtkControlMap::TOTAL:
    {
      static const char* const curvatures[] = { "MeanCurvature", "GaussianCurvature",
        "MinimumCurvature", "MaximumCurvature", "TotalCurvature" };
      maps.emplace_back(curvatures[importance - vtkControlMap::MEAN]);
      break;
    }
    case vtkControlMap::L2:
      maps.insert(maps.end(), { "MeanCurvature", "GaussianCurvature" });
      break;
    case vtkControlMap::IMAGE:
      maps.insert(maps.end(), projected ? 1 : 0, "Position");
      break;
    case vtkControlMap::ARRAY:
      maps.insert(maps.end(), name ? 1 : 0, name ? name : "");
      break;
    default:
      break;
  }
  const char* sizes = this->ControlMap->GetSizeArrayName();
  maps.insert(maps.end(), sizes ? 1 : 0, sizes ? sizes : "");
  return maps;
}

void RemesherStages::selectMaps()
{
  vtkDataArraySelection* maps = this->MapRenderer->GetMapSelection();
  const std::vector<std::string> needed = this->neededMaps();
  std::vector<std::string> added;
  for (const std::string& map : this->EnabledMaps)
  {
    if (std::find(needed.begin(), needed.end(), map) == needed.end())
    {
      maps->DisableArray(map.c_str());
    }
    else
    {
      added.push_back(map);
    }
  }
  for (const std::string& map : needed)
  {
    if (!maps->ArrayIsEnabled(map.c_str()))
    {
      maps->EnableArray(map.c_str());
      added.push_back(map);
    }
  }
  this->EnabledMaps = std::move(added);
}

vtkMTimeType RemesherStages::timeOfAtlas()
{
  return std::max(this->Atlas->GetOutputDataObject(0)->GetMTime(),
    this->Atlas->GetOutputDataObject(1)->GetMTime());
}

RemesherStages::Made RemesherStages::made()
{
  Made made;
  made.atlas = this->timeOfAtlas();
  this->forEachOutput([&made](vtkDataObject* output) {
    made.outputs.push_back(vtkSmartPointer<vtkDataObject>::Take(output->NewInstance()));
    made.outputs.back()->ShallowCopy(output);
  });
  made.overlaps = this->NumberOfOverlaps;
  made.simplifiedFeatures = this->Optimizer->NumberOfSimplifiedFeatures;
  made.simplifiedFeaturesOfQuads = this->QuadMesher->NumberOfSimplifiedFeatures;
  made.leastNumberOfSamples = this->Sampler->MinimumNumberOfSamples;
  made.samplesOfMaps = this->MapRenderer->GetNumberOfSamples();
  made.samplesOfControl = this->ControlMap->GetNumberOfSamples();
  made.samples = this->Sampler->GetNumberOfSamples();
  made.raises = this->Sampler->GetRaiseNumberOfSamples();
  made.grows = this->ControlMap->GetGrowFromFeatures();
  made.toleranceScale = this->Optimizer->GetFeatureToleranceScale();
  made.sizePlaces = vtkSmartPointer<vtkDoubleArray>::New();
  made.sizePlaces->DeepCopy(this->ControlMap->GetSizePlaces());
  return made;
}

bool RemesherStages::putBack(const Made& made)
{
  if (made.outputs.empty() || made.atlas != this->timeOfAtlas())
  {
    return false;
  }
  // Parameters that differ make their algorithms look out of date: who asks these for more gets
  // the same again.
  this->MapRenderer->SetNumberOfSamples(made.samplesOfMaps);
  this->ControlMap->SetNumberOfSamples(made.samplesOfControl);
  this->ControlMap->SetGrowFromFeatures(made.grows);
  this->ControlMap->SetSizePlaces(made.sizePlaces);
  this->Sampler->SetNumberOfSamples(made.samples);
  this->Sampler->SetRaiseNumberOfSamples(made.raises);
  this->Optimizer->SetFeatureToleranceScale(made.toleranceScale);
  this->NumberOfOverlaps = made.overlaps;
  this->Optimizer->NumberOfSimplifiedFeatures = made.simplifiedFeatures;
  this->QuadMesher->NumberOfSimplifiedFeatures = made.simplifiedFeaturesOfQuads;
  this->Sampler->MinimumNumberOfSamples = made.leastNumberOfSamples;
  auto kept = made.outputs.begin();
  this->forEachOutput([&kept](vtkDataObject* output) { output->ShallowCopy(*kept++); });
  return true;
}
}
