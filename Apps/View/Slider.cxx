// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Slider.h"

#include "TextNumbers.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
// Pixels at scale 1.
constexpr float KnobRadius = 6.5F;
constexpr float ValueWidth = 62;
constexpr float ValueHeight = 18;
}

Slider::Slider(std::string label, const Range& range, Format format, Change change)
  : NumberControl(false)
  , Label(std::move(label))
  , Limits(range)
  , Text(std::move(format))
  , Changed(std::move(change))
  , Value(range.low)
{
}

double Slider::placeOf(double value) const
{
  const Range& r = this->Limits;
  const double v = std::clamp(value, r.low, r.high);
  return r.logarithmic ? std::log(v / r.low) / std::log(r.high / r.low)
                       : std::pow((v - r.low) / (r.high - r.low), 1. / r.power);
}

double Slider::valueAt(double place) const
{
  const Range& r = this->Limits;
  const double p = std::clamp(place, 0., 1.);
  const double v = r.logarithmic ? r.low * std::pow(r.high / r.low, p)
                                 : r.low + (r.high - r.low) * std::pow(p, r.power);
  if (!(r.step > 0))
  {
    return v;
  }
  // Divided, not multiplied, by what is whole: 157 / 20 is the number nearest to 7.85.
  const double steps = std::round(v / r.step);
  const double rounded = r.step < 1 ? steps / std::round(1. / r.step) : steps * r.step;
  return std::clamp(rounded, r.low, r.high);
}

void Slider::paint(Canvas& canvas)
{
  const float s = canvas.scale();
  this->Scale = s;
  const float upper = this->Box.top() - 9 * s;
  const Shade strong = this->Enabled ? shades::Accent : shades::Faint;
  canvas.text(
    this->Box.x, upper, this->Label, { 12, this->Enabled ? shades::Word : shades::Faint });
  const TextLook look{ 12,
    !this->Enabled                     ? shades::Faint
      : this->Held || this->Typed.on() ? shades::Accent
                                       : shades::Word,
    Align::Right, true };
  if (this->Typed.on())
  {
    const float width = ValueWidth * s;
    // Within its box: beyond, nobody would paint over it.
    canvas.box(
      { this->Box.right() - width, upper - 9 * s, width, 18 * s }, shades::Card, shades::Accent, 3);
    this->Typed.line().paint(canvas, this->Box.right() - 5 * s, upper, width - 8 * s, look);
  }
  else
  {
    canvas.text(this->Box.right(), upper, this->Text(this->Value), look);
  }
  const float y = this->Box.y + 9 * s;
  const float left = this->Box.x + KnobRadius * s;
  const float length = this->Box.w - 2 * KnobRadius * s;
  const float x = left + length * static_cast<float>(this->placeOf(this->Value));
  canvas.fill({ left, y - 2 * s, length, 4 * s }, shades::Line);
  canvas.fill({ left, y - 2 * s, x - left, 4 * s }, strong);
  canvas.disc(x, y, KnobRadius,
    this->Enabled && (this->Held || this->Hovered) ? shades::AccentSoft : shades::Card, strong);
}

bool Slider::press(const Pointer& pointer)
{
  if (!this->Enabled)
  {
    return false;
  }
  if (pointer.secondary)
  {
    if (this->Default && *this->Default != this->Value)
    {
      this->Value = *this->Default;
      this->Changed(this->Value, true);
    }
    return false;
  }
  if (this->isOverValue(pointer))
  {
    this->Typed.on() ? this->Typed.line().place(pointer, false)
                     : this->Typed.begin(shortestText(this->Value));
    return false;
  }
  this->Held = true;
  this->drag(pointer);
  return true;
}

void Slider::drag(const Pointer& pointer)
{
  const float margin = KnobRadius * this->Scale;
  const double value =
    this->valueAt((pointer.x - this->Box.x - margin) / (this->Box.w - 2 * margin));
  if (value != this->Value)
  {
    this->Value = value;
    this->Changed(value, false);
  }
}

void Slider::release(const Pointer&)
{
  this->Held = false;
  this->Changed(this->Value, true);
}

bool Slider::isOverValue(const Pointer& pointer) const
{
  // A slider without a name shows no value.
  return !this->Label.empty() && pointer.x >= this->Box.right() - ValueWidth * this->Scale &&
    pointer.y >= this->Box.top() - ValueHeight * this->Scale;
}

void Slider::finish(bool accept)
{
  const bool isTyped = this->Typed.on() && accept && this->Typed.touched();
  this->Typed.finish();
  double value = 0;
  if (!isTyped || !this->takeTyped(value))
  {
    return;
  }
  if (value < this->Limits.low || value > this->Limits.high)
  {
    this->tell(TypedNumber::whyNot(value, this->Limits.low, this->Limits.high));
  }
  else if (value != this->Value)
  {
    this->Value = value;
    this->Changed(value, true);
  }
}
}
