// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <map>

namespace stipple
{
namespace
{
const char* const NameOfName = "RegionArrayName";
}

std::string regionArrayName(vtkDataObject* data)
{
  auto* names = data
    ? vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(NameOfName))
    : nullptr;
  return names && names->GetNumberOfValues() > 0 ? names->GetValue(0) : std::string();
}

void setRegionArrayName(vtkDataObject* data, const std::string& name)
{
  vtkNew<vtkStringArray> names;
  names->SetName(NameOfName);
  names->InsertNextValue(name);
  data->GetFieldData()->AddArray(names);
}

std::string regionNamesOf(const std::string& regionArray)
{
  const std::size_t end = regionArray.size() < 3 ? regionArray.size() : regionArray.size() - 3;
  return (regionArray.substr(end) == "Ids" ? regionArray.substr(0, end) : regionArray) + "Names";
}

std::vector<int> numberRegions(vtkAbstractArray* labels)
{
  std::map<vtkVariant, int, vtkVariantLessThan> numbers;
  std::vector<int> result(static_cast<std::size_t>(labels->GetNumberOfTuples()));
  std::vector<int*> slots;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    slots.push_back(&numbers[labels->GetVariantValue(static_cast<vtkIdType>(i))]);
  }
  int next = 0;
  for (auto& number : numbers)
  {
    number.second = next++;
  }
  std::transform(slots.begin(), slots.end(), result.begin(), [](const int* slot) { return *slot; });
  return result;
}

Status findRegions(vtkPolyData* surface, const std::string& name, vtkAbstractArray*& labels)
{
  vtkCellData* arrays = surface->GetCellData();
  labels = arrays->GetAbstractArray(name.c_str());
  if (!labels)
  {
    std::string have;
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      const char* other = arrays->GetArrayName(i);
      have += (have.empty() ? "" : ", ") + std::string(other ? other : "");
    }
    return Status::error("The input has no cell array '" + name + "' of regions; it has " +
      (have.empty() ? "none." : have + "."));
  }
  if (labels->GetNumberOfComponents() != 1)
  {
    return Status::error("The cell array '" + name + "' has " +
      std::to_string(labels->GetNumberOfComponents()) +
      " components: the label of a region needs one.");
  }
  return Status::success();
}
}
