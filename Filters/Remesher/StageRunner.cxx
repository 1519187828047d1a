// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StageRunner.h"

#include "FilterExecution.h"
#include "MessageText.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <utility>

namespace stipple
{
namespace
{
Status failureOf(vtkAlgorithm* filter, std::string sentence)
{
  switch (static_cast<StatusCode>(filter->GetErrorCode()))
  {
    case StatusCode::Aborted:
      return Status::aborted();
    case StatusCode::BadInput:
      return Status::error(std::move(sentence));
    case StatusCode::TooFewPoints:
      return Status::tooFewPoints(std::move(sentence));
    default:
      return Status::internal(std::move(sentence));
  }
}
}

StageRunner::StageRunner(RemesherStages& stages, RunCallbacks callbacks)
  : Stages(stages)
  , Callbacks(std::move(callbacks))
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(&StageRunner::execute);
  for (vtkAlgorithm* stage : this->Stages.InOrder)
  {
    stage->AddObserver(vtkCommand::StartEvent, this->Observer);
    stage->AddObserver(vtkCommand::ProgressEvent, this->Observer);
    stage->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    stage->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  }
}

StageRunner::~StageRunner()
{
  // A stage may live on in a caller's hands.
  for (vtkAlgorithm* stage : this->Stages.InOrder)
  {
    stage->RemoveObserver(this->Observer);
    stage->GetExecutive()->RemoveObserver(this->Observer);
  }
}

void StageRunner::execute(vtkObject* caller, unsigned long event, void* runner, void* callData)
{
  auto* self = static_cast<StageRunner*>(runner);
  vtkAlgorithm* stage = self->Stages.InOrder[self->Current];
  if (event == vtkCommand::ErrorEvent)
  {
    std::string& text = caller == stage ? self->StageError : self->ExecutiveError;
    if (text.empty() && callData)
    {
      text = sentenceOf(static_cast<const char*>(callData));
    }
  }
  else if (event == vtkCommand::StartEvent)
  {
    self->HasStarted = self->HasStarted || caller == stage;
  }
  else if (caller == stage)
  {
    const auto [begin, end] = self->Stages.progressOf(self->Current);
    self->tell(begin + (end - begin) * std::clamp(stage->GetProgress(), 0., 1.));
    if (self->isStopped())
    {
      stage->SetAbortExecute(1);
    }
  }
}

void StageRunner::setProgressRange(double from, double to)
{
  this->ProgressFrom = from;
  this->ProgressTo = to;
}

void StageRunner::tell(double fraction)
{
  this->Callbacks.tell(this->ProgressFrom + (this->ProgressTo - this->ProgressFrom) * fraction);
}

Progress StageRunner::reportNothingNew()
{
  return [this](double) {
    this->tell(0.);
    return !this->isStopped();
  };
}

Status StageRunner::run(int algorithm)
{
  vtkAlgorithm* filter = this->Stages.InOrder[algorithm];
  const int stage = RemesherStages::stageOf(algorithm);
  this->Current = algorithm;
  this->HasStarted = false;
  this->StageError.clear();
  this->ExecutiveError.clear();
  this->Callbacks.stageStarts(stage);
  if (this->isStopped())
  {
    return Status::aborted();
  }
  const double begin = vtkTimerLog::GetUniversalTime();
  const bool updated = filter->GetExecutive()->Update() != 0;
  this->Seconds[stage] += this->HasStarted ? vtkTimerLog::GetUniversalTime() - begin : 0.;
  if (takeStop(filter) || this->isStopped())
  {
    return Status::aborted();
  }
  if (!updated || !this->StageError.empty())
  {
    filter->Modified();
    return failureOf(filter,
      !this->StageError.empty() ? this->StageError
        : !this->ExecutiveError.empty()
        ? this->ExecutiveError
        : "The " + std::string(RemesherStages::nameOf(algorithm)) + " failed without saying why.");
  }
  this->tell(this->Stages.progressOf(algorithm)[1]);
  this->Callbacks.stageEnds(stage);
  return Status::success();
}
}
