// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The command line of stipple-view.
#ifndef stipple_ViewOptions_h
#define stipple_ViewOptions_h

#include "OptionText.h"
#include "ProgramText.h"

#include <string>
#include <vector>

namespace stipple
{
/// The number of points that a surface opens with.
constexpr int DefaultPoints = 5000;
/// The number of points that the window takes: with more, a preview takes seconds.
constexpr int MostPoints = 1'000'000;
/// Most that the slider gives; more can be typed.
constexpr int MostSliderPoints = 50'000;

/// "play" and "shot", which may come many times, are in order; "size", if given, is a row of two
/// numbers.
[[nodiscard]] Arguments parseViewOptions(const std::vector<std::string>& arguments);

[[nodiscard]] ProgramDescription describeViewer();
}

#endif
