// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Charts to pixels on the CPU (paper, section 2.3): first the face of every pixel, then any map by
// the barycentric coordinates of the pixel's centre in that face. The OpenGL pass follows the same
// rules.
//
// The coverage rule, shared by both back ends:
// - A chart point becomes a float device coordinate in [-1, 1] (deviceCoordinate), then a float
// window
//   coordinate, then a fixed-point one with 8 fractional bits, as graphics hardware has it.
// - A triangle owns a pixel whose centre is inside, or on an edge by the top-left rule, so that the
//   triangles of a chart, which tile its rectangle, own every pixel once.
// - Where rounding folds triangles over, the smaller one in space wins, then the lower index.
// - Pixels that nobody owns (the charts of others may have gaps) go to the nearest triangle.
#ifndef stipple_MapRasterizer_h
#define stipple_MapRasterizer_h

#include "Geometry.h"
#include "Progress.h"
#include "StippleFiltersMapsModule.h"

#include <array>
#include <vector>

namespace stipple
{
/// A chart as the rasterisers see it.
struct MapChart
{
  Vec2 extent = Vec2::Ones();                ///< width and height of the rectangle
  std::vector<Vec2> uv;                      ///< per point
  std::vector<std::array<int, 3>> triangles; ///< of points
  std::vector<float> area;                   ///< per triangle, in space; the smaller wins a pixel

  int numberOfTriangles() const { return static_cast<int>(this->triangles.size()); }
};

/// How a map comes from the values.
enum class MapKind
{
  Constant,   ///< one tuple a triangle
  Linear,     ///< one tuple a point, interpolated
  UnitVector, ///< as Linear, then normalised
  /// Values are pairs (H, R) a point, R half the difference of the principal curvatures; both are
  /// interpolated, and 2 (H^2 + R^2) is the sum of the principal curvatures' squares.
  TotalCurvature
};

/// One map to make.
struct MapRequest
{
  MapKind kind = MapKind::Linear;
  int components = 1;             ///< of the map, 1 to 4
  const double* values = nullptr; ///< tuples by triangle or by point; pairs for TotalCurvature
  float* output = nullptr;        ///< width x height tuples, row by row from the lower left

  int valueComponents() const
  {
    return this->kind == MapKind::TotalCurvature ? 2 : this->components;
  }
};

/// The device coordinate of a chart point, the float that both back ends start from.
inline std::array<float, 2> deviceCoordinate(const MapChart& chart, const Vec2& uv)
{
  return { static_cast<float>(2. * uv.x() / chart.extent.x() - 1.),
    static_cast<float>(2. * uv.y() / chart.extent.y() - 1.) };
}

/// Barycentric coordinates over a triangle as a function of a pixel's index: those of corners 1 and
/// 2 are gradient . (pixel centre - corner 0), in pixel units. A degenerate triangle yields its
/// corner 0.
struct PixelBarycentrics
{
  Vec2 corner;    ///< corner 0, in pixels
  Vec2 gradient1; ///< per pixel
  Vec2 gradient2;

  PixelBarycentrics(const MapChart& chart, int triangle, int width, int height);
};

/// The triangle of every pixel (width x height, row by row from the lower left), -1 where none owns
/// it.
STIPPLEFILTERSMAPS_EXPORT void rasterizeFaces(
  const MapChart& chart, int width, int height, int* faces);

/// Gives every pixel without a face (-1) its nearest triangle; returns how many there were. Leaves
/// the image alone if the chart has no triangle.
STIPPLEFILTERSMAPS_EXPORT int fillUncoveredPixels(
  const MapChart& chart, int width, int height, int* faces);

/// Makes the maps from the faces. Every face is valid.
STIPPLEFILTERSMAPS_EXPORT Status rasterizeMaps(const MapChart& chart, int width, int height,
  const int* faces, const std::vector<MapRequest>& requests, const Progress& progress = {});
} // namespace stipple

#endif
