// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of the mesh, or that might be of it, that pass through others.
#ifndef stipple_MeshCrossings_h
#define stipple_MeshCrossings_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"
#include "TriangleIntersections.h"

#include <array>

namespace stipple
{
using MeshTriangle = std::array<Vertex, 3>;

inline PlacedTriangle placed(const OptimizedMesh& mesh, const MeshTriangle& t)
{
  return { { t[0].index(), t[1].index(), t[2].index() },
    { mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]) } };
}

inline bool intersect(const OptimizedMesh& mesh, const MeshTriangle& s, const MeshTriangle& t)
{
  return intersect(placed(mesh, s), placed(mesh, t));
}

/// Whether after a swap of the edge no more triangles about its corners pass through its own than
/// now. Asked where no corner is free, as on a strip between two creases, whose other side may
/// be as near as its own: no move would part them again. True elsewhere.
STIPPLEFILTERSOPTIMIZATION_EXPORT bool swapStaysApart(const OptimizedMesh& mesh, Edge e);
}

#endif
