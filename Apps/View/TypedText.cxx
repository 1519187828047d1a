// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TypedText.h"

#include "Display.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace stipple
{
namespace
{
// Pixels at scale 1.
constexpr float CaretGap = 2;
constexpr float CaretHeight = 16;

/// UTF-8 has more bytes of a letter after its first.
bool isWithinLetter(char byte)
{
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}
}

void TypedText::set(const std::string& text)
{
  this->Text = text;
  this->Caret = text.size();
  this->Anchor = this->Caret;
}

void TypedText::select(std::size_t begin, std::size_t end)
{
  this->Anchor = std::min(begin, this->Text.size());
  this->Caret = std::min(end, this->Text.size());
}

std::pair<std::size_t, std::size_t> TypedText::selection() const
{
  return std::minmax(this->Caret, this->Anchor);
}

std::size_t TypedText::before(std::size_t place) const
{
  while (place > 0 && isWithinLetter(this->Text[--place]))
  {
  }
  return place;
}

std::size_t TypedText::after(std::size_t place) const
{
  const std::size_t size = this->Text.size();
  place = std::min(place + 1, size);
  while (place < size && isWithinLetter(this->Text[place]))
  {
    ++place;
  }
  return place;
}

void TypedText::move(std::size_t place, bool selects)
{
  this->Caret = place;
  this->Anchor = selects ? this->Anchor : place;
}

char TypedText::taken(const std::string& rest, char letter) const
{
  return this->Allowed ? this->Allowed(rest, letter) : letter;
}

void TypedText::insert(const std::string& text)
{
  const auto [begin, end] = this->selection();
  this->Text.erase(begin, end - begin);
  this->move(begin, false);
  for (const char letter : text)
  {
    if (const char taken = this->taken(this->Text, letter); taken != 0)
    {
      this->Text.insert(this->Caret, 1, taken);
      this->move(this->Caret + 1, false);
    }
  }
}

bool TypedText::key(const KeyStroke& stroke)
{
  const std::string& key = stroke.symbol;
  const auto [begin, end] = this->selection();
  const bool selected = begin != end;
  if (stroke.control && (key == "a" || key == "A"))
  {
    this->select(0, this->Text.size());
  }
  else if (stroke.control && (key == "v" || key == "V"))
  {
    std::string words = clipboardText();
    // One line: a path that was copied may have its line's end.
    words.erase(std::find_if(words.begin(), words.end(),
                  [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }),
      words.end());
    this->insert(words);
  }
  else if (key == "Left" || key == "KP_Left")
  {
    this->move(selected && !stroke.shift ? begin : this->before(this->Caret), stroke.shift);
  }
  else if (key == "Right" || key == "KP_Right")
  {
    this->move(selected && !stroke.shift ? end : this->after(this->Caret), stroke.shift);
  }
  else if (key == "Home" || key == "KP_Home")
  {
    this->move(0, stroke.shift);
  }
  else if (key == "End" || key == "KP_End")
  {
    this->move(this->Text.size(), stroke.shift);
  }
  else if (key == "BackSpace" || key == "Delete" || key == "KP_Delete")
  {
    if (!selected)
    {
      this->move(key == "BackSpace" ? this->before(this->Caret) : this->after(this->Caret), true);
    }
    this->insert("");
  }
  else if (stroke.letter != 0 && !stroke.control)
  {
    // One that is not taken does not take away the selection.
    if (this->taken(this->Text.substr(0, begin) + this->Text.substr(end), stroke.letter) != 0)
    {
      this->insert(std::string(1, stroke.letter));
    }
  }
  else
  {
    return false;
  }
  return true;
}

void TypedText::paint(
  Canvas& canvas, float x, float middle, float width, const TextLook& look, const std::string& lead)
{
  const float s = canvas.scale();
  // Where not all fits, what is before the caret is cut first: there it is typed.
  std::size_t first = 0;
  std::string head = lead;
  const auto fits = [&](
                      const std::string& words) { return canvas.textWidth(words, look) <= width; };
  if (!fits(lead + this->Text))
  {
    head = lead + "...";
    while (first < this->Caret && !fits(head + this->Text.substr(first, this->Caret - first)))
    {
      first = this->after(first);
    }
    head = first == 0 ? lead : head;
  }
  std::size_t last = this->Text.size();
  while (last > this->Caret && !fits(head + this->Text.substr(first, last - first)))
  {
    last = this->before(last);
  }
  const std::string words = head + this->Text.substr(first, last - first);
  const float begin = look.align == Align::Right ? x - canvas.textWidth(words, look) : x;
  this->Stops.clear();
  for (std::size_t place = first;; place = this->after(place))
  {
    this->Stops.emplace_back(
      place, begin + canvas.textWidth(head + this->Text.substr(first, place - first), look));
    if (place >= last)
    {
      break;
    }
  }
  const auto pixelOf = [this](std::size_t place) {
    const auto stop = std::lower_bound(this->Stops.begin(), this->Stops.end(), place,
      [](const std::pair<std::size_t, float>& a, std::size_t b) { return a.first < b; });
    return stop == this->Stops.end() ? this->Stops.back().second : stop->second;
  };
  const auto [from, to] = this->selection();
  if (from != to)
  {
    const float left = pixelOf(std::max(from, first));
    canvas.fill({ left - 2 * s, middle - 0.5F * CaretHeight * s, pixelOf(to) - left + 4 * s,
                  CaretHeight * s },
      shades::AccentSoft);
  }
  canvas.text(x, middle, words, look);
  const float caret = pixelOf(this->Caret) + CaretGap * s;
  canvas.rule(
    caret, middle - 0.5F * CaretHeight * s, caret, middle + 0.5F * CaretHeight * s, shades::Accent);
}

void TypedText::place(const Pointer& pointer, bool selects)
{
  const auto nearest = std::min_element(
    this->Stops.begin(), this->Stops.end(), [&pointer](const auto& a, const auto& b) {
      return std::abs(a.second - pointer.x) < std::abs(b.second - pointer.x);
    });
  if (nearest != this->Stops.end())
  {
    this->move(nearest->first, selects);
  }
}
}
