// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the user sees while waiting, and Ctrl-C.
#ifndef stipple_Terminal_h
#define stipple_Terminal_h

#include <string>

namespace stipple
{
/// Catches SIGINT and SIGTERM from now on; the second one ends the program at once.
void catchInterrupts();
[[nodiscard]] bool interrupted();

/// A bar on stderr if that is a terminal and it is wanted; else nothing at all.
class ProgressBar
{
public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { this->clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void show(double fraction, const std::string& what);
  void clear();

private:
  bool On;
  std::string Shown;
};
}

#endif
