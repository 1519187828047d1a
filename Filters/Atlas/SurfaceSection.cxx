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

SurfaceSection::Walk::Walk(const SurfaceSection& section, Halfedge edge)
  : Edge(edge)
  , At(section.Middle)
  , Next(edge)
  , Tail(section.height(section.Surface.tail(edge)))
  , Head(section.height(section.Surface.head(edge)))
{
}

bool SurfaceSection::Walk::step(const SurfaceSection& section, double reach)
{
  const CutSurface& surface = section.Surface;
  // Of the two other edges of a face one has ends on both sides; a closed section comes back to
  // the edge, any other to a boundary: each face is passed once.
  const auto most = static_cast<std::size_t>(surface.numberOfFaces());
  if (this->HasEnded || this->Turns.size() >= most)
  {
    return false;
  }
  const Halfedge next = nextHalfedge(this->Next);
  const double top = section.height(surface.head(next));
  const bool isNext = (top >= 0) != (this->Head >= 0);
  const Halfedge out = isNext ? next : nextHalfedge(next);
  const double tail = isNext ? this->Head : top;
  const double head = isNext ? top : this->Tail;
  const double t = tail == head ? 0.5 : std::clamp(tail / (tail - head), 0., 1.);
  const Vec3& begin = surface.point(surface.tail(out));
  const Vec3 crossing = begin + t * (surface.point(surface.head(out)) - begin);
  const double distance = this->Distance + (crossing - this->At).norm();
  if (distance > reach)
  {
    return false;
  }
  const Halfedge across = surface.twin[out];
  this->HasEnded =
    !across.valid() || section.isEnd(out) || across == this->Edge || out == this->Edge;
  if (this->HasEnded)
  {
    return false;
  }
  this->Distance = distance;
  this->At = crossing;
  this->Turns.push_back({ distance, section.turn(faceOf(out), faceOf(across)) });
  this->Next = across;
  this->Tail = head;
  this->Head = tail;
  return true;
}
}
