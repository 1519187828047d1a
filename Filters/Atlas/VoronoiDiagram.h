// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Approximate geodesic Voronoi diagrams on a surface (Eck et al. 1995).
#ifndef stipple_VoronoiDiagram_h
#define stipple_VoronoiDiagram_h

#include "CutSurface.h"
#include "ReportingThread.h"

#include <functional>
#include <queue>

namespace stipple
{
/// Cells grown triangle by triangle from triangles to triangles next to them, not across cuts;
/// distances run from centroid to centroid. Sites may be added one at a time.
class VoronoiDiagram
{
public:
  explicit VoronoiDiagram(const CutSurface& surface, Stop stop = {});

  /// Adds a site; takes what is nearer to it than to any site before.
  void addSite(Face face, int cell);
  /// Cell of a triangle, -1 if no site reaches it.
  int cell(Face face) const { return this->Cell[face]; }
  /// The triangle that is farthest from its site, of some.
  Face farthest(const std::vector<Face>& faces) const;
  /// Takes triangles out of their cells.
  void forget(const std::vector<Face>& faces);
  /// Gives triangles that hang on their cell by one edge only to the cell that surrounds them: on a
  /// straight boundary they would have next to no area in the plane.
  void removeSpikes(const std::vector<Face>& faces);

private:
  int cellAcross(Halfedge h) const;
  bool removeSpike(Halfedge h);
  Vec3 center(Face face) const;

  const CutSurface& Surface;
  Stop WantsStop; // growing ends where it is then
  ElementArray<Face, double> Distance;
  ElementArray<Face, int> Cell;
  using Entry = std::pair<double, Face>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Front;
};
}

#endif
