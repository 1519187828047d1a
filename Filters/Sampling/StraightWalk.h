// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A straight walk: what lies on the surface beside a backbone or around a place, over seams and
// creases.
#ifndef stipple_StraightWalk_h
#define stipple_StraightWalk_h

#include "AtlasSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stipple
{
/// A straight walk on the surface; it ends at the latest after so many faces.
class StraightWalk
{
public:
  /// From a place of an edge into the face on its left, at a right angle.
  StraightWalk(const AtlasSurface& surface, int halfedge, const Vec3& bary, int mostFaces)
    : Surface(surface)
    , MostFaces(mostFaces)
    , Face(halfedge / 3)
    , Entry(halfedge % 3)
    , Bary(bary)
  {
    this->setDirection(0., 1.);
  }
  /// From inside a face along a unit vector in its plane.
  StraightWalk(
    const AtlasSurface& surface, int face, const Vec3& bary, const Vec3& direction, int mostFaces)
    : Surface(surface)
    , MostFaces(mostFaces)
    , Face(face)
    , Entry(-1)
    , Bary(bary)
  {
    this->setDirection(direction);
  }

  int face() const { return this->Face; }
  const Vec3& bary() const { return this->Bary; }
  Vec3 position() const { return this->Surface.position(this->Face, this->Bary); }
  /// In space, of unit length.
  const Vec3& direction() const { return this->Direction; }

  /// Goes on by a length; calls crossed(halfedge, length left) for every edge on the way, which
  /// says whether it may be crossed, with the walk at the edge. False where the walk ends.
  template <typename F>
  bool advance(double length, F crossed)
  {
    for (;;)
    {
      if (!this->Valid)
      {
        return false;
      }
      double reach = std::numeric_limits<double>::max();
      int corner = -1;
      for (int k = 0; k < 3; ++k)
      {
        // The edge opposite corner k is halfedge k + 1 of the face.
        if (this->Rate[k] < 0 && (k + 1) % 3 != this->Entry)
        {
          const double t = std::max(0., -this->Bary[k] / this->Rate[k]);
          if (t < reach)
          {
            reach = t;
            corner = k;
          }
        }
      }
      if (corner < 0)
      {
        return false;
      }
      if (length <= reach)
      {
        this->Bary = clampedBarycentric(this->Bary + length * this->Rate);
        return true;
      }
      length -= reach;
      const int h = 3 * this->Face + (corner + 1) % 3;
      const int twin = this->Surface.twin[h];
      this->Bary = clampedBarycentric(this->Bary + reach * this->Rate);
      if (!crossed(h, length) || twin < 0 || ++this->Crossed > this->MostFaces)
      {
        return false;
      }
      const Vec3 edge =
        (this->Surface.points[this->Surface.head(h)] - this->Surface.points[this->Surface.tail(h)])
          .normalized();
      const double along = std::clamp(this->Direction.dot(edge), -1., 1.);
      const double atTail = this->Bary[h % 3];
      this->Face = twin / 3;
      this->Entry = twin % 3;
      this->Bary = Vec3::Zero();
      this->Bary[nextHalfedge(twin) % 3] = atTail;
      this->Bary[twin % 3] = 1. - atTail;
      // The new face's own direction along its edge is the opposite one.
      this->setDirection(-along, std::sqrt(std::max(0., 1. - along * along)));
    }
  }

private:
  /// The corners of the face, and its normal, twice as long as its area.
  struct Corners
  {
    std::array<Vec3, 3> opposite; ///< edges
    Vec3 normal;
  };
  Corners corners() const
  {
    const Vec3& a = this->Surface.point(this->Face, 0);
    const Vec3& b = this->Surface.point(this->Face, 1);
    const Vec3& c = this->Surface.point(this->Face, 2);
    return { { { c - b, a - c, b - a } }, (b - a).cross(c - a) };
  }

  /// A direction in the face, by its parts along the edge of entry and away from it.
  void setDirection(double along, double away)
  {
    const Corners corners = this->corners();
    const double area = corners.normal.norm(); // twice
    const Vec3& edge = corners.opposite[(this->Entry + 2) % 3];
    const double length = edge.norm();
    this->Valid = area > 0 && length > 0;
    if (!this->Valid)
    {
      return;
    }
    const Vec3 normal = corners.normal / area;
    const Vec3 unit = edge / length;
    this->setDirection(along * unit + away * normal.cross(unit), corners, normal, area);
  }
  void setDirection(const Vec3& direction)
  {
    const Corners corners = this->corners();
    const double area = corners.normal.norm();
    this->Valid = area > 0;
    if (this->Valid)
    {
      this->setDirection(direction, corners, corners.normal / area, area);
    }
  }
  void setDirection(const Vec3& direction, const Corners& corners, const Vec3& normal, double area)
  {
    this->Direction = direction;
    for (int k = 0; k < 3; ++k)
    {
      this->Rate[k] = this->Direction.dot(normal.cross(corners.opposite[k])) / area;
    }
  }

  const AtlasSurface& Surface;
  const int MostFaces;
  int Face;
  int Entry; // corner at which the edge of entry begins; -1 inside a face
  Vec3 Bary;
  Vec3 Direction = Vec3::Zero();
  Vec3 Rate = Vec3::Zero(); // of the barycentric coordinates, per length
  bool Valid = false;
  int Crossed = 0;
};
}

#endif
