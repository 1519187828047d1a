// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Shorter edges about some triangles, and longer ones elsewhere: the number of vertices stays.
#ifndef stipple_LocalRefinement_h
#define stipple_LocalRefinement_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

#include <vector>

namespace stipple
{
/// Makes the spacing half as large as triangles are, in a region about each of some, and splits
/// wide edges there with vertices that are needed least elsewhere. `changed` are the triangles'
/// corners and all vertices with other triangles about them than before.
STIPPLEFILTERSOPTIMIZATION_EXPORT Status refineAbout(
  OptimizedMesh& mesh, const std::vector<Face>& faces, std::vector<Vertex>& changed);
}

#endif
