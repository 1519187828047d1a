// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FiguresView.h"

#include "SceneActors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace stipple
{
namespace
{
/// Degrees; triangles with less are of no use to most who compute on a mesh.
constexpr double AlarmingAngle = 5;

std::string printed(const char* format, double value)
{
  char text[48];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

/// 100 only where it is all.
std::string share(double percent)
{
  constexpr double MostButAll = 99.9;
  return printed("%.1f %%", percent < 100 ? std::min(percent, MostButAll) : percent);
}

/// Bars over a base line; `labels` are (bar, text) below it.
template <std::size_t N>
void barChart(Canvas& canvas, const Rect& box, const std::string& title,
  const std::array<double, N>& bars, const std::vector<std::pair<float, std::string>>& labels,
  const Shade& shade)
{
  const float s = canvas.scale();
  canvas.text(box.x, box.top() - 7 * s, title, { 11, shades::Quiet });
  const Rect plot{ box.x, box.y + 15 * s, box.w, box.h - 33 * s };
  const double most = *std::max_element(bars.begin(), bars.end());
  const float width = plot.w / static_cast<float>(N);
  for (std::size_t i = 0; most > 0 && i < N; ++i)
  {
    const float height = plot.h * static_cast<float>(bars[i] / most);
    if (bars[i] > 0)
    {
      canvas.fill({ plot.x + (static_cast<float>(i) + 0.1F) * width, plot.y, 0.8F * width,
                    std::max(1.F, height) },
        shade);
    }
  }
  canvas.rule(plot.x, plot.y, plot.right(), plot.y, shades::Faint);
  for (const auto& label : labels)
  {
    canvas.text(plot.x + label.first * width, box.y + 7 * s, label.second,
      { 10.5F, shades::Quiet, Align::Center });
  }
}
}

void FiguresView::setFigures(const MeshFigures& figures)
{
  this->Figures = figures;
  this->Known = true;
}

void FiguresView::paint(Canvas& canvas)
{
  const float s = canvas.scale();
  if (!this->Known)
  {
    canvas.text(this->Box.x, this->Box.top() - 12 * s, "no mesh yet", { 12, shades::Quiet });
    return;
  }
  const Shade words = this->Stale ? shades::Faint : shades::Word;
  const MeshQuality& q = this->Figures.quality;
  const vtkIdType quads = this->Figures.quads;
  std::vector<std::pair<const char*, std::string>> rows = { { "points", grouped(q.numberOfPoints) },
    { quads > 0 ? "quads + tri." : "triangles",
      (quads > 0 ? grouped(quads) + " + " : "") + grouped(q.numberOfTriangles - 2 * quads) },
    { "quality, mean", printed("%.3f", q.averageQ) },
    { "angle, least", printed("%.1f\u00b0", q.minimumAngle) },
    { "angle, mean least", printed("%.1f\u00b0", q.averageMinimumAngle) },
    { "valence 6", share(q.percentValence6) }, { "valence 5 to 7", share(q.percentValence567) } };
  if (this->Figures.lostFeatureEdges > 0)
  {
    rows.emplace_back("lost feature edges", grouped(this->Figures.lostFeatureEdges));
  }
  const float column = 0.52F * this->Box.w;
  const float step = std::min(24 * s, this->Box.h / static_cast<float>(rows.size()));
  float y = this->Box.top() - 0.5F * step;
  for (const auto& row : rows)
  {
    canvas.text(this->Box.x, y, row.first, { 12, this->Stale ? shades::Faint : shades::Quiet });
    const bool alarms =
      !this->Stale && row.first == std::string("angle, least") && q.minimumAngle < AlarmingAngle;
    canvas.text(this->Box.x + column - 8 * s, y, row.second,
      { 12, alarms ? shades::Alarm : words, Align::Right, true });
    y -= step;
  }
  const Shade bars = this->Stale ? shades::Line : shades::Accent;
  const float left = this->Box.x + column + 12 * s;
  const float half = 0.5F * this->Box.h;
  const float width = this->Box.right() - left;
  barChart(canvas, { left, this->Box.y + half, width, half - 4 * s }, "valences",
    this->Figures.valences,
    { { 0.5F, "3" }, { 1.5F, "4" }, { 2.5F, "5" }, { 3.5F, "6" }, { 4.5F, "7" }, { 5.5F, "8" },
      { 6.5F, "9" } },
    bars);
  barChart(canvas, { left, this->Box.y, width, half - 4 * s }, "angles", this->Figures.angles,
    { { 0.6F, "0\u00b0" }, { 6.F, "60\u00b0" }, { 12.F, "120\u00b0" }, { 17.F, "180\u00b0" } },
    bars);
}
}
