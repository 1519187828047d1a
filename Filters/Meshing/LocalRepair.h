// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The last few bad triangles, one by one: folds that sampling left, and small angles that
// relaxation cannot open.
#ifndef stipple_LocalRepair_h
#define stipple_LocalRepair_h

#include "OptimizedMesh.h"

namespace stipple
{
/// Smallest angle of a triangle (radians) if it is sound; below zero if it is folded over, the
/// lower the farther.
STIPPLEFILTERSMESHING_EXPORT double triangleQuality(const OptimizedMesh& mesh, int a, int b, int c);

/// Swaps edges and moves vertices about every triangle whose quality is below `threshold`
/// (radians), always such that the worst triangle touched becomes better. Returns the number of
/// triangles that stay below the threshold.
STIPPLEFILTERSMESHING_EXPORT int repairTriangles(
  OptimizedMesh& mesh, double threshold, bool maySwap, bool mayMove, int maximumNumberOfPasses);
}

#endif
