// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Semi-regular meshes (paper 5, Figure 9): a base mesh whose triangles are split 1 to 4 again and
// again, on the surface.
#ifndef stipple_SemiRegularSubdivision_h
#define stipple_SemiRegularSubdivision_h

#include "Atlas.h"
#include "OptimizedMesh.h"
#include "SampleSet.h"
#include "StippleFiltersPatternsModule.h"

namespace stipple
{
struct SubdividedMesh
{
  std::vector<Sample> samples; ///< the base mesh's come first
  std::vector<Triangle> triangles;
  std::vector<int> level;                   ///< by vertex; 0 in the base mesh
  std::vector<std::array<int, 2>> parents;  ///< by vertex, the ends of the edge that it split; -1
                                            ///< twice in the base mesh
  std::vector<int> baseTriangle;            ///< by triangle
  std::vector<OptimizedMesh::Chain> chains; ///< by backbone; empty for seams
};

/// Splits every triangle of a mesh on the surface in four, `levels` (>= 0) times. A new vertex lies
/// on the surface by the middle of its edge, whatever seams lie between its ends; on a sharp or
/// boundary backbone, in the middle of the piece of it. `chains`: the vertices of every backbone in
/// order, a closed one's first again at the end; some of them may lie off it, where features were
/// simplified. Every level is relaxed for `rounds` rounds, which do not touch the connectivity.
STIPPLEFILTERSPATTERNS_EXPORT Status subdivideSemiRegularly(const Atlas& atlas,
  const std::vector<Sample>& samples, const std::vector<Triangle>& triangles,
  const std::vector<std::vector<int>>& chains, int levels, int rounds, SubdividedMesh& mesh,
  const Progress& progress);
}

#endif
