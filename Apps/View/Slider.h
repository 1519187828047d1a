// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Slider_h
#define stipple_Slider_h

#include "TypedNumber.h"

#include <functional>
#include <optional>
#include <string>

namespace stipple
{
/// A value along a line: its name above on the left, the value on the right. A press on the value
/// lets it be typed (Return takes it, Esc gives up), the right button resets it.
class Slider : public NumberControl
{
public:
  struct Range
  {
    double low = 0;
    double high = 1;
    double power = 1; ///< place along the line to this power; more than 1: finer at its low end
    bool logarithmic = false; ///< instead; low must be positive
    double step = 0;          ///< values are multiples of this; 0: any
  };
  using Format = std::function<std::string(double)>;
  /// Called with the value while it is dragged, and once more with `rests` when it is let go.
  using Change = std::function<void(double value, bool rests)>;

  Slider(std::string label, const Range& range, Format format, Change change);

  void setRange(const Range& range) { this->Limits = range; }
  void setValue(double value) { this->Value = value; }
  /// What the right button goes back to.
  void setDefault(double value) { this->Default = value; }
  /// Disabled: faint, and not to be dragged.
  void setEnabled(bool enabled) { this->Enabled = enabled; }
  double value() const { return this->Value; }

  void paint(Canvas& canvas) override;
  bool press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;

protected:
  bool isHandled() const override { return this->Enabled; }

private:
  double placeOf(double value) const; ///< 0 to 1
  double valueAt(double place) const;

  bool isOverValue(const Pointer& pointer) const;
  void finish(bool accept) override;

  std::string Label;
  Range Limits;
  Format Text;
  Change Changed;
  double Value = 0;
  std::optional<double> Default;
  bool Held = false;
  bool Enabled = true;
  float Scale = 1; ///< of the last painting
};
}

#endif
