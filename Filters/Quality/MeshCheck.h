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
/// of them oriented alike and none degenerate (see TriangleShape), that leaves no gap: a place of
/// the surface whose distance to the nearest triangle exceeds twice that triangle's longest edge,
/// and twice the edge length e that equal triangles would have, or a triangle whose centroid is
/// more than 2 e off the surface. Otherwise too few points, and the sentence says what is wrong.
/// Looks at as many places of the surface as the mesh has points. Call connect() of the mesh
/// before.
STIPPLEFILTERSQUALITY_EXPORT Status checkMesh(const TriangleSurface& mesh,
  const TriangleSurface& surface, const SurfaceTopology& topology, const Progress& progress);
}

#endif
