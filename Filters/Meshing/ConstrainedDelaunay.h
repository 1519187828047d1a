// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Constrained Delaunay triangulation in the plane (paper 4.1); the only file that sees CGAL.
#ifndef stipple_ConstrainedDelaunay_h
#define stipple_ConstrainedDelaunay_h

#include "Progress.h"
#include "ReportingThread.h"
#include "StippleFiltersMeshingModule.h"
#include "TriangleSurface.h"

namespace stipple
{
/// What kept constrainedDelaunay() from keeping its promise.
struct DelaunayConflict
{
  enum class Kind
  {
    None,
    Duplicate, ///< point `first` coincides with point `second`
    OnSegment, ///< point `first` lies in the interior of segment `second`
    Crossing,  ///< segments `first` and `second` cross
    Degenerate ///< fewer than three points, or all on one line
  };
  Kind kind = Kind::None;
  int first = -1;
  int second = -1;
};

/// The triangles (counterclockwise, each of positive area) of the region that the segments enclose.
/// Points and segments must be in general enough position: distinct points, segments that meet at
/// their ends only and pass through no other point. Exact predicates decide, so that collinear,
/// cocircular and nearly coincident points are as good as any. The result depends on the input's
/// order only. Once `stop` is true, this ends early and leaves no triangle.
STIPPLEFILTERSMESHING_EXPORT DelaunayConflict constrainedDelaunay(const std::vector<Vec2>& points,
  const std::vector<std::array<int, 2>>& segments, std::vector<Triangle>& triangles,
  const Stop& stop = {});
}

#endif
