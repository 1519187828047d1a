// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpText.h"

#include <algorithm>

namespace stipple
{
const std::vector<std::pair<std::string, std::string>>& keyHelp()
{
  static const std::vector<std::pair<std::string, std::string>> lines = { { "Camera", "" },
    { "left button", "turn, both views together" }, { "middle button, Shift", "move" },
    { "right button, wheel", "zoom" },
    { "r, Shift+R", "fit the model into the view; as it was opened" },
    { "f", "fly to what is under the pointer" },
    { "Shift+X, Y, Z", "along an axis; again: from the other side" },
    { "u", "y or z is up, from the beginning's side" },
    { "w, s", "wireframe, surface, in both views" }, { "Edit", "" },
    { "n", "type the number of points; Return takes it" },
    { "on a slider", "click its number to type it; right button: default" },
    { "v, b, k, x", "pointer: camera, brush, constraint points, feature edges" },
    { "square brackets, Ctrl, Shift", "the brush: smaller, larger; takes paint away; spreads it" },
    { "p, Shift+P", "the brush fills up to features; takes paint away up to them" },
    { "y", "the brush mirrors in x, in y, in z, not" },
    { "Shift with the edge tool", "all edges on the way from the last one" },
    { "on the transfer function", "left button: add, drag a point; right: remove it" },
    { "Ctrl+Z, Ctrl+Y", "undo, redo" }, { "Return", "mesh now" },
    { "Esc", "stop what is being made" }, { "Show", "" },
    { "d", "next of samples, input, charts, density" },
    { "l, m", "feature lines (violet: lost in the mesh), seams" },
    { "o", "both in one view, with a line to drag between them" },
    { "c", "mesh colored by smallest angle, quality, distance, not" },
    { "g", "go to the worst triangle by color or angle; then to the next" },
    { "Shift+G", "go to a feature edge that is lost; then to the next" }, { "Files", "" },
    { "Ctrl+O", "open a surface or a session" },
    { "Ctrl+S, Ctrl+Shift+S", "save the mesh; under a name" },
    { "Ctrl+P, Ctrl+E", "save a picture of the window; figures of both views" },
    { "Ctrl+J", "save the session" }, { "q, Ctrl+Q", "quit; asks first if something is not saved" },
    { "h", "this page" } };
  return lines;
}

void paintHelp(Canvas& canvas, const Rect& window)
{
  const float s = canvas.scale();
  const auto& lines = keyHelp();
  const auto rows = static_cast<float>(lines.size() + 1);
  const float step = std::min(21 * s, (window.h - 60 * s) / rows);
  const float width = 620 * s;
  const float height = step * rows + 44 * s;
  const Rect box = canvas.page(window, width, height);
  float y = box.top() - 26 * s;
  canvas.text(box.x + 24 * s, y, "Keys", { 15, shades::Accent, Align::Left, true });
  canvas.text(
    box.right() - 24 * s, y, "h closes this page", { 11.5F, shades::Quiet, Align::Right });
  y -= 0.5F * step;
  for (const auto& line : lines)
  {
    y -= step;
    if (line.second.empty())
    {
      canvas.text(box.x + 24 * s, y, line.first, { 11.5F, shades::Quiet, Align::Left, true });
      continue;
    }
    canvas.text(box.x + 24 * s, y, line.first, { 12.5F, shades::Word, Align::Left, true });
    canvas.text(box.x + 210 * s, y, line.second, { 12.5F });
  }
}
}
