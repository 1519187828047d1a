// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One chart: its samples triangulated in the parameter plane, with the backbones as constraints
// (paper 4.1).
#ifndef stipple_ChartTriangulation_h
#define stipple_ChartTriangulation_h

#include "ChartGraph.h"
#include "ReportingThread.h"
#include "StippleFiltersMeshingModule.h"
#include "TriangleComplex.h"

namespace stipple
{
/// Numbers the pieces of all backbones between neighbouring samples: the labels of constrained
/// halfedges.
struct STIPPLEFILTERSMESHING_EXPORT BackboneIntervals
{
  std::vector<int> begin;                ///< by backbone, and the number of intervals
  std::vector<std::vector<int>> samples; ///< by backbone, ascending by arc length, without its end
                                         ///< nodes

  BackboneIntervals(const FeatureGraph& graph, std::vector<std::vector<int>> samplesByBackbone);
  Label label(int backbone, int interval) const { return Label(this->begin[backbone] + interval); }
  ElementRange<Label> labels() const { return { 0, this->count() }; }
  int backbone(Label label) const;
  int count() const { return this->begin.back(); }
};

/// The triangulation of a chart in its parameter plane.
struct ChartTriangulation
{
  TriangleComplex complex; ///< over the chart's own vertices
  /// By vertex; two vertices may be the same sample where a cut enters the chart.
  std::vector<int> sample;
  std::vector<Vec2> parameter; ///< by vertex
  /// Labels of intervals between which no triangle is left: one edge.
  std::vector<std::array<Label, 2>> merged;

  int numberOfVertices() const { return static_cast<int>(this->sample.size()); }
};

/// What a triangulation is Delaunay by, as far as constraints let it: lengths in the parameter
/// plane, or on the surface, which are others where the chart is squeezed or sheared.
enum class DelaunayMetric
{
  Plane,
  Surface
};

/// Triangulates chart c. Constraints follow the backbones exactly, so that every sample comes out
/// on its side of them, also where the chord between two samples would cut it off; what that needs
/// besides the samples is taken out again. Once `stop` is true, this ends early and leaves nothing
/// of use.
STIPPLEFILTERSMESHING_EXPORT Status triangulateChart(const AtlasSurface& surface, int c,
  const ChartGraph& chartGraph, const std::vector<BackboneTrace>& traces, const FeatureGraph& graph,
  const BackboneIntervals& intervals, const std::vector<Sample>& samples,
  const std::vector<int>& interior, DelaunayMetric metric, ChartTriangulation& mesh,
  const Stop& stop = {});
}

#endif
