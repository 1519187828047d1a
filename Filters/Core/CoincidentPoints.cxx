// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CoincidentPoints.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace stipple
{
std::vector<vtkIdType> firstAtPlace(vtkPolyData* data)
{
  const auto n = static_cast<std::size_t>(data->GetNumberOfPoints());
  // By their bits, so that what is no number has a place in the order, too.
  std::vector<std::array<std::uint64_t, 3>> bits(n);
  for (std::size_t p = 0; p < n; ++p)
  {
    double x[3];
    data->GetPoint(static_cast<vtkIdType>(p), x);
    const Place place = placeOf(x);
    std::memcpy(bits[p].data(), place.data(), sizeof(Place));
  }
  std::vector<vtkIdType> first(n);
  std::iota(first.begin(), first.end(), 0);
  std::vector<vtkIdType> order = first;
  std::sort(order.begin(), order.end(),
    [&bits](vtkIdType a, vtkIdType b) { return bits[a] != bits[b] ? bits[a] < bits[b] : a < b; });
  for (std::size_t i = 1; i < n; ++i)
  {
    if (bits[order[i - 1]] == bits[order[i]])
    {
      first[order[i]] = first[order[i - 1]];
    }
  }
  return first;
}
}
