// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Copies of the triangles of other blocks about a block, as filters that look at neighbours need.
#ifndef stipple_BlockGhosts_h
#define stipple_BlockGhosts_h

#include "RankMessages.h"

#include "vtkSmartPointer.h"

class vtkPartitionedDataSet;
class vtkPolyData;

namespace stipple
{
/// Adds so many rings of triangles of other partitions to each of this rank's, with their arrays,
/// behind its own, ring by ring. Points of partitions have global ids; null partitions are other
/// ranks', which are dealt as SurfaceBlocks::rankOf() says. Arrays `vtkGhostType` tell what is
/// there twice: each triangle and each point is no ghost in one partition, a point in the first of
/// those with a triangle of their own at it. All ranks call it, with the same number; none adds
/// no arrays either.
[[nodiscard]] STIPPLEFILTERSPARALLEL_EXPORT Status addGhostCells(
  int levels, const RankMessages& ranks, vtkPartitionedDataSet* blocks);

/// The same data, or a copy without ghost cells and arrays that tell of them.
STIPPLEFILTERSPARALLEL_EXPORT vtkSmartPointer<vtkPolyData> withoutGhosts(vtkPolyData* data);
}

#endif
