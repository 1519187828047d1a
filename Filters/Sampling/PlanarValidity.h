// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Enough samples on backbones that every chart's straight-line graph is planar and can be
// triangulated.
#ifndef stipple_PlanarValidity_h
#define stipple_PlanarValidity_h

#include "SamplingDomain.h"

namespace stipple
{
struct BackboneInterval
{
  int backbone;
  int interval;
  bool operator<(const BackboneInterval& o) const
  {
    return backbone != o.backbone ? backbone < o.backbone : interval < o.interval;
  }
  bool operator==(const BackboneInterval& o) const
  {
    return backbone == o.backbone && interval == o.interval;
  }
};

/// Intervals that need a sample in their middle, ascending, because
/// - a chart's boundary polygon has fewer than three corners or no area,
/// - all samples of a chart lie on one line in space,
/// - a feature's sample or a constraint does not lie strictly inside it,
/// - two segments cross, touch or overlap other than at a shared end,
/// - a sample or constraint lies between a segment and the curve that it stands for, or on it,
/// - two intervals join the same two samples (no simplicial complex has such edges), or one to
/// itself.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<BackboneInterval> invalidIntervals(
  const SamplingDomain& domain, const BackbonePlaces& places,
  const std::vector<ChartGraph>& graphs);

/// What makeValid() arrives at.
struct ValidPlaces
{
  BackbonePlaces places;
  std::vector<Sample> samples; ///< fixed samples, then those on backbones
  std::vector<ChartGraph> graphs;
  std::vector<int> leastInterior; ///< samples that must lie inside each chart: one if three bound
                                  ///< it
};

/// Adds samples to the middle of invalid intervals until there is none.
STIPPLEFILTERSSAMPLING_EXPORT Status makeValid(
  const SamplingDomain& domain, BackbonePlaces places, ValidPlaces& valid);
}

#endif
