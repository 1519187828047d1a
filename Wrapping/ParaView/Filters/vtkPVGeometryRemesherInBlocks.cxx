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

namespace
{
/// Sets a parameter of the filter. The filter's time is not this one's: runs modify it, too.
template <typename Setter>
void change(vtkAlgorithm* self, vtkAlgorithm* filter, Setter setter)
{
  const vtkMTimeType before = filter->GetMTime();
  setter(vtkPGeometryRemesher::SafeDownCast(filter));
  if (filter->GetMTime() != before)
  {
    self->Modified();
  }
}
}

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

void vtkPVGeometryRemesherInBlocks::SetTrianglesPerBlock(vtkIdType triangles)
{
  change(this, this->GetFilter(), [=](auto* filter) { filter->SetTrianglesPerBlock(triangles); });
}

void vtkPVGeometryRemesherInBlocks::SetHealingRings(int rings)
{
  change(this, this->GetFilter(), [=](auto* filter) { filter->SetHealingRings(rings); });
}

void vtkPVGeometryRemesherInBlocks::SetMinimumNumberOfGhostLevels(int levels)
{
  change(
    this, this->GetFilter(), [=](auto* filter) { filter->SetMinimumNumberOfGhostLevels(levels); });
}

void vtkPVGeometryRemesherInBlocks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
