// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVGeometryRemesherInBlocks.h"

#include "OptionTable.h"
#include "Progress.h"

#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPGeometryRemesher.h"

vtkStandardNewMacro(vtkPVGeometryRemesherInBlocks);

vtkPVGeometryRemesherInBlocks::vtkPVGeometryRemesherInBlocks()
{
  const vtkNew<vtkPGeometryRemesher> remesher;
  this->SetFilter(remesher, { InputKind::Pieces });
}

stipple::Status vtkPVGeometryRemesherInBlocks::TakeInputs(
  const std::vector<vtkDataObject*>&, stipple::OptionValues& values)
{
  auto* remesher = vtkPGeometryRemesher::SafeDownCast(this->GetFilter());
  remesher->SetNumberOfPoints(values.integer("points"));
  stipple::applyOptions(values, remesher->GetRemesher());
  return stipple::Status::success();
}

// The filter's own time does not count: it is modified by each run.
void vtkPVGeometryRemesherInBlocks::SetTrianglesPerBlock(vtkIdType triangles)
{
  auto* remesher = vtkPGeometryRemesher::SafeDownCast(this->GetFilter());
  const vtkIdType before = remesher->GetTrianglesPerBlock();
  remesher->SetTrianglesPerBlock(triangles);
  if (remesher->GetTrianglesPerBlock() != before)
  {
    this->Modified();
  }
}

void vtkPVGeometryRemesherInBlocks::SetHealingRings(int rings)
{
  auto* remesher = vtkPGeometryRemesher::SafeDownCast(this->GetFilter());
  const int before = remesher->GetHealingRings();
  remesher->SetHealingRings(rings);
  if (remesher->GetHealingRings() != before)
  {
    this->Modified();
  }
}

void vtkPVGeometryRemesherInBlocks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
