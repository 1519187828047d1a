// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a block as the data set that users get.
#ifndef stipple_BlockOutput_h
#define stipple_BlockOutput_h

#include "BlockRemeshing.h"

class vtkPartitionedDataSet;

namespace stipple
{
/// Writes the meshes of this rank's blocks as partitions, with global ids of points and the
/// surface's arrays at each point and under each triangle. All ranks call it.
[[nodiscard]] STIPPLEFILTERSPARALLEL_EXPORT Status writeBlocks(const SurfaceBlocks& blocks,
  std::vector<BlockMesh>& meshes, const RankMessages& ranks, vtkPartitionedDataSet* output);
}

#endif
