// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A surface with few triangles, on which charts are decided, and the way back to all of them (the
// "hierarchical solver" that the paper names as future work).
#ifndef stipple_SurfaceCoarsening_h
#define stipple_SurfaceCoarsening_h

#include "CutSurface.h"
#include "ReportingThread.h"

namespace stipple
{
/// Edges collapse, one end into the other, until few triangles are left; vertex splits undo that in
/// reverse (Hoppe 1996, "Progressive meshes"). Boundaries, creases and edges that users name stay
/// lines, with their ends and branches where they are. Cuts of the coarse surface come back split
/// by split: where the cuts about a vertex end up at both of the two that it is split into, the
/// edge between these is cut, too. So no split changes how cuts and pieces hang together, and
/// disks come back as disks.
class STIPPLEFILTERSATLAS_EXPORT SurfaceCoarsening
{
public:
  /// Collapses edges until there are so many triangles or nearly nothing more can go, and gives up
  /// when asked to. The surface is borrowed.
  SurfaceCoarsening(const CutSurface& surface, int numberOfTriangles, const Stop& stop = {});

  /// Some of the surface's triangles, with corners where others' were; each has its own index as
  /// its source cell. No edge is cut but on the boundary.
  const CutSurface& coarse() const { return this->Coarse; }

  /// Cuts by halfedge of the surface, for those of the coarse one, whose edges may have been split
  /// since. A triangle goes to the chart that has most of it, and what is cut is the edges between
  /// charts, and within one those of the coarse surface. Of no use once it was asked to stop.
  ElementArray<Halfedge, char> prolong(const CutSurface& cutCoarse, const Stop& stop = {}) const;

private:
  class Builder;
  ElementArray<Halfedge, char> alongEdges(const CutSurface& cutCoarse) const;
  const CutSurface& Fine;
  CutSurface Coarse;
  std::vector<Face> FineFaces;         ///< by triangle of the coarse surface
  HalfedgeTwins Twin;                  ///< on the fine one's halfedges, as they were left
  ElementArray<Halfedge, char> IsLine; ///< the same
  std::vector<Halfedge> Collapsed;     ///< in order; the tail of each went into its head
};
}

#endif
