// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What a program says of itself, made of its options: help, manual page, completions of shells.
#ifndef stipple_ProgramText_h
#define stipple_ProgramText_h

#include "OptionTable.h"
#include "Progress.h"

#include <string>
#include <utility>
#include <vector>

namespace stipple
{
/// A program in words.
struct ProgramDescription
{
  struct Group
  {
    std::string title; ///< may be empty, for options that come first
    std::vector<Option> options;
  };

  std::string name;
  std::string version;
  std::string brief;     ///< half a sentence: "remesh ..."
  std::string arguments; ///< "INPUT -o OUTPUT [options]"
  std::string text;      ///< what it does, in lines
  std::vector<Group> groups;
  std::string keysTitle;                                     ///< of a window
  std::vector<std::pair<std::string, std::string>> keys;     ///< and what they do
  std::string exitStatus;                                    ///< in lines
  std::vector<std::pair<std::string, std::string>> examples; ///< command, and what it does
  std::vector<std::string> seeAlso;                          ///< other programs
};

/// What --help and --help=... ask for: help, man, bash or zsh.
[[nodiscard]] Status tellAbout(
  const ProgramDescription& program, const std::string& asked, std::string& text);

[[nodiscard]] std::string helpText(const ProgramDescription& program);
/// In the language of man(7), section 1.
[[nodiscard]] std::string manualPage(const ProgramDescription& program);
/// For bash: options, the words that they take, and files with the endings that they may have.
[[nodiscard]] std::string bashCompletion(const ProgramDescription& program);
/// The same for zsh.
[[nodiscard]] std::string zshCompletion(const ProgramDescription& program);
}

#endif
