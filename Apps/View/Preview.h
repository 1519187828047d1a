// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The part of the pipeline that follows a slider: control map and error diffusion (paper 3.3), on
// the charts and maps that the worker made. PreviewWorker has it in a thread of its own.
#ifndef stipple_Preview_h
#define stipple_Preview_h

#include "Progress.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCommand;
class vtkControlMap;
class vtkErrorDiffusionSampler;
class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
struct SamplingInput;
struct Session;

/// A draft is what can be had while something moves: the same number of samples, but without
/// shorter edges near features and around what is thin, which take as long as all the rest.
enum class PreviewStage
{
  Draft,
  Final
};

class Preview
{
public:
  Preview();
  ~Preview();
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  void setAtlas(const SamplingInput& atlas);
  void setImportanceImage(vtkImageData* image);
  /// Called while it works; it may set the AbortExecute of the filter that calls it.
  void observeProgress(vtkCommand* command);

  /// Whether a draft of it is anything else.
  [[nodiscard]] static bool hasDraft(const Session& session);
  /// Samples anew what changed.
  [[nodiscard]] Status update(const Session& session, PreviewStage stage = PreviewStage::Final);

  /// Of the last update that succeeded.
  vtkPartitionedDataSetCollection* controls();
  vtkPartitionedDataSetCollection* halftones();
  vtkPolyData* samples();
  /// Of the feature graph, to the mesh of the samples.
  vtkSmartPointer<vtkPolyData> creases(const Session& session);

  /// How much of the surface has which importance, before the transfer function, in bars over
  /// [0, 1]; computed anew only if the kind of importance changed.
  [[nodiscard]] std::vector<double> importanceHistogram(const Session& session, int bars);

private:
  bool Ready = false;
  int Given = 0; ///< samples on top of a session's
  vtkNew<vtkControlMap> Control;
  vtkNew<vtkErrorDiffusionSampler> Sampler;
  vtkNew<vtkControlMap> RawImportance; ///< without transfer function, gamma and filters
};
}

#endif
