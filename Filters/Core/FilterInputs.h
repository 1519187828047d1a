// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What every filter of this folder does in RequestData before and after its algorithm.
#ifndef stipple_FilterInputs_h
#define stipple_FilterInputs_h

#include "Atlas.h"
#include "SampleSet.h"

class vtkAlgorithm;
class vtkInformationVector;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// Input ports 0 to 2: samples or a mesh whose points are samples, charts, feature graph.
class FilterInputs
{
public:
  explicit FilterInputs(vtkInformationVector** ports);

  /// Whether there is nothing to do.
  bool isEmpty() const;
  vtkPolyData* samples() const { return this->Samples; }
  Status read(Atlas::Pointer& atlas, std::vector<Sample>& samples) const;

private:
  vtkPolyData* Samples;
  vtkPartitionedDataSetCollection* Charts;
  vtkPolyData* FeatureGraph;
};

/// Reports to a filter, and stops when it is to abort.
Progress progressOf(vtkAlgorithm* filter);

/// What RequestData() returns after a failure: an error, which the filter reports, or an abort.
int endAfter(const Status& failure, vtkAlgorithm* filter);
}

#endif
