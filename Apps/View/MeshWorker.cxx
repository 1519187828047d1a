// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshWorker.h"

#include "Backbones.h"
#include "LostFeatures.h"
#include "Messages.h"
#include "NearestTriangle.h"
#include "PolyDataConversion.h"

#include "vtkCallbackCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"

#include <algorithm>

#if defined(__linux__)
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace stipple
{
namespace
{
/// The window's thread comes first when there are fewer cores than work.
void lowerPriority()
{
#if defined(__linux__)
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), 10);
#endif
}

bool sameMaps(const Session& a, const Session& b)
{
  return sameForStage(a, b, "vtkConformalAtlas") && sameForStage(a, b, "vtkGeometryMapRenderer");
}

template <typename T>
vtkSmartPointer<T> copyOf(vtkDataObject* data)
{
  auto copy = vtkSmartPointer<T>::New();
  copy->DeepCopy(data);
  return copy;
}
}

MeshWorker::MeshWorker(vtkPolyData* input)
  : Remesher(vtkSmartPointer<vtkGeometryRemesher>::New())
{
  this->Remesher->SetInputData(copyOf<vtkPolyData>(input));
  this->Remesher->GetMapRenderer()->SetBackendToCPU(); // OpenGL belongs to the window's thread
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(this);
  observer->SetCallback(&MeshWorker::onEvent);
  this->Remesher->AddObserver(vtkCommand::ProgressEvent, observer);
  this->Remesher->AddObserver(vtkGeometryRemesher::StageEndEvent, observer);
  this->begin();
}

MeshWorker::~MeshWorker()
{
  this->end();
}

void MeshWorker::start(const Session& session)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->StopAsked =
    std::max<int>(this->StopAsked, sameMaps(this->Current, session) ? BeforeTheMesh : AtOnce);
  this->Mesh.reset();
  this->Error.clear();
  this->setNext(session);
}

void MeshWorker::relax()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Next.reset();
  this->StopAsked = std::max<int>(this->StopAsked, BeforeTheMesh);
}

void MeshWorker::cancel()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Next.reset();
  this->StopAsked = AtOnce;
}

bool MeshWorker::idle()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return !this->Busy && !this->Atlas && !this->Mesh && this->Error.empty();
}

std::unique_ptr<AtlasResult> MeshWorker::takeAtlas()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::move(this->Atlas);
}

std::unique_ptr<MeshResult> MeshWorker::takeMesh()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::move(this->Mesh);
}

std::string MeshWorker::takeError()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  std::string error;
  error.swap(this->Error);
  return error;
}

void MeshWorker::prepare(const Session& session)
{
  this->Current = session;
  this->StopAsked = GoOn;
  this->Fraction = 0.;
  this->Tried = 0;
}

void MeshWorker::takeImage(vtkImageData* image)
{
  this->Remesher->GetControlMap()->SetImportanceImage(image);
}

void MeshWorker::perform(const Session& session)
{
  lowerPriority();
  const double begin = vtkTimerLog::GetUniversalTime();
  ErrorCollector errors(this->Remesher);
  applyOptions(session, this->Remesher);
  this->MapsDone = false;
  this->Remesher->Update();
  if (this->StopAsked != GoOn)
  {
    return;
  }
  if (!errors.first().empty())
  {
    // VTK takes a filter that has failed for up to date: the next try would have no error, and no
    // mesh.
    this->Remesher->Modified();
    // The charts may be fine, and a preview of fewer points possible.
    this->publishAtlas();
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Error = errors.first();
    return;
  }
  auto result = std::make_unique<MeshResult>();
  result->session = session;
  result->mesh = copyOf<vtkPolyData>(this->Remesher->GetOutputDataObject(0));
  result->lines = copyOf<vtkPolyData>(this->Remesher->GetOutputDataObject(1));
  result->deviation = this->Remesher->GetDeviation();
  result->figures = measureFigures(result->mesh);
  result->figures.cutEdges = this->Remesher->GetAtlas()->GetNumberOfSplitEdges();
  result->creases =
    creasesTo(vtkPolyData::SafeDownCast(this->Remesher->GetAtlas()->GetOutputDataObject(1)),
      vtkPolyData::SafeDownCast(this->Remesher->GetSampler()->GetOutputDataObject(0)),
      this->Remesher->GetPattern() == vtkGeometryRemesher::QUADS);
  result->lost = lostFeatures(this->Remesher);
  if (result->lost)
  {
    // Most simplifications move points along a line that is kept: what is counted is what is seen.
    result->figures.lostFeatureEdges = static_cast<int>(result->lost->GetNumberOfLines());
  }
  if (!this->inspect(*result))
  {
    return;
  }
  result->seconds = vtkTimerLog::GetUniversalTime() - begin;
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->StopAsked == GoOn)
  {
    this->Mesh = std::move(result);
  }
}

