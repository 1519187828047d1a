// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include "Layout.h"

#include "vtkRenderWindow.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#if defined(__linux__)
#include <GL/glx.h>
#include <X11/Xlib.h>
#undef Status // Xlib has a macro of this name
#endif

namespace stipple
{
namespace
{
#if defined(__linux__)
/// It stays open: an X server without a screen starts anew when its last client leaves, and would
/// refuse the window's connection meanwhile.
Display* openDisplay()
{
  static Display* display = nullptr;
  display = display ? display : XOpenDisplay(nullptr);
  return display;
}
#endif
}

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
  Display* display = openDisplay();
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

std::array<int, 2> defaultWindowSize()
{
  std::array<int, 2> size = { { 1280, 800 } };
#if defined(__linux__)
  // A title bar and a desktop's panel.
  constexpr int Bars = 72;
  if (Display* display = openDisplay())
  {
    const int screen = DefaultScreen(display);
    size[0] = std::clamp(DisplayWidth(display, screen), LeastWidth, size[0]);
    size[1] = std::clamp(DisplayHeight(display, screen) - Bars, LeastHeight, size[1]);
  }
#endif
  return size;
}

void setLeastSize(vtkRenderWindow* window, int width, int height)
{
#if defined(__linux__)
  auto* display = static_cast<Display*>(window->GetGenericDisplayId());
  const auto id = reinterpret_cast<Window>(window->GetGenericWindowId());
  if (!display || !id)
  {
    return;
  }
  XSizeHints hints = {};
  long supplied = 0;
  XGetWMNormalHints(display, id, &hints, &supplied);
  hints.flags |= PMinSize;
  hints.min_width = width;
  hints.min_height = height;
  XSetWMNormalHints(display, id, &hints);
#else
  (void)window;
  (void)width;
  (void)height;
#endif
}

void setTitle(vtkRenderWindow* window, const std::string& title)
{
  window->SetWindowName(title.c_str());
#if defined(__linux__)
  auto* display = static_cast<Display*>(window->GetGenericDisplayId());
  const auto id = reinterpret_cast<Window>(window->GetGenericWindowId());
  if (!display || !id)
  {
    return;
  }
  // Of the Extended Window Manager Hints.
  for (const char* name : { "_NET_WM_NAME", "_NET_WM_ICON_NAME" })
  {
    XChangeProperty(display, id, XInternAtom(display, name, False),
      XInternAtom(display, "UTF8_STRING", False), 8, PropModeReplace,
      reinterpret_cast<const unsigned char*>(title.data()), static_cast<int>(title.size()));
  }
#endif
}

std::string clipboardText()
{
  std::string text;
#if defined(__linux__)
  Display* display = openDisplay();
  if (!display)
  {
    return text;
  }
  // Who has it writes it to a property of a window of ours, and tells.
  constexpr std::chrono::milliseconds MostWait(2000);
  constexpr long MostWords = 1024; // of four bytes
  const Atom utf8 = XInternAtom(display, "UTF8_STRING", False);
  const Atom property = XInternAtom(display, "STIPPLE_CLIPBOARD", False);
  const Window window =
    XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
  XConvertSelection(
    display, XInternAtom(display, "CLIPBOARD", False), utf8, property, window, CurrentTime);
  XFlush(display);
  const auto end = std::chrono::steady_clock::now() + MostWait;
  XEvent event;
  bool answered = false;
  while (!answered && std::chrono::steady_clock::now() < end)
  {
    answered = XCheckTypedWindowEvent(display, window, SelectionNotify, &event) != 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(answered ? 0 : 2));
  }
  if (answered && event.xselection.property != None)
  {
    Atom type = None;
    int format = 0;
    unsigned long size = 0;
    unsigned long left = 0;
    unsigned char* data = nullptr;
    XGetWindowProperty(
      display, window, property, 0, MostWords, True, utf8, &type, &format, &size, &left, &data);
    if (type == utf8 && format == 8)
    {
      text.assign(reinterpret_cast<const char*>(data), size);
    }
    if (data)
    {
      XFree(data);
    }
  }
  XDestroyWindow(display, window);
  XFlush(display);
#endif
  return text;
}
}
