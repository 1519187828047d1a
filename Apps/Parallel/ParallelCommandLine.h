// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The options of stipple-mpi: those of stipple's that hold for blocks, and its own.
#ifndef stipple_ParallelCommandLine_h
#define stipple_ParallelCommandLine_h

#include "OptionText.h"
#include "ProgramText.h"

#include <string>
#include <vector>

namespace stipple
{
[[nodiscard]] Arguments parseParallelCommandLine(const std::vector<std::string>& arguments);
[[nodiscard]] ProgramDescription describeParallelProgram();
}

#endif
