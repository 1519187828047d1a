// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceWalk.h"

namespace stipple
{
SurfaceWalk::SurfaceWalk(const TriangleSurface& surface, std::vector<char> wall)
  : Surface(surface)
  , Wall(std::move(wall))
  , Normal(surface.triangles.size())
  , Gradient(surface.triangles.size())
{
  this->Wall.resize(3 * surface.triangles.size(), 0);
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    const Vec3& a = surface.point(f, 0);
    const Vec3& b = surface.point(f, 1);
    const Vec3& c = surface.point(f, 2);
    const Vec3 n = (b - a).cross(c - a);
    const double square = n.squaredNorm();
    if (square > 0)
    {
      this->Gradient[f] = { { n.cross(c - b) / square, n.cross(a - c) / square } };
      this->Normal[f] = n / std::sqrt(square);
    }
    else
    {
      this->Gradient[f] = { { Vec3::Zero(), Vec3::Zero() } };
      this->Normal[f] = Vec3::Zero();
    }
  }
}

SurfacePlace SurfaceWalk::walk(const SurfacePlace& from, const Vec3& vector, bool passWalls) const
{
  // A walk about a vertex may pass many faces without getting on: the bound only ends what would go
  // on for ever.
  constexpr int MaximumNumberOfCrossings = 10000;
  SurfacePlace place = from;
  Vec3 left = vector;
  int cameThrough = -1;
  for (int crossing = 0; crossing < MaximumNumberOfCrossings; ++crossing)
  {
    const auto& gradient = this->Gradient[place.face];
    Vec3 step;
    step[0] = gradient[0].dot(left);
    step[1] = gradient[1].dot(left);
    step[2] = -step[0] - step[1];
    double t = 1.;
    int exit = -1;
    for (int k = 0; k < 3; ++k)
    {
      if (step[k] < 0 && k != cameThrough && place.bary[k] + t * step[k] < 0)
      {
        t = place.bary[k] / -step[k];
        exit = k;
      }
    }
    if (!std::isfinite(t))
    {
      break;
    }
    place.bary = (place.bary + t * step).cwiseMax(0.);
    if (exit >= 0)
    {
      place.bary[exit] = 0;
    }
    place.bary /= place.bary.sum();
    if (exit < 0)
    {
      break;
    }
    const int h = 3 * place.face + (exit + 1) % 3; // the edge opposite to corner `exit`
    const int g = this->Surface.twin[h];
    if (g < 0 || (this->Wall[h] && !passWalls))
    {
      break;
    }
    left *= 1. - t;
    const Vec3 edge =
      this->Surface.points[this->Surface.head(h)] - this->Surface.points[this->Surface.tail(h)];
    const double square = edge.squaredNorm();
    if (square <= 0)
    {
      break;
    }
    // Unfold: the part along the edge stays, the part across turns into the next face.
    const Vec3 outward = edge.cross(this->Normal[h / 3]);
    const Vec3 onward = edge.cross(this->Normal[g / 3]);
    left = (left.dot(edge) * edge + left.dot(outward) * onward) / square;
    Vec3 bary = Vec3::Zero();
    bary[g % 3] = place.bary[nextHalfedge(h) % 3];
    bary[nextHalfedge(g) % 3] = place.bary[h % 3];
    place.face = g / 3;
    place.bary = bary;
    cameThrough = previousHalfedge(g) % 3;
  }
  return place;
}
}
