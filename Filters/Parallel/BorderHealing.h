// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What borders of blocks leave in the mesh is optimised away: strips along them, as parts of the
// mesh of their own.
#ifndef stipple_BorderHealing_h
#define stipple_BorderHealing_h

#include "BlockRemeshing.h"
#include "MeshOptimizer.h"

namespace stipple
{
/// Optimises the mesh about the borders, `rings` (2 or more) edges to each side, on the surface of
/// all blocks about. What moves about one curve alone is done curve by curve, each by the rank of
/// its first block; then what is near two or more, in connected parts. Points that are held (on
/// creases and boundaries) stay. Afterwards a block's mesh has points of its neighbours', and lacks
/// some of its own. All ranks call it; so do those without blocks.
[[nodiscard]] STIPPLEFILTERSPARALLEL_EXPORT Status healBorders(const SurfaceBlocks& blocks,
  const std::vector<BlockOutline>& outlines, const BlockBorders& borders,
  const OptimizerOptions& options, int rings, const RankMessages& ranks,
  std::vector<BlockMesh>& meshes);
}

#endif
