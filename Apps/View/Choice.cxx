// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Choice.h"

namespace stipple
{
Choice::Choice(Kind kind, std::vector<std::string> words, int columns, Chosen chosen)
  : Manner(kind)
  , Columns(columns)
  , OnChosen(std::move(chosen))
{
  for (std::string& word : words)
  {
    this->Cells.push_back({ std::move(word), "" });
  }
}

void Choice::setHints(const std::vector<std::string>& hints)
{
  for (std::size_t i = 0; i < hints.size() && i < this->Cells.size(); ++i)
  {
    this->Cells[i].hint = hints[i];
  }
}

std::string Choice::hint(const Pointer& pointer) const
{
  const int word = this->wordAt(pointer, false);
  return word >= 0 ? this->Cells[static_cast<std::size_t>(word)].hint : "";
}

int Choice::rows() const
{
  return (static_cast<int>(this->Cells.size()) + this->Columns - 1) / this->Columns;
}

void Choice::choose(int word)
{
  for (std::size_t i = 0; i < this->Cells.size(); ++i)
  {
    this->Cells[i].on = static_cast<int>(i) == word;
  }
}

Rect Choice::cellBox(int word) const
{
  const float height = this->Box.h / static_cast<float>(this->rows());
  const float gap = 0.12F * height;
  const float width =
    (this->Box.w - gap * static_cast<float>(this->Columns - 1)) / static_cast<float>(this->Columns);
  return { this->Box.x + static_cast<float>(word % this->Columns) * (width + gap),
    this->Box.top() - static_cast<float>(word / this->Columns + 1) * height + gap, width,
    height - gap };
}

int Choice::wordAt(const Pointer& pointer, bool enabled) const
{
  for (std::size_t i = 0; i < this->Cells.size(); ++i)
  {
    if ((this->Cells[i].enabled || !enabled) &&
      this->cellBox(static_cast<int>(i)).has(pointer.x, pointer.y))
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void Choice::paint(Canvas& canvas)
{
  for (std::size_t i = 0; i < this->Cells.size(); ++i)
  {
    const int word = static_cast<int>(i);
    const Cell& cell = this->Cells[i];
    const Rect box = this->cellBox(word);
    const bool down = word == this->Pressed && word == this->Under;
    const bool on = cell.on && cell.enabled;
    const Shade& ground = on ? shades::Accent
      : down                 ? shades::AccentSoft
      : word == this->Under  ? shades::Hover
                             : shades::Card;
    canvas.box(box, ground, on ? shades::Accent : shades::Line, 4);
    const TextLook look{ 11.5F,
      on                ? shades::Card
        : !cell.enabled ? shades::Faint
                        : shades::Word,
      Align::Center };
    canvas.text(box.x + 0.5F * box.w, box.y + 0.5F * box.h,
      canvas.fitted(cell.text, box.w - 4 * canvas.scale(), look), look);
  }
}

bool Choice::press(const Pointer& pointer)
{
  if (pointer.secondary && this->OnReset && this->wordAt(pointer) >= 0)
  {
    this->OnReset();
  }
  this->Pressed = pointer.secondary ? -1 : this->wordAt(pointer);
  this->Under = this->Pressed;
  return this->Pressed >= 0;
}

void Choice::release(const Pointer& pointer)
{
  const int word = this->Pressed;
  this->Pressed = -1;
  if (word >= 0 && word == this->wordAt(pointer))
  {
    this->OnChosen(word);
  }
}

bool Choice::hover(bool over, const Pointer& pointer)
{
  const int before = this->Under;
  this->Under = over ? this->wordAt(pointer) : -1;
  return before != this->Under;
}
}
