// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartTriangulation.h"

#include "ConstrainedDelaunay.h"
#include "SurfaceDelaunay.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stipple
{
namespace
{
/// Parameters closer to a side of the rectangle than this, relative to its size, are on that side.
constexpr double OnSide = 1e-11;

Vec2 snapToSides(Vec2 p, const Vec2& extent)
{
  for (int k = 0; k < 2; ++k)
  {
    if (std::abs(p[k]) <= OnSide)
    {
      p[k] = 0;
    }
    else if (std::abs(p[k] - extent[k]) <= OnSide)
    {
      p[k] = extent[k];
    }
  }
  return p;
}

Vec2 keepOffSides(Vec2 p, const Vec2& extent)
{
  for (int k = 0; k < 2; ++k)
  {
    p[k] = std::clamp(p[k], 2. * OnSide, extent[k] - 2. * OnSide);
  }
  return p;
}

/// The piece of a backbone that a segment of the chart graph stands for.
struct Piece
{
  double from;
  double to;
};

Piece pieceOf(const BackboneTrace& trace, bool closed, const std::vector<int>& onBackbone,
  const std::vector<Sample>& samples, int interval)
{
  const int n = static_cast<int>(onBackbone.size());
  const auto s = [&](int i) { return samples[onBackbone[i]].arcLength; };
  if (closed)
  {
    return interval == 0 ? Piece{ s(n - 1), s(0) + trace.length() }
                         : Piece{ s(interval - 1), s(interval) };
  }
  return { interval == 0 ? 0. : s(interval - 1), interval == n ? trace.length() : s(interval) };
}

/// Backbone vertices strictly inside a piece, where the curve bends in the parameter plane.
std::vector<int> bendsOf(const AtlasSurface& surface, const BackboneTrace& trace, bool closed,
  int side, const Piece& piece)
{
  std::vector<int> bends;
  const int segments = static_cast<int>(trace.arcLength.size()) - 1;
  const double tolerance = 1e-12 * trace.length();
  const auto parameterAt = [&](int segment, double t) {
    return trace.parameter(surface, { segment, t }, side);
  };
  for (int turn = 0; turn < (closed ? 2 : 1); ++turn)
  {
    const double shift = turn * trace.length();
    const auto first = std::upper_bound(
      trace.arcLength.begin(), trace.arcLength.end(), piece.from - shift + tolerance);
    for (auto it = first; it != trace.arcLength.end(); ++it)
    {
      const int j = static_cast<int>(it - trace.arcLength.begin());
      if (*it + shift >= piece.to - tolerance)
      {
        break;
      }
      if (j == segments || (j == 0 && turn == 0)) // the closing point of a cycle comes as point 0
                                                  // of the next turn
      {
        continue;
      }
      const Vec2 before = parameterAt((j + segments - 1) % segments, 0.);
      const Vec2 here = parameterAt(j, 0.);
      const Vec2 after = parameterAt(j, 1.);
      const double bend = std::abs(orient2(before, here, after));
      if (bend > 1e-12 * (here - before).norm() * (after - here).norm())
      {
        bends.push_back(j);
      }
    }
  }
  return bends;
}

double shapeInSpace(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double sum = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return sum > 0 ? 4. * std::sqrt(3.) * triangleArea(a, b, c) / sum : 0.;
}

/// The planar graph that is handed to the triangulation, with the extra vertices at bends.
class ChartProblem
{
public:
  ChartProblem(const AtlasSurface& surface, int c)
    : Surface(surface)
    , Extent(surface.extent[c])
  {
  }
  void build(const ChartGraph& chartGraph, int c, const std::vector<BackboneTrace>& traces,
    const FeatureGraph& graph, const BackboneIntervals& intervals,
    const std::vector<Sample>& samples, const std::vector<int>& interior);
  Status triangulate(int c, DelaunayMetric metric, const Stop& stop, ChartTriangulation& mesh);

private:
  int add(int sample, const Vec2& uv, const Vec3& position)
  {
    this->Sample.push_back(sample);
    this->Parameter.push_back(uv);
    this->Position.push_back(position);
    return static_cast<int>(this->Sample.size()) - 1;
  }
  void removeBends(ChartTriangulation& mesh) const;

  const AtlasSurface& Surface;
  const Vec2 Extent;
  std::vector<int> Sample; // -1 at a bend
  std::vector<Vec2> Parameter;
  std::vector<Vec3> Position;
  std::vector<std::array<int, 2>> Segments;
  std::vector<Label> SegmentLabel;
  int InteriorBegin = 0; // bends and samples on backbones come first
};

void ChartProblem::build(const ChartGraph& chartGraph, int c,
  const std::vector<BackboneTrace>& traces, const FeatureGraph& graph,
  const BackboneIntervals& intervals, const std::vector<stipple::Sample>& samples,
  const std::vector<int>& interior)
{
  std::vector<char> onSide(chartGraph.vertices.size(), 0);
  for (int v : chartGraph.boundary)
  {
    onSide[v] = 1;
  }
  for (std::size_t v = 0; v < chartGraph.vertices.size(); ++v)
  {
    const int s = chartGraph.vertices[v].sample;
    const Vec2& uv = chartGraph.vertices[v].uv;
    this->add(s, onSide[v] ? snapToSides(uv, this->Extent) : uv,
      this->Surface.position(samples[s].face, samples[s].bary));
  }
  for (const ChartGraph::Segment& segment : chartGraph.segments)
  {
    const BackboneTrace& trace = traces[segment.backbone];
    const Backbone& backbone = graph.backbones[segment.backbone];
    const Piece piece = pieceOf(
      trace, backbone.closed, intervals.samples[segment.backbone], samples, segment.interval);
    // A cut inside the chart has two sides in it: take the one that this segment runs along.
    int side = 0;
    double nearest = 1e300;
    for (int s = 0; s < 2; ++s)
    {
      if (trace.hasSide(s) && trace.chart[s] == c)
      {
        const double to = piece.to > trace.length() ? piece.to - trace.length() : piece.to;
        const double distance = (trace.parameter(this->Surface, trace.locate(piece.from), s) -
                                  chartGraph.vertices[segment.first].uv)
                                  .norm() +
          (trace.parameter(this->Surface, trace.locate(to), s) -
            chartGraph.vertices[segment.second].uv)
            .norm();
        if (distance < nearest)
        {
          nearest = distance;
          side = s;
        }
      }
    }
    const Label label = intervals.label(segment.backbone, segment.interval);
    int last = segment.first;
    const auto link = [&](int v) {
      this->Segments.push_back({ { last, v } });
      this->SegmentLabel.push_back(label);
      last = v;
    };
    for (int j : bendsOf(this->Surface, trace, backbone.closed, side, piece))
    {
      const Vec2 uv = trace.parameter(this->Surface, { j, 0. }, side);
      link(this->add(-1, segment.onBoundary ? snapToSides(uv, this->Extent) : uv,
        this->Surface.points[backbone.points[j]]));
    }
    link(segment.second);
  }
  this->InteriorBegin = static_cast<int>(this->Sample.size());
  for (int s : interior)
  {
    const stipple::Sample& sample = samples[s];
    this->add(s, keepOffSides(this->Surface.parameter(sample.face, sample.bary), this->Extent),
      this->Surface.position(sample.face, sample.bary));
  }
}

Status ChartProblem::triangulate(
  int c, DelaunayMetric metric, const Stop& stop, ChartTriangulation& mesh)
{
  using Kind = DelaunayConflict::Kind;
  const std::string chart = "Chart " + std::to_string(c);
  std::vector<Triangle> triangles;
  const int attempts = 100 + static_cast<int>(this->Sample.size());
  for (int attempt = 0;; ++attempt)
  {
    const DelaunayConflict conflict =
      constrainedDelaunay(this->Parameter, this->Segments, triangles, stop);
    if (isAsked(stop))
    {
      return Status::aborted();
    }
    if (conflict.kind == Kind::None)
    {
      break;
    }
    const bool canMove = (conflict.kind == Kind::Duplicate || conflict.kind == Kind::OnSegment) &&
      conflict.first >= this->InteriorBegin;
    if (!canMove || attempt == attempts)
    {
      return Status::tooFewPoints(chart +
        " cannot be triangulated: its backbones carry too few samples, or samples that coincide; "
        "use "
        "more points.");
    }
    // The place on the surface stays; only the triangulation sees the sample a hair's breadth away.
    const double angle = 2.399963 * (attempt + 1);
    const double radius = 4. * OnSide * (1 + attempt % 8);
    Vec2& p = this->Parameter[conflict.first];
    p = keepOffSides(p + radius * Vec2(std::cos(angle), std::sin(angle)), this->Extent);
  }
  if (triangles.empty())
  {
    return Status::tooFewPoints(chart + " has no triangle between its samples; use more points.");
  }
  TriangleComplex& complex = mesh.complex;
  complex.triangles = std::move(triangles);
  complex.twin = halfedgeTwins(complex.triangles);
  complex.label.assign(complex.twin.size(), Label());
  std::map<std::pair<Vertex, Vertex>, Label> labelOf; // of a segment, from the smaller vertex
  std::vector<char> onBackbone(this->Sample.size(), 0);
  for (std::size_t s = 0; s < this->Segments.size(); ++s)
  {
    const auto [a, b] = this->Segments[s];
    labelOf[std::minmax(Vertex(a), Vertex(b))] = this->SegmentLabel[s];
    onBackbone[a] = onBackbone[b] = 1;
  }
  for (Halfedge h : complex.halfedges())
  {
    const Vertex a = complex.tail(h);
    const Vertex b = complex.head(h);
    if (onBackbone[a.index()] && onBackbone[b.index()])
    {
      const auto found = labelOf.find(std::minmax(a, b));
      if (found != labelOf.end())
      {
        complex.label[h] = found->second;
      }
    }
  }
  if (metric == DelaunayMetric::Surface)
  {
    swapToSurfaceDelaunay(this->Surface, Chart(c), this->Parameter, complex, stop);
  }
  this->removeBends(mesh);
  if (!complex.isSound())
  {
    return Status::tooFewPoints(chart +
      " cannot be triangulated: its triangles do not fit together without the bends of its "
      "backbones; use more points.");
  }
  std::vector<char> used(this->Sample.size(), 0);
  for (const Triangle& t : complex.triangles)
  {
    for (int v : t)
    {
      used[v] = 1;
    }
  }
  for (std::size_t v = 0; v < used.size(); ++v)
  {
    if (static_cast<bool>(used[v]) != (this->Sample[v] >= 0))
    {
      return Status::tooFewPoints(
        chart + " cannot be triangulated: its backbones carry too few samples; use more points.");
    }
  }
  mesh.sample = std::move(this->Sample);
  mesh.parameter = std::move(this->Parameter);
  return Status::success();
}

void ChartProblem::removeBends(ChartTriangulation& mesh) const
{
  TriangleComplex& complex = mesh.complex;
  std::vector<Vertex> bends;
  for (int v = 0; v < this->InteriorBegin; ++v)
  {
    if (this->Sample[v] < 0)
    {
      bends.emplace_back(v);
    }
  }
  if (bends.empty())
  {
    return;
  }
  const auto score = [this](Vertex va, Vertex vb, Vertex vc) {
    const int a = va.index();
    const int b = vb.index();
    const int c = vc.index();
    if (this->Sample[a] == this->Sample[c] && this->Sample[a] >= 0)
    {
      return -20.;
    }
    const double plane = orient2(this->Parameter[a], this->Parameter[b], this->Parameter[c]);
    return shapeInSpace(this->Position[a], this->Position[b], this->Position[c]) -
      (plane > 0 ? 0. : 2.);
  };
  ElementArray<Vertex, Halfedge> outgoing(this->Sample.size());
  for (Halfedge h : complex.halfedges())
  {
    outgoing[complex.tail(h)] = h;
  }
  // Now and then a bend can go only after its neighbour has gone.
  for (std::size_t before = bends.size() + 1; !bends.empty() && bends.size() < before;)
  {
    before = bends.size();
    bends.erase(
      std::remove_if(bends.begin(), bends.end(),
        [&](Vertex v) { return complex.removeFromChain(v, outgoing, score, mesh.merged); }),
      bends.end());
  }
  complex.compact();
}
}

BackboneIntervals::BackboneIntervals(
  const FeatureGraph& graph, std::vector<std::vector<int>> samplesByBackbone)
  : begin(1, 0)
  , samples(std::move(samplesByBackbone))
{
  for (std::size_t b = 0; b < graph.backbones.size(); ++b)
  {
    const int n = static_cast<int>(this->samples[b].size());
    this->begin.push_back(this->begin.back() + n + (graph.backbones[b].closed ? 0 : 1));
  }
}

int BackboneIntervals::backbone(Label label) const
{
  const auto behind = std::upper_bound(this->begin.begin(), this->begin.end(), label.index());
  return static_cast<int>(behind - this->begin.begin()) - 1;
}

Status triangulateChart(const AtlasSurface& surface, int c, const ChartGraph& chartGraph,
  const std::vector<BackboneTrace>& traces, const FeatureGraph& graph,
  const BackboneIntervals& intervals, const std::vector<Sample>& samples,
  const std::vector<int>& interior, DelaunayMetric metric, ChartTriangulation& mesh,
  const Stop& stop)
{
  ChartProblem problem(surface, c);
  problem.build(chartGraph, c, traces, graph, intervals, samples, interior);
  return problem.triangulate(c, metric, stop, mesh);
}
}
