// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Connectivity optimisation by edge swaps (paper 4.2).
#ifndef stipple_EdgeSwaps_h
#define stipple_EdgeSwaps_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// The edge may be swapped, and its opposite angles (in space) exceed 180 degrees together.
bool isDelaunaySwap(const OptimizedMesh& mesh, int edge);

/// Passes over all edges in order, again and again while something changes; they return the number
/// of swaps.

/// Swaps edges whose opposite angles (in space) exceed 180 degrees together.
STIPPLEFILTERSOPTIMIZATION_EXPORT int delaunaySwaps(
  OptimizedMesh& mesh, int maximumNumberOfPasses = 5);

/// Swaps edges where that reduces the valence dispersion: valence 6 inside, 4 on a boundary; beside
/// creases and at corners, as many triangles in every sector as its angle holds, so that both sides
/// of a crease are balanced. No angle under minimumAngle (degrees) is made.
STIPPLEFILTERSOPTIMIZATION_EXPORT int regularitySwaps(
  OptimizedMesh& mesh, double minimumAngle = 15., int maximumNumberOfPasses = 5);

/// Swaps edges where that raises the smaller area / perimeter^2 of the two triangles.
STIPPLEFILTERSOPTIMIZATION_EXPORT int aspectSwaps(
  OptimizedMesh& mesh, int maximumNumberOfPasses = 5);

/// Triangles about v that are missing (positive) or too many; for v on a crease, in the sector of
/// halfedge h, which leaves v and has a triangle to its left.
STIPPLEFILTERSOPTIMIZATION_EXPORT int valenceExcess(
  const OptimizedMesh& mesh, OptimizedMesh::Halfedge h);

/// The same, but beside creases and boundaries always to three triangles, so that their vertices
/// have two neighbours on each side (Figure 8).
STIPPLEFILTERSOPTIMIZATION_EXPORT int ribExcess(
  const OptimizedMesh& mesh, OptimizedMesh::Halfedge h);

/// What a vertex costs whose valence is off by `excess`: one too many or too few is as good as any.
int irregularity(int excess);

/// By how much swapping the edge changes the sum of the squared excesses of its four vertices.
STIPPLEFILTERSOPTIMIZATION_EXPORT int dispersionChange(const OptimizedMesh& mesh, int edge);
}

#endif
