// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The boundary of a disk chart on the sides of a rectangle (paper 2.2).
#ifndef stipple_RectangleLayout_h
#define stipple_RectangleLayout_h

#include "ChartMesh.h"

#include <optional>

namespace stipple
{
/// A rectangle and where its corners sit on the boundary, counterclockwise, as fractions of the
/// boundary's length (of which only the part after the point counts).
struct RectanglePlacement
{
  std::array<double, 4> corner;
  Vec2 extent; ///< width and height; the larger is 1
  /// Whether the extent is to be the one with which the map is closest to conformal: long charts'.
  bool fits = false;
};

class RectangleLayout
{
public:
  /// The chart has to outlive the layout; its boundary has four vertices or more.
  RectangleLayout(const TriangleSurface& surface, const ChartMesh& chart);

  /// Rectangles worth trying: with sides of 1, 2 or 4 times the other sides' length, turned around
  /// from the boundary's sharpest corner; with corners at the boundary's sharpest corners, where a
  /// conformal map would else have to straighten an angle, which makes it dense there; and, for a
  /// long chart, with the chart's perimeter and area and short sides at its two ends.
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
  /// The corners of a chart that has four, as near to each other as they are; else none.
  std::vector<Corner> cornersOfSlender() const;
  /// Where a long chart ends, as a fraction of the boundary (the other end is half of it away): its
  /// boundary, folded there, lies upon itself but for the chart's width. None if that is not small
  /// everywhere: a wide chart that is cut open has a long boundary, too.
  std::optional<double> foldOfLong(double length, double width) const;
  /// A place on the boundary, by a fraction of it.
  Vec3 pointAt(double fraction) const;
  /// Of a long chart, whose area and perimeter are those of such a rectangle; its corners as they
  /// come, and moved to sharp ones nearby. None for others.
  std::vector<RectanglePlacement> placementsOfLong() const;

  const ChartMesh& Chart;
  double Area = 0;
  std::vector<Vec3> Outline;     // positions of the boundary's vertices
  std::vector<double> ArcLength; // at the boundary's vertices and, last, in total
  std::vector<double> Turn;      // at the boundary's vertices, radians
};
}

#endif
