// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How long edges may be where creases and boundaries are close to one another.
#ifndef stipple_FeatureSizes_h
#define stipple_FeatureSizes_h

#include "Atlas.h"
#include "GradedSizes.h"
#include "ReportingThread.h"

#include <functional>
#include <vector>

namespace stipple
{
/// How long edges may be at a place on a feature, and how long they would be else.
struct FeatureSize
{
  Vec3 position;
  double size;
  double spacing;
};

/// Places on creases and boundaries where something else of the kind is nearer than the spacing
/// there, and how long edges may be so that triangles fit in between: in proportion to the local
/// feature size (J. Ruppert, A Delaunay Refinement Algorithm for Quality 2-Dimensional Mesh
/// Generation, 1995), which is measured straight across, on the surface, to what is farther away
/// along the features themselves. Short features count at their ends, small loops all around. What
/// lies in the corner where two features meet counts not.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<FeatureSize> featureSizes(const Atlas& atlas,
  const std::function<double(const SurfacePlace&)>& spacing, const Stop& stop = nullptr);

/// Of these the ones that are met by edges of `finest` of the spacing and longer: what would not be
/// meshed well by those (SamplingConstants::LeastSize) is left out.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<SizeSource> sizesFrom(
  const std::vector<FeatureSize>& features, double finest);
}

#endif
