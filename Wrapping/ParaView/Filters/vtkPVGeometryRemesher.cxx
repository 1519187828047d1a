// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVGeometryRemesher.h"

#include "OptionTable.h"
#include "PointRows.h"

#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkPVGeometryRemesher);

vtkPVGeometryRemesher::vtkPVGeometryRemesher()
{
  const vtkNew<vtkGeometryRemesher> remesher;
  this->SetFilter(remesher,
    { InputKind::Surface, InputKind::Curves, InputKind::Image, InputKind::Points,
      InputKind::Points });
  // Another OpenGL context beside ParaView's would do harm, if there were one.
  remesher->GetMapRenderer()->SetBackendToCPU();
}

stipple::Status vtkPVGeometryRemesher::TakeInputs(
  const std::vector<vtkDataObject*>& data, stipple::OptionValues& values)
{
  auto* remesher = vtkGeometryRemesher::SafeDownCast(this->GetFilter());
  remesher->GetAtlas()->SetFeatureCurves(vtkPolyData::SafeDownCast(data[1]));
  remesher->GetControlMap()->SetImportanceImage(vtkImageData::SafeDownCast(data[2]));
  stipple::addConstraints(vtkPolyData::SafeDownCast(data[3]), values);
  return stipple::addStrokes(vtkPolyData::SafeDownCast(data[4]), values);
}

void vtkPVGeometryRemesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
