// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The preview in a thread of its own: a smooth gradation or a band-pass of a large model takes
// longer than a frame.
#ifndef stipple_PreviewWorker_h
#define stipple_PreviewWorker_h

#include "DotPainter.h"
#include "MeshWorker.h"
#include "Preview.h"
#include "SampleRelaxation.h"

#include <chrono>

namespace stipple
{
struct PreviewResult
{
  Session session;     ///< that it was made with
  std::string problem; ///< why there are no samples, a sentence; empty if there are
  vtkIdType numberOfSamples = 0;
  vtkSmartPointer<vtkPolyData> creases;               ///< to the mesh of the samples
  std::shared_ptr<const DotImages> dots;              ///< on the charts
  std::vector<vtkSmartPointer<vtkImageData>> density; ///< densityImages(), if asked for
  /// Images with `Control` and `FaceIndex`.
  vtkSmartPointer<vtkPartitionedDataSetCollection> controls;
  std::vector<double> histogram; ///< Preview::importanceHistogram()
  double seconds = 0;
};

class PreviewWorker : public SessionWorker
{
public:
  /// Histograms have so many bars. Where sampling takes fewer seconds than the second, samples are
  /// relaxed as well; where it takes more, a draft comes first.
  explicit PreviewWorker(int bars, double quickPace = 0.02);
  ~PreviewWorker() override; ///< stops what runs

  /// The charts and maps from now on; what is done for others is not handed over any more.
  void setAtlas(const SamplingInput& atlas);
  /// Whether sessions that are started from now on are to have densities as well.
  void setDensityWanted(bool wanted) { this->DensityWanted = wanted; }
  /// Samples for this next, a draft first where a frame has no time for more. What runs is
  /// finished, so that something moves while a slider does, unless it has taken long or there is a
  /// draft.
  void start(const Session& session);
  /// Gives up what runs and what is next.
  void cancel();
  /// Nothing runs, and all that was done has been taken.
  [[nodiscard]] bool idle();
  /// For how long the latest session has been waited for, in seconds; 0 if it is not.
  [[nodiscard]] double waiting();

  /// What is done since it was asked last; null if nothing.
  [[nodiscard]] std::unique_ptr<PreviewResult> take();

private:
  using Clock = std::chrono::steady_clock;
  static void onProgress(vtkObject* caller, unsigned long event, void* self, void* callData);
  void stop() override { this->Stop = true; }
  void prepare(const Session& session) override;
  void takeImage(vtkImageData* image) override;
  void perform(const Session& session) override;
  std::unique_ptr<PreviewResult> sample(const Session& session, PreviewStage stage);
  void handOver(std::unique_ptr<PreviewResult> result);

  Preview Sampling;                             ///< the thread's
  std::unique_ptr<SampleRelaxation> Relaxation; ///< the thread's
  std::unique_ptr<DotPainter> Painter;          ///< the thread's
  double Pace = 0;                              ///< the thread's: seconds that sampling takes
  bool HasDraft = false;                        ///< of what runs
  const int Bars;
  const double QuickPace;
  std::string HistogramOf;              ///< the thread's: the importance of
  std::vector<double> Histogram;        ///< the thread's
  std::unique_ptr<SamplingInput> Atlas; ///< the thread's, where it is another one
  std::unique_ptr<SamplingInput> NextAtlas;
  std::unique_ptr<PreviewResult> Done;
  Clock::time_point Asked;   ///< the first session that nothing was handed over for
  Clock::time_point Started; ///< what runs
  std::atomic<bool> DensityWanted{ false };
  std::atomic<bool> Stop{ false }; ///< what runs, at its next report
};
}

#endif
