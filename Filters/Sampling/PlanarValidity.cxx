// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PlanarValidity.h"

#include "SamplingConstants.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

/// Sine of the angle by which p lies to the left of the segment (a, b), seen from its nearer end.
double angleFrom(const Vec2& a, const Vec2& b, const Vec2& p)
{
  const double reach = std::min((p - a).norm(), (p - b).norm()) * (b - a).norm();
  return reach > 0 ? orient2(a, b, p) / reach : 0.;
}

/// Buckets of items by the cells that their boxes touch.
class BoxGrid
{
public:
  BoxGrid(const Vec2& extent, std::size_t items)
    : Side(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(items))), 1, 512))
    , Scale(this->Side / extent.x(), this->Side / extent.y())
    , Cells(static_cast<std::size_t>(this->Side) * this->Side)
  {
  }
  void insert(int item, const Vec2& low, const Vec2& high)
  {
    this->each(low, high, [&](std::vector<int>& cell) {
      cell.push_back(item);
      return true;
    });
  }
  /// Calls f for the items near a box, some of them repeatedly, until it returns false.
  template <typename F>
  void visit(const Vec2& low, const Vec2& high, F f)
  {
    this->each(low, high,
      [&](const std::vector<int>& cell) { return std::all_of(cell.begin(), cell.end(), f); });
  }

private:
  template <typename F>
  void each(const Vec2& low, const Vec2& high, F f)
  {
    const auto cell = [this](double x, double scale) {
      return std::clamp(static_cast<int>(x * scale), 0, this->Side - 1);
    };
    for (int y = cell(low.y(), this->Scale.y()); y <= cell(high.y(), this->Scale.y()); ++y)
    {
      for (int x = cell(low.x(), this->Scale.x()); x <= cell(high.x(), this->Scale.x()); ++x)
      {
        if (!f(this->Cells[static_cast<std::size_t>(y) * this->Side + x]))
        {
          return;
        }
      }
    }
  }
  int Side;
  Vec2 Scale;
  std::vector<std::vector<int>> Cells;
};

/// The checks of one chart.
class ChartCheck
{
public:
  ChartCheck(const SamplingDomain& domain, const BackbonePlaces& places, const ChartGraph& graph,
    int chart, std::vector<BackboneInterval>& bad)
    : Domain(domain)
    , Places(places)
    , Graph(graph)
    , Chart(chart)
    , Tolerance(domain.tolerance(chart))
    , Bad(bad)
    , BoundaryPlace(graph.vertices.size(), -1)
  {
    for (std::size_t i = 0; i < graph.boundary.size(); ++i)
    {
      this->BoundaryPlace[graph.boundary[i]] = static_cast<int>(i);
    }
  }

  void run()
  {
    if (!this->boundaryHasArea())
    {
      this->refineLongestBoundaryInterval();
      return;
    }
    if (const Line line = this->line(); this->isAllOn(line))
    {
      this->refineIntervalOff(line);
      return;
    }
    for (std::size_t v = 0; v < this->Graph.vertices.size(); ++v)
    {
      if (this->BoundaryPlace[v] < 0)
      {
        this->Inner.push_back(this->Graph.vertices[v].uv);
        this->InnerVertex.push_back(static_cast<int>(v));
      }
    }
    for (const Vec2& p : this->Domain.chartConstraints[this->Chart])
    {
      this->Inner.push_back(p);
      this->InnerVertex.push_back(-1);
    }
    for (std::size_t i = 0; i < this->Graph.segments.size(); ++i)
    {
      if (this->Graph.segments[i].onBoundary)
      {
        this->checkChord(this->Graph.segments[i]);
      }
      else
      {
        this->Segment.push_back(static_cast<int>(i));
      }
    }
    this->checkDiagonals();
    this->checkPockets();
  }

private:
  const Vec2& uv(int vertex) const { return this->Graph.vertices[vertex].uv; }

  std::array<double, 2> ends(const ChartGraph::Segment& s) const
  {
    return this->Domain.interval(this->Places, s.backbone, s.interval);
  }
  double length(const ChartGraph::Segment& s) const
  {
    const auto [begin, end] = this->ends(s);
    return end - begin;
  }
  void refine(const ChartGraph::Segment& s) { this->Bad.push_back({ s.backbone, s.interval }); }

