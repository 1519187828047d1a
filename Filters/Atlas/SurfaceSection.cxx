// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSection.h"

#include "ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
FaceNormals faceNormalsOf(const CutSurface& surface)
{
  FaceNormals normals(surface.faces().size());
  parallelFor(surface.faces(), [&](Face f) { normals[f] = surface.faceNormal(f); });
  return normals;
}

SurfaceSection::SurfaceSection(
  const CutSurface& surface, const FaceNormals& normals, Halfedge edge, Ends ends)
  : Surface(surface)
  , NormalOf(normals)
  , Edge(edge)
  , Where(ends)
  , Middle(0.5 * (surface.point(surface.tail(edge)) + surface.point(surface.head(edge))))
  , Along(surface.edge(edge).normalized())
{
}

double SurfaceSection::turn(Face from, Face to) const
{
  const Vec3& a = this->NormalOf[from];
  const Vec3& b = this->NormalOf[to];
  // The parts of both along the edge do not count.
  const double sine = a.cross(b).dot(this->Along);
  const double cosine = a.dot(b) - a.dot(this->Along) * b.dot(this->Along);
  return std::atan2(sine, cosine);
}

double SurfaceSection::ownTurn() const
{
  return this->turn(faceOf(this->Surface.twin[this->Edge]), faceOf(this->Edge));
}

Vec3 SurfaceSection::crossing(Halfedge h) const
{
  const Vec3& a = this->Surface.point(this->Surface.tail(h));
  const Vec3& b = this->Surface.point(this->Surface.head(h));
  const double high = (a - this->Middle).dot(this->Along);
  const double low = (b - this->Middle).dot(this->Along);
  const double t = high == low ? 0.5 : std::clamp(high / (high - low), 0., 1.);
  return a + t * (b - a);
}

SurfaceSection::Walk::Walk(const SurfaceSection& section, Halfedge edge)
  : Edge(edge)
  , At(section.Middle)
  , Next(edge)
{
}

void SurfaceSection::Walk::follow(const SurfaceSection& section, double reach)
{
  const CutSurface& surface = section.Surface;
  // Of the two other edges of a face one has ends on both sides; a closed section comes back to
  // the edge, any other to a boundary: each face is passed once.
  const auto most = static_cast<std::size_t>(surface.numberOfFaces());
  while (!this->HasEnded && this->Turns.size() < most)
  {
    const Halfedge next = nextHalfedge(this->Next);
    const bool isHeadInFront = section.height(surface.head(this->Next)) >= 0;
    const bool isTopInFront = section.height(surface.head(next)) >= 0;
    const Halfedge out = isTopInFront == isHeadInFront ? nextHalfedge(next) : next;
    const Vec3 crossing = section.crossing(out);
    const double distance = this->Distance + (crossing - this->At).norm();
    if (distance > reach)
    {
      return;
    }
    this->Distance = distance;
    this->At = crossing;
    const Halfedge across = surface.twin[out];
    this->HasEnded =
      !across.valid() || section.isEnd(out) || across == this->Edge || out == this->Edge;
    if (!this->HasEnded)
    {
      this->Turns.push_back({ distance, section.turn(faceOf(out), faceOf(across)) });
      this->Next = across;
    }
  }
}
}
