// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceBorders.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
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

  struct Point
  {
    Place place;
    double reach; ///< what is farther away is another point
    vtkIdType id;
  };

  void add(const Point& point) { this->Cells[key(point.place)].push_back(point); }

  /// The id of the nearest one that is within both reaches; -1 if there is none.
  vtkIdType nearest(const Point& to) const
  {
    vtkIdType best = -1;
    double least = std::numeric_limits<double>::infinity();
    const std::array<long long, 3> middle = key(to.place);
    for (int i = 0; i < 27; ++i)
    {
      const auto cell = this->Cells.find(
        { middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1 });
      if (cell == this->Cells.end())
      {
        continue;
      }
      for (const Point& point : cell->second)
      {
        const double d = distance(to.place, point.place);
        if (d < least && d <= std::min(to.reach, point.reach))
        {
          least = d;
          best = point.id;
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
  std::unordered_map<std::array<long long, 3>, std::vector<Point>, Hash<3>> Cells;
};

/// What point each one becomes: itself, or an earlier one.
std::vector<vtkIdType> sameGlobalIds(vtkDataArray* ids)
{
  std::unordered_map<long long, vtkIdType> first;
  std::vector<vtkIdType> becomes(static_cast<std::size_t>(ids->GetNumberOfTuples()));
  for (std::size_t i = 0; i < becomes.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    becomes[i] =
      first.emplace(static_cast<long long>(ids->GetComponent(point, 0)), point).first->second;
  }
  return becomes;
}

std::vector<vtkIdType> samePlaces(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkPolyData* appended)
{
  std::vector<vtkIdType> becomes(static_cast<std::size_t>(appended->GetNumberOfPoints()));
  std::iota(becomes.begin(), becomes.end(), 0);
  double bounds[6];
  appended->GetBounds(bounds);
  const double tolerance = RelativeTolerance *
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  if (!(tolerance > 0) || !std::isfinite(tolerance))
  {
    return becomes;
  }
  Lattice earlier(tolerance);
  vtkIdType begin = 0;
  for (vtkPolyData* piece : pieces)
  {
    const std::vector<double> edges = shortestBorderEdges(piece);
    std::vector<Lattice::Point> own; // two of a piece are two
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (std::isinf(edges[i]))
      {
        continue;
      }
      const vtkIdType point = begin + static_cast<vtkIdType>(i);
      const Lattice::Point here{ placeOf(appended->GetPoints(), point),
        std::min(tolerance, ShareOfEdge * edges[i]), point };
      const vtkIdType same = earlier.nearest(here);
      if (same >= 0)
      {
        becomes[static_cast<std::size_t>(point)] = same;
      }
      else
      {
        own.push_back(here);
      }
    }
    for (const Lattice::Point& point : own)
    {
      earlier.add(point);
    }
    begin += piece->GetNumberOfPoints();
  }
  return becomes;
}

vtkSmartPointer<vtkCellArray> renumbered(vtkCellArray* cells, const std::vector<vtkIdType>& newIds)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  std::vector<vtkIdType> cell;
  auto each = vtk::TakeSmartPointer(cells->NewIterator());
  for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
  {
    each->GetCurrentCell(size, ids);
    cell.assign(ids, ids + size);
    for (vtkIdType& id : cell)
    {
      const bool isPoint = id >= 0 && id < static_cast<vtkIdType>(newIds.size());
      id = isPoint ? newIds[static_cast<std::size_t>(id)] : id; // the filter will complain
    }
    result->InsertNextCell(size, cell.data());
  }
  return result;
}
}

vtkSmartPointer<vtkPolyData> joinPieces(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkPolyData* appended)
{
  const bool haveIds = std::all_of(pieces.begin(), pieces.end(),
    [](vtkPolyData* piece) { return piece->GetPointData()->GetGlobalIds() != nullptr; });
  vtkDataArray* ids = haveIds ? appended->GetPointData()->GetGlobalIds() : nullptr;
  const std::vector<vtkIdType> becomes = ids ? sameGlobalIds(ids) : samePlaces(pieces, appended);

  std::vector<vtkIdType> newIds(becomes.size());
  vtkNew<vtkIdList> kept;
  for (std::size_t i = 0; i < becomes.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    newIds[i] = becomes[i] == point ? kept->InsertNextId(point)
                                    : newIds[static_cast<std::size_t>(becomes[i])];
  }
  vtkNew<vtkPolyData> joined;
  joined->ShallowCopy(appended); // for the cells' arrays, and those of the whole
  joined->GetPointData()->Initialize();
  joined->GetPointData()->CopyAllOn();
  joined->GetPointData()->CopyAllocate(appended->GetPointData(), kept->GetNumberOfIds());
  vtkNew<vtkPoints> points;
  points->SetDataType(appended->GetPoints()->GetDataType());
  points->SetNumberOfPoints(kept->GetNumberOfIds());
  for (vtkIdType i = 0; i < kept->GetNumberOfIds(); ++i)
  {
    points->SetPoint(i, appended->GetPoint(kept->GetId(i)));
    joined->GetPointData()->CopyData(appended->GetPointData(), kept->GetId(i), i);
  }
  joined->SetPoints(points);
  joined->SetVerts(renumbered(appended->GetVerts(), newIds));
  joined->SetLines(renumbered(appended->GetLines(), newIds));
  joined->SetPolys(renumbered(appended->GetPolys(), newIds));
  joined->SetStrips(renumbered(appended->GetStrips(), newIds));
  return joined.Get();
}
}
