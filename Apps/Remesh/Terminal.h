// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the user sees while waiting, and Ctrl-C.
#ifndef stipple_Terminal_h
#define stipple_Terminal_h

#include <chrono>
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
/// Ends the program as the signal would have, had it not been caught: that is what a shell goes by
/// to end a loop or a script too, and calls 130 (SIGINT) or 143 (SIGTERM).
[[noreturn]] void endByInterrupt();

/// A bar on stderr if that is a terminal and it is wanted; else nothing at all. It tells the time
/// that is left, as soon as that can be told from the time that has passed.
class ProgressBar
{
public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { this->clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Whether somebody sees it.
  bool isOn() const { return this->On; }
  void show(double fraction, const std::string& what);
  void clear();

private:
  using Clock = std::chrono::steady_clock;

  std::string timeLeft(double fraction);

  bool On;
  Clock::time_point Begin = Clock::now();
  std::string Shown;
};
}

#endif
