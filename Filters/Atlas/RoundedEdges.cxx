// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RoundedEdges.h"

#include "ParallelFor.h"
#include "SurfaceSection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <set>

namespace stipple
{
namespace
{
double sumUpTo(const std::vector<Turn>& turns, double distance)
{
  double sum = 0;
  for (const Turn& t : turns)
  {
    sum += t.distance <= distance ? t.angle : 0.;
  }
  return sum;
}

double variationBetween(const std::vector<Turn>& turns, double from, double to)
{
  double sum = 0;
  for (const Turn& t : turns)
  {
    sum += t.distance > from && t.distance <= to ? std::abs(t.angle) : 0.;
  }
  return sum;
}

/// How the surface turns on both sides of an edge, as far as the widest band reaches.
class Profile
{
public:
  Profile(const CutSurface& surface, const FaceNormals& normals, Halfedge edge,
    const RoundedEdgeOptions& options)
    : Options(options)
    , Angle(options.angle * Pi / 180)
    , Across(surface, normals, edge, SurfaceSection::Ends::AtFeatures)
    , Own(this->Across.ownTurn())
    , Left(this->Across, edge)
    , Right(this->Across, surface.twin[edge])
  {
  }

  bool isInMiddle()
  {
    double width = this->Options.width;
    for (int k = 0; k < Halvings; ++k, width /= 2)
    {
      this->follow(width / 2);
      const double whole = std::abs(this->turnUpTo(width / 2));
      if (whole < this->Angle)
      {
        continue;
      }
      this->follow(width);
      const double beside = variationBetween(this->Left.turns(), width / 2, width) +
        variationBetween(this->Right.turns(), width / 2, width);
      if (beside <= this->Options.flank * whole)
      {
        // Of a band that is as wide as this, edges beside the middle do not see all. In narrower
        // ones they would seem to be in the middle, too.
        return this->isHalfWay(width);
      }
    }
    return false;
  }

  double width()
  {
    this->follow(this->Options.width);
    std::vector<Turn> both = this->Left.turns();
    for (const Turn& t : this->Right.turns())
    {
      both.push_back({ t.distance, -t.angle });
    }
    std::sort(both.begin(), both.end(),
      [](const Turn& a, const Turn& b) { return a.distance < b.distance; });
    double sum = this->Own;
    if (std::abs(sum) >= this->Angle)
    {
      return 0.;
    }
    for (const Turn& t : both)
    {
      sum += t.angle;
      if (std::abs(sum) >= this->Angle)
      {
        return 2 * t.distance;
      }
    }
    return std::numeric_limits<double>::infinity();
  }

private:
  static constexpr int Halvings = 6;
  static constexpr double Rounding = 1e-6;

  void follow(double reach)
  {
    this->Left.follow(this->Across, reach);
    this->Right.follow(this->Across, reach);
  }
  /// Between the ends of a band that reaches so far to both sides. The right half is followed the
  /// other way.
  double turnUpTo(double reach) const
  {
    return this->Own + sumUpTo(this->Left.turns(), reach) - sumUpTo(this->Right.turns(), reach);
  }

  /// Of two edges beside the very middle one is.
  bool isHalfWay(double reach) const
  {
    const double l = sumUpTo(this->Left.turns(), reach);
    const double r = -sumUpTo(this->Right.turns(), reach);
    const double whole = this->Own + l + r;
    const double sign = whole < 0 ? -1. : 1.;
    return sign * l <= (0.5 + Rounding) * sign * whole &&
      sign * r < (0.5 - Rounding) * sign * whole;
  }

  const RoundedEdgeOptions& Options;
  const double Angle;
  const SurfaceSection Across;
  const double Own;
  SurfaceSection::Walk Left;
  SurfaceSection::Walk Right;
};

/// Edges as a graph, grown without cycles that are short.
class Lines
{
public:
  Lines(const CutSurface& surface, const FaceNormals& normals, std::vector<Halfedge> found,
    const RoundedEdgeOptions& options)
    : Surface(surface)
    , Options(options)
    , First(surface.vertexHalfedges())
    , At(surface.points.size())
  {
    std::stable_sort(found.begin(), found.end(),
      [&](Halfedge a, Halfedge b) { return surface.edgeLength(a) > surface.edgeLength(b); });
    for (const Halfedge h : found)
    {
      // Finite: cycles that are looked for are.
      this->add(h, std::min(options.width, Profile(surface, normals, h, options).width()));
    }
  }

  void join()
  {
    for (const Vertex v : this->Surface.vertices())
    {
      if (this->At[v.index()].size() == 1)
      {
        this->joinFrom(v);
      }
    }
  }

