// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Something over the whole window that takes all events while it is there: a question, a list of
// files.
#ifndef stipple_Page_h
#define stipple_Page_h

#include "Control.h"

#include <algorithm>

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

/// Which of the boxes the pointer is in; -1: none.
template <typename Boxes>
int boxAt(const Boxes& boxes, const Pointer& pointer)
{
  const auto found = std::find_if(boxes.begin(), boxes.end(),
    [&pointer](const Rect& box) { return box.has(pointer.x, pointer.y); });
  return found == boxes.end() ? -1 : static_cast<int>(found - boxes.begin());
}
}

#endif
