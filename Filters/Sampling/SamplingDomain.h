// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What sampling needs to know about the charts and their backbones, whatever the control map says.
#ifndef stipple_SamplingDomain_h
#define stipple_SamplingDomain_h

#include "Atlas.h"
#include "StippleFiltersSamplingModule.h"

#include <array>
#include <vector>

namespace stipple
{
/// Arc lengths of the samples inside every backbone, ascending.
using BackbonePlaces = std::vector<std::vector<double>>;

struct STIPPLEFILTERSSAMPLING_EXPORT SamplingDomain
{
  Atlas::Pointer atlas;
  std::vector<char> onBackbone; ///< by halfedge of the surface
  /// A backbone as one of the charts beside it sees it.
  struct BackboneSide
  {
    int backbone;
    int side;
  };
  std::vector<std::vector<BackboneSide>> chartSides; ///< by chart, in the backbones' order
  /// Nodes of the graph and constraints that lie on no backbone, in this order.
  std::vector<Sample> fixedSamples;
  /// Constraints on a backbone become samples of that backbone; those in a chart are listed by
  /// chart.
  BackbonePlaces fixedPlaces;
  std::vector<std::vector<Vec2>> chartConstraints;

  const AtlasSurface& surface() const { return this->atlas->surface(); }
  const FeatureGraph& graph() const { return this->atlas->graph(); }
  const std::vector<BackboneTrace>& traces() const { return this->atlas->traces(); }
  const FirstFundamentalForm& metric(int face) const { return this->atlas->metric()[Face(face)]; }
  int numberOfCharts() const { return this->surface().numberOfCharts(); }
  /// Distances in a chart's parameter plane below this one are nothing.
  double tolerance(int chart) const
  {
    return 1e-10 * this->surface().extent[Chart(chart)].maxCoeff();
  }
  /// Arc lengths at which interval i of a backbone begins and ends; the last may exceed the length
  /// of a closed one. Interval i lies between samples i - 1 and i.
  std::array<double, 2> interval(const BackbonePlaces& places, int backbone, int i) const;
  /// A sample of kind Backbone at an arc length.
  Sample backboneSample(int backbone, double arcLength) const;
  /// The fixed samples, and then those on the backbones.
  std::vector<Sample> samples(const BackbonePlaces& places) const;
};

/// Says what is wrong with charts and feature graph.
STIPPLEFILTERSSAMPLING_EXPORT Status readSamplingDomain(
  const Atlas::Pointer& atlas, SamplingDomain& domain);
}

#endif
