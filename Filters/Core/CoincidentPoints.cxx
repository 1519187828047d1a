// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CoincidentPoints.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace stipple
{
std::vector<vtkIdType> firstAtPlace(vtkPolyData* data)
{
  const auto n = static_cast<std::size_t>(data->GetNumberOfPoints());
  std::vector<Place> places(n);
  for (std::size_t p = 0; p < n; ++p)
  {
    data->GetPoint(static_cast<vtkIdType>(p), places[p].data());
    places[p] = placeOf(places[p].data());
  }
  std::vector<vtkIdType> first(n);
  std::iota(first.begin(), first.end(), 0);
  std::vector<vtkIdType> order = first;
  // By their bytes, so that what is no number has a place in the order, too.
  const auto compare = [&places](vtkIdType a, vtkIdType b) {
    return std::memcmp(places[a].data(), places[b].data(), sizeof(Place));
  };
  std::sort(order.begin(), order.end(), [&compare](vtkIdType a, vtkIdType b) {
    const int difference = compare(a, b);
    return difference != 0 ? difference < 0 : a < b;
  });
  for (std::size_t i = 1; i < n; ++i)
  {
    if (compare(order[i - 1], order[i]) == 0)
    {
      first[order[i]] = first[order[i - 1]];
    }
  }
  return first;
}
}
