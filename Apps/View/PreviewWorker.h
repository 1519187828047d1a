// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The preview in a thread of its own: a smooth gradation or a band-pass of a large model takes
// longer than a frame. Sessions that come while it samples are one, the latest. No VTK object is
// ever in two threads.
#ifndef stipple_PreviewWorker_h
#define stipple_PreviewWorker_h

#include "MeshWorker.h"
#include "Preview.h"

#include <chrono>

namespace stipple
{
struct PreviewResult
{
  Session session;     ///< that it was made with
  std::string problem; ///< why there are no samples, a sentence; empty if there are
  vtkSmartPointer<vtkPolyData> samples;
  vtkSmartPointer<vtkPartitionedDataSetCollection> halftones;
  vtkSmartPointer<vtkPartitionedDataSetCollection> controls;
  std::vector<double> histogram; ///< Preview::importanceHistogram()
  double seconds = 0;
};

class PreviewWorker
{
public:
  /// `importanceImage` is copied; it may be null. Histograms have so many bars.
  PreviewWorker(vtkImageData* importanceImage, int bars);
  ~PreviewWorker(); ///< stops what runs
  PreviewWorker(const PreviewWorker&) = delete;
  PreviewWorker& operator=(const PreviewWorker&) = delete;

  /// The charts and maps from now on; what is done for others is not handed over any more.
  void setAtlas(const SamplingInput& atlas);
  /// Samples for this next. What runs is finished, so that something moves while a slider does,
  /// unless it has taken long.
  void start(const Session& session);
  /// Nothing runs, and all that was done has been taken.
  [[nodiscard]] bool idle();
  /// For how long the latest session has been waited for, in seconds; 0 if it is not.
  [[nodiscard]] double waiting();

  /// What is done since it was asked last; null if nothing.
  [[nodiscard]] std::unique_ptr<PreviewResult> take();

private:
  using Clock = std::chrono::steady_clock;
  static void onProgress(vtkObject* caller, unsigned long event, void* self, void* callData);
  void work();
  std::unique_ptr<PreviewResult> perform(const Session& session);

  Preview Sampling; ///< the thread's
  int Bars;
  std::string HistogramOf;       ///< the thread's: the importance of
  std::vector<double> Histogram; ///< the thread's
  std::mutex Mutex;
  std::condition_variable Wake;
  std::unique_ptr<SamplingInput> NextAtlas;
  std::unique_ptr<Session> Next;
  std::unique_ptr<PreviewResult> Done;
  Clock::time_point Asked;   ///< the first session that nothing was handed over for
  Clock::time_point Started; ///< what runs
  bool Busy = false;
  bool Quit = false;
  std::atomic<bool> Stop{ false }; ///< what runs, at its next report
  std::thread Thread;
};
}

#endif
