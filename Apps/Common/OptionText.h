// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Options as text: command lines, files of rows, and help.
#ifndef stipple_OptionText_h
#define stipple_OptionText_h

#include "OptionTable.h"
#include "Progress.h"

#include <string>
#include <utility>
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

/// An option that is a program's, not the table's.
[[nodiscard]] Option programOption(Option::Group group, Option::Kind kind, const char* name,
  const char* argument, const char* help, const std::vector<std::string>& endings = {});

/// What a command line says.
struct Arguments
{
  /// What was given, by the options' names; "model" is the input.
  OptionValues options;
  /// The same as it was typed.
  std::vector<std::pair<std::string, std::string>> inOrder;
  std::string asked;   ///< "help" or "version", with what was typed behind it: all else is idle
  std::string problem; ///< what is wrong first, one sentence
};

/// What a program takes: a model or a session.
struct InputRule
{
  bool mayBeMissing = false;
  std::vector<std::string> endings; ///< of its name; empty: those of meshes
};

/// Reads a command line with these options; -o FILE and -oFILE are --output, and -h is --help;
/// what follows -- is the input.
[[nodiscard]] Arguments parseArguments(const std::vector<std::string>& arguments,
  const std::vector<Option>& table, const std::string& usage, const InputRule& rule = {});

/// Of some words, the one that was probably meant; empty if none is near.
[[nodiscard]] std::string nearestWord(
  const std::string& typed, const std::vector<std::string>& words);

/// An entry of a help text: `left`, and `right` in lines beside it.
[[nodiscard]] std::string helpEntry(const std::string& left, const std::string& right);
/// What can be typed for an option: "-o, --output".
[[nodiscard]] std::string optionNames(const Option& option);
/// The two sides of an option's entry: how it is typed; what it means, its range and default.
[[nodiscard]] std::pair<std::string, std::string> optionEntry(const Option& option);
}

#endif
