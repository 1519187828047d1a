// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Connectivity optimisation by edge swaps (paper 4.2).
#ifndef stipple_EdgeSwaps_h
#define stipple_EdgeSwaps_h

#include "MeshEdit.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// The edge may be swapped, and its opposite angles (in space) exceed 180 degrees together.
STIPPLEFILTERSOPTIMIZATION_EXPORT bool isDelaunaySwap(const OptimizedMesh& mesh, Edge e);

/// Passes over all edges in order, again and again while something changes; they return the number
/// of swaps.

/// Swaps edges whose opposite angles (in space) exceed 180 degrees together.
STIPPLEFILTERSOPTIMIZATION_EXPORT int delaunaySwaps(MeshEdit& edit, int maximumNumberOfPasses);

/// Swaps edges where that reduces the valence dispersion: valence 6 inside, 4 on a boundary; beside
/// creases and at corners, as many triangles in every sector as its angle holds, so that both sides
/// of a crease are balanced. No angle under minimumAngle (radians) is made.
STIPPLEFILTERSOPTIMIZATION_EXPORT int regularitySwaps(
  MeshEdit& edit, double minimumAngle, int maximumNumberOfPasses);

/// Swaps edges where that raises the smaller area / perimeter^2 of the two triangles, in space and
/// as it were if both were laid flat about the edge.
STIPPLEFILTERSOPTIMIZATION_EXPORT int aspectSwaps(MeshEdit& edit, int maximumNumberOfPasses);

/// Triangles about v that are too many (negative: missing); for v on a crease, in the sector of
/// halfedge h, which leaves v and has a triangle to its left.
STIPPLEFILTERSOPTIMIZATION_EXPORT int valenceExcess(const OptimizedMesh& mesh, Halfedge h);

/// The same, but beside creases and boundaries always to three triangles, so that their vertices
/// have two neighbours on each side (Figure 8).
STIPPLEFILTERSOPTIMIZATION_EXPORT int ribExcess(const OptimizedMesh& mesh, Halfedge h);

/// What a vertex costs whose valence is off by `excess`: one too many or too few is as good as any.
STIPPLEFILTERSOPTIMIZATION_EXPORT int irregularity(int excess);

/// By how much swapping an edge changes the sum of cost(v, excess(h)) over its four vertices, each
/// with its halfedge: the ends lose a triangle, the others gain one.
template <typename Excess, typename Cost>
int costChangeOfSwap(const OptimizedMesh& mesh, Edge e, const Excess& excess, const Cost& cost)
{
  int change = 0;
  const auto wing = mesh.wing(e);
  for (int i = 0; i < 4; ++i)
  {
    const Vertex v = mesh.from(wing[i]);
    const int before = excess(wing[i]);
    change += cost(v, before + (i < 2 ? -1 : 1)) - cost(v, before);
  }
  return change;
}
}

#endif
