// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Loops over a mesh's elements on all threads.
#ifndef stipple_ParallelFor_h
#define stipple_ParallelFor_h

#include "ElementIds.h"

#include "vtkSMPTools.h"

namespace stipple
{
/// Calls visit(id) for all ids from 0 to the range's size. What it writes must be the element's
/// own.
template <typename Id, typename Visit>
void parallelFor(const ElementRange<Id>& ids, const Visit& visit)
{
  constexpr vtkIdType Grain = 512; // elements a task: some 50 us of work, and more
  vtkSMPTools::For(0, ids.size(), Grain, [&](vtkIdType begin, vtkIdType end) {
    for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
    {
      visit(Id(i));
    }
  });
}
}

#endif
