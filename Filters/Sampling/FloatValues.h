// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The values of a VTK array as floats.
#ifndef stipple_FloatValues_h
#define stipple_FloatValues_h

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkFloatArray.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace stipple
{
/// The norm where there are several components. Borrowed where they are floats already.
class FloatValues
{
public:
  explicit FloatValues(vtkDataArray* array)
  {
    auto* floats = vtkFloatArray::SafeDownCast(array);
    if (floats && floats->GetNumberOfComponents() == 1)
    {
      this->Data = floats->GetPointer(0);
      return;
    }
    this->Copy.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
    const auto copy = [this](auto* typed) {
      const auto tuples = vtk::DataArrayTupleRange(typed);
      for (vtkIdType i = 0; i < tuples.size(); ++i)
      {
        double squared = 0;
        double last = 0;
        for (const auto component : tuples[i])
        {
          last = static_cast<double>(component);
          squared += last * last;
        }
        this->Copy[i] = static_cast<float>(tuples[i].size() == 1 ? last : std::sqrt(squared));
      }
    };
    if (!vtkArrayDispatch::Dispatch::Execute(array, copy))
    {
      copy(array);
    }
    this->Data = this->Copy.data();
  }
  FloatValues(const FloatValues&) = delete;
  void operator=(const FloatValues&) = delete;
  float operator[](std::size_t i) const { return this->Data[i]; }
  const float* data() const { return this->Data; }

private:
  const float* Data;
  std::vector<float> Copy;
};
}

#endif
