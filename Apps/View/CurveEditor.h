// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_CurveEditor_h
#define stipple_CurveEditor_h

#include "Control.h"

#include <functional>
#include <utility>
#include <vector>

namespace stipple
{
/// A piecewise linear function from [0, 1] to [0, 1] over a histogram. Drag a point; press where
/// there is none to add one; the right button takes one away.
class CurveEditor : public Control
{
public:
  using Points = std::vector<std::array<double, 2>>;
  /// Importances as they are.
  static Points straight() { return { { 0, 0 }, { 1, 1 } }; }
  using Change = std::function<void(const Points& points, bool rests)>;

  explicit CurveEditor(Change change);

  /// No points: the identity.
  void setPoints(const Points& points);
  /// The power that follows the curve; shown as a thinner line if it is not 1.
  void setGamma(double gamma) { this->Gamma = gamma; }
  /// Bars, of any unit.
  void setHistogram(const std::vector<double>& bars) { this->Bars = bars; }

  void paint(Canvas& canvas) override;
  bool press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;

private:
  Rect plot() const;
  std::pair<float, float> placeOf(const std::array<double, 2>& point) const;
  std::array<double, 2> pointAt(const Pointer& pointer) const;
  int nearest(const Pointer& pointer) const; ///< -1: none is near

  Change Changed;
  Points Curve = straight();
  double Gamma = 1;
  std::vector<double> Bars;
  int Held = -1;
};
}

#endif
