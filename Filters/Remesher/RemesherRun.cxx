// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RemesherRun.h"

#include "DensityArray.h"
#include "FeatureGraph.h"
#include "MeshCheck.h"
#include "MessageText.h"
#include "PolyDataConversion.h"
#include "ReportingThread.h"
#include "SamplingConstants.h"
#include "SurfaceDeviation.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkGeometryRemesher.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace stipple
{
namespace
{
using Remesher = vtkGeometryRemesher;

/// Where edges are too long for a mesh to be sound or beautiful, shorter ones are asked for at so
/// many triangles at most, as a share of all.
constexpr double RefinedShare = 0.01;
/// Times that samples are taken anew for edges this much shorter where their mesh passes through
/// itself. Of 33 parts a third time left more such places on 12 and fewer on 13.
constexpr int MostDrafts = 2;
constexpr double DraftShare = 0.5;
}

RemesherRun::RemesherRun(RunCallbacks callbacks)
  : Runner(this->Stages, std::move(callbacks))
{
  this->Places->SetNumberOfComponents(4);
  this->Overlapping->SetNumberOfComponents(4);
}

void RemesherRun::begin(int pattern)
{
  this->Stages.Pattern = pattern;
  this->Stages.NumberOfOverlaps = 0;
  this->Runner.clearSeconds();
  this->Runner.setProgressRange(0., 1.);
  this->IsTried = false;
  this->FarthestFeature = 0.;
}

Status RemesherRun::takeInput(vtkPolyData* input, const std::string& selection)
{
  if (!selection.empty() && this->Stages.Pattern != Remesher::TRIANGLES)
  {
    return Status::error("A selected part can be remeshed with triangles only.");
  }
  vtkControlMap* control = this->Stages.ControlMap;
  if (control->GetImportance() == vtkControlMap::ARRAY)
  {
    if (Status status = checkDensityArray(input, control->GetImportanceArrayName()); !status.ok())
    {
      return status;
    }
  }
  if (Status status = checkSizeArray(input, control->GetSizeArrayName()); !status.ok())
  {
    return status;
  }
  if (this->Input == input && this->InputTime == input->GetMTime() && this->Selection == selection)
  {
    return Status::success();
  }
  this->Input = nullptr;
  this->Part = SelectedPart();
  if (!selection.empty())
  {
    if (Status status = this->Part.split(input, selection); !status.ok())
    {
      return status;
    }
  }
  vtkNew<vtkPolyData> copy; // the atlas must not lead upstream of the filter
  copy->ShallowCopy(selection.empty() ? input : this->Part.part());
  this->Stages.Atlas->SetInputDataObject(0, copy);
  if (!selection.empty() || !this->Selection.empty())
  {
    this->Stages.Atlas->SetFixedEdges(this->Part.borderEdges());
  }
  this->Input = input;
  this->InputTime = input->GetMTime();
  this->Selection = selection;
  return Status::success();
}

Status RemesherRun::remesh(int points)
{
  this->Points = points;
  this->IsTried = false;
  return this->refine();
}

Status RemesherRun::tryNumber(int points)
{
  this->Points = points;
  this->IsTried = true;
  const double from = this->Runner.progressEnd();
  this->Runner.setProgressRange(from, 0.5 * (1. + from));
  return this->refine();
}

void RemesherRun::boundFeatures(double farthest, double area)
{
  this->FarthestFeature = farthest;
  this->Area = area;
}

/// Makes a sound mesh, and another one, of shorter edges where they are too long (coarsePlaces()).
/// That one is kept if it has fewer such places, and is no farther from the surface than shows, or
/// than the first one.
Status RemesherRun::refine()
{
  this->Places->SetNumberOfTuples(0);
  this->Overlapping->SetNumberOfTuples(0);
  if (Status status = this->makeSound(); !status.ok())
  {
    return status;
  }
  vtkNew<vtkDoubleArray> poor;
  poor->SetNumberOfComponents(4);
  CoarsePlaceCount count;
  if (Status status =
        this->findPlaces(this->mesh(), this->finestShare(), this->Overlapping, poor, count);
      !status.ok())
  {
    return status;
  }
  this->Stages.NumberOfOverlaps = count.overlaps;
  // Where sizes do not grow, they do not from places either; where features have less than they ask
  // for, or the places are all over, points for them would be missed by others as poor.
  if (count.triangles == 0 || !this->sizesGrow() || !this->Stages.ControlMap->GetHasGrownInFull() ||
    count.triangles > RefinedShare * static_cast<double>(this->mesh()->GetNumberOfCells()))
  {
    return Status::success();
  }
  double distance = 0.;
  if (Status status = this->measureVisibleDistance(distance); !status.ok())
  {
    return status;
  }
  const RemesherStages::Made first = this->Stages.made();
  this->Places->DeepCopy(poor);
  const Status second = this->makeSound();
  if (second.isAbort())
  {
    return second;
  }
  if (second.ok())
  {
    CoarsePlaceCount left;
    if (Status status = this->findPlaces(this->mesh(), this->finestShare(), nullptr, nullptr, left);
        !status.ok())
    {
      return status;
    }
    if (left < count)
    {
      double distanceLeft = 0.;
      if (Status status = this->measureVisibleDistance(distanceLeft); !status.ok())
      {
        return status;
      }
      if (distanceLeft <= distance)
      {
        this->Stages.NumberOfOverlaps = left.overlaps;
        return Status::success();
      }
    }
  }
  if (this->Stages.putBack(first))
  {
    return Status::success();
  }
  this->Places->SetNumberOfTuples(0);
  this->Overlapping->SetNumberOfTuples(0);
  return this->makeSound();
}

/// Makes meshes until one is sound: with features that move less, then with sizes that do not grow,
/// then on finer charts.
Status RemesherRun::makeSound()
{
  RemesherStages& s = this->Stages;
  this->IsUnsound = false;
  // Features of a base mesh may move as far as the mesh that it is subdivided to is fine; if no
  // sound one comes of that, as far as the base mesh is fine, or not at all.
  const bool isSplit = s.Pattern == Remesher::SEMIREGULAR;
  const int splits = isSplit ? s.Subdivider->GetNumberOfSubdivisions() : 0;
  const double finest = std::min(std::pow(0.5, splits), this->largestToleranceScale());
  double toleranceScale = finest; // of features that the optimiser simplifies
  bool mayGrow = true;            // sizes may
  std::vector<double> otherScales =
    splits > 0 ? std::vector<double>{ 0., 1. } : std::vector<double>();
  int level = 0;
  Status soundness = Status::success(); // of the mesh before
  for (;;)
  {
    s.Atlas->SetRefinementLevel(level);
    if (Status status = this->runStages(mayGrow, toleranceScale); !status.ok())
    {
      // Maps that differ in density by more than numbers can tell places apart: other charts do.
      if (status.code() == StatusCode::Internal && level < s.Atlas->GetRefinementLevelMaxValue())
      {
        ++level;
        continue;
      }
      // A number that other charts and sizes ask for says nothing about those before.
      this->IsUnsound = status.code() == StatusCode::TooFewPoints && !soundness.ok();
      return this->IsUnsound ? soundness : status;
    }
    soundness = this->check(s.last(isSplit ? Remesher::TRIANGLES : s.Pattern));
    if (soundness.ok() && isSplit)
    {
      if (Status status = this->subdivide(); !status.ok())
      {
        return status;
      }
      soundness = this->check(s.Subdivider);
    }
    if (soundness.ok() || soundness.isAbort())
    {
      return soundness;
    }
    if (!otherScales.empty())
    {
      toleranceScale = otherScales.back();
      otherScales.pop_back();
      continue;
    }
    toleranceScale = finest;
    const bool hasGrown = s.ControlMap->GetHasGrown();
    if (!hasGrown && level == s.Atlas->GetRefinementLevelMaxValue())
    {
      this->IsUnsound = true;
      return soundness;
    }
    mayGrow = mayGrow && !hasGrown;
    level += hasGrown ? 0 : 1;
  }
}

/// All stages but the subdivision, which goes on from a sound mesh.
Status RemesherRun::runStages(bool mayGrow, double toleranceScale)
{
  RemesherStages& s = this->Stages;
  s.Atlas->SetMeasureNormalCurvature(s.ControlMap->GetCurvaturePoints() > 0.);
  if (Status status = this->run(Remesher::ATLAS); !status.ok())
  {
    return status;
  }
  s.selectMaps();
  // Where sizes are to be alike, or triangles in rows, they do not grow from features.
  const bool hasQuads = s.Pattern == Remesher::QUADS;
  s.ControlMap->SetGrowFromFeatures(
    mayGrow && s.Optimizer->GetFollowDensity() && !s.Optimizer->GetRibs() && !hasQuads);
  s.ControlMap->SetSizePlaces(this->Places);
  s.ControlMap->SetFollowImportance(s.Optimizer->GetFollowDensity() || hasQuads);
  if (Status status = this->takeSamples(); !status.ok())
  {
    return status;
  }
  if (hasQuads)
  {
    s.QuadMesher->SetFeatureTolerance(s.Optimizer->GetFeatureTolerance());
    return this->run(RemesherStages::QuadMeshing);
  }
  if (Status status = this->run(Remesher::MESHING); !status.ok())
  {
    return status;
  }
  if (Status status = this->partSheets(); !status.ok())
  {
    return status;
  }
  s.Optimizer->SetFeatureToleranceScale(toleranceScale);
  s.Optimizer->SetRefineFaults(this->sizesGrow());
  return this->run(Remesher::OPTIMISATION);
}

/// From maps to samples. Also finds how many there will be.
Status RemesherRun::takeSamples()
{
  RemesherStages& s = this->Stages;
  const int most = s.Sampler->GetNumberOfSamplesMaxValue();
  const bool isByLength = (s.ControlMap->GetEdgeLength() > 0. && !this->IsTried) ||
    ((s.ControlMap->GetSizeArrayName() || s.ControlMap->GetCurvaturePoints() > 0.) &&
      this->Points == 0);
  // By lengths: about so many; the control says it exactly.
  int points = this->Points > 0
    ? this->Points + this->numberOfGivenPoints()
    : static_cast<int>(std::min<vtkIdType>(s.Atlas->GetNumberOfSurfacePoints(), most));
  for (bool isFirst = true;; isFirst = false)
  {
    s.MapRenderer->SetNumberOfSamples(points);
    s.ControlMap->SetNumberOfSamples(isByLength ? 0 : points);
    for (const int stage : { Remesher::MAPS, Remesher::CONTROL })
    {
      if (Status status = this->run(stage); !status.ok())
      {
        return status;
      }
    }
    const double wanted = isByLength ? s.ControlMap->GetNumberOfWantedSamples() : points;
    if (wanted > most)
    {
      return Status::error("Edges of these lengths take " + countText(wanted) +
        " points, more than " + std::to_string(most) + ": ask for longer ones.");
    }
    const int before = points;
    points = std::max(1, static_cast<int>(std::lround(wanted)));
    if (!isFirst || points <= before) // maps are fine enough
    {
      break;
    }
  }
  s.Sampler->SetNumberOfSamples(points);
  s.Sampler->SetRaiseNumberOfSamples(this->Points == 0 || isByLength || this->IsTried);
  return this->run(Remesher::SAMPLING);
}

/// Samples and their mesh are made in a fraction of the time that it takes to optimise one: where
/// it passes through itself, they are made anew with shorter edges.
Status RemesherRun::partSheets()
{
  RemesherStages& s = this->Stages;
  const vtkIdType all = this->Overlapping->GetNumberOfTuples();
  for (int i = 0; all > 0 && i < MostDrafts && s.ControlMap->GetHasGrownInFull(); ++i)
  {
    vtkNew<vtkDoubleArray> places;
    places->DeepCopy(s.ControlMap->GetSizePlaces());
    CoarsePlaceCount count;
    if (Status status = this->findPlaces(s.Mesher->GetOutput(), DraftShare, places, nullptr, count);
        !status.ok())
    {
      return status;
    }
    if (count.overlaps == 0 && i > 0)
    {
      break;
    }
    // What comes up later is not seen here.
    const vtkIdType later = count.overlaps == 0 ? all : 0;
    places->InsertTuples(places->GetNumberOfTuples(), later, 0, this->Overlapping);
    s.ControlMap->SetSizePlaces(places);
    if (Status status = this->takeSamples(); !status.ok())
    {
      return status;
    }
    if (Status status = this->run(Remesher::MESHING); !status.ok())
    {
      return status;
    }
  }
  return Status::success();
}

Status RemesherRun::subdivide()
{
  RemesherStages& s = this->Stages;
  // Each level has four times the triangles, and about four times the points.
  const double points = static_cast<double>(s.Optimizer->GetOutput()->GetNumberOfPoints()) *
    std::pow(4., s.Subdivider->GetNumberOfSubdivisions());
  const int most = s.Sampler->GetNumberOfSamplesMaxValue();
  if (points > most)
  {
    return Status::error("The mesh would have some " + countText(twoDigits(points)) +
      " points, of which there can be " + std::to_string(most) +
      ": ask for fewer, or for fewer subdivisions.");
  }
  return this->run(RemesherStages::Subdivision);
}

Status RemesherRun::run(int algorithm)
{
  const Status status = this->Runner.run(algorithm);
  if (status.code() != StatusCode::TooFewPoints || this->Part.numberOfBorderPoints() == 0)
  {
    return status;
  }
  const int least = this->leastNumberOfPoints();
  return least > 0
    ? Status::tooFewPoints("The selected part has no mesh of " + std::to_string(this->Points) +
        " new points: ask for at least " + std::to_string(least) + ".")
    : status;
}

Status RemesherRun::withAtlas(const std::function<Status(const Atlas&, const Progress&)>& work)
{
  Atlas::Pointer atlas; // the one that the stages share
  if (Status status = Atlas::read(
        vtkPartitionedDataSetCollection::SafeDownCast(this->Stages.Atlas->GetOutputDataObject(0)),
        vtkPolyData::SafeDownCast(this->Stages.Atlas->GetOutputDataObject(1)), atlas);
      !status.ok())
  {
    return status;
  }
  return runReporting(this->Runner.reportNothingNew(),
    [&](const Progress& progress) { return work(*atlas, progress); });
}

/// Whether what an algorithm made may be handed to a user.
Status RemesherRun::check(vtkAlgorithm* algorithm)
{
  TriangleSurface mesh = fromPolyData(vtkPolyData::SafeDownCast(algorithm->GetOutputDataObject(0)));
  mesh.connect();
  return this->withAtlas([&](const Atlas& atlas, const Progress& progress) {
    return checkMesh(mesh, atlas.surface(), atlas.topology(), progress);
  });
}

/// See addSizePlaces().
Status RemesherRun::findPlaces(vtkPolyData* mesh, double share, vtkDoubleArray* overlapping,
  vtkDoubleArray* poor, CoarsePlaceCount& count)
{
  return this->withAtlas([&](const Atlas& atlas, const Progress& progress) {
    return addSizePlaces(mesh, atlas, share, progress, overlapping, poor, count);
  });
}

/// See visibleDistance().
Status RemesherRun::measureVisibleDistance(double& distance)
{
  return this->withAtlas([&](const Atlas& atlas, const Progress& progress) {
    return visibleDistance(this->mesh(), atlas, progress, distance);
  });
}

/// The share of edges that is asked for where a mesh is at fault: as short as sizes may get beside
/// features.
double RemesherRun::finestShare()
{
  // Edges that are asked for are those of the base mesh.
  const bool isSplit = this->Stages.Pattern == Remesher::SEMIREGULAR;
  const double splits = isSplit ? this->Stages.Subdivider->GetNumberOfSubdivisions() : 0;
  return SamplingConstants::FinestSize * std::pow(2., splits);
}

/// The largest scale of their tolerance with which features move no farther than they may.
double RemesherRun::largestToleranceScale()
{
  const double spacing = std::sqrt(this->Area / (this->Points * densityOfEdges(1.)));
  const double farthest = this->Stages.Optimizer->GetFeatureTolerance() * spacing;
  return this->FarthestFeature > 0. ? std::min(1., this->FarthestFeature / farthest) : 1.;
}

bool RemesherRun::sizesGrow()
{
  vtkControlMap* control = this->Stages.ControlMap;
  return control->GetGrowFromFeatures() && control->GetGrowth() > 1.;
}

vtkPolyData* RemesherRun::mesh()
{
  return vtkPolyData::SafeDownCast(this->Stages.last(this->Stages.Pattern)->GetOutputDataObject(0));
}

int RemesherRun::numberOfPoints()
{
  return static_cast<int>(this->Stages.Sampler->GetOutput()->GetNumberOfPoints()) -
    this->numberOfGivenPoints();
}

int RemesherRun::numberOfGivenPoints()
{
  vtkConformalAtlas* atlas = this->Stages.Atlas;
  const bool areFixed = this->Part.numberOfBorderPoints() > 0 || atlas->GetFixedPoints();
  auto* graph = vtkPolyData::SafeDownCast(atlas->GetOutputDataObject(1));
  vtkDataArray* keep = areFixed && graph ? graph->GetCellData()->GetArray("Keep") : nullptr;
  vtkDataArray* surfacePoint = keep ? graph->GetPointData()->GetArray("SurfacePointId") : nullptr;
  if (!surfacePoint)
  {
    return 0;
  }
  std::set<double> ends;
  vtkIdType size;
  const vtkIdType* points;
  for (vtkIdType l = 0; l < graph->GetNumberOfLines(); ++l)
  {
    graph->GetLines()->GetCellAtId(l, size, points);
    if (size > 0 &&
      keep->GetComponent(graph->GetNumberOfVerts() + l, 0) == static_cast<double>(Keep::Edges))
    {
      ends.insert({ surfacePoint->GetComponent(points[0], 0),
        surfacePoint->GetComponent(points[size - 1], 0) });
    }
  }
  return static_cast<int>(ends.size());
}

int RemesherRun::leastNumberOfPoints()
{
  const int least = this->Stages.Sampler->GetMinimumNumberOfSamples() - this->numberOfGivenPoints();
  return this->IsUnsound ? 0 : std::max(0, least);
}
}
