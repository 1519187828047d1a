// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "XmlNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <vtk_utf8.h>

#include <iterator>
#include <vector>

namespace stipple
{
namespace
{
bool isXmlName(vtkAbstractArray* array)
{
  return !array->GetName() || xmlName(array->GetName()) == array->GetName();
}

bool hasXmlNames(vtkFieldData* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (!isXmlName(data->GetAbstractArray(i)))
    {
      return false;
    }
  }
  return true;
}

void rename(vtkFieldData* data)
{
  auto* attributes = vtkDataSetAttributes::SafeDownCast(data);
  std::vector<vtkSmartPointer<vtkAbstractArray>> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkAbstractArray* array = data->GetAbstractArray(i); !isXmlName(array))
    {
      arrays.emplace_back(array);
    }
  }
  for (const auto& array : arrays)
  {
    auto copy = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    auto* numbers = vtkDataArray::SafeDownCast(array);
    if (numbers)
    {
      vtkDataArray::SafeDownCast(copy)->ShallowCopy(numbers);
    }
    else
    {
      copy->DeepCopy(array);
    }
    const std::string name = xmlName(array->GetName());
    copy->SetName(name.c_str());
    data->AddArray(copy);
    for (int a = 0; attributes && a < vtkDataSetAttributes::NUM_ATTRIBUTES; ++a)
    {
      if (attributes->GetAbstractAttribute(a) == array)
      {
        attributes->SetActiveAttribute(name.c_str(), a);
      }
    }
    data->RemoveArray(array->GetName());
  }
}

template <typename DataSet>
vtkSmartPointer<DataSet> renamed(DataSet* data)
{
  if (hasXmlNames(data->GetPointData()) && hasXmlNames(data->GetCellData()) &&
    hasXmlNames(data->GetFieldData()))
  {
    return data;
  }
  auto copy = vtkSmartPointer<DataSet>::New();
  copy->ShallowCopy(data);
  rename(copy->GetPointData());
  rename(copy->GetCellData());
  rename(copy->GetFieldData());
  return copy;
}
}

std::string xmlName(const std::string& name)
{
  std::string text;
  utf8::replace_invalid(name.begin(), name.end(), std::back_inserter(text), U'?');
  std::string result;
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    result += c == '&' ? "&amp;"
      : c == '<'       ? "&lt;"
      : c == '"'       ? "&quot;"
                       : std::string(1, byte < 0x20 || byte == 0x7F ? '?' : c);
  }
  return result;
}

vtkSmartPointer<vtkPolyData> withXmlNames(vtkPolyData* data)
{
  return renamed(data);
}

vtkSmartPointer<vtkImageData> withXmlNames(vtkImageData* data)
{
  return renamed(data);
}
}
