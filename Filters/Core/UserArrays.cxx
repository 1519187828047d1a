// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "UserArrays.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

#include <sstream>

namespace stipple
{
Status checkedCount(vtkIdType number, const std::string& what, int& count)
{
  if (number > MaximumNumberOfElements)
  {
    return Status::error("There are " + std::to_string(number) + " " + what + ", more than the " +
      std::to_string(MaximumNumberOfElements) + " that can be numbered.");
  }
  count = static_cast<int>(number);
  return Status::success();
}

Status findArray(vtkFieldData* data, const char* name, int components, vtkIdType tuples,
  const std::string& owner, const std::string& remedy, vtkDataArray*& array)
{
  array = data->GetArray(name);
  const std::string whose = owner + (array ? " has an array " : " has no array ") + name;
  if (!array)
  {
    return Status::error(whose + ": " + remedy + ".");
  }
  if (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != tuples)
  {
    return Status::error(whose + " of " + std::to_string(array->GetNumberOfTuples()) +
      " tuples of " + std::to_string(array->GetNumberOfComponents()) + " components instead of " +
      std::to_string(tuples) + " of " + std::to_string(components) + ": " + remedy + ".");
  }
  return Status::success();
}

Status badId(vtkDataArray* array, vtkIdType tuple, const std::string& element, int size)
{
  std::ostringstream text;
  text.precision(17);
  text << "The " << array->GetName() << " of " << element << " is " << array->GetComponent(tuple, 0)
       << ", which is none of the ";
  text << size << " that there are, counted from 0.";
  return Status::error(text.str());
}

Status checkCells(vtkCellArray* cells, vtkIdType numberOfPoints, const std::string& owner)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return Status::success();
  }
  if (!cells->IsValid())
  {
    return Status::error("The cells of " + owner +
      " contradict themselves: their offsets do not ascend to the number of ids.");
  }
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      if (ids[k] < 0 || ids[k] >= numberOfPoints)
      {
        return Status::error("Cell " + std::to_string(i) + " of " + owner + " has the point " +
          std::to_string(ids[k]) + ", but there are " + std::to_string(numberOfPoints) +
          " points, counted from 0.");
      }
    }
  }
  return Status::success();
}

Status checkAttributes(
  vtkDataSetAttributes* data, vtkIdType elements, const char* what, const std::string& owner)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < elements)
    {
      return Status::error("The array " +
        std::string(array->GetName() ? array->GetName() : "without a name") + " of " + owner +
        " has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
        std::to_string(elements) + " " + what + ".");
    }
  }
  return Status::success();
}
}
