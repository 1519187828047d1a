// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "IntrinsicTriangulation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stipple
{
namespace
{
/// Of a triangle by its sides, right to the last digits for needles, too (W. Kahan, Miscalculating
/// Area and Angles of a Needle-like Triangle, 2014).
double areaOf(double a, double b, double c)
{
  std::array<double, 3> l = { { a, b, c } };
  std::sort(l.begin(), l.end());
  const double product = (l[2] + (l[1] + l[0])) * (l[0] - (l[2] - l[1])) * (l[0] + (l[2] - l[1])) *
    (l[2] + (l[1] - l[0]));
  return 0.25 * std::sqrt(std::max(0., product));
}
}

IntrinsicTriangulation::IntrinsicTriangulation(
  const TriangleSurface& surface, const ChartMesh& chart)
  : Triangles(chart.triangles)
  , Length(3 * chart.triangles.size(), 0.)
  , Twin(halfedgeTwins(chart.triangles))
{
  for (std::size_t i = 0; i < chart.faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Length[halfedgeOf(Face(static_cast<int>(i)), k)] =
        surface.edgeLength(halfedgeOf(chart.faces[i], k));
    }
  }
}

double IntrinsicTriangulation::cotangentOpposite(Halfedge h) const
{
  const double a = this->Length[h];
  const double b = this->Length[nextHalfedge(h)];
  const double c = this->Length[previousHalfedge(h)];
  // b^2 + c^2 - a^2 without cancellation where two sides are alike.
  const double twiceDot = b * b + (c - a) * (c + a);
  const double area = 4 * areaOf(a, b, c);
  return area * LargestCotangent <= std::abs(twiceDot) ? std::copysign(LargestCotangent, twiceDot)
                                                       : twiceDot / area;
}

bool IntrinsicTriangulation::isDelaunay(Halfedge h) const
{
  constexpr double rounding = 1e-9;
  const Halfedge twin = this->Twin[h];
  if (!twin.valid() || faceOf(twin) == faceOf(h))
  {
    return true;
  }
  const double a = this->cotangentOpposite(h);
  const double b = this->cotangentOpposite(twin);
  return a + b >= -rounding * (1 + std::abs(a) + std::abs(b));
}

void IntrinsicTriangulation::flip(Halfedge h)
{
  // From a to b, with c on its left and d on its right: from c to d.
  const Halfedge t = this->Twin[h];
  const std::array<Halfedge, 4> side = { { nextHalfedge(h), previousHalfedge(h), nextHalfedge(t),
    previousHalfedge(t) } }; // bc, ca, ad, db
  std::array<double, 4> length;
  std::array<Halfedge, 4> twin;
  for (int i = 0; i < 4; ++i)
  {
    length[i] = this->Length[side[i]];
    twin[i] = this->Twin[side[i]];
  }
  const double ab = this->Length[h];
  const auto apex = [ab](double fromA, double fromB) {
    return Vec2(
      0.5 * (ab + (fromA - fromB) * (fromA + fromB) / ab), 2 * areaOf(ab, fromA, fromB) / ab);
  };
  const Vec2 c = apex(length[1], length[0]);
  const Vec2 d = apex(length[2], length[3]);
  const double cd = std::hypot(c.x() - d.x(), c.y() + d.y());
  const int atA = this->tail(h);
  const int atB = this->tail(t);
  const int atC = this->tail(side[1]);
  const int atD = this->tail(side[3]);
  const Face f = faceOf(h);
  const Face g = faceOf(t);
  this->Triangles[f.index()] = { { atC, atD, atB } };
  this->Triangles[g.index()] = { { atD, atC, atA } };
  // The sides in their new places: db and bc in f, ca and ad in g.
  const std::array<Halfedge, 4> place = { { halfedgeOf(f, 2), halfedgeOf(g, 1), halfedgeOf(g, 2),
    halfedgeOf(f, 1) } };
  for (int i = 0; i < 4; ++i)
  {
    // Two of the sides may be one edge.
    const auto moved = std::find(side.begin(), side.end(), twin[i]);
    const Halfedge other = moved == side.end() ? twin[i] : place[moved - side.begin()];
    this->Length[place[i]] = length[i];
    this->Twin[place[i]] = other;
    if (other.valid())
    {
      this->Twin[other] = place[i];
    }
  }
  const Halfedge inF = halfedgeOf(f, 0);
  const Halfedge inG = halfedgeOf(g, 0);
  this->Length[inF] = this->Length[inG] = cd;
  this->Twin[inF] = inG;
  this->Twin[inG] = inF;
}

int IntrinsicTriangulation::flipToDelaunay()
{
  // It ends: each flip lowers the Dirichlet energy of the functions that are linear on triangles
  // (Rippa 1990), beyond rounding, and of triangulations with edges up to a length there are
  // finitely many.
  std::vector<Halfedge> open;
  for (const Halfedge h : this->halfedges())
  {
    if (this->Twin[h].valid() && h < this->Twin[h] && !this->isDelaunay(h))
    {
      open.push_back(h);
    }
  }
  int flips = 0;
  while (!open.empty())
  {
    const Halfedge h = open.back();
    open.pop_back();
    if (this->isDelaunay(h))
    {
      continue;
    }
    const Halfedge t = this->Twin[h];
    const Face f = faceOf(h);
    const Face g = faceOf(t);
    this->flip(h);
    ++flips;
    for (const Face face : { f, g })
    {
      for (const int k : { 1, 2 })
      {
        open.push_back(halfedgeOf(face, k));
      }
    }
  }
  return flips;
}
}
