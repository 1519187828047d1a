// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What main() of both programs does with text, failures and exceptions.
#ifndef stipple_Program_h
#define stipple_Program_h

#include "ProgramText.h"
#include "Progress.h"

#include <functional>
#include <string>
#include <utility>

namespace stipple
{
enum ExitStatus
{
  Done = 0,
  Failed = 1,
  WrongUsage = 2
};

class Program
{
public:
  explicit Program(std::string name)
    : Name(std::move(name))
  {
  }

  /// One line on stderr; returns the status.
  [[nodiscard]] int complain(const std::string& sentence, ExitStatus status) const;
  /// Text on stdout.
  [[nodiscard]] int print(const std::string& text) const;
  /// What --help or --help=... asks for, on stdout.
  [[nodiscard]] int tell(const ProgramDescription& description, const std::string& asked) const;
  /// Does it, keeping what it frees (keepFreedMemory()), and tells why it failed, if it did;
  /// exceptions too.
  [[nodiscard]] int perform(const std::function<Status()>& work) const;

private:
  std::string Name;
};

/// So many threads, or all cores if these are fewer: oneTBB ignores what is beyond, and says so on
/// stderr. Once in a program, before anything else is done by several threads.
void useThreads(int most);
}

#endif
