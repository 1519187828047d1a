// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Vectors, and the few plane and triangle formulas that every stage needs.
#ifndef stipple_Geometry_h
#define stipple_Geometry_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace stipple
{
using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

constexpr double Pi = 3.14159265358979323846;

/// z-component of the cross product of two plane vectors.
inline double cross2(const Vec2& a, const Vec2& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Twice the signed area of the plane triangle (a, b, c); positive if counterclockwise.
inline double orient2(const Vec2& a, const Vec2& b, const Vec2& c)
{
  return cross2(b - a, c - a);
}

/// Area of a triangle in space.
inline double triangleArea(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return 0.5 * (b - a).cross(c - a).norm();
}

/// The nearest place to p on the segment (a, b), in the plane or in space.
template <int N>
Eigen::Matrix<double, N, 1> nearestOnSegment(const Eigen::Matrix<double, N, 1>& p,
  const Eigen::Matrix<double, N, 1>& a, const Eigen::Matrix<double, N, 1>& b)
{
  const Eigen::Matrix<double, N, 1> ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(ab) / squared, 0., 1.) : 0.;
  return a + t * ab;
}

template <int N>
double distanceToSegment(const Eigen::Matrix<double, N, 1>& p, const Eigen::Matrix<double, N, 1>& a,
  const Eigen::Matrix<double, N, 1>& b)
{
  return (nearestOnSegment(p, a, b) - p).norm();
}

/// Cotangent of the angle at a in triangle (a, b, c), clamped to +-limit so that slivers stay
/// finite.
inline double cotangent(const Vec3& a, const Vec3& b, const Vec3& c, double limit = 1e4)
{
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const double s = u.cross(v).norm();
  const double d = u.dot(v);
  if (s * limit <= std::abs(d))
  {
    return d > 0 ? limit : (d < 0 ? -limit : 0.);
  }
  return d / s;
}

/// Barycentric coordinates of p in the plane triangle (a, b, c), which is not degenerate.
inline Vec3 barycentric(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c)
{
  const double area = orient2(a, b, c);
  const double v = orient2(a, p, c) / area;
  const double w = orient2(a, b, p) / area;
  return { 1. - v - w, v, w };
}

/// Barycentric coordinates of a point in the plane of a triangle in space; of one outside that
/// plane, those of its projection.
inline Vec3 barycentricInSpace(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = p - a;
  const Vec3 normal = u.cross(v);
  const double area = normal.squaredNorm();
  const double s = w.cross(v).dot(normal) / area;
  const double t = u.cross(w).dot(normal) / area;
  return { 1 - s - t, s, t };
}

/// The corner, 0 to 2, of a triangle in space that is nearest to a place in it; of several, the
/// first. In a long triangle it need not be that of the largest coordinate.
inline int nearestCorner(const Vec3& barycentric, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 place = barycentric[0] * a + barycentric[1] * b + barycentric[2] * c;
  int nearest = 0;
  Vec3((a - place).squaredNorm(), (b - place).squaredNorm(), (c - place).squaredNorm())
    .minCoeff(&nearest);
  return nearest;
}

/// Clamps barycentric coordinates to the triangle and makes them sum to one.
inline Vec3 clampedBarycentric(const Vec3& b)
{
  const Vec3 c = b.cwiseMax(0.);
  return c / c.sum();
}
}

#endif
