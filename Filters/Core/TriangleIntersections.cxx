// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleIntersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <variant>

namespace stipple
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A hair's breadth above a plane, over lengths.
constexpr double CoplanarTolerance = 1e-9;

// Boxes about each of the surface's triangles, in the mean: slivers of a flat face have them all in
// common, and would be compared each with each.
constexpr double MostPairs = 100;

/// All corners of t, but for those that are shared, lie on one side of the plane of s, and not by a
/// hair's breadth: then nothing but a shared corner is common to both.
bool isBeside(const PlacedTriangle& s, const PlacedTriangle& t)
{
  const Vec3& a = s.point[0];
  const Vec3 u = s.point[1] - a;
  const Vec3 w = s.point[2] - a;
  const Vec3 n = u.cross(w);
  const double scale = CoplanarTolerance * u.norm() * w.norm();
  int sides = 0; // 1: above, 2: below, 4: near the plane
  for (int k = 0; k < 3; ++k)
  {
    if (t.id[k] != s.id[0] && t.id[k] != s.id[1] && t.id[k] != s.id[2])
    {
      const Vec3 p = t.point[k] - a;
      const double height = n.dot(p);
      const double noise = scale * p.norm();
      sides |= height > noise ? 1 : height < -noise ? 2 : 4;
    }
  }
  return sides == 1 || sides == 2;
}

/// The plane through an edge of s, upright on s, parts the triangles: all corners of t, but for one
/// that is shared and ends the edge, lie beyond it, and not by a hair's breadth. Of triangles in
/// one plane that have a corner in common at most, and do not touch elsewhere, either has such an
/// edge.
bool isBeyondAnEdge(const PlacedTriangle& s, const PlacedTriangle& t)
{
  const Vec3 n = (s.point[1] - s.point[0]).cross(s.point[2] - s.point[0]);
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const Vec3 outwards = (s.point[next] - s.point[k]).cross(n);
    const double scale = CoplanarTolerance * outwards.norm();
    // s itself is on this side, whatever rounding made of the normal.
    bool beyond = outwards.dot(s.point[(k + 2) % 3] - s.point[k]) < 0.;
    for (int j = 0; beyond && j < 3; ++j)
    {
      const Vec3 p = t.point[j] - s.point[k];
      beyond = t.id[j] == s.id[k] || t.id[j] == s.id[next] || outwards.dot(p) > scale * p.norm();
    }
    if (beyond)
    {
      return true;
    }
  }
  return false;
}

/// What a triangle or an edge is: CGAL's predicates want none that is less than it seems.
using Simplex = std::variant<Kernel::Point_3, Kernel::Segment_3, Kernel::Triangle_3>;

Simplex edge(const Kernel::Point_3& a, const Kernel::Point_3& b)
{
  return a == b ? Simplex(a) : Simplex(Kernel::Segment_3(a, b));
}

Kernel::Point_3 pointOf(const PlacedTriangle& t, int k)
{
  const Vec3& p = t.point[k % 3];
  return Kernel::Point_3(p.x(), p.y(), p.z());
}

Simplex oppositeOf(const PlacedTriangle& t, int k)
{
  return edge(pointOf(t, k + 1), pointOf(t, k + 2));
}

Simplex wholeOf(const PlacedTriangle& t)
{
  const Kernel::Triangle_3 whole(pointOf(t, 0), pointOf(t, 1), pointOf(t, 2));
  if (!whole.is_degenerate())
  {
    return whole;
  }
  // Collinear points: in their order along the line the first and the last.
  const auto [first, last] = std::minmax({ whole[0], whole[1], whole[2] });
  return edge(first, last);
}

bool meet(const Simplex& a, const Simplex& b)
{
  return std::visit([](const auto& x, const auto& y) { return CGAL::do_intersect(x, y); }, a, b);
}

struct FaceBox : CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_NONE>
{
  FaceBox(const Box& box, int f)
    : Box_d(CGAL::Bbox_3(
        box.low.x(), box.low.y(), box.low.z(), box.high.x(), box.high.y(), box.high.z()))
    , Face(f)
  {
  }
  std::size_t id() const { return static_cast<std::size_t>(this->Face); }
  int Face;
};
}

bool intersect(const PlacedTriangle& s, const PlacedTriangle& t)
{
  int sharedS = -1;
  int sharedT = -1;
  int shared = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (s.id[i] == t.id[j])
      {
        sharedS = i;
        sharedT = j;
        ++shared;
      }
    }
  }
  if (shared > 1 || isBeside(s, t) || isBeside(t, s) || isBeyondAnEdge(s, t) ||
    isBeyondAnEdge(t, s))
  {
    return false;
  }
  if (shared == 0)
  {
    return meet(wholeOf(s), wholeOf(t));
  }
  return meet(oppositeOf(s, sharedS), wholeOf(t)) || meet(oppositeOf(t, sharedT), wholeOf(s));
}

std::optional<std::vector<Box>> placesOfIntersections(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  const auto placed = [&](int f) {
    const Triangle& t = triangles[f];
    return PlacedTriangle{ t, { points[t[0]], points[t[1]], points[t[2]] } };
  };
  const auto boxOf = [&](int f) {
    const Triangle& t = triangles[f];
    return Box::around(points[t[0]], points[t[1]], points[t[2]]);
  };
  std::vector<FaceBox> boxes;
  boxes.reserve(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    boxes.emplace_back(boxOf(static_cast<int>(f)), static_cast<int>(f));
  }
  std::vector<Box> places;
  struct TooMany
  {
  };
  double left = MostPairs * static_cast<double>(triangles.size());
  try
  {
    CGAL::box_self_intersection_d(
      boxes.begin(), boxes.end(), [&](const FaceBox& a, const FaceBox& b) {
        if (--left < 0)
        {
          throw TooMany(); // no other way leads out
        }
        if (intersect(placed(a.Face), placed(b.Face)))
        {
          places.push_back(boxOf(a.Face).common(boxOf(b.Face)));
        }
      });
  }
  catch (const TooMany&)
  {
    return {};
  }
  return places;
}
}
