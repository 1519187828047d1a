// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A straight walk: what lies on the surface beside a backbone or around a place, over seams and
// creases.
#ifndef stipple_StraightWalk_h
#define stipple_StraightWalk_h

#include "AtlasSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
/// A straight walk on the surface; it ends at the latest after so many faces. The face that it is
/// in lies in a plane of its own, one of its edges, the base, from (0, 0) to the right.
class StraightWalk
{
public:
  /// From a place of an edge into the face on its left, at a right angle.
  StraightWalk(const AtlasSurface& surface, int halfedge, const Vec3& bary, int mostFaces)
    : Surface(surface)
    , MostFaces(mostFaces)
    , Halfedge(halfedge)
    , Entered(true)
  {
    this->layOut();
    this->Place = { (1. - bary[halfedge % 3]) * this->Length, 0. };
    this->Forward = { 0., 1. };
  }
  /// From inside a face along a unit vector in its plane.
  StraightWalk(
    const AtlasSurface& surface, int face, const Vec3& bary, const Vec3& direction, int mostFaces)
    : Surface(surface)
    , MostFaces(mostFaces)
    , Halfedge(3 * face)
    , Entered(false)
  {
    this->layOut();
    this->Place = { bary[1] * this->Length + bary[2] * this->Apex.x(), bary[2] * this->Apex.y() };
    if (this->Valid)
    {
      const Axes axes = this->axes();
      this->Forward = { direction.dot(axes.right), direction.dot(axes.up) };
    }
  }

  int face() const { return this->Halfedge / 3; }
  Vec3 bary() const
  {
    const double apex = this->Valid ? this->Place.y() / this->Apex.y() : 0.;
    const double head =
      this->Length > 0 ? (this->Place.x() - apex * this->Apex.x()) / this->Length : 0.;
    const int corner = this->Halfedge % 3;
    Vec3 result;
    result[corner] = 1. - apex - head;
    result[(corner + 1) % 3] = head;
    result[(corner + 2) % 3] = apex;
    return clampedBarycentric(result);
  }
  Vec3 position() const { return this->Surface.position(this->face(), this->bary()); }
  /// In space, of unit length.
  Vec3 direction() const
  {
    if (!this->Valid)
    {
      return Vec3::Zero();
    }
    const Axes axes = this->axes();
    return this->Forward.x() * axes.right + this->Forward.y() * axes.up;
  }

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
      const Exit exit = this->exit();
      if (!(exit.reach >= 0))
      {
        return false;
      }
      if (length <= exit.reach)
      {
        this->Place += length * this->Forward;
        return true;
      }
      length -= exit.reach;
      this->Place += exit.reach * this->Forward;
      const int twin = this->Surface.twin[exit.halfedge];
      if (!crossed(exit.halfedge, length) || twin < 0 || ++this->Crossed > this->MostFaces)
      {
        return false;
      }
      this->enter(twin, exit);
    }
  }

private:
  /// Where the walk leaves its face, across an edge from `tail` by `edge`.
  struct Exit
  {
    int halfedge;
    double reach; ///< to there
    Vec2 tail;
    Vec2 edge;
  };
  /// Of the face's plane, in space.
  struct Axes
  {
    Vec3 right;
    Vec3 up;
  };

  Axes axes() const
  {
    const Vec3& tail = this->Surface.points[this->Surface.tail(this->Halfedge)];
    const Vec3 right =
      (this->Surface.points[this->Surface.head(this->Halfedge)] - tail) / this->Length;
    const Vec3 side = this->Surface.points[this->apexPoint()] - tail;
    return { right, (side - this->Apex.x() * right) / this->Apex.y() };
  }
  int apexPoint() const { return this->Surface.tail(nextHalfedge(nextHalfedge(this->Halfedge))); }

  /// Lays the face into its plane, by its base.
  void layOut()
  {
    const Vec3& tail = this->Surface.points[this->Surface.tail(this->Halfedge)];
    const Vec3 base = this->Surface.points[this->Surface.head(this->Halfedge)] - tail;
    const Vec3 side = this->Surface.points[this->apexPoint()] - tail;
    this->Length = base.norm();
    // The height by the area: what Pythagoras leaves of a needle's is rounding.
    this->Apex = Vec2(base.dot(side), base.cross(side).norm()) / this->Length;
    this->Valid = this->Length > 0 && this->Apex.y() > 0;
  }

  /// The first edge on the way that is crossed from the inside; none if its reach is no number.
  Exit exit() const
  {
    Exit first = { -1, std::numeric_limits<double>::quiet_NaN(), Vec2::Zero(), Vec2::Zero() };
    const auto offer = [&](int halfedge, const Vec2& tail, const Vec2& edge) {
      const double rate = cross2(this->Forward, edge);
      if (rate > 0)
      {
        const double reach = std::max(0., cross2(tail - this->Place, edge) / rate);
        if (!(reach >= first.reach))
        {
          first = { halfedge, reach, tail, edge };
        }
      }
    };
    const Vec2 head(this->Length, 0.);
    const int next = nextHalfedge(this->Halfedge);
    offer(next, head, this->Apex - head);
    offer(nextHalfedge(next), this->Apex, -this->Apex);
    if (!this->Entered)
    {
      offer(this->Halfedge, Vec2::Zero(), head);
    }
    return first;
  }

  /// Over an edge into the next face, of which it is the base, run along the other way.
  void enter(int twin, const Exit& exit)
  {
    const double square = exit.edge.squaredNorm();
    const double share = std::clamp((this->Place - exit.tail).dot(exit.edge) / square, 0., 1.);
    const Vec2 along = exit.edge / std::sqrt(square);
    this->Forward = { -this->Forward.dot(along), std::max(0., cross2(this->Forward, along)) };
    this->Halfedge = twin;
    this->Entered = true;
    this->layOut();
    this->Place = { (1. - share) * this->Length, 0. };
  }

  const AtlasSurface& Surface;
  const int MostFaces;
  int Halfedge; // the base
  bool Entered; // across the base, which is not an edge to leave by
  // In the plane of the face:
  double Length = 0; // of the base
  Vec2 Apex = Vec2::Zero();
  Vec2 Place = Vec2::Zero();
  Vec2 Forward = Vec2::Zero(); // of unit length
  bool Valid = false;
  int Crossed = 0;
};
}

#endif
