// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What stipple-mpi does once it knows what is wanted.
#ifndef stipple_ParallelRun_h
#define stipple_ParallelRun_h

#include "OptionTable.h"
#include "Progress.h"
#include "RankMessages.h"

namespace stipple
{
/// Reads, remeshes and writes; the status is the same on all ranks.
[[nodiscard]] Status runParallel(const OptionValues& options, const RankMessages& ranks);
}

#endif
