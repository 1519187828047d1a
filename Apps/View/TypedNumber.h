// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_TypedNumber_h
#define stipple_TypedNumber_h

#include "TypedText.h"

#include <string>

namespace stipple
{
/// A number while it is typed, key by key.
class TypedNumber
{
public:
  enum class End
  {
    None,     ///< it goes on
    Accepted, ///< Return, Tab
    GivenUp   ///< Esc
  };

  /// 1e4, 2.5e3 and 12,345 are whole numbers, too.
  explicit TypedNumber(bool whole);

  /// Begins with a number that the first letter replaces, or with none.
  void begin(const std::string& text = "");
  void finish() { this->On = false; }
  bool on() const { return this->On; }
  /// Something was typed, be it what was there.
  bool touched() const { return this->Touched; }
  const std::string& text() const { return this->Line.text(); }
  /// As it is typed, whole or not. False if it is no number.
  [[nodiscard]] bool value(double& number) const;
  TypedText& line() { return this->Line; }
  /// Takes all keys, so that none does anything else meanwhile, but commands (Ctrl) that are not a
  /// text field's: false for these.
  bool key(const KeyStroke& stroke, End& end);
  /// Why a number that was typed is not taken; empty if it is.
  static std::string whyNot(double typed, double low, double high);

private:
  bool Whole;
  bool On = false;
  bool Touched = false;
  TypedText Line;
};

/// A control with a number that can be typed.
class NumberControl : public Control
{
public:
  explicit NumberControl(bool whole)
    : Typed(whole)
  {
  }
  bool wantsKeys() const override { return this->Typed.on(); }
  bool key(const KeyStroke& stroke) override;
  void blur() override { this->finish(true); }

protected:
  /// The typing ends; what was typed counts, or does not.
  virtual void finish(bool accept) = 0;
  /// What was typed; false, and it is told, if that is no number. Nothing is not told.
  bool takeTyped(double& value) const;

  TypedNumber Typed;
};
}

#endif
