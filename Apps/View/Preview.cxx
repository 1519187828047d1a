// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Preview.h"

#include "Backbones.h"
#include "MeshWorker.h"
#include "Messages.h"
#include "SceneActors.h"
#include "SessionEdits.h"
#include "ViewOptions.h"

#include "vtkCommand.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// Of smoothing: a thousandth of a density is not seen (a third of the time on 26,000 points), nor
/// is a hundredth while it changes.
constexpr double FinalTolerance = 1e-3;
constexpr double DraftTolerance = 1e-2;

/// Whether edges get shorter near features, as vtkGeometryRemesher has it.
bool mayGrow(const Session& session)
{
  return session.text("preset") == "adaptive" && session.text("pattern") != "quads";
}
}

Preview::Preview()
{
  this->RawImportance->SetSmoothingTolerance(FinalTolerance);
  this->Sampler->SetInputConnection(0, this->Control->GetOutputPort(0));
}

Preview::~Preview() = default;

void Preview::setAtlas(const SamplingInput& atlas)
{
  for (vtkControlMap* control : { this->Control.Get(), this->RawImportance.Get() })
  {
    control->SetInputDataObject(0, atlas.maps);
    control->SetInputDataObject(1, atlas.charts);
  }
  this->Control->SetInputDataObject(2, atlas.graph);
  this->Sampler->SetInputDataObject(1, atlas.charts);
  this->Sampler->SetInputDataObject(2, atlas.graph);
  this->Given = atlas.given;
  this->Ready = true;
}

void Preview::setImportanceImage(vtkImageData* image)
{
  this->Control->SetImportanceImage(image);
  this->RawImportance->SetImportanceImage(image);
}

void Preview::observeProgress(vtkCommand* command)
{
  for (vtkAlgorithm* filter :
    { static_cast<vtkAlgorithm*>(this->Control), static_cast<vtkAlgorithm*>(this->Sampler),
      static_cast<vtkAlgorithm*>(this->RawImportance) })
  {
    filter->AddObserver(vtkCommand::ProgressEvent, command);
  }
}

bool Preview::hasDraft(const Session& session)
{
  return mayGrow(session) && !pointsFollow(session);
}

Status Preview::update(const Session& session, PreviewStage stage)
{
  applyOptions(session, this->Control);
  const bool isDraft = stage == PreviewStage::Draft;
  this->Control->SetSmoothingTolerance(isDraft ? DraftTolerance : FinalTolerance);
  this->Control->SetFollowImportance(followsImportance(session));
  this->Control->SetGrowFromFeatures(mayGrow(session) && !isDraft);
  const bool follows = pointsFollow(session);
  ErrorCollector controlErrors(this->Control);
  ErrorCollector samplerErrors(this->Sampler);
  const int samples = session.integer("points") + this->Given;
  this->Control->SetNumberOfSamples(follows ? 0 : samples);
  this->Sampler->SetRaiseNumberOfSamples(follows);
  this->Sampler->SetUpsampleSpikes(!isDraft);
  if (follows)
  {
    this->Control->Update();
    const double points = this->Control->GetNumberOfWantedSamples();
    if (controlErrors.first().empty() && points > MostPoints)
    {
      return Status::error("Edges of these lengths take " +
        grouped(static_cast<long long>(points)) + " points; the window shows up to " +
        grouped(MostPoints) + ".");
    }
    this->Sampler->SetNumberOfSamples(std::max(1, static_cast<int>(std::lround(points))));
  }
  else
  {
    this->Sampler->SetNumberOfSamples(samples);
  }
  this->Sampler->Update();
  const std::string& sentence =
    controlErrors.first().empty() ? samplerErrors.first() : controlErrors.first();
  if (!sentence.empty())
  {
    // Or they were up to date next time, without samples and without an error.
    this->Control->Modified();
    this->Sampler->Modified();
  }
  return sentence.empty() ? Status::success() : Status::error(sentence);
}

vtkPartitionedDataSetCollection* Preview::controls()
{
  return vtkPartitionedDataSetCollection::SafeDownCast(this->Control->GetOutputDataObject(0));
}

vtkPartitionedDataSetCollection* Preview::halftones()
{
  return this->Sampler->GetHalftones();
}

vtkPolyData* Preview::samples()
{
  return vtkPolyData::SafeDownCast(this->Sampler->GetOutputDataObject(0));
}

vtkSmartPointer<vtkPolyData> Preview::creases(const Session& session)
{
  auto* graph = vtkPolyData::SafeDownCast(this->Control->GetInputDataObject(2, 0));
  return creasesTo(graph, this->samples(), session.text("pattern") == "quads");
}

std::vector<double> Preview::importanceHistogram(const Session& session, int bars)
{
  std::vector<double> histogram(bars, 0.);
  if (!this->Ready)
  {
    return histogram;
  }
  Session raw;
  for (const char* name : { "importance", "importance_array", "image_projection" })
  {
    raw.set(name, session.text(name));
  }
  raw.setList("band_pass", session.list("band_pass"));
  raw.set("minimum_density", 0);
  applyOptions(raw, this->RawImportance);
  ErrorCollector errors(this->RawImportance);
  this->RawImportance->Update();
  auto* images =
    vtkPartitionedDataSetCollection::SafeDownCast(this->RawImportance->GetOutputDataObject(0));
  const unsigned int charts = images ? images->GetNumberOfPartitionedDataSets() : 0;
  // Control / AreaDistortion is the importance up to one factor: its largest value is 1.
  double most = 0;
  for (const bool counting : { false, true })
  {
    for (unsigned int c = 0; c < charts; ++c)
    {
      auto* image = vtkImageData::SafeDownCast(images->GetPartitionAsDataObject(c, 0));
      auto* control = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("Control"));
      auto* area = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("AreaDistortion"));
      if (!control || !area)
      {
        return histogram;
      }
      const double pixel = image->GetSpacing()[0] * image->GetSpacing()[1];
      for (vtkIdType i = 0; i < control->GetNumberOfValues(); ++i)
      {
        const double a = area->GetValue(i);
        const double importance = a > 0 ? control->GetValue(i) / a : 0;
        if (!counting)
        {
          most = std::max(most, importance);
        }
        else if (most > 0)
        {
          const int bar = static_cast<int>(importance / most * bars);
          histogram[std::clamp(bar, 0, bars - 1)] += a * pixel;
        }
      }
    }
  }
  return histogram;
}
}
