// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One run of stipple-view: read, open the window, do what the command line asks for.
#ifndef stipple_ViewRun_h
#define stipple_ViewRun_h

#include "Progress.h"

#include <string>

namespace stipple
{
struct Arguments;

/// An error is the one sentence for stderr.
[[nodiscard]] Status runViewer(const Arguments& line);

/// What --version prints.
[[nodiscard]] std::string viewVersionText();
}

#endif
