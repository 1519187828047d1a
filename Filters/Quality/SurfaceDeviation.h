// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The largest distance between two surfaces, with a bound that holds between all samples.
#ifndef stipple_SurfaceDeviation_h
#define stipple_SurfaceDeviation_h

#include "NearestTriangle.h"
#include "Progress.h"
#include "StippleFiltersQualityModule.h"
#include "TriangleSurface.h"

namespace stipple
{
/// Between which the largest distance lies, in the surfaces' unit of length.
struct DeviationBounds
{
  double lower = 0; ///< the distance of a place
  double upper = 0; ///< no place is farther, but for rounding
};

/// The largest distance of a place of `from`, anywhere on its triangles, to `to`, which both may be
/// any soups. Within upper <= 1.01 lower + accuracy, where accuracy is a length; what rounding
/// leaves of the surfaces' coordinates is the least. Pieces of
/// triangles are cut until the distance to one triangle, which is convex, is small enough at all
/// corners of a piece: along the prisms over the triangles nearest to them, so that there are about
/// as many pieces as triangles that lie over one another. The same for any number of threads; 0 if
/// one of them is empty. May be called by one thread at a time.
STIPPLEFILTERSQUALITY_EXPORT Status oneSidedDeviation(const TriangleSurface& from,
  const NearestTriangle& to, double accuracy, const Progress& progress, DeviationBounds& bounds);

/// The larger of both directions: the Hausdorff distance of two surfaces.
STIPPLEFILTERSQUALITY_EXPORT Status surfaceDeviation(const TriangleSurface& a,
  const TriangleSurface& b, double accuracy, const Progress& progress, DeviationBounds& bounds);
}

#endif
