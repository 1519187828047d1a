// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the user sees while waiting, and Ctrl-C.
#ifndef stipple_Terminal_h
#define stipple_Terminal_h

#include <string>

namespace stipple
{
/// Catches SIGINT and SIGTERM from now on: work has a second to notice interrupted(), then the
/// program ends.
void catchInterrupts();
/// Files are being written: interrupted() will be asked before they are put in place, and nothing
/// else ends the program.
void holdInterrupts();
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
