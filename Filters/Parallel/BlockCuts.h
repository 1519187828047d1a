// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A surface is cut into blocks by its triangles alone: k-d cuts of their centres.
#ifndef stipple_BlockCuts_h
#define stipple_BlockCuts_h

#include "RankMessages.h"

#include <array>

namespace stipple
{
/// A place in single precision: all that cuts need, and half the memory.
using Centre = std::array<float, 3>;

/// The block of each of this rank's triangles, of `blocks` (1 or more) for those of all ranks. A
/// set of triangles for b blocks is cut across the longest side of the box of its centres, so that
/// floor(b / 2) / b of the triangles lie below; all centres with the coordinate of the cut lie
/// below, too. So blocks depend on the centres, and not on which rank has them, nor on their order.
/// Bentley, "Multidimensional binary search trees used for associative searching", 1975.
/// Blocks may be empty where centres coincide.
STIPPLEFILTERSPARALLEL_EXPORT std::vector<int> cutIntoBlocks(
  const std::vector<Centre>& centres, int blocks, const RankMessages& ranks);
}

#endif
