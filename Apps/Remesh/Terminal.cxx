// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Terminal.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

namespace stipple
{
namespace
{
volatile std::sig_atomic_t Interrupted = 0;
volatile std::sig_atomic_t Holding = 0;

void onSignal(int)
{
  Interrupted = 1;
  if (!Holding)
  {
    alarm(1);
  }
}

/// Nobody noticed; there is no file yet that would be left half-written.
void onAlarm(int)
{
  if (!Holding)
  {
    constexpr char Text[] = "stipple: interrupted\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, Text, sizeof(Text) - 1);
    _exit(1);
  }
}
}

void catchInterrupts()
{
  struct sigaction action = {};
  action.sa_flags = SA_RESTART;
  action.sa_handler = onSignal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = onAlarm;
  sigaction(SIGALRM, &action, nullptr);
}

void holdInterrupts()
{
  Holding = 1;
  alarm(0);
}

bool interrupted()
{
  return Interrupted != 0;
}

ProgressBar::ProgressBar(bool wanted)
  : On(wanted && isatty(STDERR_FILENO) != 0)
{
  const char* terminal = std::getenv("TERM");
  this->On = this->On && !(terminal && std::string(terminal) == "dumb");
}

void ProgressBar::show(double fraction, const std::string& what)
{
  if (!this->On)
  {
    return;
  }
  constexpr int Width = 32;
  const int full = static_cast<int>(Width * std::clamp(fraction, 0., 1.));
  std::string line = "[" + std::string(full, '=') + std::string(Width - full, ' ') + "] " +
    std::to_string(static_cast<int>(100 * std::clamp(fraction, 0., 1.))) + " % " + what;
  if (line != this->Shown)
  {
    std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
    std::fflush(stderr);
    this->Shown = line;
  }
}

void ProgressBar::clear()
{
  if (!this->Shown.empty())
  {
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
    this->Shown.clear();
  }
}
}
