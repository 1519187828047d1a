// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Backbones.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace stipple
{
vtkSmartPointer<vtkPolyData> backbonesOfType(vtkPolyData* lines, int type)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkDataArray* types = lines ? lines->GetCellData()->GetArray("BackboneType") : nullptr;
  if (!types)
  {
    return data;
  }
  vtkNew<vtkCellArray> cells;
  const vtkIdType first = lines->GetNumberOfVerts();
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    if (static_cast<int>(types->GetComponent(first + i, 0)) == type)
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
}
