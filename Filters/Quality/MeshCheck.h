// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a mesh may be handed to a user: what is promised of every mesh, looked for in this one.
#ifndef stipple_MeshCheck_h
#define stipple_MeshCheck_h

#include "Progress.h"
#include "StippleFiltersQualityModule.h"
#include "TriangleSurface.h"

namespace stipple
{
/// Success for a mesh without isolated points whose triangles form a manifold of this topology, all
/// of them oriented alike and none degenerate (see TriangleShape), and that is nowhere farther from
/// the surface than it is coarse; otherwise too few points, and the sentence says what is wrong and
/// where. A place of the surface is too far if its distance to the nearest triangle exceeds both
/// that triangle's longest edge and the edge length that equal triangles would have: samples on the
/// surface with gaps no wider than their spacing leave no such place. Looks at three random places
/// for each of the mesh's points.
STIPPLEFILTERSQUALITY_EXPORT Status checkMesh(const TriangleSurface& mesh,
  const TriangleSurface& surface, const SurfaceTopology& topology, const Progress& progress);
}

#endif
