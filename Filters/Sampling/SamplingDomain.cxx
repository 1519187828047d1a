// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SamplingDomain.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace stipple
{
namespace
{
/// A segment of a backbone by the surface point that it begins at, if the backbone changes there
/// between a chart's inside and its border, or from chart to chart: there must be a node. Else -1.
int segmentThatLacksNode(const SamplingDomain& domain, std::size_t b)
{
  const AtlasSurface& s = domain.surface();
  const BackboneTrace& trace = domain.traces()[b];
  const auto chartPoint = [&](int h) { return s.chartPoints[h / 3][h % 3]; };
  for (std::size_t i = 0; i + 1 < trace.arcLength.size(); ++i)
  {
    const int l = trace.halfedge[0][i];
    const int r = trace.halfedge[1][i];
    const bool inside = l >= 0 && r >= 0 && s.faceChart[l / 3] == s.faceChart[r / 3] &&
      chartPoint(l) == chartPoint(nextHalfedge(r)) && chartPoint(nextHalfedge(l)) == chartPoint(r);
    const int left = l >= 0 ? s.faceChart[l / 3] : -1;
    const int right = r >= 0 ? s.faceChart[r / 3] : -1;
    if (inside != trace.insideChart || left != trace.chart[0] || right != trace.chart[1])
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

/// Sorts constraints into nodes (nothing to do), places on backbones, and places inside charts.
class ConstraintSorter
{
public:
  explicit ConstraintSorter(SamplingDomain& domain)
    : Domain(domain)
    , Node(domain.graph().nodes())
  {
    for (std::size_t b = 0; b < domain.traces().size(); ++b)
    {
      const BackboneTrace& trace = domain.traces()[b];
      for (int side = 0; side < 2; ++side)
      {
        for (std::size_t i = 0; i < trace.halfedge[side].size(); ++i)
        {
          this->Segment[trace.halfedge[side][i]] = { static_cast<int>(b), static_cast<int>(i),
            side };
        }
      }
      const Backbone& backbone = domain.graph().backbones[b];
      for (std::size_t i = 0; i < backbone.points.size(); ++i)
      {
        this->Point[backbone.points[i]] = { static_cast<int>(b), trace.arcLength[i] };
      }
    }
  }

  void add(int face, Vec3 bary)
  {
    const AtlasSurface& s = this->Domain.surface();
    bary = clampedBarycentric(bary.unaryExpr([](double x) { return x < 1e-9 ? 0. : x; }));
    for (int k = 0; k < 3; ++k)
    {
      const int point = s.triangles[face][k];
      if (bary[k] == 1.)
      {
        if (std::binary_search(this->Node.begin(), this->Node.end(), point))
        {
          return;
        }
        const auto found = this->Point.find(point);
        if (found != this->Point.end())
        {
          this->addPlace(found->second.first, found->second.second);
          return;
        }
      }
      else if (bary[(k + 2) % 3] == 0.)
      {
        const auto found = this->Segment.find(3 * face + k);
        if (found != this->Segment.end())
        {
          const auto& [b, i, side] = found->second;
          const std::vector<double>& arc = this->Domain.traces()[b].arcLength;
          const double t = side == 0 ? bary[(k + 1) % 3] : bary[k];
          this->addPlace(b, arc[i] + t * (arc[i + 1] - arc[i]));
          return;
        }
      }
    }
    const int chart = s.faceChart[face];
    const Vec2 uv = s.parameter(face, bary);
    for (const Vec2& other : this->Domain.chartConstraints[chart])
    {
      if ((other - uv).norm() <= this->Domain.tolerance(chart))
      {
        return;
      }
    }
    Sample sample;
    sample.kind = SampleKind::Constraint;
    sample.face = face;
    sample.bary = bary;
    this->Domain.fixedSamples.push_back(sample);
    this->Domain.chartConstraints[chart].push_back(uv);
  }

private:
  void addPlace(int backbone, double s)
  {
    const BackboneTrace& trace = this->Domain.traces()[backbone];
    const double near = 1e-9 * trace.length();
    const bool closed = this->Domain.graph().backbones[backbone].closed;
    std::vector<double>& places = this->Domain.fixedPlaces[backbone];
    if (closed && s >= trace.length() - near)
    {
      s = 0;
    }
    if (!closed && (s <= near || s >= trace.length() - near))
    {
      return; // a node
    }
    const auto at = std::lower_bound(places.begin(), places.end(), s - near);
    if (at == places.end() || *at > s + near)
    {
      places.insert(at, s);
    }
  }

  struct BackboneSegment
  {
    int backbone;
    int segment;
    int side;
  };
  SamplingDomain& Domain;
  std::vector<int> Node;
  std::unordered_map<int, BackboneSegment> Segment;      // by halfedge
  std::unordered_map<int, std::pair<int, double>> Point; // by surface point
};
}

std::array<double, 2> SamplingDomain::interval(
  const BackbonePlaces& places, int backbone, int i) const
{
  const std::vector<double>& p = places[backbone];
  const double length = this->traces()[backbone].length();
  const int n = static_cast<int>(p.size());
  if (this->graph().backbones[backbone].closed)
  {
    if (n == 0)
    {
      return { { 0., length } };
    }
    return i == 0 ? std::array<double, 2>{ { p.back(), p.front() + length } }
                  : std::array<double, 2>{ { p[i - 1], p[i] } };
  }
  return { { i == 0 ? 0. : p[i - 1], i == n ? length : p[i] } };
}

Sample SamplingDomain::backboneSample(int backbone, double arcLength) const
{
  const BackboneTrace& trace = this->traces()[backbone];
  const BackboneTrace::Place place = trace.locate(arcLength);
  const int side = trace.chart[0] >= 0 ? 0 : 1;
  Sample sample;
  sample.kind = SampleKind::Backbone;
  sample.face = trace.face(place, side);
  sample.bary = trace.bary(place, side);
  sample.backbone = backbone;
  sample.arcLength = arcLength;
  return sample;
}

std::vector<Sample> SamplingDomain::samples(const BackbonePlaces& places) const
{
  std::vector<Sample> result = this->fixedSamples;
  for (std::size_t b = 0; b < places.size(); ++b)
  {
    for (double s : places[b])
    {
      result.push_back(this->backboneSample(static_cast<int>(b), s));
    }
  }
  return result;
}

Status readSamplingDomain(const Atlas::Pointer& atlas, SamplingDomain& domain)
{
  domain = {};
  domain.atlas = atlas;
  const AtlasSurface& s = domain.surface();
  for (std::size_t b = 0; b < domain.traces().size(); ++b)
  {
    if (const int i = segmentThatLacksNode(domain, b); i >= 0)
    {
      return Status::error("Backbone " + std::to_string(b) + " has no node at surface point " +
        std::to_string(domain.graph().backbones[b].points[i]) +
        ", where it passes from one chart, or from a chart's border, to another: pass the feature "
        "graph of "
        "the vtkConformalAtlas that made the charts.");
    }
  }
  domain.onBackbone.assign(s.twin.size(), 0);
  domain.chartSides.resize(s.numberOfCharts());
  for (std::size_t b = 0; b < domain.traces().size(); ++b)
  {
    const BackboneTrace& trace = domain.traces()[b];
    for (int side = 0; side < 2; ++side)
    {
      for (int h : trace.halfedge[side])
      {
        if (h >= 0)
        {
          domain.onBackbone[h] = 1;
        }
      }
      if (trace.hasSide(side))
      {
        domain.chartSides[trace.chart[side]].push_back({ static_cast<int>(b), side });
      }
    }
  }
  for (int c = 0; c < s.numberOfCharts(); ++c)
  {
    const auto& sides = domain.chartSides[c];
    const bool isBounded = std::any_of(sides.begin(), sides.end(),
      [&](const auto& side) { return !domain.traces()[side.backbone].insideChart; });
    if (!isBounded && s.chartBegin[c + 1] > s.chartBegin[c])
    {
      return Status::error("The feature graph has no backbone along the boundary of chart " +
        std::to_string(c) + ": pass output port 1 of the vtkConformalAtlas that made the charts.");
    }
  }
  const ElementArray<Vertex, Halfedge>& first = domain.atlas->vertexHalfedges();
  for (int node : domain.graph().nodes())
  {
    Sample sample;
    sample.kind = SampleKind::Corner;
    const Halfedge h = first[Vertex(node)];
    sample.face = faceOf(h).index();
    sample.bary[cornerOf(h)] = 1.;
    sample.surfacePoint = node;
    domain.fixedSamples.push_back(sample);
  }
  domain.fixedPlaces.resize(domain.graph().backbones.size());
  domain.chartConstraints.resize(s.numberOfCharts());
  ConstraintSorter sorter(domain);
  for (std::size_t i = 0; i < domain.graph().constraints.size(); ++i)
  {
    const ConstraintPoint& c = domain.graph().constraints[i];
    sorter.add(s.chartBegin[c.chart] + c.chartCell, c.bary);
  }
  return Status::success();
}
}
