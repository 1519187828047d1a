// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_PolygonTriangulation_h
#define stipple_PolygonTriangulation_h

#include "StippleFiltersCoreModule.h"
#include "TriangleSurface.h"

namespace stipple
{
/// Cuts a polygon in space into triangles of its corners, oriented as it is: always two fewer than
/// it has corners. A quad is cut along its shorter diagonal; else a fan from the first corner where
/// that covers the polygon, as it does a convex one; else ears are cut off, the best shaped first.
/// Corners may lie on a side, and coincide where a bridge leads to a hole.
STIPPLEFILTERSCORE_EXPORT std::vector<Triangle> triangulatePolygon(
  const std::vector<Vec3>& corners);
}

#endif
