// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Choice_h
#define stipple_Choice_h

#include "Control.h"

#include <functional>
#include <vector>

namespace stipple
{
/// Words in a grid: one of them is chosen, or, as Several, each is on or off; as Commands, each
/// does something and none stays chosen.
class Choice : public Control
{
public:
  enum class Kind
  {
    One,
    Several,
    Commands
  };
  using Chosen = std::function<void(int word)>;

  Choice(Kind kind, std::vector<std::string> words, int columns, Chosen chosen);

  void setWord(int word, const std::string& text) { this->Cells[word].text = text; }
  void setOn(int word, bool on) { this->Cells[word].on = on; }
  void setEnabled(int word, bool enabled) { this->Cells[word].enabled = enabled; }
  /// A hint a word, in their order.
  void setHints(const std::vector<std::string>& hints);
  void choose(int word); ///< One: this and no other
  /// What the right button does, over a word that is enabled.
  void setReset(std::function<void()> reset) { this->OnReset = std::move(reset); }
  int rows() const;

  void paint(Canvas& canvas) override;
  bool press(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  bool hover(bool over, const Pointer& pointer) override;
  std::string hint(const Pointer& pointer) const override;

private:
  struct Cell
  {
    std::string text;
    std::string hint;
    bool on = false;
    bool enabled = true;
  };
  Rect cellBox(int word) const;
  int wordAt(const Pointer& pointer, bool enabled = true) const; ///< -1: none

  Kind Manner;
  std::vector<Cell> Cells;
  int Columns;
  Chosen OnChosen;
  std::function<void()> OnReset;
  int Pressed = -1;
  int Under = -1; ///< the pointer
};
}

#endif
