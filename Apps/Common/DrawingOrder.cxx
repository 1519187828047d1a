// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingOrder.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace stipple
{
namespace
{
constexpr int Bits = 21; ///< a coordinate's: three are a key

/// With two places free after each bit.
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffffU;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffU;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fU;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3U;
  return (bits | bits << 2) & 0x1249249249249249U;
}
}

vtkSmartPointer<vtkCellArray> inDrawingOrder(vtkPolyData* mesh)
{
  vtkCellArray* polygons = mesh->GetPolys();
  double bounds[6];
  mesh->GetBounds(bounds);
  const double longest =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  constexpr double Largest = (1 << Bits) - 1;
  const double toKey = longest > 0 ? Largest / longest : 0.;
  std::vector<std::pair<std::uint64_t, vtkIdType>> order;
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    polygons->GetCellAtId(cell, size, ids);
    std::array<double, 3> sum{};
    for (vtkIdType k = 0; k < size; ++k)
    {
      std::array<double, 3> x{};
      mesh->GetPoint(ids[k], x.data());
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += (x[axis] - bounds[2 * axis]) / static_cast<double>(size);
      }
    }
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double place = sum[axis] * toKey; // no number where the box has no size
      key |= spread(place > 0. ? static_cast<std::uint64_t>(std::min(place, Largest)) : 0) << axis;
    }
    order.emplace_back(key, cell);
  }
  std::sort(order.begin(), order.end());
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->AllocateExact(polygons->GetNumberOfCells(), polygons->GetNumberOfConnectivityIds());
  for (const auto& [key, cell] : order)
  {
    vtkIdType size;
    const vtkIdType* ids;
    polygons->GetCellAtId(cell, size, ids);
    result->InsertNextCell(size, ids);
  }
  return result;
}
}
