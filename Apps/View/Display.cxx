// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include <cstdlib>

#if defined(__linux__)
#include <GL/glx.h>
#include <X11/Xlib.h>
#undef Status // Xlib has a macro of this name
#endif

namespace stipple
{
Status checkDisplay()
{
#if defined(__linux__)
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return Status::error(
      "there is no display to open a window on (DISPLAY is not set); the program "
      "stipple needs none");
  }
  // It stays open: an X server without a screen starts anew when its last client leaves, and would
  // refuse the window's connection meanwhile.
  static Display* display = nullptr;
  display = display ? display : XOpenDisplay(nullptr);
  if (!display)
  {
    return Status::error(
      "cannot open the display '" + std::string(name) + "'; the program stipple needs none");
  }
  int error = 0;
  int event = 0;
  const bool glx = glXQueryExtension(display, &error, &event) != 0;
  if (!glx)
  {
    return Status::error("the display '" + std::string(name) +
      "' has no OpenGL (GLX); the program stipple needs none");
  }
#endif
  return Status::success();
}
}
