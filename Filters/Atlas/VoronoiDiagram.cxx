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

void VoronoiDiagram::addSite(int face, int cell)
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
    for (int h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (this->Surface.cut[h])
      {
        continue;
      }
      const int g = this->Surface.twin[h] / 3;
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

int VoronoiDiagram::farthest(const std::vector<int>& faces) const
{
  return *std::max_element(faces.begin(), faces.end(),
    [&](int a, int b) { return this->Distance[a] < this->Distance[b]; });
}

void VoronoiDiagram::forget(const std::vector<int>& faces)
{
  for (int f : faces)
  {
    this->Distance[f] = Infinity;
    this->Cell[f] = -1;
  }
}

void VoronoiDiagram::removeSpikes(const std::vector<int>& faces)
{
  // Every step takes an edge from the boundaries between cells: two go, one comes.
  bool changed = true;
  while (changed && !isAsked(this->WantsStop))
  {
    changed = false;
    for (int f : faces)
    {
      for (int h = 3 * f; h < 3 * f + 3; ++h)
      {
        changed = this->removeSpike(h) || changed;
      }
    }
  }
}

/// The cell across a halfedge, -1 where the surface is cut.
int VoronoiDiagram::cellAcross(int h) const
{
  return this->Surface.cut[h] ? -1 : this->Cell[this->Surface.twin[h] / 3];
}

/// The triangle of h goes to the other cell if it is held by the edge opposite h's tail alone, and
/// if that cell has the whole fan around the tail (else its boundary would touch itself there).
bool VoronoiDiagram::removeSpike(int h)
{
  const int other = this->cellAcross(h);
  const int own = this->Cell[h / 3];
  if (other < 0 || other == own || this->cellAcross(previousHalfedge(h)) != other ||
    this->cellAcross(nextHalfedge(h)) != own)
  {
    return false;
  }
  for (int g = this->Surface.twin[previousHalfedge(h)]; g != h;
       g = this->Surface.twin[previousHalfedge(g)])
  {
    if (this->Surface.cut[previousHalfedge(g)] || this->Cell[g / 3] != other)
    {
      return false;
    }
  }
  this->Cell[h / 3] = other;
  return true;
}

Vec3 VoronoiDiagram::center(int face) const
{
  return (this->Surface.point(face, 0) + this->Surface.point(face, 1) +
           this->Surface.point(face, 2)) /
    3.;
}
}
