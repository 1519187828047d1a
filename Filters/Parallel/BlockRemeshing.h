// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One block of a surface, remeshed alone with the border that it shares with its neighbours.
#ifndef stipple_BlockRemeshing_h
#define stipple_BlockRemeshing_h

#include "BlockOutline.h"
#include "SurfaceBlocks.h"

#include <utility>

class vtkGeometryRemesher;

namespace stipple
{
/// Where on the surface a point of the mesh lies.
struct BlockPlace
{
  int block = -1;    ///< none: where the block's own data say
  int triangle = -1; ///< one of the block's own
  std::array<double, 3> bary = { { 0, 0, 0 } };
};

/// A block's part of the mesh. Ids of points are those of the whole mesh: first the samples on
/// borders, then block by block the others.
struct BlockMesh
{
  std::vector<long long> id;
  std::vector<Vec3> position;
  std::vector<std::array<int, 3>> triangles; ///< of own points
  std::vector<BlockPlace> trianglePlace;     ///< under each; its bary does not count
  std::vector<int> triangleData;             ///< cell of `arrays`, or -1
  std::vector<std::array<int, 2>> lines;     ///< edges on creases and boundaries, as own points
  std::vector<BlockPlace> place;
  std::vector<int> data;               ///< own point of `arrays`, or -1 where place says more
  vtkSmartPointer<vtkPolyData> arrays; ///< the remesher's, with its arrays
};

/// Runs the remesher on a block's own triangles, so that its mesh has the borders' samples, an edge
/// from each to the next, and `points` others, whose ids are -1, -2, ... in their order. Parameters
/// that the block needs of the remesher are put back afterwards. Where the block is the whole
/// surface, none is set but the number of points. Too few points: the status knows how many the
/// block needs.
STIPPLEFILTERSPARALLEL_EXPORT Status remeshBlock(const SurfaceBlock& block,
  const BlockOutline& outline, const BlockBorders& borders, int points, bool isWhole,
  vtkGeometryRemesher* remesher, const Progress& progress, BlockMesh& mesh);
}

#endif
