// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_TypedNumber_h
#define stipple_TypedNumber_h

#include "Control.h"

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

  /// Whole numbers have no point and no sign; 1e4 is one.
  explicit TypedNumber(bool whole)
    : Whole(whole)
  {
  }

  /// Begins with a number that the first key replaces, or with none.
  void begin(const std::string& text = "");
  void finish() { this->On = false; }
  bool on() const { return this->On; }
  /// Nothing was typed yet.
  bool fresh() const { return this->Fresh; }
  const std::string& text() const { return this->Text; }
  /// Takes all keys, so that none does anything else meanwhile.
  End key(const KeyStroke& stroke);
  /// Why a number that was typed is not what is taken; empty if it is.
  static std::string whyNot(double typed, double low, double high);

private:
  bool takes(char letter) const;

  bool Whole;
  bool On = false;
  bool Fresh = false;
  std::string Text;
};
}

#endif
