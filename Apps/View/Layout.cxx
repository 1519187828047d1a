// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Layout.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
Layout makeLayout(int width, int height)
{
  // The panel's controls fit a window 800 pixels high; they grow with it.
  const float s = std::clamp(std::min(height / 800.F, width / 1280.F), 0.5F, 2.F);
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  Layout l;
  l.scale = s;
  l.window = { 0, 0, w, h };
  const float statusHeight = std::round(26 * s);
  const float panelWidth = std::round(272 * s);
  const float stripHeight = std::round(std::max(216 * s, 0.27F * h));
  const float left = w - panelWidth;
  l.status = { 0, 0, w, statusHeight };
  l.panel = { left, statusHeight, panelWidth, h - statusHeight };
  l.strip = { 0, statusHeight, left, stripHeight };
  const float viewBottom = statusHeight + stripHeight;
  const float half = std::floor(0.5F * left);
  l.before = { 0, viewBottom, half, h - viewBottom };
  l.after = { half, viewBottom, left - half, h - viewBottom };
  const float sheetWidth = std::round(0.38F * left);
  const float curveWidth = std::round(0.28F * left);
  l.sheet = { 0, statusHeight, sheetWidth, stripHeight };
  l.curve = { sheetWidth, statusHeight, curveWidth, stripHeight };
  l.figures = { sheetWidth + curveWidth, statusHeight, left - sheetWidth - curveWidth,
    stripHeight };
  return l;
}
}
