// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_TypedText_h
#define stipple_TypedText_h

#include "Control.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace stipple
{
/// A line of text while it is typed, with a caret and a selection. Keys are those of text fields:
/// arrows, Home and End (with Shift they select), Ctrl+A, BackSpace, Delete, and Ctrl+V for what
/// was copied elsewhere. Places in it are bytes, between letters of UTF-8.
class TypedText
{
public:
  /// What a letter becomes, mostly itself; 0: it is not taken. `rest` is what the line has besides
  /// the selection.
  using Takes = std::function<char(const std::string& rest, char letter)>;

  TypedText() = default;
  explicit TypedText(Takes takes)
    : Allowed(std::move(takes))
  {
  }

  /// The caret is at the end.
  void set(const std::string& text);
  /// What is typed next replaces it; the caret is at its end.
  void select(std::size_t begin, std::size_t end);
  /// In place of the selection; letters that are not taken are left out.
  void insert(const std::string& text);
  /// Whether the key is a text field's.
  bool key(const KeyStroke& stroke);

  const std::string& text() const { return this->Text; }
  bool empty() const { return this->Text.empty(); }
  std::size_t caret() const { return this->Caret; }
  /// Begin and end; equal if nothing is selected.
  std::pair<std::size_t, std::size_t> selection() const;

  /// Within `width` pixels of x, the side that the look aligns to, as much of it as fits, the caret
  /// among it; `lead` comes before.
  void paint(Canvas& canvas, float x, float middle, float width, const TextLook& look,
    const std::string& lead = "");
  /// The caret goes to where the pointer is, in the line as it was painted last.
  void place(const Pointer& pointer, bool selects);

private:
  char taken(const std::string& rest, char letter) const;
  void move(std::size_t place, bool selects);
  std::size_t before(std::size_t place) const;
  std::size_t after(std::size_t place) const;

  Takes Allowed;
  std::string Text;
  std::size_t Caret = 0;
  std::size_t Anchor = 0;                           ///< where the selection began
  std::vector<std::pair<std::size_t, float>> Stops; ///< places and their pixels, as painted last
};
}

#endif
