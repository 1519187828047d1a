// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Question_h
#define stipple_Question_h

#include "Page.h"

#include <functional>
#include <string>
#include <vector>

namespace stipple
{
/// A sentence and its answers, each a button with a key.
class Question : public Page
{
public:
  struct Answer
  {
    std::string text;
    std::string key; ///< X11's name: "Return", "Escape", "d", ...
    std::function<void()> action;
  };

  /// `title` in bold, `sentence` below. The first answer is the one that stands out.
  Question(std::string title, std::string sentence, std::vector<Answer> answers);

  void paint(Canvas& canvas, const Rect& window) override;
  void press(const Pointer& pointer) override;
  void key(const KeyStroke& stroke) override;
  void hover(const Pointer& pointer) override;

private:
  int answerAt(const Pointer& pointer) const; ///< -1: none

  std::string Title;
  std::string Sentence;
  std::vector<Answer> Answers;
  std::vector<Rect> Boxes; ///< of the answers, as painted last
  int Under = -1;          ///< the pointer
};
}

#endif
