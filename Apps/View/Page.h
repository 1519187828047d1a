// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Something over the whole window that takes all events while it is there: a question, a list of
// files.
#ifndef stipple_Page_h
#define stipple_Page_h

#include "Control.h"

namespace stipple
{
class Page
{
public:
  Page() = default;
  virtual ~Page() = default;
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// Over all of the window, a rectangle of pixels.
  virtual void paint(Canvas& canvas, const Rect& window) = 0;
  virtual void press(const Pointer& pointer) = 0;
  virtual void key(const KeyStroke& stroke) = 0;
  virtual void hover(const Pointer&) {}
  /// Notches of the wheel, away from the user positive.
  virtual void wheel(int) {}
};
}

#endif
