// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Backbones.h"

#include "FeatureGraph.h"

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

bool isOfType(vtkPolyData* lines, int type, vtkIdType cell)
{
  vtkDataArray* types = lines->GetCellData()->GetArray("BackboneType");
  return types && static_cast<int>(types->GetComponent(cell, 0)) == type;
}
}

vtkSmartPointer<vtkPolyData> backbonesOfType(vtkPolyData* lines, int type)
{
  return selectedBackbones(lines, [&](vtkIdType cell) { return isOfType(lines, type, cell); });
}

vtkSmartPointer<vtkPolyData> creasesTo(vtkPolyData* lines, double edgeLength)
{
  constexpr int Sharp = 0;
  vtkDataArray* widths = lines ? lines->GetCellData()->GetArray("Width") : nullptr;
  return selectedBackbones(lines, [&](vtkIdType cell) {
    return isOfType(lines, Sharp, cell) &&
      (!widths || widths->GetComponent(cell, 0) <= Backbone::WidthOfCrease * edgeLength);
  });
}
}
