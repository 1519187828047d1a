// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CurveEditor.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
constexpr double LeastGap = 0.01; // between neighbours, in x

double valueAt(const CurveEditor::Points& curve, double x)
{
  if (x <= curve.front()[0])
  {
    return curve.front()[1];
  }
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    if (x <= curve[i][0])
    {
      const double t = (x - curve[i - 1][0]) / (curve[i][0] - curve[i - 1][0]);
      return curve[i - 1][1] + t * (curve[i][1] - curve[i - 1][1]);
    }
  }
  return curve.back()[1];
}
}

CurveEditor::CurveEditor(Change change)
  : Changed(std::move(change))
{
}

void CurveEditor::setPoints(const Points& points)
{
  this->Curve = points.empty() ? straight() : points;
}

Rect CurveEditor::plot() const
{
  const float margin = 0.045F * this->Box.h;
  return { this->Box.x + margin, this->Box.y + 3.4F * margin, this->Box.w - 2 * margin,
    this->Box.h - 4.4F * margin };
}

std::pair<float, float> CurveEditor::placeOf(const std::array<double, 2>& point) const
{
  const Rect p = this->plot();
  return { p.x + p.w * static_cast<float>(point[0]), p.y + p.h * static_cast<float>(point[1]) };
}

std::array<double, 2> CurveEditor::pointAt(const Pointer& pointer) const
{
  const Rect p = this->plot();
  return { std::clamp<double>((pointer.x - p.x) / p.w, 0, 1),
    std::clamp<double>((pointer.y - p.y) / p.h, 0, 1) };
}

int CurveEditor::nearest(const Pointer& pointer) const
{
  int best = -1;
  float bestDistance = 0.07F * this->Box.h;
  for (std::size_t i = 0; i < this->Curve.size(); ++i)
  {
    const auto place = this->placeOf(this->Curve[i]);
    const float distance = std::hypot(place.first - pointer.x, place.second - pointer.y);
    if (distance < bestDistance)
    {
      best = static_cast<int>(i);
      bestDistance = distance;
    }
  }
  return best;
}

void CurveEditor::paint(Canvas& canvas)
{
  const float s = canvas.scale();
  const Rect p = this->plot();
  canvas.box({ p.x - 1, p.y - 1, p.w + 2, p.h + 2 }, shades::Card, shades::Line, 0);
  const double most =
    this->Bars.empty() ? 0 : *std::max_element(this->Bars.begin(), this->Bars.end());
  const float width = p.w / static_cast<float>(std::max<std::size_t>(1, this->Bars.size()));
  for (std::size_t i = 0; most > 0 && i < this->Bars.size(); ++i)
  {
    // By the square root: most of a surface is flat, and the rest must be seen too.
    const float height = p.h * static_cast<float>(std::sqrt(this->Bars[i] / most));
    canvas.fill({ p.x + static_cast<float>(i) * width, p.y, std::max(1.F, width - 1), height },
      { 214, 220, 229 });
  }
  std::vector<std::pair<float, float>> line;
  if (this->Gamma != 1)
  {
    constexpr int Steps = 60;
    for (int i = 0; i <= Steps; ++i)
    {
      const double x = static_cast<double>(i) / Steps;
      line.push_back(
        this->placeOf({ x, std::pow(std::clamp(valueAt(this->Curve, x), 0., 1.), this->Gamma) }));
    }
    canvas.polyline(line, { 219, 138, 36 }, 1.5F);
    line.clear();
  }
  line.push_back(this->placeOf({ 0, valueAt(this->Curve, 0) }));
  for (const auto& point : this->Curve)
  {
    line.push_back(this->placeOf(point));
  }
  line.push_back(this->placeOf({ 1, valueAt(this->Curve, 1) }));
  canvas.polyline(line, shades::Accent, 2);
  for (std::size_t i = 0; i < this->Curve.size(); ++i)
  {
    const auto place = this->placeOf(this->Curve[i]);
    canvas.disc(place.first, place.second, 5,
      static_cast<int>(i) == this->Held ? shades::AccentSoft : shades::Card, shades::Accent);
  }
  const float y = this->Box.y + 3 * s;
  canvas.text(p.x, y, "flat", { 10.5F, shades::Quiet });
  canvas.text(p.x + 0.5F * p.w, y, "importance", { 10.5F, shades::Quiet, Align::Center });
  canvas.text(p.right(), y, "most", { 10.5F, shades::Quiet, Align::Right });
}

bool CurveEditor::press(const Pointer& pointer)
{
  int point = this->nearest(pointer);
  if (pointer.secondary)
  {
    if (point >= 0 && this->Curve.size() > 2)
    {
      this->Curve.erase(this->Curve.begin() + point);
      this->Changed(this->Curve, true);
    }
    return false;
  }
  if (point < 0)
  {
    const auto added = this->pointAt(pointer);
    const auto place = std::lower_bound(this->Curve.begin(), this->Curve.end(), added);
    point = static_cast<int>(place - this->Curve.begin());
    this->Curve.insert(place, added);
  }
  this->Held = point;
  this->drag(pointer);
  return true;
}

void CurveEditor::drag(const Pointer& pointer)
{
  if (this->Held < 0)
  {
    return;
  }
  auto moved = this->pointAt(pointer);
  const int last = static_cast<int>(this->Curve.size()) - 1;
  const double low = this->Held > 0 ? this->Curve[this->Held - 1][0] + LeastGap : 0;
  const double high = this->Held < last ? this->Curve[this->Held + 1][0] - LeastGap : 1;
  moved[0] = low <= high ? std::clamp(moved[0], low, high) : 0.5 * (low + high);
  if (moved != this->Curve[this->Held])
  {
    this->Curve[this->Held] = moved;
    this->Changed(this->Curve, false);
  }
}

void CurveEditor::release(const Pointer&)
{
  this->Held = -1;
  this->Changed(this->Curve, true);
}
}
