// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What every filter does in RequestData before and after its algorithm.
#ifndef stipple_FilterExecution_h
#define stipple_FilterExecution_h

#include "Guarded.h"
#include "ReportingThread.h"

class vtkAlgorithm;

namespace stipple
{
/// Reports to a filter, and stops when it is to abort. The fraction never falls: who tries
/// something again waits.
Progress progressOf(vtkAlgorithm* filter);

/// What RequestData() returns after its work. A failure leaves the outputs empty and its code in
/// the filter's errorCode, 0 otherwise; an error is reported, an abort is none.
int endAfter(const Status& outcome, vtkAlgorithm* filter, unsigned long& errorCode);

/// Whether a filter was stopped in its last Update(). If so, it is made fit for another: its flag
/// is cleared, as executives did until VTK 9.2, and it is modified, as what it left is no result.
bool takeStop(vtkAlgorithm* filter);

/// All of RequestData(): calls work(progress), which returns a Status, on another thread while this
/// one reports and hears whether to stop. What a library throws is an error: VTK's executives let
/// no exception through.
template <typename Work>
int execute(vtkAlgorithm* filter, unsigned long& errorCode, const Work& work)
{
  // Twice, for the thread may not start.
  const Status outcome = guarded([&] {
    return runReporting(progressOf(filter),
      [&work](const Progress& progress) { return guarded([&] { return work(progress); }); });
  });
  return endAfter(outcome, filter, errorCode);
}
}

#endif
