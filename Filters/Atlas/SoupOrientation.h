// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// From triangles that share points to an oriented manifold.
#ifndef stipple_SoupOrientation_h
#define stipple_SoupOrientation_h

#include "TriangleSurface.h"

namespace stipple
{
/// Turns triangles so that neighbours agree, and duplicates points where the surface is not
/// manifold. sourcePoint, one a point, is extended by the origin of each duplicate.
///
/// Orientation spreads breadth first, so that a surface that can't be oriented is cut open along a
/// short line, where fronts meet: a Moebius strip straight across. Edges of more than two triangles
/// join none of them; around each point, what still holds together gets a point of its own.
void orientSoup(std::vector<Triangle>& triangles, std::vector<int>& sourcePoint);
}

#endif
