// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_HelpText_h
#define stipple_HelpText_h

#include "Canvas.h"

#include <string>
#include <utility>
#include <vector>

namespace stipple
{
/// Keys, and what they do, by groups; a group's title has an empty second text.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& keyHelp();

/// The overlay in the middle of the window.
void paintHelp(Canvas& canvas, const Rect& window);
}

#endif
