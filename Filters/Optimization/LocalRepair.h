// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The last few bad triangles and valences, one by one: folds that sampling left, and small angles
// that relaxation cannot open.
#ifndef stipple_LocalRepair_h
#define stipple_LocalRepair_h

#include "MeshEdit.h"
#include "StippleFiltersOptimizationModule.h"

#include <functional>

namespace stipple
{
/// Moves a vertex to where the worst triangle about it is better, if there is such a place. If it
/// stays in its ring, one that leaves triangles folded goes no farther from its neighbours than
/// these are from each other.
STIPPLEFILTERSOPTIMIZATION_EXPORT bool improveByMove(
  MeshEdit& edit, Vertex v, bool staysInRing = false);

/// Moves vertices beside triangles that are worse than `enough` (radians), round by round, until
/// all of the faces are as good as `wanted`. Returns whether they are, and adds up how often a
/// vertex was to move.
STIPPLEFILTERSOPTIMIZATION_EXPORT bool settle(MeshEdit& edit, const std::vector<Vertex>& vertices,
  const std::vector<Face>& faces, double enough, double wanted, int maximumNumberOfRounds,
  int* numberOfMoves = nullptr);

/// Swaps edges and moves vertices about every triangle whose quality is below `threshold`
/// (radians), always such that the worst triangle touched becomes better. Returns the number of
/// triangles that stay below the threshold.
STIPPLEFILTERSOPTIMIZATION_EXPORT int repairTriangles(
  MeshEdit& edit, double threshold, bool maySwap, bool mayMove, int maximumNumberOfPasses);

/// Swaps edges where that brings valences nearer to 5 to 7 (beside creases and boundaries, to one
/// off what the angle holds), if moves then make all triangles about the edge as good as
/// `threshold` (radians), or as good as the worst of them was. Returns the number of swaps.
STIPPLEFILTERSOPTIMIZATION_EXPORT int repairValences(
  MeshEdit& edit, double threshold, int maximumNumberOfPasses);

/// Moves vertices, which must not be fixed, to where the triangles about them are more alike and
/// more regular. No triangle gets worse than enough (radians), or than the worst about the vertex.
/// A vertex only stays where accept(v), asked last, says so.
STIPPLEFILTERSOPTIMIZATION_EXPORT void equalizeTriangles(MeshEdit& edit,
  const std::vector<Vertex>& vertices, double enough, int numberOfRounds,
  const std::function<bool(Vertex)>& accept);
}

#endif
