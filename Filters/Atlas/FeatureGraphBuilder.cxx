// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGraphBuilder.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
struct GraphEdge
{
  int a;
  int b;
  BackboneType type;
  bool cut; ///< charts end here, also along a sharp edge
  Keep keep;
  bool isBent;            ///< sharp or boundary: the surface has it, not only its regions
  bool isRounded = false; ///< sharp to a mesh that is coarse; it follows the input's edges
  int other(int p) const { return this->a == p ? this->b : this->a; }
};

std::vector<GraphEdge> graphEdges(const CutSurface& surface)
{
  std::vector<GraphEdge> edges;
  for (const Halfedge h : surface.halfedges())
  {
    const int tail = surface.tail(h).index();
    const int head = surface.head(h).index();
    const Halfedge twin = surface.twin[h];
    if (twin.valid() && twin < h)
    {
      continue;
    }
    if (surface.isBoundary(h))
    {
      edges.push_back({ tail, head, BackboneType::Boundary, true, surface.keep[h], true });
    }
    else if (surface.isFeature(h))
    {
      edges.push_back({ tail, head, BackboneType::Sharp, surface.cut[h] != 0, surface.keep[h],
        surface.sharp[h] != 0 && !surface.isRounded(h), surface.isRounded(h) });
    }
    else if (surface.cut[h] != 0)
    {
      edges.push_back({ tail, head, BackboneType::Seam, true, Keep::Nothing, false });
    }
  }
  return edges;
}

/// Tells how lines of features turn.
class Turns
{
public:
  Turns(const CutSurface& surface, const std::vector<GraphEdge>& edges)
    : Surface(surface)
    , Edges(edges)
    , At(surface.points.size())
  {
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      if (edges[e].type != BackboneType::Seam)
      {
        this->At[edges[e].a].push_back(static_cast<int>(e));
        this->At[edges[e].b].push_back(static_cast<int>(e));
      }
    }
  }

  const std::vector<int>& at(int p) const { return this->At[p]; }

  /// Of a point between two edges: whether the line turns there by more than the angle with this
  /// cosine. Borders of regions and rounded creases go to and fro with the input's edges where
  /// these run across them: only what several edges tell is a turn.
  bool isCorner(int p, double cosine) const
  {
    const GraphEdge& first = this->Edges[this->At[p][0]];
    const GraphEdge& second = this->Edges[this->At[p][1]];
    if (first.type != second.type)
    {
      return true;
    }
    if (std::max(first.keep, second.keep) == Keep::Edges)
    {
      const bool isOriginal = p < this->Surface.numberOfOriginalPoints;
      if (this->Surface.isFixedPoint.empty() ? isOriginal
                                             : isOriginal && this->Surface.isFixedPoint[p] != 0)
      {
        return true;
      }
      if (first.keep == second.keep && !this->Surface.isFixedPoint.empty())
      {
        return false;
      }
    }
    if (!this->turns(p, first.other(p), second.other(p), cosine))
    {
      return false;
    }
    const bool isFlat = !first.isBent && !second.isBent;
    for (int step = 1; isFlat && step <= StepsOfBorder; ++step)
    {
      if (!this->turns(p, this->pointAfter(p, 0, step), this->pointAfter(p, 1, step), cosine))
      {
        return false;
      }
    }
    return true;
  }

private:
  static constexpr int StepsOfBorder = 3; // to and fro takes two

  bool turns(int p, int before, int after, double cosine) const
  {
    const Vec3& x = this->Surface.points[p];
    const Vec3 u = (x - this->Surface.points[before]).normalized();
    const Vec3 v = (this->Surface.points[after] - x).normalized();
    return u.dot(v) < cosine;
  }

  /// The input's vertex so many steps from a point along one of its two edges, or where the line
  /// ends before. Points that were put on the border's edges are no steps.
  int pointAfter(int p, int side, int steps) const
  {
    int e = this->At[p][side];
    int q = this->Edges[e].other(p);
    while (this->At[q].size() == 2 && q != p)
    {
      steps -= q < this->Surface.numberOfOriginalPoints ? 1 : 0;
      if (steps <= 0)
      {
        break;
      }
      e = this->At[q][0] == e ? this->At[q][1] : this->At[q][0];
      q = this->Edges[e].other(q);
    }
    return q;
  }

  const CutSurface& Surface;
  const std::vector<GraphEdge>& Edges;
  std::vector<std::vector<int>> At; // a point's features
};
}

FeatureGraph buildFeatureGraph(
  const CutSurface& surface, double cornerAngle, const std::vector<int>& tips)
{
  FeatureGraph graph;
  const std::size_t n = surface.points.size();
  graph.isCorner.assign(n, 0);
  const std::vector<GraphEdge> edges = graphEdges(surface);
  std::vector<std::vector<int>> at(n);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    at[edges[e].a].push_back(static_cast<int>(e));
    at[edges[e].b].push_back(static_cast<int>(e));
  }
  const Turns turns(surface, edges);
  const double straight = std::cos(cornerAngle * Pi / 180);
  std::vector<char> isTip(n, 0);
  for (int p : tips)
  {
    isTip[p] = 1;
  }
  std::vector<char> isNode(n, 0);
  for (std::size_t p = 0; p < n; ++p)
  {
    const std::size_t features = turns.at(static_cast<int>(p)).size();
    graph.isCorner[p] = features == 2 ? turns.isCorner(static_cast<int>(p), straight)
                                      : features > 0 || (isTip[p] && !at[p].empty());
    // Also where a cut that runs along a sharp line ends: beyond it the line lies inside a chart.
    isNode[p] = graph.isCorner[p] || (!at[p].empty() && at[p].size() != 2) ||
      (at[p].size() == 2 &&
        (edges[at[p][0]].type != edges[at[p][1]].type ||
          edges[at[p][0]].cut != edges[at[p][1]].cut ||
          edges[at[p][0]].keep != edges[at[p][1]].keep ||
          edges[at[p][0]].isRounded != edges[at[p][1]].isRounded));
  }

  std::vector<char> used(edges.size(), 0);
  const auto follow = [&](int start, int first) {
    Backbone backbone;
    backbone.type = edges[first].type;
    backbone.keep = edges[first].keep;
    backbone.points = { start };
    int e = first;
    int p = start;
    while (true)
    {
      used[e] = 1;
      p = edges[e].other(p);
      if (p == start && !isNode[p])
      {
        backbone.closed = true;
        break;
      }
      backbone.points.push_back(p);
      if (isNode[p])
      {
        break;
      }
      e = at[p][0] == e ? at[p][1] : at[p][0];
    }
    graph.backbones.push_back(std::move(backbone));
  };
  for (std::size_t p = 0; p < n; ++p)
  {
    for (int e : at[p])
    {
      if (isNode[p] && !used[e])
      {
        follow(static_cast<int>(p), e);
      }
    }
  }
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (!used[e])
    {
      follow(edges[e].a, static_cast<int>(e));
    }
  }
  return graph;
}
}
