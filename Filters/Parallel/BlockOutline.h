// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What a block of a surface is like before it is remeshed: its features, densities and border.
#ifndef stipple_BlockOutline_h
#define stipple_BlockOutline_h

#include "BlockBorders.h"
#include "SurfaceBlocks.h"

class vtkGeometryRemesher;

namespace stipple
{
/// What a block tells before it is remeshed.
struct BlockOutline
{
  std::vector<OpenEdge> openEdges;
  /// Sharp edges of own triangles, and those between regions, as the block's points.
  std::vector<std::array<int, 2>> creases;
  std::vector<double> density; ///< wanted, up to one factor, by point; empty if the same everywhere
  double wanted = 0;           ///< the density's integral over the block
};

/// Looks for features (in a surface with this diagonal), regions and densities of a block.
STIPPLEFILTERSPARALLEL_EXPORT Status outlineBlock(
  const SurfaceBlock& block, vtkGeometryRemesher* remesher, double diagonal, BlockOutline& outline);

/// Parts of a block that creases and the block's border cut off, and that are smaller than two of
/// the mesh's triangles of this edge length, or narrower than a third of it: where a border runs to
/// and fro over a crease. Each is to go to the neighbour that it shares most of its border with,
/// creases aside if it can be; to one of a smaller number if isDown.
STIPPLEFILTERSPARALLEL_EXPORT std::vector<std::array<long long, 2>> findSlivers(
  const SurfaceBlock& block, const BlockOutline& outline, double edgeLength, bool isDown);
}

#endif
