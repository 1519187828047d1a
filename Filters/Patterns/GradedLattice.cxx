// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GradedLattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace stipple
{
namespace
{
/// Halvings of the cells of mean size.
constexpr int MostHalvings = 10;

/// Of a corner's coordinate.
constexpr int CornerBits = 31;

/// Corners of cells have whole coordinates at the finest level.
using Corner = std::array<std::int64_t, 2>;

class Cells
{
public:
  Cells(const AreaPoints& area, double wanted)
    : Area(area)
    , Wanted(wanted)
    , Order(area.places.size())
  {
    const Vec2& extent = area.extent;
    const double mean = area.total / (extent.x() * extent.y());
    const double spacing = std::sqrt(wanted / mean);
    const Vec2 steps(std::floor(extent.x() / spacing), std::floor(extent.y() / spacing));
    // One more cell on either side reaches beyond the rectangle.
    const double most = steps.maxCoeff() + 2;
    const int doublings = std::max(0, static_cast<int>(std::ceil(std::log2(most))));
    const int halvings = std::clamp(CornerBits - doublings, 0, MostHalvings);
    this->Unit = std::ldexp(spacing, -halvings);
    this->Origin = 0.5 * (extent - spacing * steps) - Vec2(spacing, spacing);
    std::iota(this->Order.begin(), this->Order.end(), 0);
    const std::int64_t whole = std::int64_t(1) << (doublings + halvings);
    this->grow({ { { 0, 0 } }, { { whole, whole } } }, this->Order.begin(), this->Order.end());
  }
  GradedLattice take() { return std::move(this->Lattice); }

private:
  struct Cell
  {
    Corner low;
    Corner sides;
  };
  using Range = std::vector<int>::iterator;

  Vec2 placeOf(const Corner& corner) const
  {
    return this->Origin +
      this->Unit * Vec2(static_cast<double>(corner[0]), static_cast<double>(corner[1]));
  }
  /// The cell, which has these points, or those that it is split into.
  void grow(const Cell& cell, Range begin, Range end)
  {
    if (begin == end)
    {
      return;
    }
    double area = 0;
    Vec2 squaredLengths = Vec2::Zero();
    for (Range i = begin; i != end; ++i)
    {
      const auto point = static_cast<std::size_t>(*i);
      area += this->Area.areas[point];
      squaredLengths += this->Area.areas[point] * this->Area.squaredStretches[point];
    }
    const Vec2 sides =
      this->Unit * Vec2(static_cast<double>(cell.sides[0]), static_cast<double>(cell.sides[1]));
    const Vec2 high = this->placeOf(cell.low) + sides;
    // What reaches beyond the rectangle would have as much.
    const Vec2 within =
      high.cwiseMin(this->Area.extent) - this->placeOf(cell.low).cwiseMax(Vec2::Zero());
    const bool isLarge = area * sides.x() * sides.y() > 2 * this->Wanted * within.x() * within.y();
    // On the surface; four times the square where it is twice as long as wide.
    const Vec2 squares = squaredLengths.cwiseProduct(sides.cwiseAbs2());
    const bool splits[2] = { cell.sides[0] > 1 && 4 * squares[0] > squares[1],
      cell.sides[1] > 1 && 4 * squares[1] > squares[0] };
    if (isLarge && (splits[0] || splits[1]))
    {
      this->split(cell, splits[0], splits[1], begin, end);
      return;
    }
    this->add(cell, sides.minCoeff());
  }
  void split(const Cell& cell, bool first, bool second, Range begin, Range end)
  {
    if (!first && !second)
    {
      this->grow(cell, begin, end);
      return;
    }
    const int axis = first ? 0 : 1;
    Cell lower = cell;
    lower.sides[axis] /= 2;
    Cell upper = lower;
    upper.low[axis] += lower.sides[axis];
    const double cut = this->placeOf(upper.low)[axis];
    const Range middle = std::partition(begin, end, [this, axis, cut](int i) {
      return this->Area.places[static_cast<std::size_t>(i)][axis] < cut;
    });
    this->split(lower, false, first && second, begin, middle);
    this->split(upper, false, first && second, middle, end);
  }
  void add(const Cell& cell, double length)
  {
    const Corner high = { { cell.low[0] + cell.sides[0], cell.low[1] + cell.sides[1] } };
    this->Lattice.cells.push_back(
      { { this->node(cell.low, length), this->node({ { high[0], cell.low[1] } }, length),
        this->node(high, length), this->node({ { cell.low[0], high[1] } }, length) } });
  }
  int node(const Corner& corner, double length)
  {
    const auto key =
      static_cast<std::uint64_t>(corner[0]) << 32U | static_cast<std::uint64_t>(corner[1]);
    const int next = static_cast<int>(this->Lattice.nodes.size());
    const auto [place, isNew] = this->NodeOf.try_emplace(key, next);
    if (isNew)
    {
      this->Lattice.nodes.push_back(this->placeOf(corner));
      this->Lattice.spacing.push_back(length);
    }
    double& spacing = this->Lattice.spacing[static_cast<std::size_t>(place->second)];
    spacing = std::min(spacing, length);
    return place->second;
  }

  const AreaPoints& Area;
  double Wanted;
  std::vector<int> Order;
  Vec2 Origin = Vec2::Zero();
  double Unit = 1;
  GradedLattice Lattice;
  std::unordered_map<std::uint64_t, int> NodeOf;
};

/// How much longer lines along the parameters' axes are on the surface, squared: the diagonal of
/// the map's first fundamental form.
Vec2 squaredStretches(const AtlasSurface& surface, Face face)
{
  const Vec2 a = surface.cornerUV(face, 1) - surface.cornerUV(face, 0);
  const Vec2 b = surface.cornerUV(face, 2) - surface.cornerUV(face, 0);
  const Vec3 p = surface.point(face, 1) - surface.point(face, 0);
  const Vec3 q = surface.point(face, 2) - surface.point(face, 0);
  const double area = a.x() * b.y() - a.y() * b.x();
  return area > 0
    ? Vec2((b.y() * p - a.y() * q).squaredNorm(), (a.x() * q - b.x() * p).squaredNorm()) /
      (area * area)
    : Vec2(Vec2::Zero());
}
}

AreaPoints spreadArea(
  const AtlasSurface& surface, int chart, double parts, const DensityField& density)
{
  const auto densityAt = [&](Face face, const Vec3& bary) {
    return density.uniform() ? 1. : density.at(surface, { face.index(), bary });
  };
  const auto amountOf = [&](Face face) {
    return surface.faceArea(face) * densityAt(face, Vec3(1, 1, 1) / 3);
  };
  AreaPoints points;
  points.extent = surface.extent[Chart(chart)];
  for (const Face face : surface.faces(Chart(chart)))
  {
    points.total += amountOf(face);
  }
  for (const Face face : surface.faces(Chart(chart)))
  {
    const double area = surface.faceArea(face);
    const Vec2 stretches = stipple::squaredStretches(surface, face);
    // In n rows of triangles alike, of which those that lie upside down have their middles between.
    const int n =
      std::max(1, static_cast<int>(std::ceil(std::sqrt(amountOf(face) * parts / points.total))));
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; i + j < n; ++j)
      {
        for (const double third : { 1. / 3, 2. / 3 })
        {
          if (i + j + 2 * third <= n)
          {
            const Vec3 bary((i + third) / n, (j + third) / n, 1 - (i + j + 2 * third) / n);
            points.places.push_back(surface.parameter(face, bary));
            points.areas.push_back(area / n / n * densityAt(face, bary));
            points.squaredStretches.push_back(stretches);
          }
        }
      }
    }
  }
  return points;
}

