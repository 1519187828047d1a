// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One chart's control map as the kernels see it: borrowed pixels and the rectangle that they span.
#ifndef stipple_ControlImage_h
#define stipple_ControlImage_h

#include "Geometry.h"
#include "StippleFiltersSamplingModule.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
/// Pixels (x, y) with xBegin <= x < xEnd and yBegin <= y < yEnd.
struct PixelBox
{
  int xBegin;
  int xEnd;
  int yBegin;
  int yEnd;
};

/// Pixel (i, j) is centred at ((i + .5) extent.x / width, (j + .5) extent.y / height) of the
/// rectangle.
struct STIPPLEFILTERSSAMPLING_EXPORT ControlImage
{
  int width = 0;
  int height = 0;
  Vec2 extent = Vec2::Ones();
  const float* control = nullptr; ///< wanted samples per unit of parameter area, up to a factor
  const float* areaDistortion = nullptr; ///< surface area / parameter area
  const int* faceIndex = nullptr;        ///< triangle of the chart, -1 for none; may be null

  int numberOfPixels() const { return this->width * this->height; }
  double pixelArea() const
  {
    return this->extent.x() * this->extent.y() / this->width / this->height;
  }
  /// The pixel that a parameter lies in; the nearest one for a parameter outside.
  int pixelAt(const Vec2& uv) const
  {
    const int x = static_cast<int>(uv.x() / this->extent.x() * this->width);
    const int y = static_cast<int>(uv.y() / this->extent.y() * this->height);
    return std::clamp(y, 0, this->height - 1) * this->width + std::clamp(x, 0, this->width - 1);
  }
  Vec2 centre(int pixel) const
  {
    const int x = pixel % this->width;
    const int y = pixel / this->width;
    return { (x + 0.5) * this->extent.x() / this->width,
      (y + 0.5) * this->extent.y() / this->height };
  }
  /// The pixels that a triangle of parameters may own, and one more on each side: who owns a pixel
  /// is decided with rounded coordinates.
  PixelBox pixelsAround(const Vec2& a, const Vec2& b, const Vec2& c) const
  {
    const Vec2 toPixel(this->width / this->extent.x(), this->height / this->extent.y());
    const Vec2 low = a.cwiseMin(b).cwiseMin(c).cwiseProduct(toPixel).array() - 1.5;
    const Vec2 high = a.cwiseMax(b).cwiseMax(c).cwiseProduct(toPixel).array() + 0.5;
    return { std::max(0, static_cast<int>(std::ceil(low.x()))),
      std::min(this->width, static_cast<int>(std::floor(high.x())) + 1),
      std::max(0, static_cast<int>(std::ceil(low.y()))),
      std::min(this->height, static_cast<int>(std::floor(high.y())) + 1) };
  }
  /// Wanted samples per unit of surface area, up to the global factor; 0 where nothing is known.
  double density(int pixel) const
  {
    const double c = this->control[pixel];
    const double a = this->areaDistortion[pixel];
    return c > 0 && a > 0 ? c / a : 0.;
  }
};

/// What a chart's control image holds.
struct ControlMass
{
  double total = 0;   ///< integral over the rectangle
  double largest = 0; ///< largest value
};

/// Sums a control image. Negative values and NaN count as zero; an infinite one makes the total
/// infinite.
STIPPLEFILTERSSAMPLING_EXPORT ControlMass controlMass(const ControlImage& image);

/// Calls f(c) for every chart, on all threads.
template <typename F>
void forEachChart(std::size_t charts, F f)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(charts), 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType c = begin; c < end; ++c)
    {
      f(static_cast<std::size_t>(c));
    }
  });
}
}

#endif
