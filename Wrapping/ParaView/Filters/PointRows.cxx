// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointRows.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>

namespace stipple
{
void addConstraints(vtkPolyData* points, OptionValues& values)
{
  auto rows = values.rows<3>("constraints");
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    rows.emplace_back();
    points->GetPoint(i, rows.back().data());
  }
  values.setRows("constraints", rows);
}

Status addStrokes(vtkPolyData* points, OptionValues& values)
{
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return Status::success();
  }
  auto rows = values.rows<5>("strokes");
  std::array<vtkDataArray*, 2> arrays;
  const std::vector<Option::Column>& columns = findOption("strokes")->columns;
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const std::string& name = columns[3 + i].name;
    arrays[i] = points->GetPointData()->GetArray(name.c_str());
    if (!arrays[i] || arrays[i]->GetNumberOfComponents() != 1)
    {
      return Status::error("The points of strokes have no point array '" + name +
        "' of one component: add it, for example by the filter Calculator.");
    }
  }
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    std::array<double, 5> row;
    points->GetPoint(p, row.data());
    row[3] = arrays[0]->GetComponent(p, 0);
    row[4] = arrays[1]->GetComponent(p, 0);
    rows.push_back(row);
  }
  values.setRows("strokes", rows);
  return Status::success();
}
}