GradedLattice gradedLattice(const AreaPoints& area, double wanted)
{
  return area.total > 0 && wanted > 0 ? Cells(area, wanted).take() : GradedLattice();
}

PointBins::PointBins(const std::vector<Vec2>& points)
  : Points(points)
{
  if (points.empty())
  {
    this->Begin.assign(2, 0);
    return;
  }
  Vec2 high = points.front();
  this->Low = high;
  for (const Vec2& p : points)
  {
    this->Low = this->Low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec2 size = high - this->Low;
  // About a point a bin.
  const double n = static_cast<double>(points.size());
  this->Side = std::max({ std::sqrt(size.x() * size.y() / n), size.maxCoeff() / n, 1e-300 });
  this->Width = static_cast<int>(size.x() / this->Side) + 1;
  this->Height = static_cast<int>(size.y() / this->Side) + 1;
  const auto binOfPoint = [this](const Vec2& p) {
    const auto [i, j] = this->binOf(p);
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(this->Width) +
      static_cast<std::size_t>(i);
  };
  this->Begin.assign(
    static_cast<std::size_t>(this->Width) * static_cast<std::size_t>(this->Height) + 1, 0);
  for (const Vec2& p : points)
  {
    ++this->Begin[binOfPoint(p) + 1];
  }
  for (std::size_t bin = 1; bin < this->Begin.size(); ++bin)
  {
    this->Begin[bin] += this->Begin[bin - 1];
  }
  std::vector<int> next(this->Begin.begin(), this->Begin.end() - 1);
  this->Order.resize(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    this->Order[static_cast<std::size_t>(next[binOfPoint(points[p])]++)] = static_cast<int>(p);
  }
}

double PointBins::squaredDistance(const Vec2& place) const
{
  double least = std::numeric_limits<double>::infinity();
  // A point outside of the box is farther than its half side.
  const Vec2 high = this->Low + this->Side * Vec2(this->Width, this->Height);
  const double most =
    std::max((place - this->Low).cwiseAbs().maxCoeff(), (high - place).cwiseAbs().maxCoeff());
  for (double reach = this->Side; !this->Points.empty(); reach *= 2)
  {
    this->forEachIn(place - Vec2(reach, reach), place + Vec2(reach, reach), [&](int p) {
      least = std::min(least, (this->Points[static_cast<std::size_t>(p)] - place).squaredNorm());
    });
    if (least <= reach * reach || reach > most)
    {
      break;
    }
  }
  return least;
}

std::array<int, 2> PointBins::binOf(const Vec2& point) const
{
  const Vec2 place = (point - this->Low) / this->Side;
  const auto within = [](double x, int n) {
    return static_cast<int>(std::clamp(x, 0., static_cast<double>(n - 1)));
  };
  return { { within(place.x(), this->Width), within(place.y(), this->Height) } };
}

void PointBins::forEachIn(
  const Vec2& low, const Vec2& high, const std::function<void(int)>& visit) const
{
  const auto [i0, j0] = this->binOf(low);
  const auto [i1, j1] = this->binOf(high);
  for (int j = j0; j <= j1; ++j)
  {
    for (int i = i0; i <= i1; ++i)
    {
      const std::size_t bin = static_cast<std::size_t>(j) * static_cast<std::size_t>(this->Width) +
        static_cast<std::size_t>(i);
      for (int k = this->Begin[bin]; k < this->Begin[bin + 1]; ++k)
      {
        const int p = this->Order[static_cast<std::size_t>(k)];
        const Vec2& place = this->Points[static_cast<std::size_t>(p)];
        if ((place - low).minCoeff() >= 0 && (high - place).minCoeff() >= 0)
        {
          visit(p);
        }
      }
    }
  }
}
}
