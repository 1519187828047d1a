// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Loops over a mesh's elements on all threads.
#ifndef stipple_ParallelFor_h
#define stipple_ParallelFor_h

#include "ElementIds.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace stipple
{
/// Calls visit(range) for blocks of ids, of 64 but for the last of a task's, all from 0 to the
/// range's size. What it writes must be the elements' own.
template <typename Id, typename Visit>
void parallelForBlocks(const ElementRange<Id>& ids, const Visit& visit)
{
  constexpr vtkIdType Grain = 512; // elements a task: some 50 us of work, and more
  constexpr int Block = 64;        // what they read stays in the nearest cache
  vtkSMPTools::For(0, ids.size(), Grain, [&](vtkIdType begin, vtkIdType end) {
    for (int i = static_cast<int>(begin); i < static_cast<int>(end); i += Block)
    {
      visit(ElementRange<Id>(i, std::min(i + Block, static_cast<int>(end))));
    }
  });
}

/// Calls visit(id) for all ids from 0 to the range's size. What it writes must be the element's
/// own.
template <typename Id, typename Visit>
void parallelFor(const ElementRange<Id>& ids, const Visit& visit)
{
  parallelForBlocks(ids, [&](const ElementRange<Id>& block) {
    for (const Id id : block)
    {
      visit(id);
    }
  });
}
}

#endif
