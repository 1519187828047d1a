// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterInputs.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <algorithm>

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
    filter->UpdateProgress(std::max(filter->GetProgress(), fraction));
    return filter->GetAbortExecute() == 0;
  };
}

int endAfter(const Status& outcome, vtkAlgorithm* filter, unsigned long& errorCode)
{
  errorCode = static_cast<unsigned long>(outcome.code());
  if (outcome.ok())
  {
    filter->UpdateProgress(1.);
    return 1;
  }
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    filter->GetOutputDataObject(port)->Initialize();
  }
  if (outcome.isAbort())
  {
    return 1;
  }
  vtkErrorWithObjectMacro(filter, << outcome.message());
  return 0;
}
}
