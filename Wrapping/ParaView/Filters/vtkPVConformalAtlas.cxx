// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVConformalAtlas.h"

#include "OptionTable.h"
#include "PointRows.h"

#include "vtkConformalAtlas.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkPVConformalAtlas);

vtkPVConformalAtlas::vtkPVConformalAtlas()
{
  const vtkNew<vtkConformalAtlas> atlas;
  this->SetFilter(atlas, { InputKind::Surface, InputKind::Curves, InputKind::Points });
}

stipple::Status vtkPVConformalAtlas::TakeInputs(
  const std::vector<vtkDataObject*>& data, stipple::OptionValues& values)
{
  vtkConformalAtlas::SafeDownCast(this->GetFilter())
    ->SetFeatureCurves(vtkPolyData::SafeDownCast(data[1]));
  stipple::addConstraints(vtkPolyData::SafeDownCast(data[2]), values);
  return stipple::Status::success();
}

void vtkPVConformalAtlas::SetMeasureNormalCurvature(bool measure)
{
  if (this->GetMeasureNormalCurvature() != measure)
  {
    vtkConformalAtlas::SafeDownCast(this->GetFilter())->SetMeasureNormalCurvature(measure);
    this->Modified();
  }
}

bool vtkPVConformalAtlas::GetMeasureNormalCurvature()
{
  return vtkConformalAtlas::SafeDownCast(this->GetFilter())->GetMeasureNormalCurvature();
}

void vtkPVConformalAtlas::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
