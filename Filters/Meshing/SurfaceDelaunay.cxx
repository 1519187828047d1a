// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDelaunay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace stipple
{
namespace
{
/// How far into its triangle an edge is measured, of the way to the middle: not along the chart's
/// sides, nor lines of the input, where it is open which triangle comes next.
constexpr double Inset = 1e-4;
/// Share of its length that a swap shortens an edge by at least, more than lengths are off by.
constexpr double LeastGain = 1e-3;
/// What swaps leave of a triangle's area in the plane, over the square of its longest edge.
constexpr double LeastArea = 1e-9;

/// The angle opposite to side a; pi if the others do not reach that far.
double angleOpposite(double a, double b, double c)
{
  const double product = 2. * b * c;
  return product > 0 ? std::acos(std::clamp((b * b + c * c - a * a) / product, -1., 1.)) : 0.;
}

class SurfaceDelaunay
{
public:
  SurfaceDelaunay(const AtlasSurface& surface, Chart c, const std::vector<Vec2>& parameter,
    TriangleComplex& complex)
    : Walk(surface, c)
    , Parameter(parameter)
    , Complex(complex)
  {
  }

  int swapAll(const Stop& stop)
  {
    int swaps = 0;
    std::vector<Halfedge> waiting;
    for (const Halfedge h : this->Complex.halfedges())
    {
      if (this->maySwap(h) && h < this->Complex.twin[h])
      {
        waiting.push_back(h);
      }
    }
    std::reverse(waiting.begin(), waiting.end()); // the first one comes first
    for (int count = 0; !waiting.empty(); ++count)
    {
      if (count % 256 == 0 && isAsked(stop))
      {
        break;
      }
      const Halfedge h = waiting.back();
      waiting.pop_back();
      if (!this->maySwap(h) || !this->isBetterSwapped(h))
      {
        continue;
      }
      this->Complex.flip(h);
      ++swaps;
      const Halfedge g = this->Complex.twin[h];
      waiting.insert(waiting.end(),
        { nextHalfedge(h), previousHalfedge(h), nextHalfedge(g), previousHalfedge(g) });
    }
    return swaps;
  }

private:
  bool maySwap(Halfedge h) const
  {
    return !this->Complex.isBoundary(h) && !this->Complex.label[h].valid();
  }
  const Vec2& at(Vertex v) const { return this->Parameter[v.index()]; }
  /// Of the edge from a to b of a triangle with c.
  double length(Vertex a, Vertex b, Vertex c)
  {
    const auto key = (static_cast<std::uint64_t>(std::min(a, b).index()) << 32) |
      static_cast<std::uint64_t>(std::max(a, b).index());
    const auto [found, isNew] = this->Length.try_emplace(key, 0.);
    if (isNew)
    {
      const Vec2 centre = (this->at(a) + this->at(b) + this->at(c)) / 3.;
      const auto inset = [&](
                           Vertex v) { return Vec2(this->at(v) + Inset * (centre - this->at(v))); };
      this->Walk.walk(inset(a));
      found->second = this->Walk.walk(inset(b));
    }
    return found->second;
  }
  bool isTriangle(Vertex a, Vertex b, Vertex c) const
  {
    const Vec2& p = this->at(a);
    const Vec2& q = this->at(b);
    const Vec2& r = this->at(c);
    const double longest =
      std::max({ (q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm() });
    return orient2(p, q, r) > LeastArea * longest;
  }
  bool isBetterSwapped(Halfedge h)
  {
    const Vertex a = this->Complex.tail(h);
    const Vertex b = this->Complex.head(h);
    const Vertex c = this->Complex.apex(h);
    const Vertex d = this->Complex.apex(this->Complex.twin[h]);
    if (c == d || !this->isTriangle(d, c, a) || !this->isTriangle(c, d, b))
    {
      return false;
    }
    const double ab = this->length(a, b, c);
    const double bc = this->length(b, c, a);
    const double ca = this->length(c, a, b);
    const double ad = this->length(a, d, b);
    const double db = this->length(d, b, a);
    if (std::min({ ab, bc, ca, ad, db }) < 0 ||
      angleOpposite(ab, bc, ca) + angleOpposite(ab, ad, db) <= EIGEN_PI)
    {
      return false;
    }
    const double cd = this->length(c, d, a);
    return cd >= 0 && cd < (1. - LeastGain) * ab;
  }

  ParameterWalk Walk;
  const std::vector<Vec2>& Parameter;
  TriangleComplex& Complex;
  std::unordered_map<std::uint64_t, double> Length; // by the smaller vertex and the larger one
};
}

ParameterWalk::ParameterWalk(const AtlasSurface& surface, Chart chart)
  : Surface(surface)
  , Faces(surface.faces(chart))
{
  this->begin();
}

void ParameterWalk::begin()
{
  this->At = *this->Faces.begin();
  this->Place = this->Surface.parameter(this->At, Vec3::Constant(1. / 3.));
}

double ParameterWalk::walk(const Vec2& to)
{
  const AtlasSurface& s = this->Surface;
  Face face = this->At;
  int entry = -1; // corner at which the edge begins that the way has crossed last
  double done = 0;
  double length = 0;
  for (int step = 0; step <= 2 * this->Faces.size(); ++step)
  {
    const Vec2& p = s.cornerUV(face, 0);
    const Vec2& q = s.cornerUV(face, 1);
    const Vec2& r = s.cornerUV(face, 2);
    const double area = orient2(p, q, r);
    if (!(area > 0))
    {
      break;
    }
    const auto bary = [&](const Vec2& x) {
      const double b0 = orient2(x, q, r) / area;
      const double b1 = orient2(p, x, r) / area;
      return Vec3(b0, b1, 1. - b0 - b1);
    };
    const Vec3 from = bary(this->Place);
    const Vec3 change = bary(to) - from;
    double reach = 1.;
    int exit = -1; // corner at which the edge begins
    for (int k = 0; k < 3; ++k)
    {
      const int edge = (k + 1) % 3; // opposite
      if (change[k] < 0 && edge != entry && from[k] < reach * -change[k])
      {
        reach = std::max(done, from[k] / -change[k]);
        exit = edge;
      }
    }
    Vec3 way = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      way += (reach - done) * change[k] * s.point(face, k);
    }
    length += way.norm();
    done = reach;
    if (exit < 0)
    {
      this->At = face;
      this->Place = to;
      return length;
    }
    const Halfedge h = halfedgeOf(face, exit);
    const Halfedge twin = s.twin[h];
    const bool goesOn = twin.valid() && s.faceChart[faceOf(twin)] == s.faceChart[face] &&
      s.chartPoint(nextHalfedge(twin)) == s.chartPoint(h) &&
      s.chartPoint(twin) == s.chartPoint(nextHalfedge(h));
    if (!goesOn)
    {
      break;
    }
    face = faceOf(twin);
    entry = cornerOf(twin);
  }
  this->begin();
  return -1.;
}

int swapToSurfaceDelaunay(const AtlasSurface& surface, Chart c, const std::vector<Vec2>& parameter,
  TriangleComplex& complex, const Stop& stop)
{
  return SurfaceDelaunay(surface, c, parameter, complex).swapAll(stop);
}
}
