// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityArray.h"

#include "AttributeTransfer.h"
#include "MapCatalogue.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace stipple
{
namespace
{
bool isOwn(const std::string& name)
{
  const std::vector<std::string>& maps = MapCatalogue::names();
  return name == "Control" || isChartArray(name) ||
    std::find(maps.begin(), maps.end(), name) != maps.end();
}

Status checkNumbers(vtkDataArray* array, const std::string& name, const std::string& element)
{
  if (isOwn(name))
  {
    return Status::error("The input's array " + name +
      " has the name of one that Stipple makes, which would take its place: rename it.");
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      if (const double value = array->GetComponent(i, k); !std::isfinite(value))
      {
        return Status::error("The array " + name + " of the input is " +
          (std::isnan(value) ? "NaN" : "infinite") + " at " + element + " " + std::to_string(i) +
          ": it must be finite.");
      }
    }
  }
  return Status::success();
}

Status checkLengths(vtkDataArray* array, const std::string& name, const std::string& element)
{
  if (const int components = array->GetNumberOfComponents(); components != 1)
  {
    return Status::error("The array " + name + " of the input has " + std::to_string(components) +
      " components: lengths of edges are single numbers.");
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    if (!(array->GetComponent(i, 0) > 0.))
    {
      return Status::error("The array " + name + " of the input is not above 0 at " + element +
        " " + std::to_string(i) + ": no edge can have that length.");
    }
  }
  return Status::success();
}

using Check = Status (*)(vtkDataArray*, const std::string& name, const std::string& element);

/// The check's answer for the input's array of that name, on points if there is one.
Status checkArray(vtkPolyData* input, const char* name, Check check)
{
  if (!name)
  {
    return Status::success();
  }
  if (vtkDataArray* array = input->GetPointData()->GetArray(name))
  {
    return check(array, name, "point");
  }
  vtkDataArray* array = input->GetCellData()->GetArray(name);
  return array ? check(array, name, "cell") : Status::success();
}
}

Status checkDensityArray(vtkPolyData* input, const char* name)
{
  return checkArray(input, name, checkNumbers);
}

Status checkSizeArray(vtkPolyData* input, const char* name)
{
  const Status status = checkDensityArray(input, name);
  return status.ok() ? checkArray(input, name, checkLengths) : status;
}
}
