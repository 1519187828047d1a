// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How many pixels a chart's maps need: no pixel of a uniform sampling should want more than half a
// sample, or error diffusion cannot place the samples where the chart is densest.
#ifndef stipple_MapSizing_h
#define stipple_MapSizing_h

#include "MapRasterizer.h"

#include <array>
#include <vector>

namespace stipple
{
/// What a chart asks of its map.
struct MapDemand
{
  Vec2 extent = Vec2::Ones(); ///< of the rectangle
  double area = 0.;           ///< in space
  double densityRatio = 1.;   ///< see densityRatio()
  /// The same for larger fractions: 2, 4, 8 ... thousandths, up to half of the surface and more.
  std::vector<double> coarseRatios;

  /// What a chart with so many samples asks for: what holds less than MissedSample of one may be as
  /// dense as it likes.
  double ratioFor(double samples) const;
};
/// A chart of few samples does not feel what is denser than its pixels and wants less than this.
constexpr double MissedSample = 0.05;

constexpr double NegligibleFraction = 0.001;

/// The density (A3D / A2D) that all but a fraction of the chart's surface stays below, over the
/// chart's mean density. At least 1.
STIPPLEFILTERSMAPS_EXPORT double densityRatio(
  const MapChart& chart, double fraction = NegligibleFraction);

STIPPLEFILTERSMAPS_EXPORT MapDemand demandOf(const MapChart& chart);

/// Width and height for a chart that gets this many samples (its share): 2 n r pixels or more, with
/// the rectangle's aspect and sides within [32, 4096]. The longer side is a rung of a ladder of
/// factor sqrt(2), so that the size seldom changes with the number of samples.
STIPPLEFILTERSMAPS_EXPORT std::array<int, 2> automaticMapSize(
  const MapDemand& demand, double samples);

/// The same for all charts that share so many samples by their areas. Together they have at most
/// MostPixels or 32 a sample, whichever is more, or the least that is possible: where maps are so
/// distorted that it would be more, the densest places of the densest charts get fewer.
constexpr double MostPixels = 1 << 26;
STIPPLEFILTERSMAPS_EXPORT std::vector<std::array<int, 2>> automaticMapSizes(
  const std::vector<MapDemand>& demands, double samples);

/// Width and height for a longer side of this many pixels.
STIPPLEFILTERSMAPS_EXPORT std::array<int, 2> fixedMapSize(const Vec2& extent, int longer);
} // namespace stipple

#endif