  bool boundaryHasArea() const
  {
    const std::vector<int>& loop = this->Graph.boundary;
    double area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      area += cross2(this->uv(loop[i]), this->uv(loop[(i + 1) % loop.size()]));
    }
    const Vec2& extent = this->Domain.surface().extent[this->Chart];
    return loop.size() >= 3 && area > 1e-9 * extent.x() * extent.y();
  }

  void refineLongestBoundaryInterval()
  {
    const ChartGraph::Segment* longest = nullptr;
    for (const ChartGraph::Segment& s : this->Graph.segments)
    {
      if (s.onBoundary && (!longest || this->length(s) > this->length(*longest)))
      {
        longest = &s;
      }
    }
    if (longest)
    {
      this->refine(*longest);
    }
  }

  /// Where a segment begins or ends, or between, on the surface.
  Vec3 position(const ChartGraph::Segment& s, double share) const
  {
    const auto [begin, end] = this->ends(s);
    const double at = begin + share * (end - begin);
    const double length = this->Domain.traces()[s.backbone].length();
    const SurfacePlace place =
      this->Domain.atlas->placeOfBackbone(s.backbone, at > length ? at - length : at);
    return this->Domain.surface().position(place.face, place.bary);
  }

  /// From one sample to that farthest from it, in space.
  struct Line
  {
    Vec3 first = Vec3::Zero();
    Vec3 along = Vec3::Zero();

    double distance(const Vec3& p) const
    {
      return this->along.squaredNorm() > 0
        ? (p - this->first).cross(this->along).norm() / this->along.norm()
        : (p - this->first).norm();
    }
    /// What is farther is off the line.
    double least() const { return Constants::LeastHeight * this->along.norm(); }
  };
  Line line() const
  {
    Line result;
    result.first = this->position(this->Graph.segments.front(), 0.);
    for (const ChartGraph::Segment& s : this->Graph.segments)
    {
      for (const double end : { 0., 1. })
      {
        const Vec3 to = this->position(s, end) - result.first;
        result.along = to.squaredNorm() > result.along.squaredNorm() ? to : result.along;
      }
    }
    return result;
  }

  /// Whether all that the chart's triangles would join lies on one line in space, as the four ends
  /// of a letter U do: the parameter plane does not tell.
  bool isAllOn(const Line& line) const
  {
    return this->Domain.chartConstraints[this->Chart].empty() &&
      std::all_of(this->Graph.segments.begin(), this->Graph.segments.end(),
        [&](const ChartGraph::Segment& s) {
          return line.distance(this->position(s, 0.)) <= line.least() &&
            line.distance(this->position(s, 1.)) <= line.least();
        });
  }

  void refineIntervalOff(const Line& line)
  {
    const ChartGraph::Segment* farthest = nullptr;
    double largest = 0;
    for (const ChartGraph::Segment& s : this->Graph.segments)
    {
      for (const double share : { 0.25, 0.5, 0.75 })
      {
        const double distance = s.onBoundary ? line.distance(this->position(s, share)) : 0.;
        if (distance > line.least() && distance > largest)
        {
          farthest = &s;
          largest = distance;
        }
      }
    }
    if (farthest)
    {
      this->refine(*farthest);
    }
  }

  /// Bit k is set if p lies on side k of the rectangle.
  int sides(const Vec2& p) const
  {
    const Vec2& extent = this->Domain.surface().extent[this->Chart];
    const double t = this->Tolerance;
    return (p.x() <= t ? 1 : 0) | (p.x() >= extent.x() - t ? 2 : 0) | (p.y() <= t ? 4 : 0) |
      (p.y() >= extent.y() - t ? 8 : 0);
  }

  /// A boundary segment that cuts a corner off the rectangle must not cut off a feature or a
  /// constraint.
  void checkChord(const ChartGraph::Segment& s)
  {
    if ((this->sides(this->uv(s.first)) & this->sides(this->uv(s.second))) != 0)
    {
      return;
    }
    const int n = static_cast<int>(this->Graph.boundary.size());
    const bool along = (this->BoundaryPlace[s.first] + 1) % n == this->BoundaryPlace[s.second];
    const Vec2& a = this->uv(along ? s.first : s.second);
    const Vec2& b = this->uv(along ? s.second : s.first);
    for (const Vec2& p : this->Inner)
    {
      if (angleFrom(a, b, p) <= Constants::LeastAngle)
      {
        this->refine(s);
        return;
      }
    }
  }

  /// A feature segment between two boundary samples must not run along the polygon.
  void checkDiagonals()
  {
    const int n = static_cast<int>(this->Graph.boundary.size());
    for (int i : this->Segment)
    {
      const ChartGraph::Segment& s = this->Graph.segments[i];
      const int p = this->BoundaryPlace[s.first];
      const int q = this->BoundaryPlace[s.second];
      if (p >= 0 && q >= 0 &&
        ((p + 1) % n == q || (q + 1) % n == p ||
          (this->sides(this->uv(s.first)) & this->sides(this->uv(s.second))) != 0))
      {
        this->refine(s);
      }
    }
  }

  /// The curve that a segment stands for, in this chart, from sample to sample.
  std::vector<Vec2> curve(const ChartGraph::Segment& s) const
  {
    const BackboneTrace& trace = this->Domain.traces()[s.backbone];
    const int side = trace.chart[0] == this->Chart ? 0 : 1;
    const auto [begin, end] = this->ends(s);
    const double length = trace.length();
    const auto wrap = [length](double x) { return x >= length ? x - length : x; };
    std::vector<Vec2> result = { trace.parameter(
      this->Domain.surface(), trace.locate(wrap(begin)), side) };
    const int n = static_cast<int>(trace.arcLength.size()) - 1;
    int i = trace.locate(wrap(begin)).segment + 1;
    for (double lap = begin >= length ? length : 0; lap <= length; lap += length, i = 0)
    {
      for (; i < n && trace.arcLength[i] + lap < end; ++i)
      {
        result.push_back(trace.parameter(this->Domain.surface(), { i, 0. }, side));
      }
      if (end <= length + lap)
      {
        break;
      }
    }
    result.push_back(trace.parameter(
      this->Domain.surface(), trace.locate(end > length ? end - length : end), side));
    return result;
  }

  /// Nothing may lie between a segment and its curve, or on the segment. No two segments cross then
  /// either: the closed curves that two of them form with their own backbones cross an even number
  /// of times, the backbones themselves never do; so where the segments cross, an end of one lies
  /// within the other's.
  void checkPockets()
  {
    if (this->Segment.empty() || this->Inner.empty())
    {
      return;
    }
    BoxGrid grid(this->Domain.surface().extent[this->Chart], this->Inner.size());
    for (std::size_t k = 0; k < this->Inner.size(); ++k)
    {
      grid.insert(static_cast<int>(k), this->Inner[k], this->Inner[k]);
    }
    for (int i : this->Segment)
    {
      const ChartGraph::Segment& s = this->Graph.segments[i];
      const std::vector<Vec2> loop = this->curve(s); // closed by the segment itself
      Vec2 low = loop.front();
      Vec2 high = low;
      for (const Vec2& p : loop)
      {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      const Vec2 margin(this->Tolerance, this->Tolerance);
      grid.visit(low - margin, high + margin, [&](int k) {
        const int v = this->InnerVertex[k];
        if (v == s.first || v == s.second || !this->inPocket(loop, this->Inner[k]))
        {
          return true;
        }
        this->refine(s);
        return false;
      });
    }
  }

  bool inPocket(const std::vector<Vec2>& loop, const Vec2& p) const
  {
    const Vec2& a = loop.front();
    const Vec2& b = loop.back();
    // On the segment: within its length, and at no angle.
    if ((p - a).dot(b - a) >= 0 && (p - b).dot(a - b) >= 0 &&
      std::abs(angleFrom(a, b, p)) <= Constants::LeastAngle)
    {
      return true;
    }
    bool inside = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
    {
      if ((loop[i].y() > p.y()) != (loop[j].y() > p.y()) &&
        p.x() < loop[i].x() +
            (loop[j].x() - loop[i].x()) * (p.y() - loop[i].y()) / (loop[j].y() - loop[i].y()))
      {
        inside = !inside;
      }
    }
    return inside;
  }

  const SamplingDomain& Domain;
  const BackbonePlaces& Places;
  const ChartGraph& Graph;
  const int Chart;
  const double Tolerance;
  std::vector<BackboneInterval>& Bad;
  std::vector<int> BoundaryPlace; // by vertex, -1 inside
  std::vector<int> Segment;       // those inside the chart
  std::vector<Vec2> Inner;        // vertices and constraints inside the chart
  std::vector<int> InnerVertex;
};

