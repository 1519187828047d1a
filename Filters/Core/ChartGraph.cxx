// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartGraph.h"

#include <algorithm>
#include <unordered_map>

namespace stipple
{
BackboneTrace::Place BackboneTrace::locate(double s) const
{
  const auto next = std::upper_bound(this->arcLength.begin() + 1, this->arcLength.end() - 1, s);
  const int segment = static_cast<int>(next - this->arcLength.begin()) - 1;
  const double a = this->arcLength[segment];
  const double b = this->arcLength[segment + 1];
  return { segment, b > a ? std::clamp((s - a) / (b - a), 0., 1.) : 0. };
}

Vec3 BackboneTrace::bary(const Place& place, int side) const
{
  const int h = this->halfedge[side][place.segment];
  const double atTail = side == 0 ? 1. - place.t : place.t;
  Vec3 result = Vec3::Zero();
  result[h % 3] = atTail;
  result[nextHalfedge(h) % 3] = 1. - atTail;
  return result;
}

Vec2 BackboneTrace::parameter(const AtlasSurface& surface, const Place& place, int side) const
{
  return surface.parameter(this->face(place, side), this->bary(place, side));
}

Status traceBackbones(const AtlasSurface& surface, const ElementArray<Vertex, Halfedge>& first,
  const FeatureGraph& graph, std::vector<BackboneTrace>& traces)
{
  const int numberOfPoints = static_cast<int>(surface.points.size());
  traces.assign(graph.backbones.size(), {});
  for (std::size_t b = 0; b < graph.backbones.size(); ++b)
  {
    const Backbone& backbone = graph.backbones[b];
    BackboneTrace& trace = traces[b];
    trace.arcLength.push_back(0);
    std::array<bool, 2> present = { { true, true } };
    for (int i = 0; i < backbone.numberOfSegments(); ++i)
    {
      const int p = backbone.points[i];
      const int q = backbone.segmentEnd(i);
      std::array<int, 2> h = { { -1, -1 } };
      if (p < numberOfPoints && q < numberOfPoints)
      {
        h[0] = findHalfedge(surface, first, Vertex(p), Vertex(q)).index();
        h[1] = findHalfedge(surface, first, Vertex(q), Vertex(p)).index();
      }
      if (h[0] < 0 && h[1] < 0)
      {
        return Status::error("Backbone " + std::to_string(b) + " runs from surface point " +
          std::to_string(p) + " to " + std::to_string(q) +
          ", which is no edge of these charts: pass charts and feature graph of the same "
          "vtkConformalAtlas.");
      }
      trace.arcLength.push_back(
        trace.arcLength.back() + (surface.points[q] - surface.points[p]).norm());
      for (int side = 0; side < 2; ++side)
      {
        trace.halfedge[side].push_back(h[side]);
        present[side] = present[side] && h[side] >= 0;
      }
    }
    for (int side = 0; side < 2; ++side)
    {
      if (present[side] && !trace.halfedge[side].empty())
      {
        trace.chart[side] = surface.faceChart[trace.halfedge[side][0] / 3];
      }
    }
    if (trace.chart[0] >= 0 && trace.chart[0] == trace.chart[1])
    {
      const int l = trace.halfedge[0][0];
      const int r = trace.halfedge[1][0];
      const auto chartPoint = [&](int h) { return surface.chartPoints[h / 3][h % 3]; };
      trace.insideChart = chartPoint(l) == chartPoint(nextHalfedge(r)) &&
        chartPoint(nextHalfedge(l)) == chartPoint(r);
    }
  }
  return Status::success();
}

std::vector<std::vector<int>> samplesByBackbone(
  const FeatureGraph& graph, const std::vector<Sample>& samples)
{
  std::vector<std::vector<int>> result(graph.backbones.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (samples[i].kind == SampleKind::Backbone)
    {
      result[samples[i].backbone].push_back(static_cast<int>(i));
    }
  }
  for (std::vector<int>& list : result)
  {
    std::stable_sort(list.begin(), list.end(),
      [&](int a, int b) { return samples[a].arcLength < samples[b].arcLength; });
  }
  return result;
}

std::vector<ChartGraph> buildChartGraphs(const AtlasSurface& surface, const FeatureGraph& graph,
  const std::vector<BackboneTrace>& traces, const std::vector<Sample>& samples)
{
  std::vector<ChartGraph> charts(surface.numberOfCharts());
  std::unordered_map<int, int> nodeSample;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (samples[i].kind == SampleKind::Corner)
    {
      nodeSample[samples[i].surfacePoint] = static_cast<int>(i);
    }
  }
  const std::vector<std::vector<int>> onBackbone = samplesByBackbone(graph, samples);
  std::vector<std::unordered_map<int, int>> vertexOfChartPoint(charts.size());
  std::vector<std::vector<std::array<int, 2>>> boundaryLink(charts.size());

