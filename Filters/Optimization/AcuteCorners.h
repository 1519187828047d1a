// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Corners that two creases or boundaries leave at a small angle, and open later: farther out, the
// triangle between them has larger angles.
#ifndef stipple_AcuteCorners_h
#define stipple_AcuteCorners_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// The regions about such corners in which spacing must grow for the creases to be `angle`
/// (radians, > 0) apart where the first points on them lie. Corners whose creases do not open that
/// far within 3.4 edges stay as they are: larger triangles would not help them.
STIPPLEFILTERSOPTIMIZATION_EXPORT CoarseRegions findAcuteCorners(
  const OptimizedMesh& mesh, double angle);
}

#endif
