// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVSurfaceQuality.h"

#include "OptionTable.h"
#include "Progress.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSurfaceQuality.h"

vtkStandardNewMacro(vtkPVSurfaceQuality);

vtkPVSurfaceQuality::vtkPVSurfaceQuality()
{
  const vtkNew<vtkSurfaceQuality> quality;
  this->SetFilter(quality, { InputKind::Surface, InputKind::Surface });
}

stipple::Status vtkPVSurfaceQuality::TakeInputs(
  const std::vector<vtkDataObject*>& data, stipple::OptionValues&)
{
  vtkSurfaceQuality::SafeDownCast(this->GetFilter())
    ->SetReferenceData(vtkPolyData::SafeDownCast(data[1]));
  return stipple::Status::success();
}

void vtkPVSurfaceQuality::SetNumberOfSamples(int samples)
{
  auto* quality = vtkSurfaceQuality::SafeDownCast(this->GetFilter());
  const int before = quality->GetNumberOfSamples();
  quality->SetNumberOfSamples(samples);
  if (quality->GetNumberOfSamples() != before)
  {
    this->Modified();
  }
}

int vtkPVSurfaceQuality::GetNumberOfSamples()
{
  return vtkSurfaceQuality::SafeDownCast(this->GetFilter())->GetNumberOfSamples();
}

void vtkPVSurfaceQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
