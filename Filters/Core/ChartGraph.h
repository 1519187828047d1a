// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Backbones and their samples seen in the parameter planes: one planar straight-line graph a chart.
#ifndef stipple_ChartGraph_h
#define stipple_ChartGraph_h

#include "AtlasSurface.h"
#include "FeatureGraph.h"
#include "SampleSet.h"
#include "StippleFiltersCoreModule.h"

namespace stipple
{
/// Where a backbone runs on the cut surface. Side 0 is its left (the halfedges along it), side 1
/// its right.
struct STIPPLEFILTERSCORE_EXPORT BackboneTrace
{
  std::vector<double> arcLength; ///< at every point; for a closed backbone also at its end
  std::array<std::vector<int>, 2> halfedge;  ///< by side and segment; empty where there is no
                                             ///< surface
  std::array<int, 2> chart = { { -1, -1 } }; ///< by side
  bool insideChart = false;                  ///< both sides are the same curve inside one chart

  double length() const { return this->arcLength.back(); }
  bool hasSide(int side) const
  {
    return this->chart[side] >= 0 && !(side == 1 && this->insideChart);
  }
  struct Place
  {
    int segment;
    double t; ///< in [0, 1] along the segment
  };
  Place locate(double s) const;
  /// Face and barycentric coordinates of a place, on a side that exists.
  int face(const Place& place, int side) const { return this->halfedge[side][place.segment] / 3; }
  Vec3 bary(const Place& place, int side) const;
  Vec2 parameter(const AtlasSurface& surface, const Place& place, int side) const;
};

/// Traces all backbones; an error if one does not run along the edges of the surface, of which
/// `first` is TriangleSurface::vertexHalfedges().
STIPPLEFILTERSCORE_EXPORT Status traceBackbones(const AtlasSurface& surface,
  const ElementArray<Vertex, Halfedge>& first, const FeatureGraph& graph,
  std::vector<BackboneTrace>& traces);

/// The samples of a chart that lie on backbones, and the segments between neighbours.
struct ChartGraph
{
  struct Vertex
  {
    int sample;
    Vec2 uv;
  };
  struct Segment
  {
    int first;  ///< vertex
    int second; ///< vertex
    int backbone;
    int interval; ///< between sample interval - 1 and sample interval of the backbone's own samples
    bool onBoundary;
  };
  std::vector<Vertex> vertices;
  std::vector<Segment> segments;
  std::vector<int> boundary; ///< vertices around the chart, counterclockwise
};

/// The samples of every backbone by arc length (kind Backbone only, not its end nodes).
STIPPLEFILTERSCORE_EXPORT std::vector<std::vector<int>> samplesByBackbone(
  const FeatureGraph& graph, const std::vector<Sample>& samples);

/// One graph a chart. A seam sample becomes one vertex on each side, also when both sides are the
/// same chart.
STIPPLEFILTERSCORE_EXPORT std::vector<ChartGraph> buildChartGraphs(const AtlasSurface& surface,
  const FeatureGraph& graph, const std::vector<BackboneTrace>& traces,
  const std::vector<Sample>& samples);
}

#endif
