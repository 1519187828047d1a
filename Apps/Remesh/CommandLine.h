// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the user asked for: the options of the table, and those of the program alone.
#ifndef stipple_CommandLine_h
#define stipple_CommandLine_h

#include "OptionText.h"
#include "ProgramText.h"

#include <string>
#include <vector>

namespace stipple
{
/// Rows that come from a file are still its name; "help=readme" asks for README's table.
[[nodiscard]] Arguments parseCommandLine(const std::vector<std::string>& arguments);

/// The program in words: every option in its group.
[[nodiscard]] ProgramDescription describeProgram();

/// README's table of options.
[[nodiscard]] std::string readmeTable();
}

#endif
