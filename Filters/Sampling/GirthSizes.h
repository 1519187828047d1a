// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How long edges may be where a smooth part of the surface is thin all around: rods, limbs, holes.
#ifndef stipple_GirthSizes_h
#define stipple_GirthSizes_h

#include "FeatureSizes.h"

namespace stipple
{
/// Places that a loop on the surface runs around which is shorter than
/// SamplingConstants::EdgesOfLoop of the edges there, and how long these may be. Loops are sought
/// by walking straight both ways, in the direction in which the surface bends most, until the two
/// walks meet head-on; what they find on the way - a rim of a sheet, a bump, an edge of a solid -
/// is no reason for shorter edges. Creases and boundaries are not crossed: featureSizes() knows
/// them. About `SamplingConstants::PlacesOfGirth` places a wanted sample are looked at.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<FeatureSize> girthSizes(const Atlas& atlas,
  const std::function<double(const SurfacePlace&)>& spacing, const Stop& stop = nullptr);
}

#endif
