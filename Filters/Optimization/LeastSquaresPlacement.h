// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Vertices off the surface, where the flat triangles between them fit it best (the paper's future
// work: geometric approximation).
#ifndef stipple_LeastSquaresPlacement_h
#define stipple_LeastSquaresPlacement_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// Positions that minimise the squared distances of the surface's points, weighted by the area
/// about them, to the planes of the triangles that they are nearest to. Vertices move along the
/// surface's normal only; those on sharp and boundary backbones, corners and constraints keep their
/// positions. The connectivity stays, and so does the number of flipped triangles.
STIPPLEFILTERSOPTIMIZATION_EXPORT std::vector<Vec3> leastSquaresPositions(
  const OptimizedMesh& mesh);
}

#endif
