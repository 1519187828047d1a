// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Layout.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
constexpr float LeastScale = 0.7F;  ///< letters stay readable
constexpr float LeastViews = 240;   ///< pixels at scale 1 that the views get before all others
constexpr float LeastStrip = 800;   ///< below this width what the strip shows would overlap
constexpr float NarrowView = 0.45F; ///< width over height; narrower ones lie above each other
}

Layout makeLayout(int width, int height, bool oneView)
{
  // The panel's controls fit a window 800 pixels high; they grow with it.
  const float s = std::clamp(std::min(height / 800.F, width / 1280.F), LeastScale, 2.F);
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  Layout l;
  l.scale = s;
  l.window = { 0, 0, w, h };
  const float statusHeight = std::min(std::round(26 * s), h);
  const float wantedPanel = std::round(272 * s);
  const float panelWidth = w - wantedPanel >= LeastViews * s ? wantedPanel : 0;
  const float left = w - panelWidth;
  const float wantedStrip = std::round(std::max(216 * s, 0.27F * h));
  const bool strip = h - statusHeight - wantedStrip >= LeastViews * s && left >= LeastStrip * s;
  const float stripHeight = strip ? wantedStrip : 0;
  l.status = { 0, 0, w, statusHeight };
  l.panel = { left, statusHeight, panelWidth, h - statusHeight };
  l.strip = { 0, statusHeight, strip ? left : 0, stripHeight };
  const float viewBottom = statusHeight + stripHeight;
  const float viewHeight = h - viewBottom;
  const float half = std::floor(0.5F * left);
  if (oneView)
  {
    l.before = { 0, viewBottom, left, viewHeight };
    l.after = l.before;
  }
  else if (half < NarrowView * viewHeight)
  {
    const float lower = std::floor(0.5F * viewHeight);
    l.before = { 0, viewBottom + lower, left, viewHeight - lower };
    l.after = { 0, viewBottom, left, lower };
  }
  else
  {
    l.before = { 0, viewBottom, half, viewHeight };
    l.after = { half, viewBottom, left - half, viewHeight };
  }
  if (strip)
  {
    const float sheetWidth = std::round(0.38F * left);
    const float curveWidth = std::round(0.28F * left);
    l.sheet = { 0, statusHeight, sheetWidth, stripHeight };
    l.curve = { sheetWidth, statusHeight, curveWidth, stripHeight };
    l.figures = { sheetWidth + curveWidth, statusHeight, left - sheetWidth - curveWidth,
      stripHeight };
  }
  return l;
}
}