  for (std::size_t b = 0; b < graph.backbones.size(); ++b)
  {
    const Backbone& backbone = graph.backbones[b];
    const BackboneTrace& trace = traces[b];
    for (int side = 0; side < 2; ++side)
    {
      if (!trace.hasSide(side))
      {
        continue;
      }
      const int c = trace.chart[side];
      ChartGraph& chart = charts[c];
      std::vector<int> chain;
      // End nodes are shared with other backbones of the chart: one vertex a chart point.
      const auto addNode = [&](int point, const BackboneTrace::Place& place) {
        const auto found = nodeSample.find(point);
        if (found == nodeSample.end())
        {
          return;
        }
        const int h = trace.halfedge[side][place.segment];
        const bool atTail = (place.t < 0.5) == (side == 0);
        const int corner = atTail ? h : nextHalfedge(h);
        auto [slot, fresh] = vertexOfChartPoint[c].try_emplace(
          surface.chartPoints[corner / 3][corner % 3], static_cast<int>(chart.vertices.size()));
        if (fresh)
        {
          chart.vertices.push_back({ found->second, surface.uv[corner] });
        }
        chain.push_back(slot->second);
      };
      if (!backbone.closed)
      {
        addNode(backbone.points.front(), { 0, 0. });
      }
      for (int s : onBackbone[b])
      {
        chain.push_back(static_cast<int>(chart.vertices.size()));
        chart.vertices.push_back(
          { s, trace.parameter(surface, trace.locate(samples[s].arcLength), side) });
      }
      if (!backbone.closed)
      {
        addNode(backbone.points.back(), { backbone.numberOfSegments() - 1, 1. });
      }
      const bool onBoundary = !trace.insideChart;
      const int n = static_cast<int>(chain.size());
      for (int i = 0; i + 1 < n + (backbone.closed ? 1 : 0); ++i)
      {
        const int from = chain[i];
        const int to = chain[(i + 1) % n];
        const int interval = backbone.closed ? (i + 1) % n : i;
        chart.segments.push_back({ from, to, static_cast<int>(b), interval, onBoundary });
        if (onBoundary)
        {
          boundaryLink[c].push_back(
            side == 0 ? std::array<int, 2>{ from, to } : std::array<int, 2>{ to, from });
        }
      }
    }
  }
  for (std::size_t c = 0; c < charts.size(); ++c)
  {
    // The chart lies to the left of its boundary links, which form one cycle.
    std::vector<int> next(charts[c].vertices.size(), -1);
    for (const auto& link : boundaryLink[c])
    {
      next[link[0]] = link[1];
    }
    if (boundaryLink[c].empty())
    {
      continue;
    }
    const int start = boundaryLink[c].front()[0];
    int v = start;
    do
    {
      charts[c].boundary.push_back(v);
      v = next[v];
    } while (v >= 0 && v != start && charts[c].boundary.size() <= next.size());
  }
  return charts;
}
}
