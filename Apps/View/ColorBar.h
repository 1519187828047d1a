// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Colours that stand for numbers, and the bar that says which for which.
#ifndef stipple_ColorBar_h
#define stipple_ColorBar_h

#include "Canvas.h"

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace stipple
{
using Pixel = std::array<unsigned char, 3>;

/// From blue over nearly white to red, by a number from 0 to 1; others count as the nearer end.
[[nodiscard]] Pixel divergingColor(double share);

/// For a density over the mean one: by its logarithm, from an eighth to eight times the mean.
[[nodiscard]] double densityShare(double ratio);

/// The colours from 0 to 1, and what some of them stand for.
struct ColorBar
{
  std::function<Pixel(double)> color;
  std::vector<std::pair<double, std::string>> ticks; ///< place from 0 to 1, number
  std::string title;
};

/// Density over the mean density.
[[nodiscard]] ColorBar densityBar();

/// How much of a place is covered already.
using Covered = std::function<double(const Rect&)>;

/// On a ground of its own, at the lower left of a view; or, if it is known what covers this, in the
/// corner that is covered least.
void paintColorBar(
  Canvas& canvas, const Rect& view, const ColorBar& bar, const Covered& covered = {});
}

#endif