/// Intervals with the same two ends: only few samples between nodes can bring that about.
void checkDoubleEdges(
  const SamplingDomain& domain, const BackbonePlaces& places, std::vector<BackboneInterval>& bad)
{
  struct Direct
  {
    int first;
    int second;
    double length;
    int backbone;
  };
  std::vector<Direct> direct;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const int b = static_cast<int>(i);
    const Backbone& backbone = domain.graph().backbones[i];
    const std::size_t inside = places[i].size();
    const int p = backbone.points.front();
    const int q = backbone.points.back();
    if ((backbone.closed || p == q) && inside < (backbone.closed ? 3u : 2u))
    {
      bad.push_back({ b, 0 });
    }
    else if (!backbone.closed && inside == 0)
    {
      direct.push_back({ std::min(p, q), std::max(p, q), domain.traces()[i].length(), b });
    }
  }
  std::sort(direct.begin(), direct.end(), [](const Direct& a, const Direct& b) {
    return std::tie(a.first, a.second, a.length, a.backbone) <
      std::tie(b.first, b.second, b.length, b.backbone);
  });
  for (std::size_t i = 1; i < direct.size(); ++i)
  {
    if (direct[i].first == direct[i - 1].first && direct[i].second == direct[i - 1].second)
    {
      bad.push_back({ direct[i].backbone, 0 });
    }
  }
}
}

