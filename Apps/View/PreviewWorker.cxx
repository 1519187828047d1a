// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PreviewWorker.h"

#include "DensityImages.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <utility>

namespace stipple
{
namespace
{
/// What takes longer is left for a session that came after it.
constexpr std::chrono::milliseconds Patience(500);

/// After so long without another session, a draft is followed by what stays.
constexpr std::chrono::milliseconds Rest(100);

/// Seconds of sampling are a mean that the newest has so much of.
constexpr double NewestShare = 0.25;

/// Each image with copies of these arrays and no other.
vtkSmartPointer<vtkPartitionedDataSetCollection> copyOfImages(
  vtkPartitionedDataSetCollection* images, std::initializer_list<const char*> arrays)
{
  auto copy = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  for (unsigned int c = 0; c < images->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* from = vtkImageData::SafeDownCast(images->GetPartitionAsDataObject(c, 0));
    vtkNew<vtkImageData> to;
    to->CopyStructure(from);
    for (const char* name : arrays)
    {
      if (vtkDataArray* array = from->GetPointData()->GetArray(name))
      {
        auto own = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
        own->DeepCopy(array);
        to->GetPointData()->AddArray(own);
      }
    }
    copy->SetPartition(c, 0, to);
  }
  return copy;
}
}

PreviewWorker::PreviewWorker(int bars, double quickPace)
  : Bars(bars)
  , QuickPace(quickPace)
{
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(this);
  observer->SetCallback(&PreviewWorker::onProgress);
  this->Sampling.observeProgress(observer);
  this->begin();
}

PreviewWorker::~PreviewWorker()
{
  this->end();
}

void PreviewWorker::setAtlas(const SamplingInput& atlas)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->NextAtlas = std::make_unique<SamplingInput>(atlas);
  this->Done.reset();
  this->Stop = true;
}

void PreviewWorker::start(const Session& session)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto now = Clock::now();
  const bool waitsForOthers = this->Next || (this->Busy && !this->HasDraft);
  this->Asked = waitsForOthers ? this->Asked : now;
  if (this->Busy && (this->HasDraft || now - this->Started > Patience))
  {
    this->Stop = true;
  }
  this->setNext(session);
}

void PreviewWorker::cancel()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Next.reset();
  this->Stop = true;
}

bool PreviewWorker::idle()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return !this->Busy && !this->Done;
}

double PreviewWorker::waiting()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Busy ? std::chrono::duration<double>(Clock::now() - this->Asked).count() : 0.;
}

std::unique_ptr<PreviewResult> PreviewWorker::take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::move(this->Done);
}

void PreviewWorker::prepare(const Session&)
{
  this->Atlas = std::move(this->NextAtlas);
  this->Stop = false;
  this->HasDraft = false;
  this->Started = Clock::now();
}

void PreviewWorker::takeImage(vtkImageData* image)
{
  this->Sampling.setImportanceImage(image);
  this->HistogramOf.clear();
}

void PreviewWorker::perform(const Session& session)
{
  if (this->Atlas)
  {
    this->Sampling.setAtlas(*this->Atlas);
    this->Relaxation = std::make_unique<SampleRelaxation>(this->Atlas->charts, this->Atlas->graph);
    this->Painter = std::make_unique<DotPainter>(this->Atlas->charts);
    this->HistogramOf.clear();
  }
  if (this->Pace > this->QuickPace && Preview::hasDraft(session))
  {
    if (auto draft = this->sample(session, PreviewStage::Draft); draft->problem.empty())
    {
      this->handOver(std::move(draft));
      if (this->isFollowedWithin(Rest))
      {
        return;
      }
    }
  }
  this->handOver(this->sample(session, PreviewStage::Final));
}

void PreviewWorker::handOver(std::unique_ptr<PreviewResult> result)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->Stop)
  {
    this->Done = std::move(result);
    this->Asked = Clock::now();
    this->HasDraft = true;
  }
}

std::unique_ptr<PreviewResult> PreviewWorker::sample(const Session& session, PreviewStage stage)
{
  const auto begin = Clock::now();
  auto result = std::make_unique<PreviewResult>();
  result->session = session;
  const Status status = this->Sampling.update(session, stage);
  if (this->Stop)
  {
    return result;
  }
  result->problem = status.ok() ? "" : status.message();
  if (status.ok())
  {
    vtkPolyData* samples = this->Sampling.samples();
    result->numberOfSamples = samples->GetNumberOfPoints();
    result->creases = this->Sampling.creases(session);
    // Where a frame has time for it; one slow frame among others changes nothing.
    if (stage == PreviewStage::Final)
    {
      const double own = std::chrono::duration<double>(Clock::now() - begin).count();
      this->Pace += NewestShare * (own - this->Pace);
    }
    const auto relaxed = this->Pace < this->QuickPace ? this->Relaxation->relax(samples) : nullptr;
    const stipple::Stop stop = [this] { return this->Stop.load(); };
    vtkPartitionedDataSetCollection* halftones = this->Sampling.halftones();
    result->dots = relaxed ? this->Painter->paint(*relaxed, halftones, stop)
                           : this->Painter->paint(samples, halftones, stop);
    if (this->DensityWanted)
    {
      result->density = densityImages(this->Sampling.controls());
    }
    result->controls = copyOfImages(this->Sampling.controls(), { "Control", "FaceIndex" });
  }
  std::string importance;
  for (const char* name : { "importance", "importance_array", "image_projection" })
  {
    importance += session.text(name) + " ";
  }
  for (const double length : session.list("band_pass"))
  {
    importance += std::to_string(length) + " ";
  }
  if (importance != this->HistogramOf)
  {
    this->Histogram = this->Sampling.importanceHistogram(session, this->Bars);
    this->HistogramOf = this->Stop ? "" : importance;
  }
  result->histogram = this->Histogram;
  result->seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return result;
}

void PreviewWorker::onProgress(vtkObject* caller, unsigned long, void* self, void*)
{
  if (static_cast<PreviewWorker*>(self)->Stop)
  {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  }
}
}