/// What is shown of a mesh besides itself; false if it was stopped.
bool MeshWorker::inspect(MeshResult& result)
{
  if (!this->NearestInput)
  {
    this->Input = fromPolyData(vtkPolyData::SafeDownCast(this->Remesher->GetInput()));
    this->NearestInput = std::make_unique<NearestTriangle>(this->Input);
  }
  result.colors =
    measureColors(result.mesh, *this->NearestInput, [this] { return this->StopAsked != GoOn; });
  Atlas::Pointer atlas;
  auto* charts = vtkPartitionedDataSetCollection::SafeDownCast(
    this->Remesher->GetAtlas()->GetOutputDataObject(0));
  if (this->StopAsked == GoOn && Atlas::read(charts, nullptr, atlas).ok())
  {
    result.dots = DotPainter(charts).paint(placeOnCharts(result.mesh, *atlas),
      this->Remesher->GetSampler()->GetHalftones(), [this] { return this->StopAsked != GoOn; });
  }
  return this->StopAsked == GoOn;
}

void MeshWorker::publishAtlas()
{
  vtkDataObject* charts = this->Remesher->GetAtlas()->GetOutputDataObject(0);
  vtkDataObject* maps = this->Remesher->GetMapRenderer()->GetOutputDataObject(0);
  const vtkMTimeType time = std::max(charts->GetMTime(), maps->GetMTime());
  const auto* images = vtkPartitionedDataSetCollection::SafeDownCast(maps);
  if (time <= this->PublishedTime || !images || images->GetNumberOfPartitionedDataSets() == 0)
  {
    return;
  }
  this->PublishedTime = time;
  auto result = std::make_unique<AtlasResult>();
  result->session = this->Current;
  result->charts = copyOf<vtkPartitionedDataSetCollection>(charts);
  result->graph = copyOf<vtkPolyData>(this->Remesher->GetAtlas()->GetOutputDataObject(1));
  result->sampling.charts = copyOf<vtkPartitionedDataSetCollection>(charts);
  result->sampling.graph = copyOf<vtkPolyData>(result->graph);
  result->sampling.maps = copyOf<vtkPartitionedDataSetCollection>(maps);
  result->sampling.given = this->Remesher->GetNumberOfGivenPoints();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Atlas = std::move(result);
}

void MeshWorker::onEvent(vtkObject* caller, unsigned long event, void* data, void* callData)
{
  auto* self = static_cast<MeshWorker*>(data);
  auto* remesher = static_cast<vtkGeometryRemesher*>(caller);
  self->Fraction = remesher->GetProgress();
  self->Tried = remesher->GetNumberOfPointsTried();
  if (event == vtkGeometryRemesher::StageEndEvent &&
    *static_cast<int*>(callData) == vtkGeometryRemesher::MAPS)
  {
    self->MapsDone = true;
    if (self->StopAsked != AtOnce)
    {
      self->publishAtlas();
    }
  }
  const int stop = self->StopAsked;
  if (stop == AtOnce || (stop == BeforeTheMesh && self->MapsDone))
  {
    remesher->SetAbortExecute(1);
  }
}
}
