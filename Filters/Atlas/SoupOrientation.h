// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// CGAL's polygon soup orientation, behind a plain signature.
#ifndef stipple_SoupOrientation_h
#define stipple_SoupOrientation_h

#include "TriangleSurface.h"

namespace stipple
{
/// Turns triangles so that neighbours agree, and duplicates points where the surface is not
/// manifold. sourcePoint is extended by the origin of each duplicate.
void orientSoup(std::vector<Triangle>& triangles, std::vector<int>& sourcePoint);

/// Removes triangles without area by collapses and flips (CGAL's remove_degenerate_faces); false if
/// some remain.
bool removeDegenerateFaces(
  TriangleSurface& surface, std::vector<int>& sourcePoint, std::vector<int>& sourceCell);
}

#endif
