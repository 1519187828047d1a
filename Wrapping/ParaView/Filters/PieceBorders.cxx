// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceBorders.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace stipple
{
namespace
{
constexpr double RelativeTolerance = 1e-6; // of the diagonal: some ulps of a float
constexpr double ShareOfEdge = 0.25;       // of a border's edge: its ends never become one

using Place = std::array<double, 3>;

Place placeOf(vtkPoints* points, vtkIdType point)
{
  Place place;
  points->GetPoint(point, place.data());
  return place;
}

double distance(const Place& a, const Place& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

template <std::size_t N>
struct Hash
{
  std::size_t operator()(const std::array<long long, N>& key) const
  {
    std::size_t hash = 0;
    for (const long long k : key)
    {
      hash = (hash ^ static_cast<std::size_t>(k)) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// The shortest border edge at each point: an edge that one polygon alone uses. Infinity at points
/// that are on none.
std::vector<double> shortestBorderEdges(vtkPolyData* data)
{
  std::unordered_map<std::array<long long, 2>, int, Hash<2>> uses;
  const vtkIdType count = data->GetNumberOfPoints();
  const auto use = [&uses, count](vtkIdType a, vtkIdType b) {
    if (a != b && std::min(a, b) >= 0 && std::max(a, b) < count) // the remesher will complain
    {
      ++uses[{ std::min(a, b), std::max(a, b) }];
    }
  };
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      use(ids[i], ids[(i + 1) % size]);
    }
  }
  auto strips = vtk::TakeSmartPointer(data->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell())
  {
    strips->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      use(ids[i], ids[i + 1]);
      use(ids[i + 1], ids[i + 2]);
      use(ids[i + 2], ids[i]);
    }
  }
  std::vector<double> shortest(
    static_cast<std::size_t>(count), std::numeric_limits<double>::infinity());
  for (const auto& [edge, number] : uses)
  {
    const double length =
      distance(placeOf(data->GetPoints(), edge[0]), placeOf(data->GetPoints(), edge[1]));
    if (number == 1 && length > 0)
    {
      shortest[edge[0]] = std::min(shortest[edge[0]], length);
      shortest[edge[1]] = std::min(shortest[edge[1]], length);
    }
  }
  return shortest;
}

/// Points of borders by where they lie.
class Lattice
{
public:
  explicit Lattice(double tolerance)
    : Tolerance(tolerance)
  {
  }

  void add(const Place& place, double reach)
  {
    this->Cells[key(place)].push_back({ place, reach });
  }

  /// The nearest one that is within both reaches; null if there is none.
  const Place* nearest(const Place& place, double reach) const
  {
    const Place* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    const std::array<long long, 3> middle = key(place);
    for (int i = 0; i < 27; ++i)
    {
      const auto cell = this->Cells.find(
        { middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1 });
      if (cell == this->Cells.end())
      {
        continue;
      }
      for (const auto& [other, otherReach] : cell->second)
      {
        const double d = distance(place, other);
        if (d < least && d <= std::min(reach, otherReach))
        {
          least = d;
          best = &other;
        }
      }
    }
    return best;
  }

private:
  std::array<long long, 3> key(const Place& place) const
  {
    std::array<long long, 3> k;
    std::transform(place.begin(), place.end(), k.begin(), [this](double x) {
      return static_cast<long long>(std::floor(x / this->Tolerance)); // within 2^63: at most 1e9
    });
    return k;
  }

  double Tolerance;
  std::unordered_map<std::array<long long, 3>, std::vector<std::pair<Place, double>>, Hash<3>>
    Cells;
};

void joinByGlobalIds(vtkDataArray* ids, vtkPoints* points)
{
  std::unordered_map<long long, vtkIdType> first;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const auto [found, isNew] = first.emplace(static_cast<long long>(ids->GetComponent(i, 0)), i);
    if (!isNew)
    {
      points->SetPoint(i, placeOf(points, found->second).data());
    }
  }
}
}

vtkSmartPointer<vtkPolyData> joinPieces(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkPolyData* appended)
{
  vtkNew<vtkPolyData> joined;
  joined->ShallowCopy(appended);
  vtkNew<vtkPoints> points;
  points->DeepCopy(appended->GetPoints());
  joined->SetPoints(points);
  const bool haveIds = std::all_of(pieces.begin(), pieces.end(),
    [](vtkPolyData* piece) { return piece->GetPointData()->GetGlobalIds() != nullptr; });
  if (vtkDataArray* ids = haveIds ? joined->GetPointData()->GetGlobalIds() : nullptr)
  {
    joinByGlobalIds(ids, points);
    return joined.Get();
  }
  double bounds[6];
  appended->GetBounds(bounds);
  const double tolerance = RelativeTolerance *
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  if (!(tolerance > 0) || !std::isfinite(tolerance))
  {
    return joined.Get();
  }
  Lattice earlier(tolerance);
  vtkIdType begin = 0;
  for (vtkPolyData* piece : pieces)
  {
    const std::vector<double> edges = shortestBorderEdges(piece);
    std::vector<std::pair<Place, double>> own; // two of a piece are two
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (std::isinf(edges[i]))
      {
        continue;
      }
      const vtkIdType point = begin + static_cast<vtkIdType>(i);
      const Place place = placeOf(points, point);
      const double reach = std::min(tolerance, ShareOfEdge * edges[i]);
      if (const Place* same = earlier.nearest(place, reach))
      {
        points->SetPoint(point, same->data());
      }
      else
      {
        own.emplace_back(place, reach);
      }
    }
    for (const auto& [place, reach] : own)
    {
      earlier.add(place, reach);
    }
    begin += piece->GetNumberOfPoints();
  }
  return joined.Get();
}
}
