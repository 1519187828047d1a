// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberField.h"

#include "SceneActors.h"
#include "TextNumbers.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
NumberField::NumberField(std::string label, const Range& range, Commit commit)
  : NumberControl(range.whole)
  , Label(std::move(label))
  , Limits(range)
  , OnCommit(std::move(commit))
{
}

void NumberField::paint(Canvas& canvas)
{
  const float s = canvas.scale();
  const float middle = this->Box.y + 0.5F * this->Box.h;
  const Shade word = this->Enabled ? shades::Word : shades::Faint;
  canvas.text(this->Box.x, middle, this->Label, { 12, word });
  const float width = 0.46F * this->Box.w;
  const Rect field{ this->Box.right() - width, this->Box.y, width, this->Box.h };
  const bool typed = this->Typed.on();
  canvas.box(field, shades::Card, typed ? shades::Accent : shades::Line, 4, typed ? 1.5F : 1);
  const float right = field.right() - 8 * s;
  if (!typed && this->Limits.automatic && this->Value == 0)
  {
    const TextLook quiet{ 12, shades::Faint, Align::Right };
    canvas.text(right, middle, canvas.fitted(this->Automatic, width - 12 * s, quiet), quiet);
    return;
  }
  const TextLook look{ 13, this->Old && !typed ? shades::Faint : word, Align::Right, true };
  if (typed)
  {
    this->Typed.line().paint(canvas, right, middle, width - 12 * s, look);
    return;
  }
  canvas.text(right, middle,
    this->Limits.whole ? grouped(static_cast<long long>(this->Value)) : shortestText(this->Value),
    look);
}

void NumberField::focus()
{
  this->Typed.begin(
    this->Limits.automatic && this->Value == 0 ? std::string() : shortestText(this->Value));
}

bool NumberField::press(const Pointer& pointer)
{
  if (!this->Enabled)
  {
    return false;
  }
  if (pointer.secondary)
  {
    if (this->Default && *this->Default != this->Value)
    {
      this->OnCommit(*this->Default);
    }
    return false;
  }
  this->Typed.on() ? this->Typed.line().place(pointer, false) : this->focus();
  return true;
}

void NumberField::finish(bool accept)
{
  if (!this->Typed.on())
  {
    return;
  }
  this->Typed.finish();
  // What is shown and typed again is meant, too: a number that followed may be fixed by it.
  if (!accept || !this->Typed.touched())
  {
    return;
  }
  const std::string& text = this->Typed.text();
  double typed = 0;
  if (!this->takeTyped(typed) && (!text.empty() || !this->Limits.automatic))
  {
    return;
  }
  const double low = this->Limits.low;
  const double value = this->Limits.whole ? std::round(typed) : typed;
  const double within =
    this->Limits.automatic && value == 0 ? 0 : std::clamp(value, low, this->Limits.high);
  if (within != value) // nothing is done that was not asked for
  {
    this->tell(TypedNumber::whyNot(value, low, this->Limits.high));
    return;
  }
  this->OnCommit(value);
  if (value != typed)
  {
    this->tell(text + " is taken as " + grouped(static_cast<long long>(value)) + ".");
  }
}
}
