// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Executes an algorithm for _pipeline.py, which calls this through ctypes: so Python's other
// threads run meanwhile, as they do not while a wrapped method does. What is called back has their
// lock.
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;

/// Nonzero stops the work.
using ProgressCallback = int (*)(double fraction);
/// An error, or a warning.
using MessageCallback = void (*)(int isError, const char* text);

class Run
{
public:
  Run(ProgressCallback progress, MessageCallback message)
    : Progress(progress)
    , Message(message)
  {
    this->OnMessage->SetClientData(this);
    this->OnMessage->SetCallback([](vtkObject*, unsigned long event, void* self, void* text) {
      static_cast<Run*>(self)->Message(
        event == vtkCommand::ErrorEvent, text ? static_cast<const char*>(text) : "");
    });
    this->OnProgress->SetClientData(this);
    this->OnProgress->SetCallback([](vtkObject* caller, unsigned long, void* self, void*) {
      static_cast<Run*>(self)->report(static_cast<vtkAlgorithm*>(caller));
    });
  }
  ~Run()
  {
    for (const auto& observer : this->Observers)
    {
      observer.first->RemoveObserver(observer.second);
    }
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// An observed object prints nothing.
  void listen(vtkAlgorithm* algorithm)
  {
    for (vtkObject* source :
      { static_cast<vtkObject*>(algorithm), static_cast<vtkObject*>(algorithm->GetExecutive()) })
    {
      this->observe(source, vtkCommand::ErrorEvent, this->OnMessage);
      this->observe(source, vtkCommand::WarningEvent, this->OnMessage);
    }
  }
  void watch(vtkAlgorithm* algorithm)
  {
    this->observe(algorithm, vtkCommand::ProgressEvent, this->OnProgress);
  }

private:
  void observe(vtkObject* source, unsigned long event, vtkCallbackCommand* command)
  {
    this->Observers.emplace_back(source, source->AddObserver(event, command));
  }

  /// Not at every event: waiting for Python's lock takes time.
  void report(vtkAlgorithm* algorithm)
  {
    const Clock::time_point now = Clock::now();
    const double fraction = std::clamp(algorithm->GetProgress(), 0., 1.);
    const bool isBig = fraction - this->Reported >= 0.01 || (fraction == 1 && this->Reported < 1);
    if (!this->Stopped && (isBig || now - this->Last > std::chrono::milliseconds(20)))
    {
      this->Last = now;
      this->Reported = fraction;
      this->Stopped = this->Progress(fraction) != 0;
    }
    if (this->Stopped)
    {
      algorithm->SetAbortExecute(1);
    }
  }

  ProgressCallback Progress;
  MessageCallback Message;
  vtkNew<vtkCallbackCommand> OnMessage;
  vtkNew<vtkCallbackCommand> OnProgress;
  std::vector<std::pair<vtkObject*, unsigned long>> Observers;
  Clock::time_point Last;
  double Reported = -1;
  bool Stopped = false;
};
}

/// Updates the first algorithm. What the others inside of it say counts as well.
extern "C" __attribute__((visibility("default"))) void stipple_update(
  void** algorithms, int count, ProgressCallback progress, MessageCallback message)
{
  const int display = vtkObject::GetGlobalWarningDisplay();
  {
    Run run(progress, message);
    auto* algorithm = static_cast<vtkAlgorithm*>(static_cast<vtkObjectBase*>(algorithms[0]));
    for (int i = 0; i < count; ++i)
    {
      run.listen(static_cast<vtkAlgorithm*>(static_cast<vtkObjectBase*>(algorithms[i])));
    }
    run.watch(algorithm);
    vtkObject::GlobalWarningDisplayOn(); // switched off, VTK would not tell observers either
    algorithm->SetAbortExecute(0);
    algorithm->Update();
    algorithm->SetAbortExecute(0);
  }
  vtkObject::SetGlobalWarningDisplay(display);
}
