// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_StartPage_h
#define stipple_StartPage_h

#include "Page.h"

#include <functional>
#include <string>
#include <vector>

namespace stipple
{
/// What a window without a file shows: open, the files of last time, an example.
class StartPage : public Page
{
public:
  struct Entry
  {
    std::string key; ///< X11's name; a digit for the recent files
    std::string text;
    std::string detail;
    std::function<void()> action;
  };

  /// `problem`: why the last choice led back here; empty mostly.
  StartPage(std::vector<Entry> entries, std::string problem);

  void paint(Canvas& canvas, const Rect& window) override;
  void press(const Pointer& pointer) override;
  void key(const KeyStroke& stroke) override;
  void hover(const Pointer& pointer) override;

private:
  int entryAt(const Pointer& pointer) const; ///< -1: none

  std::vector<Entry> Entries;
  std::string Problem;
  std::vector<Rect> Boxes; ///< of the entries, as painted last
  int Under = -1;
};
}

#endif
