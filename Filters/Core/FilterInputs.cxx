// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterInputs.h"

#include "vtkAlgorithm.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

namespace stipple
{
FilterInputs::FilterInputs(vtkInformationVector** ports)
  : Samples(vtkPolyData::GetData(ports[0]))
  , Charts(vtkPartitionedDataSetCollection::GetData(ports[1]))
  , FeatureGraph(vtkPolyData::GetData(ports[2]))
{
}

bool FilterInputs::isEmpty() const
{
  return !this->Samples || !this->Charts || this->Samples->GetNumberOfPoints() == 0;
}

Status FilterInputs::read(Atlas::Pointer& atlas, std::vector<Sample>& samples) const
{
  Status status = Atlas::read(this->Charts, this->FeatureGraph, atlas);
  return status.ok() ? readSamples(this->Samples, *atlas, samples) : status;
}

Progress progressOf(vtkAlgorithm* filter)
{
  return [filter](double fraction) {
    filter->UpdateProgress(fraction);
    return filter->GetAbortExecute() == 0;
  };
}

int endAfter(const Status& failure, vtkAlgorithm* filter)
{
  if (failure.isAbort())
  {
    return 1;
  }
  vtkErrorWithObjectMacro(filter, << failure.message());
  return 0;
}
}
