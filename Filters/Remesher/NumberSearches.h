// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Remeshing with one number of points after the other, until lengths or distances are as asked for.
#ifndef stipple_NumberSearches_h
#define stipple_NumberSearches_h

#include "Progress.h"
#include "RemesherRun.h"
#include "StippleFiltersRemesherModule.h"
#include "TriangleSurface.h"

namespace stipple
{
/// Remeshes with the number of points that the area asks for, and with others until the edges are
/// as long as the control map's EdgeLength, or as near as they get. `median`: their length.
STIPPLEFILTERSREMESHER_EXPORT Status remeshToEdgeLength(
  RemesherRun& run, int points, double& median);

/// Remeshes with numbers of points until mesh and reference, the run's input, are nowhere more than
/// `largest` (above 0, a length) apart. `reached`: what they are not, in percent of the reference's
/// diagonal. Fails if no number is found, and says what was reached.
STIPPLEFILTERSREMESHER_EXPORT Status remeshWithinDeviation(
  RemesherRun& run, const TriangleSurface& reference, double largest, double& reached);
}

#endif
