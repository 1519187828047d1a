// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_NumberField_h
#define stipple_NumberField_h

#include "Control.h"

#include <functional>

namespace stipple
{
/// A whole number that is typed: a click, the digits, Return. Escape gives up.
class NumberField : public Control
{
public:
  using Commit = std::function<void(int)>;

  NumberField(std::string label, int low, int high, Commit commit);

  void setValue(int value) { this->Value = value; }
  void focus();

  void paint(Canvas& canvas) override;
  bool press(const Pointer& pointer) override;
  bool wantsKeys() const override { return this->Focused; }
  bool key(const KeyStroke& stroke) override;
  void blur() override;

private:
  void finish(bool accept);

  std::string Label;
  int Low;
  int High;
  Commit OnCommit;
  int Value = 0;
  bool Focused = false;
  bool Fresh = false; ///< nothing typed yet: the first digit replaces the number
  std::string Typed;
};
}

#endif
