// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Flat faces of machined parts, which CAD programs write as fans and slivers, triangulated anew:
// the surface is the same, and charts, which follow its triangles, are not ragged.
#ifndef stipple_FlatFaces_h
#define stipple_FlatFaces_h

#include "CutSurface.h"
#include "FlatFaceCells.h"
#include "SurfaceRepair.h"

#include <functional>
#include <utility>
#include <vector>

namespace stipple
{
/// Flips edges between triangles that nearly lie in one plane, from slivers on (triangles with an
/// angle below 10 degrees), until these are Delaunay: no triangulation of the same points has a
/// larger smallest angle (Lawson 1977; Sibson 1978). An edge is flipped only if it is neither cut
/// nor a feature, if the surface moves by at most a thousandth of the edge, and by all flips
/// together by at most five millionths of the bounding box's diagonal, and if `mayFlip` agrees:
/// asked for an edge, the share of it where the other diagonal crosses, and the share of that, from
/// the corner over the halfedge to the one over its twin.
///
/// Returns the pairs of source cells that a flipped edge lay between.
using MayFlip = std::function<bool(Halfedge h, double s, double t)>;
STIPPLEFILTERSATLAS_EXPORT std::vector<std::pair<int, int>> triangulateFlatFaces(
  CutSurface& surface, const MayFlip& mayFlip);

/// The faces that cells make which are joined, directly or over others.
STIPPLEFILTERSATLAS_EXPORT FlatFaceCells flatFaceCells(
  const RepairedSurface& repaired, const std::vector<std::pair<int, int>>& joined);
}

#endif
