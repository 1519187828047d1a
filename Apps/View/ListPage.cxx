// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ListPage.h"

#include "Text.h"

#include <algorithm>

namespace stipple
{
ListPage::ListPage(
  std::string title, std::string sentence, std::vector<Entry> entries, std::string problem)
  : Title(std::move(title))
  , Sentence(std::move(sentence))
  , Entries(std::move(entries))
  , Problem(std::move(problem))
{
}

void ListPage::paint(Canvas& canvas, const Rect& window)
{
  const float s = canvas.scale();
  canvas.fill(window, shades::Ground);
  const auto rows = static_cast<float>(std::max<std::size_t>(1, this->Entries.size()));
  const float row = std::min(44 * s, (window.h - 120 * s) / rows);
  const float width = std::min(620 * s, window.w - 24 * s);
  const float height = row * rows + 100 * s;
  const float x = window.x + 0.5F * (window.w - width);
  float y = window.y + 0.5F * (window.h + height);
  canvas.text(x, y - 20 * s, this->Title, { 26, shades::Accent, Align::Left, true });
  const TextLook sentence{ 13, shades::Quiet };
  float line = y - 46 * s;
  for (const std::string& words : canvas.lines(this->Sentence, width, 2, sentence))
  {
    line -= 8 * s;
    canvas.text(x, line, words, sentence);
    line -= 9 * s;
  }
  y -= 84 * s;
  this->Boxes.clear();
  for (std::size_t i = 0; i < this->Entries.size(); ++i)
  {
    const Entry& entry = this->Entries[i];
    y -= row;
    const Rect box{ x, y, width, row - 0.14F * row };
    this->Boxes.push_back(box);
    const bool under = static_cast<int>(i) == this->Under;
    canvas.box(
      box, under ? shades::AccentSoft : shades::Card, under ? shades::Accent : shades::Line, 5);
    const float middle = box.y + 0.5F * box.h;
    const TextLook bold{ 13, shades::Word, Align::Left, true };
    const TextLook quiet{ 11.5F, shades::Quiet, Align::Right };
    const std::string text =
      entry.text + (entry.key.empty() ? "" : " (" + nameOfKey(entry.key) + ")");
    canvas.text(box.x + 14 * s, middle, text, bold);
    const float left = canvas.textWidth(text, bold) + 40 * s;
    canvas.text(
      box.right() - 14 * s, middle, canvas.fitted(entry.detail, box.w - left, quiet), quiet);
  }
  const TextLook alarm{ 12.5F, shades::Alarm };
  for (const std::string& words : canvas.lines(this->Problem, width, 3, alarm))
  {
    y -= 18 * s;
    canvas.text(x, y - 6 * s, words, alarm);
  }
}

int ListPage::entryAt(const Pointer& pointer) const
{
  return boxAt(this->Boxes, pointer);
}

void ListPage::press(const Pointer& pointer)
{
  if (const int entry = this->entryAt(pointer); entry >= 0)
  {
    this->Entries[static_cast<std::size_t>(entry)].action();
  }
}

void ListPage::key(const KeyStroke& stroke)
{
  const std::string key = stroke.control ? "Ctrl+" + upperCase(stroke.symbol) : stroke.symbol;
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&key](const Entry& entry) { return entry.key == key; });
  if (found != this->Entries.end())
  {
    found->action();
  }
}

void ListPage::hover(const Pointer& pointer)
{
  this->Under = this->entryAt(pointer);
}
}
