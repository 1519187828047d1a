// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Piecewise-linear curves on the surface, made of its edges (paper 2.4).
#ifndef stipple_FeatureCurves_h
#define stipple_FeatureCurves_h

#include "CutSurface.h"
#include "Progress.h"

class vtkPolyData;

namespace stipple
{
/// Inserts polylines into the surface and marks them sharp. Their points are moved to the nearest
/// place on the surface and become vertices; between two of them the curve runs where the plane
/// through both and the surface's normal cuts the surface. An error if it does not get from one to
/// the next that way.
STIPPLEFILTERSATLAS_EXPORT Status insertFeatureCurves(
  CutSurface& surface, vtkPolyData* curves, const Progress& progress);
}

#endif
