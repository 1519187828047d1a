// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceWalk.h"

#include "ParallelFor.h"

namespace stipple
{
SurfaceWalk::SurfaceWalk(const TriangleSurface& surface, const std::vector<char>& wall)
  : Faces(surface.triangles.size())
{
  parallelFor(surface.faces(), [&](Face f) {
    FaceData& face = this->Faces[f.index()];
    face.normal = surface.faceNormal(f);
    for (int k = 0; k < 3; ++k)
    {
      const Halfedge h = halfedgeOf(f, k);
      face.point[k] = surface.point(f, k);
      face.twin[k] = surface.twin[h].index();
      face.wall[k] = wall.empty() ? 0 : wall[h.index()];
    }
    const auto& p = face.point;
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const double scale = normal.squaredNorm();
    face.gradient.fill(Vec3::Zero());
    if (scale > 0)
    {
      face.gradient = { normal.cross(p[2] - p[1]) / scale, normal.cross(p[0] - p[2]) / scale };
    }
  });
}

SurfacePlace SurfaceWalk::walk(const SurfacePlace& from, const Vec3& vector, bool passWalls) const
{
  SurfacePlace place = from;
  Vec3 left = vector;
  int cameThrough = -1;
  // A shortest way meets no face twice: what comes back winds about a wire or a tip. One face is
  // looked for, a later one each time that the number of crossings has doubled (R. Brent, An
  // Improved Monte Carlo Factorization Algorithm, 1980), so that the first face of a circle of n is
  // met again after less than 3 n crossings, or what came before it was longer.
  int known = from.face;
  std::size_t next = 1;
  for (std::size_t crossing = 1; crossing <= this->Faces.size(); ++crossing)
  {
    const FaceData& face = this->Faces[place.face];
    const auto& p = face.point;
    Vec3 step; // in barycentric coordinates
    step[0] = face.gradient[0].dot(left);
    step[1] = face.gradient[1].dot(left);
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
    const int side = nextCorner(exit); // the edge opposite to it
    const int g = face.twin[side];
    if (g < 0 || (face.wall[side] && !passWalls))
    {
      break;
    }
    left *= 1. - t;
    const Vec3 edge = p[nextCorner(side)] - p[side];
    const double square = edge.squaredNorm();
    if (square <= 0)
    {
      break;
    }
    // Unfold: the part along the edge stays, the part across turns into the next face.
    const Vec3 outward = edge.cross(face.normal);
    const Vec3 onward = edge.cross(this->normal(g / 3));
    left = (left.dot(edge) * edge + left.dot(outward) * onward) / square;
    Vec3 bary = Vec3::Zero();
    bary[g % 3] = place.bary[nextCorner(side)];
    bary[nextHalfedge(g) % 3] = place.bary[side];
    place.face = g / 3;
    place.bary = bary;
    cameThrough = previousHalfedge(g) % 3;
    if (place.face == known)
    {
      break;
    }
    if (crossing == next)
    {
      known = place.face;
      next *= 2;
    }
  }
  return place;
}
}
