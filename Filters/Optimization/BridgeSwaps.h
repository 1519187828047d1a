// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Edges that run far from the surface, over a dent or through a ridge, are swapped.
#ifndef stipple_BridgeSwaps_h
#define stipple_BridgeSwaps_h

#include "MeshEdit.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// Swaps edges whose middles are farther from the surface than a share of the spacing there, or
/// than what shows (VertexSpacing), if their two triangles come nearer to it by that, and are good
/// enough for what it brings: by the rate of reachPlaces(), or no poorer than they were. Returns
/// the number of swaps.
STIPPLEFILTERSOPTIMIZATION_EXPORT int swapBridges(MeshEdit& edit, double share, double tolerance);
}

#endif
