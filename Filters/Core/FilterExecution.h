// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What every filter does in RequestData before and after its algorithm.
#ifndef stipple_FilterExecution_h
#define stipple_FilterExecution_h

#include "ReportingThread.h"

#include <exception>
#include <new>

class vtkAlgorithm;

namespace stipple
{
/// Reports to a filter, and stops when it is to abort. The fraction never falls: who tries
/// something again waits.
Progress progressOf(vtkAlgorithm* filter);

/// What RequestData() returns after its work. A failure leaves the outputs empty and its code in
/// the filter's errorCode, 0 otherwise; an error is reported, an abort is none.
int endAfter(const Status& outcome, vtkAlgorithm* filter, unsigned long& errorCode);

/// All of RequestData(): calls work(progress), which returns a Status, on another thread while this
/// one reports and hears whether to stop. What a library throws is an error: VTK's executives let
/// no exception through.
template <typename Work>
int execute(vtkAlgorithm* filter, unsigned long& errorCode, const Work& work)
{
  const auto guarded = [&work](const Progress& progress) -> Status {
    try
    {
      return work(progress);
    }
    catch (const std::bad_alloc&)
    {
      return Status::error("There is not enough memory.");
    }
    catch (const std::exception& exception)
    {
      return Status::internal(exception.what());
    }
  };
  return endAfter(runReporting(progressOf(filter), guarded), filter, errorCode);
}
}

#endif