std::vector<BackboneInterval> invalidIntervals(
  const SamplingDomain& domain, const BackbonePlaces& places, const std::vector<ChartGraph>& graphs)
{
  std::vector<BackboneInterval> bad;
  checkDoubleEdges(domain, places, bad);
  std::vector<std::vector<BackboneInterval>> badInChart(graphs.size());
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(graphs.size()), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType c = begin; c < end; ++c)
      {
        ChartCheck(domain, places, graphs[c], static_cast<int>(c), badInChart[c]).run();
      }
    });
  for (const std::vector<BackboneInterval>& list : badInChart)
  {
    bad.insert(bad.end(), list.begin(), list.end());
  }
  std::sort(bad.begin(), bad.end());
  bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
  return bad;
}

Status makeValid(const SamplingDomain& domain, BackbonePlaces places, ValidPlaces& valid)
{
  for (int round = 0; round < 24; ++round) // intervals halve: finer than any surface's detail
  {
    valid.samples = domain.samples(places);
    valid.graphs =
      buildChartGraphs(domain.surface(), domain.graph(), domain.traces(), valid.samples);
    const std::vector<BackboneInterval> bad = invalidIntervals(domain, places, valid.graphs);
    if (bad.empty())
    {
      valid.places = std::move(places);
      valid.leastInterior.assign(valid.graphs.size(), 0);
      for (std::size_t c = 0; c < valid.graphs.size(); ++c)
      {
        const ChartGraph& graph = valid.graphs[c];
        valid.leastInterior[c] = graph.boundary.size() <= 3 &&
            graph.vertices.size() == graph.boundary.size() && domain.chartConstraints[c].empty() &&
            domain.surface().chartBegin[c + 1] > domain.surface().chartBegin[c]
          ? 1
          : 0;
      }
      return Status::success();
    }
    if (bad.size() > 1000000)
    {
      break;
    }
    BackbonePlaces refined = places;
    for (const BackboneInterval& i : bad)
    {
      const auto [begin, end] = domain.interval(places, i.backbone, i.interval);
      const double length = domain.traces()[i.backbone].length();
      if (end - begin <= 1e-9 * length)
      {
        return Status::error("Backbone " + std::to_string(i.backbone) + " near surface point " +
          std::to_string(
            domain.graph()
              .backbones[i.backbone]
              .points[domain.traces()[i.backbone].locate(std::min(begin, length)).segment]) +
          " touches another one or a constraint in the chart's parameter plane: move the "
          "constraint, or "
          "repair the charts.");
      }
      const double middle = 0.5 * (begin + end);
      refined[i.backbone].push_back(middle >= length ? middle - length : middle);
    }
    for (std::size_t i = 0; i < bad.size(); ++i) // by backbone
    {
      if (i == 0 || bad[i].backbone != bad[i - 1].backbone)
      {
        std::vector<double>& of = refined[bad[i].backbone];
        std::sort(of.begin(), of.end());
      }
    }
    places = std::move(refined);
  }
  return Status::internal(
    "The backbones do not become a planar graph in their charts' parameter planes: "
    "lower the number of features, or cut the surface into more charts.");
}
}
