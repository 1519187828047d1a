// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Terminal.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

namespace stipple
{
namespace
{
volatile std::sig_atomic_t Interrupted = 0; // by this signal
volatile std::sig_atomic_t Holding = 0;

void onSignal(int number)
{
  Interrupted = number;
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
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, Text, sizeof(Text) - 1);
    endByInterrupt();
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

void endByInterrupt()
{
  const int number = Interrupted;
  std::signal(number, SIG_DFL);
  std::raise(number);
  _exit(128 + number); // not reached
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
  fraction = std::clamp(fraction, 0., 1.);
  constexpr int Width = 32;
  const int full = static_cast<int>(Width * fraction);
  const std::string line = "[" + std::string(full, '=') + std::string(Width - full, ' ') + "] " +
    std::to_string(static_cast<int>(100 * fraction)) + " % " + what + this->timeLeft(fraction);
  if (line != this->Shown)
  {
    std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
    std::fflush(stderr);
    this->Shown = line;
  }
}

std::string ProgressBar::timeLeft(double fraction)
{
  const Clock::time_point now = Clock::now();
  const double passed = std::chrono::duration<double>(now - this->Begin).count();
  if (fraction <= 0 || fraction >= 1)
  {
    return {};
  }
  // Before some seconds have passed, and a twentieth of the work is done, it would be a guess.
  constexpr double Seconds = 2;
  constexpr double Part = 0.05;
  if (passed < Seconds || fraction < Part)
  {
    return {};
  }
  const int left = static_cast<int>(std::ceil(passed / fraction * (1 - fraction)));
  return ", " +
    (left < 60 ? std::to_string(left) + " s" : std::to_string((left + 59) / 60) + " min") + " left";
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
