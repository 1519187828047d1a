// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Long work on a thread of its own, while the caller's thread reports and asks whether to stop:
// observers of VTK are called by the thread that updates only, and never wait for a long step.
#ifndef stipple_ReportingThread_h
#define stipple_ReportingThread_h

#include "Progress.h"

#include "vtkSMPTools.h"

#include <atomic>
#include <chrono>
#include <future>

namespace stipple
{
/// Calls work(progress) on another thread, and `progress`, on this one, once before and a hundred
/// times a second with the fraction that the work has told last. What the work is given costs next
/// to nothing and may be called by any thread, so that every loop can ask whether to stop. Returns
/// when the work has ended.
template <typename Work>
auto runReporting(const Progress& progress, const Work& work)
{
  std::atomic<double> fraction(0.);
  std::atomic<bool> stopped(!report(progress, 0.)); // before short work has ended
  auto result = std::async(std::launch::async, [&] {
    return work(Progress([&](double done) {
      fraction = done;
      return !stopped;
    }));
  });
  while (result.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready)
  {
    if (!stopped)
    {
      stopped = !report(progress, fraction);
    }
  }
  return result.get();
}

/// Calls f(i, stop) for i from 0 to n - 1, on all threads, which all call `progress`, with
/// fractions between from and to. Aborted if it said so: the result is to be thrown away.
template <typename F>
Status reportingFor(int n, const Progress& progress, double from, double to, const F& f)
{
  std::atomic<int> done(0);
  const Stop stop = [&] { return !report(progress, from + (to - from) * done / n); };
  vtkSMPTools::For(0, n, 1, [&](vtkIdType begin, vtkIdType end) {
    for (int i = static_cast<int>(begin); i < static_cast<int>(end) && !stop(); ++i)
    {
      f(i, stop);
      ++done;
    }
  });
  return report(progress, to) ? Status::success() : Status::aborted();
}
}

#endif
