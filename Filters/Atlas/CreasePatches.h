// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The faces that a machined part is made of: what creases part from one another.
#ifndef stipple_CreasePatches_h
#define stipple_CreasePatches_h

#include "ChartRegions.h"

namespace stipple
{
/// Cuts the surface between its patches: triangles that are connected across edges that are not
/// sharp. A patch with less than NegligibleArea of its component goes to the neighbour with which
/// it has most of its outline, unless it is the end of a sleeve (a lid of a tube) so deep that no
/// map of it can be. Creases that end inside a patch are not cut.
STIPPLEFILTERSATLAS_EXPORT void cutAlongCreases(CutSurface& surface);

/// Whether a chart can be unrolled with little distortion: by total curvatures W+ < 2 pi and W- it
/// has a map to the plane that changes lengths by sqrt((2 pi + W-) / (2 pi - W+)) at most (Bonk and
/// Lang 2003); here by the root of 2.
STIPPLEFILTERSATLAS_EXPORT bool isNearlyDevelopable(
  const TriangleSurface& surface, const ChartMesh& chart);

/// Cuts a region open from hole to hole along shortest edge paths, until it has one boundary loop.
/// Returns a halfedge of each edge.
STIPPLEFILTERSATLAS_EXPORT std::vector<Halfedge> joinLoops(ChartRegions& regions, int region);
}

#endif
