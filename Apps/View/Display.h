// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Display_h
#define stipple_Display_h

#include "Progress.h"

#include <array>
#include <string>

class vtkRenderWindow;

namespace stipple
{
/// Whether a window can be opened here; VTK itself would end the program without saying more.
[[nodiscard]] Status checkDisplay();

/// A window's size in pixels that fits the screen with a title bar and a task bar beside it: 1280 x
/// 800 or less, never less than LeastWidth x LeastHeight. Needs a display.
[[nodiscard]] std::array<int, 2> defaultWindowSize();

/// Window managers let the user make an open window no smaller than this, in pixels.
void setLeastSize(vtkRenderWindow* window, int width, int height);

/// What window managers write over a window, UTF-8, now and once it is open: VTK tells them no
/// letters beyond Latin-1.
void setTitle(vtkRenderWindow* window, const std::string& title);

/// What was copied last in this or another program, UTF-8; empty if it is no text, or who has it
/// does not answer within two seconds.
[[nodiscard]] std::string clipboardText();
}

#endif
