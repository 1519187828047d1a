// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_NumberField_h
#define stipple_NumberField_h

#include "TypedNumber.h"

#include <functional>
#include <optional>

namespace stipple
{
/// A number that is typed: a click, the digits, Return. Escape gives up.
class NumberField : public NumberControl
{
public:
  struct Range
  {
    double low = 0;
    double high = 0;
    bool whole = true;
    /// 0, or nothing typed, is outside the range and means something else.
    bool automatic = false;
  };
  using Commit = std::function<void(double)>;

  NumberField(std::string label, const Range& range, Commit commit);

  void setValue(double value) { this->Value = value; }
  /// What the right button goes back to.
  void setDefault(double value) { this->Default = value; }
  void setEnabled(bool enabled) { this->Enabled = enabled; }
  /// The number is an old one, and another is to come.
  void setOld(bool old) { this->Old = old; }
  void setLabel(const std::string& label) { this->Label = label; }
  /// What is shown for 0 where that is automatic.
  void setAutomatic(const std::string& word) { this->Automatic = word; }
  void focus();

  void paint(Canvas& canvas) override;
  bool press(const Pointer& pointer) override;

private:
  void finish(bool accept) override;

  std::string Label;
  Range Limits;
  Commit OnCommit;
  double Value = 0;
  std::optional<double> Default;
  std::string Automatic;
  bool Enabled = true;
  bool Old = false;
};
}

#endif
