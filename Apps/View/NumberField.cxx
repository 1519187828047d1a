// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberField.h"

#include "SceneActors.h"
#include "TextNumbers.h"

#include <algorithm>

namespace stipple
{
NumberField::NumberField(std::string label, int low, int high, Commit commit)
  : Label(std::move(label))
  , Low(low)
  , High(high)
  , OnCommit(std::move(commit))
{
}

void NumberField::paint(Canvas& canvas)
{
  const float s = canvas.scale();
  const float middle = this->Box.y + 0.5F * this->Box.h;
  canvas.text(this->Box.x, middle, this->Label);
  const float width = 0.46F * this->Box.w;
  const Rect field{ this->Box.right() - width, this->Box.y, width, this->Box.h };
  canvas.box(field, shades::Card, this->Focused ? shades::Accent : shades::Line, 4,
    this->Focused ? 1.5F : 1);
  const float right = field.right() - 8 * s;
  const std::string text = this->Focused ? this->Typed : grouped(this->Value);
  const TextLook look{ 13, shades::Word, Align::Right, true };
  if (this->Focused && this->Fresh)
  {
    const float w = canvas.textWidth(text, look);
    canvas.fill(
      { right - w - 2 * s, field.y + 5 * s, w + 4 * s, field.h - 10 * s }, shades::AccentSoft);
  }
  canvas.text(right, middle, text, look);
  if (this->Focused)
  {
    canvas.rule(right + 2 * s, field.y + 6 * s, right + 2 * s, field.top() - 6 * s, shades::Accent);
  }
}

void NumberField::focus()
{
  this->Focused = true;
  this->Fresh = true;
  this->Typed = std::to_string(this->Value);
}

bool NumberField::press(const Pointer& pointer)
{
  if (pointer.secondary)
  {
    return false;
  }
  this->focus();
  return true;
}

void NumberField::finish(bool accept)
{
  if (!this->Focused)
  {
    return;
  }
  this->Focused = false;
  int value = 0;
  if (accept && parseInteger(this->Typed, 0, 2'000'000'000, value))
  {
    value = std::clamp(value, this->Low, this->High);
    if (value != this->Value)
    {
      this->OnCommit(value);
    }
  }
}

void NumberField::blur()
{
  this->finish(true);
}

bool NumberField::key(const KeyStroke& stroke)
{
  if (!this->Focused || stroke.control)
  {
    return false;
  }
  if (stroke.symbol == "Return" || stroke.symbol == "KP_Enter" || stroke.symbol == "Tab")
  {
    this->finish(true);
  }
  else if (stroke.symbol == "Escape")
  {
    this->finish(false);
  }
  else if (stroke.symbol == "BackSpace" || stroke.symbol == "Delete")
  {
    this->Typed =
      this->Fresh ? "" : this->Typed.substr(0, this->Typed.size() - !this->Typed.empty());
    this->Fresh = false;
  }
  else if (stroke.letter >= '0' && stroke.letter <= '9' && (this->Fresh || this->Typed.size() < 8))
  {
    this->Typed = (this->Fresh ? "" : this->Typed) + stroke.letter;
    this->Fresh = false;
  }
  return true; // no other key does anything else meanwhile
}
}