  void dropSpurs()
  {
    for (const Vertex v : this->Surface.vertices())
    {
      std::vector<Step> spur;
      double length = 0;
      Vertex at = v;
      while (this->At[at.index()].size() == 1 + (spur.empty() ? 0U : 1U))
      {
        const std::vector<Step>& steps = this->At[at.index()];
        const Step& next =
          spur.empty() || steps[0].to != this->tailOf(spur.back()) ? steps[0] : steps[1];
        spur.push_back(next);
        length += this->Surface.edgeLength(next.halfedge);
        at = next.to;
        if (length > this->longestSpur(next.width))
        {
          break;
        }
      }
      if (!spur.empty() && this->At[at.index()].size() > 2 &&
        length <= this->longestSpur(spur.back().width))
      {
        for (const Step& step : spur)
        {
          this->remove(step.halfedge);
        }
      }
    }
  }

  /// What hangs together, if it is long enough.
  std::vector<Halfedge> lines() const
  {
    std::vector<Halfedge> result;
    std::vector<char> isSeen(this->At.size(), 0);
    for (const Vertex start : this->Surface.vertices())
    {
      if (isSeen[start.index()] != 0 || this->At[start.index()].empty())
      {
        continue;
      }
      std::vector<Vertex> queue = { start };
      isSeen[start.index()] = 1;
      std::vector<Halfedge> edges;
      double length = 0;
      double area = 0;
      for (std::size_t i = 0; i < queue.size(); ++i)
      {
        for (const Step& step : this->At[queue[i].index()])
        {
          if (step.halfedge < this->Surface.twin[step.halfedge])
          {
            edges.push_back(step.halfedge);
            const double l = this->Surface.edgeLength(step.halfedge);
            length += l;
            area += l * step.width;
          }
          if (isSeen[step.to.index()] == 0)
          {
            isSeen[step.to.index()] = 1;
            queue.push_back(step.to);
          }
        }
      }
      if (length >= this->Options.minimumLength && length * length > WidthsOfLine * area)
      {
        result.insert(result.end(), edges.begin(), edges.end());
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  /// A line is so many times as long as it is wide.
  static constexpr double WidthsOfLine = 4;

  struct Step
  {
    Halfedge halfedge;
    Vertex to;
    double width;
  };
  /// As a priority_queue has the nearest first.
  struct Reached
  {
    double length;
    Vertex vertex;
    Halfedge by;
    bool operator<(const Reached& o) const
    {
      return this->length != o.length ? this->length > o.length : o.vertex < this->vertex;
    }
  };
  double longestSpur(double width) const
  {
    return std::max(WidthsOfLine * width, this->Options.shortestBranch);
  }
  Vertex tailOf(const Step& step) const { return this->Surface.tail(step.halfedge); }

  void add(Halfedge h, double width)
  {
    const Vertex a = this->Surface.tail(h);
    const Vertex b = this->Surface.head(h);
    // The cycle that it closes is longer than a band's ends are apart.
    if (this->near(a, WidthsOfLine * width, b).count(b) > 0)
    {
      return;
    }
    this->At[a.index()].push_back({ h, b, width });
    this->At[b.index()].push_back({ this->Surface.twin[h], a, width });
  }
  void remove(Halfedge h)
  {
    for (const Halfedge side : { h, this->Surface.twin[h] })
    {
      std::vector<Step>& steps = this->At[this->Surface.tail(side).index()];
      steps.erase(std::find_if(
        steps.begin(), steps.end(), [&](const Step& s) { return s.halfedge == side; }));
    }
  }

  /// The vertices that lines lead to on paths that are no longer, the nearest first, until `last`
  /// is among them.
  std::set<Vertex> near(Vertex from, double reach, Vertex last = Vertex()) const
  {
    std::set<Vertex> reached;
    std::priority_queue<Reached> queue;
    queue.push({ 0., from, Halfedge() });
    while (!queue.empty())
    {
      const Reached now = queue.top();
      queue.pop();
      if (!reached.insert(now.vertex).second)
      {
        continue;
      }
      if (now.vertex == last)
      {
        break;
      }
      for (const Step& step : this->At[now.vertex.index()])
      {
        const double length = now.length + this->Surface.edgeLength(step.halfedge);
        if (length <= reach && reached.count(step.to) == 0)
        {
          queue.push({ length, step.to, step.halfedge });
        }
      }
    }
    return reached;
  }

  /// From where a line ends, along edges, to the nearest vertex of another, or its own other end.
  void joinFrom(Vertex end)
  {
    const Step last = this->At[end.index()].front();
    const std::set<Vertex> own = this->near(end, WidthsOfLine * last.width);
    std::priority_queue<Reached> queue;
    std::map<Vertex, Halfedge> reachedBy;
    queue.push({ 0., end, Halfedge() });
    while (!queue.empty())
    {
      const Reached now = queue.top();
      queue.pop();
      if (!reachedBy.emplace(now.vertex, now.by).second)
      {
        continue;
      }
      if (!this->At[now.vertex.index()].empty() && own.count(now.vertex) == 0)
      {
        for (Halfedge h = now.by; h.valid(); h = reachedBy.at(this->Surface.tail(h)))
        {
          this->add(h, last.width);
        }
        return;
      }
      this->forEachHalfedge(now.vertex, [&](Halfedge h) {
        const double length = now.length + this->Surface.edgeLength(h);
        if (length <= last.width && !this->Surface.isFeature(h) && !this->Surface.isBoundary(h))
        {
          queue.push({ length, this->Surface.head(h), h });
        }
      });
    }
  }
  template <typename Visit>
  void forEachHalfedge(Vertex v, const Visit& visit) const
  {
    const Halfedge first = this->First[v];
    for (Halfedge h = first; h.valid();)
    {
      visit(h);
      const Halfedge in = previousHalfedge(h);
      h = this->Surface.twin[in];
      if (h == first)
      {
        return;
      }
    }
  }

  const CutSurface& Surface;
  const RoundedEdgeOptions& Options;
  const ElementArray<Vertex, Halfedge> First;
  std::vector<std::vector<Step>> At; ///< by vertex
};
}

void measureRoundedEdges(
  const CutSurface& surface, const RoundedEdgeOptions& options, FeatureGraph& graph)
{
  struct Measured
  {
    double width;
    double length;
  };
  FaceNormals normals; // few surfaces need them
  const ElementArray<Vertex, Halfedge> first = surface.vertexHalfedges();
  std::vector<std::vector<Measured>> edges(graph.backbones.size());
  std::map<int, std::vector<std::size_t>> ending; // backbones, by the points at their ends
  for (std::size_t b = 0; b < graph.backbones.size(); ++b)
  {
    const Backbone& backbone = graph.backbones[b];
    for (int i = 0; backbone.type == BackboneType::Sharp && i < backbone.numberOfSegments(); ++i)
    {
      const Halfedge h =
        findHalfedge(surface, first, Vertex(backbone.points[i]), Vertex(backbone.segmentEnd(i)));
      if (!surface.isRounded(h))
      {
        break;
      }
      if (normals.size() == 0)
      {
        normals = faceNormalsOf(surface);
      }
      edges[b].push_back({ Profile(surface, normals, h, options).width(), surface.edgeLength(h) });
    }
    if (!edges[b].empty())
    {
      ending[backbone.points.front()].push_back(b);
      ending[backbone.points.back()].push_back(b);
    }
  }
  std::vector<char> isSeen(edges.size(), 0);
  for (std::size_t start = 0; start < edges.size(); ++start)
  {
    if (edges[start].empty() || isSeen[start] != 0)
    {
      continue;
    }
    std::vector<std::size_t> line = { start };
    isSeen[start] = 1;
    std::vector<Measured> all;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const Backbone& backbone = graph.backbones[line[i]];
      all.insert(all.end(), edges[line[i]].begin(), edges[line[i]].end());
      for (const int end : { backbone.points.front(), backbone.points.back() })
      {
        for (const std::size_t next : ending.at(end))
        {
          if (isSeen[next] == 0)
          {
            isSeen[next] = 1;
            line.push_back(next);
          }
        }
      }
    }
    std::sort(all.begin(), all.end(),
      [](const Measured& a, const Measured& b) { return a.width < b.width; });
    double whole = 0;
    for (const Measured& m : all)
    {
      whole += m.length;
    }
    std::size_t middle = 0;
    for (double sum = all[0].length; sum < 0.5 * whole && middle + 1 < all.size();)
    {
      sum += all[++middle].length;
    }
    for (const std::size_t b : line)
    {
      graph.backbones[b].width = all[middle].width;
    }
  }
}

std::vector<Halfedge> findRoundedEdges(const CutSurface& surface, const RoundedEdgeOptions& options)
{
  const FaceNormals normals = faceNormalsOf(surface);
  ElementArray<Halfedge, char> isFound(surface.twin.size(), 0);
  // Where the surface is curved less than half as much as it is in such a band on the average,
  // there is no middle of one.
  const double leastCurvature = 0.5 * options.angle * Pi / 180 / options.width;
  parallelFor(surface.halfedges(), [&](Halfedge h) {
    const Halfedge t = surface.twin[h];
    if (!(t > h) || surface.isFeature(h))
    {
      return;
    }
    const Vec3& a = normals[faceOf(h)];
    const Vec3& b = normals[faceOf(t)];
    const double across =
      (surface.faceArea(faceOf(h)) + surface.faceArea(faceOf(t))) / surface.edgeLength(h);
    if (std::atan2(a.cross(b).norm(), a.dot(b)) >= leastCurvature * across)
    {
      isFound[h] = Profile(surface, normals, h, options).isInMiddle() ? 1 : 0;
    }
  });
  std::vector<Halfedge> found;
  for (const Halfedge h : surface.halfedges())
  {
    if (isFound[h] != 0)
    {
      found.push_back(h);
    }
  }
  if (found.empty())
  {
    return found;
  }
  Lines lines(surface, normals, std::move(found), options);
  lines.join();
  lines.dropSpurs();
  return lines.lines();
}
}
