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
/// Orientation spreads breadth first across edges of two triangles, so that a surface that can't be
/// oriented is cut open along a short line, where fronts meet: a Moebius strip straight across. At
/// an edge of more triangles, each goes on in one that runs along it the other way: among those
/// whose parts of the surface end at such edges only, across the inside of the surface if as many
/// run one way as the other, so that bodies that meet in an edge stay closed; else in the one that
/// is most nearly straight on, so that a sheet goes on beneath what ends on it, and what is left
/// over ends. Around each point, what still holds together gets a point of its own; where that
/// leaves an edge of more than two, these are joined to none.
void orientSoup(
  const std::vector<Vec3>& points, std::vector<Triangle>& triangles, std::vector<int>& sourcePoint);
}

#endif
