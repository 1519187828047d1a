// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The stages brought up to date one by one, with what they report on the way.
#ifndef stipple_StageRunner_h
#define stipple_StageRunner_h

#include "Progress.h"
#include "RemesherStages.h"
#include "StippleFiltersRemesherModule.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <array>
#include <functional>
#include <string>

namespace stipple
{
/// What a run tells and asks while it goes on; all of it is called by the thread that runs.
struct RunCallbacks
{
  std::function<void(double)> tell;     ///< the fraction that is done, which may fall
  std::function<bool()> isStopped;      ///< whether to give up
  std::function<void(int)> stageStarts; ///< a vtkGeometryRemesher::StageType
  std::function<void(int)> stageEnds;
};

class STIPPLEFILTERSREMESHER_EXPORT StageRunner
{
public:
  /// The stages must outlive this.
  StageRunner(RemesherStages& stages, RunCallbacks callbacks);
  ~StageRunner();
  StageRunner(const StageRunner&) = delete;
  StageRunner& operator=(const StageRunner&) = delete;

  /// Of all that is to be done the stages are this part from now on, in fractions.
  void setProgressRange(double from, double to);
  double progressEnd() const { return this->ProgressTo; }

  /// Updates an algorithm of the stages. If that fails: its code (StatusCode::Internal if it has
  /// none of Stipple's), with the first sentence that it or its executive reported.
  Status run(int algorithm);

  /// Of a stage in all its runs since the seconds were cleared; nothing of those in which it was
  /// up to date.
  double seconds(int stage) const { return this->Seconds[stage]; }
  void clearSeconds() { this->Seconds.fill(0.); }

  bool isStopped() const { return this->Callbacks.isStopped(); }
  /// Calls observers, which may ask to stop, without news for them: for what is done between
  /// stages.
  Progress reportNothingNew();

private:
  static void execute(vtkObject* caller, unsigned long event, void* runner, void* callData);
  void tell(double fraction);

  RemesherStages& Stages;
  RunCallbacks Callbacks;
  std::array<double, RemesherStages::NumberOfStages> Seconds = {};
  double ProgressFrom = 0.;
  double ProgressTo = 1.;
  vtkNew<vtkCallbackCommand> Observer;
  int Current = 0;
  bool HasStarted = false;    ///< the current stage had something to do
  std::string StageError;     ///< the first that it reported
  std::string ExecutiveError; ///< the first that its executive reported
};
}

#endif
