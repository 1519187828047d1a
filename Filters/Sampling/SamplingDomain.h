// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What sampling needs to know about the charts and their backbones, whatever the control map says.
#ifndef stipple_SamplingDomain_h
#define stipple_SamplingDomain_h

#include "ChartGraph.h"
#include "StippleFiltersSamplingModule.h"

#include <array>
#include <vector>

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// Arc lengths of the samples inside every backbone, ascending.
using BackbonePlaces = std::vector<std::vector<double>>;

/// Squared length on the surface of a step (du, dv): E du^2 + 2 F du dv + G dv^2.
struct FirstFundamentalForm
{
  float E = 1;
  float F = 0;
  float G = 1;

  Vec2 times(const Vec2& d) const
  {
    return { this->E * d.x() + this->F * d.y(), this->F * d.x() + this->G * d.y() };
  }
  double dot(const Vec2& a, const Vec2& b) const { return this->times(a).dot(b); }
  double squared(const Vec2& d) const { return this->dot(d, d); }
};

struct STIPPLEFILTERSSAMPLING_EXPORT SamplingDomain
{
  AtlasSurface surface;
  FeatureGraph graph;
  std::vector<BackboneTrace> traces;
  std::vector<char> onBackbone;             ///< by halfedge of the surface
  std::vector<FirstFundamentalForm> metric; ///< by face, of its chart's map
  /// Nodes of the graph and constraints that lie on no backbone, in this order.
  std::vector<Sample> fixedSamples;
  /// Constraints on a backbone become samples of that backbone; those in a chart are listed by
  /// chart.
  BackbonePlaces fixedPlaces;
  std::vector<std::vector<Vec2>> chartConstraints;

  int numberOfCharts() const { return this->surface.numberOfCharts(); }
  /// Distances in a chart's parameter plane below this one are nothing.
  double tolerance(int chart) const { return 1e-10 * this->surface.extent[chart].maxCoeff(); }
  /// Arc lengths at which interval i of a backbone begins and ends; the last may exceed the length
  /// of a closed one. Interval i lies between samples i - 1 and i.
  std::array<double, 2> interval(const BackbonePlaces& places, int backbone, int i) const;
  /// A sample of kind Backbone at an arc length.
  Sample backboneSample(int backbone, double arcLength) const;
  /// The fixed samples, and then those on the backbones.
  std::vector<Sample> samples(const BackbonePlaces& places) const;
};

/// Reads charts and feature graph; says what is wrong with them.
STIPPLEFILTERSSAMPLING_EXPORT Status readSamplingDomain(
  vtkPartitionedDataSetCollection* charts, vtkPolyData* lines, SamplingDomain& domain);
}

#endif
