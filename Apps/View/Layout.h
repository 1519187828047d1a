// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where everything is in a window of some size.
#ifndef stipple_Layout_h
#define stipple_Layout_h

#include "Canvas.h"

namespace stipple
{
/// The least size of the window, in pixels, in which everything has its place.
constexpr int LeastWidth = 640;
constexpr int LeastHeight = 480;

/// Whatever does not fit is an empty rectangle: first the strip, then the panel. The status line
/// and the views are always there.
struct Layout
{
  float scale = 1; ///< of letters, lines and controls
  Rect window;
  Rect before;  ///< the model with the preview
  Rect after;   ///< the mesh
  Rect sheet;   ///< the control map
  Rect curve;   ///< the transfer function
  Rect figures; ///< the mesh's quality
  Rect strip;   ///< the last three together
  Rect panel;   ///< the controls
  Rect status;  ///< one line at the bottom
};

/// `oneView`: both views are in the same place.
[[nodiscard]] Layout makeLayout(int width, int height, bool oneView = false);
}

#endif
