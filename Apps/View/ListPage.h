// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_ListPage_h
#define stipple_ListPage_h

#include "Page.h"

#include <functional>
#include <string>
#include <vector>

namespace stipple
{
/// Entries to choose from, over the whole window: what a window without a file shows, arrays.
class ListPage : public Page
{
public:
  struct Entry
  {
    std::string key; ///< X11's name, or a letter with Ctrl as "Ctrl+O"; may be empty
    std::string text;
    std::string detail;
    std::function<void()> action;
  };

  /// `problem`: why the last choice led back here; empty mostly.
  ListPage(
    std::string title, std::string sentence, std::vector<Entry> entries, std::string problem = "");

  void paint(Canvas& canvas, const Rect& window) override;
  void press(const Pointer& pointer) override;
  void key(const KeyStroke& stroke) override;
  void hover(const Pointer& pointer) override;

private:
  int entryAt(const Pointer& pointer) const; ///< -1: none

  std::string Title;
  std::string Sentence;
  std::vector<Entry> Entries;
  std::string Problem;
  std::vector<Rect> Boxes; ///< of the entries, as painted last
  int Under = -1;
};
}

#endif
