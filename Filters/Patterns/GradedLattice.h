// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_GradedLattice_h
#define stipple_GradedLattice_h

#include "AtlasSurface.h"
#include "DensityField.h"
#include "StippleFiltersPatternsModule.h"

#include <array>
#include <functional>
#include <vector>

namespace stipple
{
/// A chart's area, times a density, as points in its plane, each with as much as its part of a
/// triangle.
struct AreaPoints
{
  Vec2 extent = Vec2::Zero(); ///< the chart's rectangle is from the origin to there
  std::vector<Vec2> places;
  std::vector<double> areas;
  std::vector<Vec2> squaredStretches; ///< of lines along the axes, from the plane to the surface
  double total = 0;
};

/// No point has more than the chart's area over `parts`, but where the density is no constant on a
/// triangle.
[[nodiscard]] STIPPLEFILTERSPATTERNS_EXPORT AreaPoints spreadArea(
  const AtlasSurface& surface, int chart, double parts, const DensityField& density = {});

/// Cells along the axes of a chart's plane.
struct GradedLattice
{
  std::vector<Vec2> nodes;               ///< the cells' corners, each once; some are outside
  std::vector<double> spacing;           ///< by node: the least side of a cell there
  std::vector<std::array<int, 4>> cells; ///< nodes from the lower left on, counterclockwise
};

/// Cells that have about as much of it as is wanted, at most twice: the squares of a lattice that
/// is centred in the rectangle where the chart's map stretches the surface alike; elsewhere parts
/// of these, or several of them, as an area quadtree has them, of which a cell that is twice as
/// long as wide on the surface is split in its length only. No point of `area` is to have more than
/// a small part of what is wanted.
[[nodiscard]] STIPPLEFILTERSPATTERNS_EXPORT GradedLattice gradedLattice(
  const AreaPoints& area, double wanted);

/// Points in a plane, to be asked for those in a box.
class STIPPLEFILTERSPATTERNS_EXPORT PointBins
{
public:
  explicit PointBins(const std::vector<Vec2>& points);
  /// Calls visit(i) for the points in the box, its sides included.
  void forEachIn(const Vec2& low, const Vec2& high, const std::function<void(int)>& visit) const;
  /// Of the nearest point; infinite where there is none.
  double squaredDistance(const Vec2& place) const;

private:
  std::array<int, 2> binOf(const Vec2& point) const;

  std::vector<Vec2> Points;
  Vec2 Low = Vec2::Zero();
  double Side = 1;
  int Width = 1;
  int Height = 1;
  std::vector<int> Begin; ///< by bin, into Order
  std::vector<int> Order;
};
}

#endif
