// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// CGAL's removal of degenerate triangles, behind a plain signature.
#ifndef stipple_DegenerateFaces_h
#define stipple_DegenerateFaces_h

#include "TriangleSurface.h"

namespace stipple
{
/// Removes triangles without area by collapses and flips (CGAL's remove_degenerate_faces); false if
/// some remain.
bool removeDegenerateFaces(
  TriangleSurface& surface, std::vector<int>& sourcePoint, std::vector<int>& sourceCell);
}

#endif
