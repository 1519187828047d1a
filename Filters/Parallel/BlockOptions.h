// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What of the table of options counts for blocks.
#ifndef stipple_BlockOptions_h
#define stipple_BlockOptions_h

#include "OptionTable.h"
#include "StippleFiltersParallelModule.h"

#include <vector>

namespace stipple
{
/// The rows of the table that blocks obey, with those of their choices, and what is automatic,
/// that blocks have.
[[nodiscard]] STIPPLEFILTERSPARALLEL_EXPORT std::vector<Option> blockOptions();
}

#endif
