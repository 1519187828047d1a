// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Backbones.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <functional>

namespace stipple
{
namespace
{
vtkSmartPointer<vtkPolyData> selectedBackbones(
  vtkPolyData* lines, const std::function<bool(vtkIdType cell)>& isSelected)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  if (!lines)
  {
    return data;
  }
  vtkNew<vtkCellArray> cells;
  const vtkIdType first = lines->GetNumberOfVerts();
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    if (isSelected(first + i))
    {
      vtkIdType size;
      const vtkIdType* ids;
      lines->GetLines()->GetCellAtId(i, size, ids);
      cells->InsertNextCell(size, ids);
    }
  }
  data->SetPoints(lines->GetPoints());
  data->SetLines(cells);
  return data;
}

/// 0 without such an array.
double valueOf(vtkPolyData* lines, const char* name, vtkIdType cell)
{
  vtkDataArray* array = lines->GetCellData()->GetArray(name);
  return array ? array->GetComponent(cell, 0) : 0.;
}
}

vtkSmartPointer<vtkPolyData> backbonesOfType(vtkPolyData* lines, int type)
{
  return selectedBackbones(lines, [&](vtkIdType cell) {
    return lines->GetCellData()->HasArray("BackboneType") != 0 &&
      static_cast<int>(valueOf(lines, "BackboneType", cell)) == type;
  });
}

vtkSmartPointer<vtkPolyData> sharpBackbones(vtkPolyData* lines)
{
  constexpr int Sharp = 0;
  return selectedBackbones(lines, [&](vtkIdType cell) {
    return lines->GetCellData()->HasArray("BackboneType") != 0 &&
      static_cast<int>(valueOf(lines, "BackboneType", cell)) == Sharp &&
      valueOf(lines, "Width", cell) == 0.;
  });
}
}
