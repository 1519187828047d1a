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

void onSignal(int)
{
  Interrupted = 1;
}
}

void catchInterrupts()
{
  struct sigaction action = {};
  action.sa_handler = onSignal;
  action.sa_flags = static_cast<int>(SA_RESETHAND); // the second signal has its default effect
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
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
