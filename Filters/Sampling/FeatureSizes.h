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
/// Places on creases and boundaries where something else of the kind is nearer than the spacing
/// there, and how long edges may be so that triangles fit in between: in proportion to the local
/// feature size (J. Ruppert, A Delaunay Refinement Algorithm for Quality 2-Dimensional Mesh
/// Generation, 1995), which is measured straight across, on the surface, to what is farther away
/// along the features themselves. Short features count at their ends, small loops all around.
/// Edges need not be shorter than SamplingConstants::FinestSize of the spacing; what would not be
/// meshed well by those is left out. What lies in the corner where two features meet counts not.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<SizeSource> featureSizes(const Atlas& atlas,
  const std::function<double(const SurfacePlace&)>& spacing, const Stop& stop = nullptr);
}

#endif
