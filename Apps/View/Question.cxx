// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Question.h"

#include <algorithm>

namespace stipple
{
Question::Question(std::string title, std::string sentence, std::vector<Answer> answers)
  : Title(std::move(title))
  , Sentence(std::move(sentence))
  , Answers(std::move(answers))
{
}

void Question::paint(Canvas& canvas, const Rect& window)
{
  const float s = canvas.scale();
  const float width = std::min(560 * s, window.w - 16 * s);
  const float height = 138 * s;
  const Rect box = canvas.page(window, width, height);
  const float pad = 22 * s;
  const TextLook title{ 15, shades::Word, Align::Left, true };
  const TextLook plain{ 12.5F, shades::Word };
  canvas.text(
    box.x + pad, box.top() - 28 * s, canvas.fitted(this->Title, width - 2 * pad, title), title);
  canvas.text(
    box.x + pad, box.top() - 56 * s, canvas.fitted(this->Sentence, width - 2 * pad, plain), plain);
  const auto count = static_cast<float>(this->Answers.size());
  const float gap = 10 * s;
  const float cell = (width - 2 * pad - gap * (count - 1)) / count;
  this->Boxes.clear();
  for (std::size_t i = 0; i < this->Answers.size(); ++i)
  {
    const Rect button{ box.x + pad + static_cast<float>(i) * (cell + gap), box.y + 18 * s, cell,
      32 * s };
    this->Boxes.push_back(button);
    const Answer& answer = this->Answers[i];
    canvas.button(button, answer.text + " (" + nameOfKey(answer.key) + ")", i == 0,
      static_cast<int>(i) == this->Under);
  }
}

int Question::answerAt(const Pointer& pointer) const
{
  return boxAt(this->Boxes, pointer);
}

void Question::press(const Pointer& pointer)
{
  if (const int answer = this->answerAt(pointer); answer >= 0)
  {
    this->Answers[static_cast<std::size_t>(answer)].action();
  }
}

void Question::key(const KeyStroke& stroke)
{
  const std::string key = stroke.symbol == "KP_Enter" ? "Return" : stroke.symbol;
  const auto found = std::find_if(this->Answers.begin(), this->Answers.end(),
    [&key](const Answer& answer) { return answer.key == key; });
  if (found != this->Answers.end())
  {
    found->action();
  }
}

void Question::hover(const Pointer& pointer)
{
  this->Under = this->answerAt(pointer);
}
}
