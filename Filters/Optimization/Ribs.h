// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The rib effect (paper 4.2, Figure 8): two neighbours on each side of every vertex on a crease.
#ifndef stipple_Ribs_h
#define stipple_Ribs_h

#include "MeshEdit.h"
#include "Progress.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// Gives vertices on creases and boundaries two neighbours on each side. One too many or missing is
/// swapped away or handed on along the crease, from vertex to vertex, to where it is wanted or
/// does no harm; then the vertices about the swaps move, those on creases along them, until all
/// triangles there are good enough, or as good as the worst of them was: else all is taken back.
/// Nothing gets farther from the surface than the mesh is somewhere, and no triangle is flipped.
/// Returns the number of sides that were mended; those until then, where it is stopped.
STIPPLEFILTERSOPTIMIZATION_EXPORT int makeRibs(MeshEdit& edit, const Stop& stop);
}

#endif
