// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterExecution.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <algorithm>

namespace stipple
{
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

bool takeStop(vtkAlgorithm* filter)
{
  if (filter->GetAbortExecute() == 0)
  {
    return false;
  }
  filter->SetAbortExecute(0);
  filter->Modified();
  return true;
}
}
