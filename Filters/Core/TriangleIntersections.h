// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of a surface that pass through each other.
#ifndef stipple_TriangleIntersections_h
#define stipple_TriangleIntersections_h

#include "Progress.h"
#include "StippleFiltersCoreModule.h"
#include "TriangleSurface.h"

#include <array>
#include <optional>
#include <vector>

namespace stipple
{
/// An axis-aligned box.
struct Box
{
  Vec3 low;
  Vec3 high;

  static Box around(const Vec3& a, const Vec3& b, const Vec3& c)
  {
    return { a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c) };
  }
  bool overlaps(const Box& other) const
  {
    return (other.low.array() <= this->high.array()).all() &&
      (this->low.array() <= other.high.array()).all();
  }
  /// What is in both, which overlap.
  Box common(const Box& other) const
  {
    return { this->low.cwiseMax(other.low), this->high.cwiseMin(other.high) };
  }
  Box grown(double by) const
  {
    return { this->low - Vec3::Constant(by), this->high + Vec3::Constant(by) };
  }
};

/// A triangle by the ids of its vertices and where they are.
struct PlacedTriangle
{
  std::array<int, 3> id;
  std::array<Vec3, 3> point;

  Box box() const { return Box::around(this->point[0], this->point[1], this->point[2]); }
};

/// Whether two triangles have more in common than a vertex or an edge that they share: exact, but
/// for what lies beside a plane by more than a hair's breadth. Folds about an edge do not count.
STIPPLEFILTERSCORE_EXPORT bool intersect(const PlacedTriangle& s, const PlacedTriangle& t);

/// For every pair of triangles that intersect, the box that both reach into, in an order of its
/// own. Nothing where boxes about triangles have far too much in common to compare them, as those
/// of slivers do.
STIPPLEFILTERSCORE_EXPORT std::optional<std::vector<Box>> placesOfIntersections(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
}

#endif
