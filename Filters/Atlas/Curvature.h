// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Gaussian and mean curvature on a triangle surface (Meyer, Desbrun, Schröder, Barr 2003).
#ifndef stipple_Curvature_h
#define stipple_Curvature_h

#include "Progress.h"
#include "StippleFiltersAtlasModule.h"
#include "TriangleSurface.h"

namespace stipple
{
struct Curvature
{
  std::vector<double> gaussian;  ///< angle defect over mixed area, by point
  std::vector<double> mean;      ///< half the mean curvature normal's length, positive where convex
  std::vector<double> mixedArea; ///< by point; sums to the surface's area
};

/// Operators of section 3 of the paper, cotangents clamped so that slivers stay finite. The defect
/// at a boundary point is pi minus its angles, so that gaussian x mixedArea sums to 2 pi times the
/// Euler characteristic; the mean curvature at a boundary point, which the operator does not
/// define, is its interior neighbours' average. Stopped, it is of no use.
STIPPLEFILTERSATLAS_EXPORT Curvature computeCurvature(
  const TriangleSurface& surface, const Stop& stop = {});
}

#endif
