// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The boundary of a disk chart on the sides of a rectangle (paper 2.2).
#ifndef stipple_RectangleLayout_h
#define stipple_RectangleLayout_h

#include "ChartMesh.h"

#include <array>
#include <optional>

namespace stipple
{
/// A rectangle and where its corners sit on the boundary, counterclockwise, as fractions of the
/// boundary's length (of which only the part after the point counts).
struct RectanglePlacement
{
  std::array<double, 4> corner;
  Vec2 extent; ///< width and height; the larger is 1
  bool isOfRibbon = false;
};

class RectangleLayout
{
public:
  /// The chart has to outlive the layout; its boundary has four vertices or more.
  RectangleLayout(const TriangleSurface& surface, const ChartMesh& chart);

  /// Rectangles worth trying: with sides of 1, 2 or 4 times the other sides' length, turned around
  /// from the boundary's sharpest corner; and with corners at the boundary's sharpest corners,
  /// where a conformal map would else have to straighten an angle, which makes it dense there.
  std::vector<RectanglePlacement> placements(bool square) const;

  /// Puts the boundary vertices on the rectangle's sides, by arc length between its corners.
  void place(const RectanglePlacement& placement, std::vector<Vec2>& uv) const;

private:
  struct Corner
  {
    double at;   // fraction of the boundary
    double turn; // radians, to the left
  };
  std::vector<Corner> sharpestCorners() const;
  /// Of the boundary's vertices so near to a place, as a share of it, the one that turns most, if
  /// one is a corner.
  std::optional<double> sharpCornerNear(double at, double reach) const;
  /// For a boundary as long, about the area, as that of a rectangle much longer than wide: its
  /// short sides between two corners as near to each other as that, each pair far from the other.
  std::vector<RectanglePlacement> slenderPlacements(const std::vector<Corner>& corners) const;
  /// The corners of a chart that has four, as near to each other as they are; else none.
  std::vector<Corner> cornersOfSlender() const;

  const ChartMesh& Chart;
  double Area = 0;
  std::vector<double> ArcLength; // at the boundary's vertices and, last, in total
  std::vector<double> Turn;      // at the boundary's vertices, radians
};
}

#endif
