// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Large and slender triangles, as CAD programs write them, split before charts are cut: seams can
// only follow edges there are, and a map that is linear on a few slivers is far from conformal.
#ifndef stipple_LongEdges_h
#define stipple_LongEdges_h

#include "CutSurface.h"

namespace stipple
{
/// Twice the edge of a regular triangulation of the surface with 800 points; on slender surfaces 2
/// % of the bounding box's diagonal.
STIPPLEFILTERSATLAS_EXPORT double longestEdgeForCharts(const CutSurface& surface);

/// Halves edges longer than `longest`, the longest of all first, until there are none, or
/// mostPoints have been added. (Longest-edge bisection: no angle becomes less than half of what the
/// smallest was; Rivara 1984.) Returns the number of points added.
STIPPLEFILTERSATLAS_EXPORT int splitLongEdges(
  CutSurface& surface, double longest, int mostPoints = 20000);
}

#endif
