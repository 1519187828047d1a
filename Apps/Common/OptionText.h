// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Options as text: what a user types, files of rows, and help.
#ifndef stipple_OptionText_h
#define stipple_OptionText_h

#include "OptionTable.h"
#include "Progress.h"

#include <string>
#include <vector>

namespace stipple
{
/// Sets an option to what was typed, or tells what is wrong with it, in words after its name. For
/// rows that come from a file, its name is kept: see readRows().
[[nodiscard]] std::string parseOption(
  const Option& option, const std::string& text, OptionValues& values);

/// Reads rows of numbers, one a line; empty lines and what follows # are skipped. Errors name file
/// and line.
[[nodiscard]] Status readRows(
  const Option& option, const std::string& file, std::vector<double>& values);

/// "unknown option '--gama'; did you mean '--gamma'?"
[[nodiscard]] std::string unknownOption(
  const std::string& typed, const std::vector<std::string>& names);

/// Of some words, the one that was probably meant; empty if none is near.
[[nodiscard]] std::string nearestWord(
  const std::string& typed, const std::vector<std::string>& words);

/// An entry of a help text: `left`, and `right` in lines beside it.
[[nodiscard]] std::string helpEntry(
  const std::string& left, const std::string& right, std::size_t indent);
}

#endif
