// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VoronoiDiagram.h"

#include <algorithm>
#include <limits>

namespace stipple
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

VoronoiDiagram::VoronoiDiagram(const CutSurface& surface, Stop stop)
  : Surface(surface)
  , WantsStop(std::move(stop))
  , Distance(surface.triangles.size(), Infinity)
  , Cell(surface.triangles.size(), -1)
{
}

void VoronoiDiagram::addSite(Face face, int cell)
{
  this->Distance[face] = 0;
  this->Cell[face] = cell;
  this->Front.push({ 0., face });
  // A triangle comes back only with a smaller distance, of finitely many.
  while (!this->Front.empty() && !isAsked(this->WantsStop))
  {
    const auto [d, f] = this->Front.top();
    this->Front.pop();
    if (d > this->Distance[f])
    {
      continue;
    }
    for (const Halfedge h : halfedgesOf(f))
    {
      if (this->Surface.cut[h])
      {
        continue;
      }
      const Face g = faceOf(this->Surface.twin[h]);
      const double there = d + (this->center(g) - this->center(f)).norm();
      if (there < this->Distance[g])
      {
        this->Distance[g] = there;
        this->Cell[g] = cell;
        this->Front.push({ there, g });
      }
    }
  }
}

Face VoronoiDiagram::farthest(const std::vector<Face>& faces) const
{
  return *std::max_element(faces.begin(), faces.end(),
    [&](Face a, Face b) { return this->Distance[a] < this->Distance[b]; });
}

void VoronoiDiagram::forget(const std::vector<Face>& faces)
{
  for (const Face f : faces)
  {
    this->Distance[f] = Infinity;
    this->Cell[f] = -1;
  }
}

void VoronoiDiagram::removeSpikes(const std::vector<Face>& faces)
{
  // Every step takes an edge from the boundaries between cells: two go, one comes.
  bool changed = true;
  while (changed && !isAsked(this->WantsStop))
  {
    changed = false;
    for (const Face f : faces)
    {
      for (const Halfedge h : halfedgesOf(f))
      {
        changed = this->removeSpike(h) || changed;
      }
    }
  }
}

/// The cell across a halfedge, -1 where the surface is cut.
int VoronoiDiagram::cellAcross(Halfedge h) const
{
  return this->Surface.cut[h] ? -1 : this->Cell[faceOf(this->Surface.twin[h])];
}

/// The triangle of h goes to the other cell if it is held by the edge opposite h's tail alone, and
/// if that cell has the whole fan around the tail (else its boundary would touch itself there).
bool VoronoiDiagram::removeSpike(Halfedge h)
{
  const int other = this->cellAcross(h);
  const int own = this->Cell[faceOf(h)];
  if (other < 0 || other == own || this->cellAcross(previousHalfedge(h)) != other ||
    this->cellAcross(nextHalfedge(h)) != own)
  {
    return false;
  }
  for (Halfedge g = this->Surface.twin[previousHalfedge(h)]; g != h;
       g = this->Surface.twin[previousHalfedge(g)])
  {
    if (this->Surface.cut[previousHalfedge(g)] || this->Cell[faceOf(g)] != other)
    {
      return false;
    }
  }
  this->Cell[faceOf(h)] = other;
  return true;
}

Vec3 VoronoiDiagram::center(Face face) const
{
  return (this->Surface.point(face, 0) + this->Surface.point(face, 1) +
           this->Surface.point(face, 2)) /
    3.;
}
}
