// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorBar.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stipple
{
namespace
{
constexpr double MostOverMean = 8; ///< densities beyond have the colour of this
constexpr int Steps = 64;          ///< of the bar
}

Pixel divergingColor(double share)
{
  // ColorBrewer's RdBu, turned around.
  static const double stops[7][3] = { { 33, 102, 172 }, { 103, 169, 207 }, { 209, 229, 240 },
    { 247, 247, 247 }, { 253, 219, 199 }, { 239, 138, 98 }, { 178, 24, 43 } };
  const double place = (share > 0 ? std::min(share, 1.) : 0.) * 6; // NaN is the lower end
  const int stop = std::min(5, static_cast<int>(place));
  const double t = place - stop;
  Pixel pixel;
  for (int k = 0; k < 3; ++k)
  {
    pixel[k] = static_cast<unsigned char>((1 - t) * stops[stop][k] + t * stops[stop + 1][k]);
  }
  return pixel;
}

double densityShare(double ratio)
{
  return ratio > 0 ? std::clamp(0.5 + 0.5 * std::log(ratio) / std::log(MostOverMean), 0., 1.) : 0;
}

ColorBar densityBar()
{
  return { divergingColor,
    { { densityShare(0.125), "1/8" }, { densityShare(0.5), "1/2" }, { densityShare(1), "1" },
      { densityShare(2), "2" }, { densityShare(8), "8" } },
    "samples per area, times the mean" };
}

void paintColorBar(Canvas& canvas, const Rect& view, const ColorBar& bar, const Covered& covered)
{
  const float s = canvas.scale();
  const float width = std::min(220 * s, view.w - 40 * s);
  const TextLook look{ 11, shades::Word };
  const std::string title = canvas.fitted(bar.title, view.w - 40 * s, look);
  const float w = std::max(width, canvas.textWidth(title, look)) + 24 * s;
  const float h = 54 * s;
  const float left = view.x + 8 * s;
  const float right = view.right() - 8 * s - w;
  const float low = view.y + 6 * s;
  const float high = view.top() - 6 * s - h;
  const Rect corners[] = { { left, low, w, h }, { right, low, w, h }, { left, high, w, h },
    { right, high, w, h } };
  const Rect& ground = covered
    ? *std::min_element(std::begin(corners), std::end(corners),
        [&](const Rect& a, const Rect& b) { return covered(a) < covered(b); })
    : corners[0];
  const Rect place{ ground.x + 12 * s, ground.y + 22 * s, width, 10 * s };
  canvas.fill(ground, { 255, 255, 255 });
  canvas.text(place.x, place.top() + 11 * s, title, look);
  for (int i = 0; i < Steps; ++i)
  {
    const Pixel pixel = bar.color((i + 0.5) / Steps);
    const float x = std::round(place.x + width * static_cast<float>(i) / Steps);
    const float end = std::round(place.x + width * static_cast<float>(i + 1) / Steps);
    canvas.fill({ x, place.y, end - x, place.h }, { pixel[0], pixel[1], pixel[2] });
  }
  for (const auto& [share, number] : bar.ticks)
  {
    const float x = place.x + width * static_cast<float>(share);
    canvas.rule(x, place.y - 4 * s, x, place.y, shades::Quiet);
    canvas.text(x, place.y - 12 * s, number, { 10.5F, shades::Word, Align::Center });
  }
}
}
