// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGraphBuilder.h"

#include <cmath>

namespace stipple
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

struct GraphEdge
{
  int a;
  int b;
  BackboneType type;
  bool cut; ///< charts end here, also along a sharp edge
  int other(int p) const { return this->a == p ? this->b : this->a; }
};

std::vector<GraphEdge> graphEdges(const CutSurface& surface)
{
  std::vector<GraphEdge> edges;
  for (int h = 0; h < 3 * surface.numberOfFaces(); ++h)
  {
    const int t = surface.twin[h];
    if (t >= 0 && t < h)
    {
      continue;
    }
    if (t < 0)
    {
      edges.push_back({ surface.tail(h), surface.head(h), BackboneType::Boundary, true });
    }
    else if (surface.sharp[h])
    {
      edges.push_back(
        { surface.tail(h), surface.head(h), BackboneType::Sharp, surface.cut[h] != 0 });
    }
    else if (surface.cut[h])
    {
      edges.push_back({ surface.tail(h), surface.head(h), BackboneType::Seam, true });
    }
  }
  return edges;
}
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
  const double straight = std::cos(cornerAngle * Pi / 180);
  std::vector<char> isTip(n, 0);
  for (int p : tips)
  {
    isTip[p] = 1;
  }
  std::vector<char> isNode(n, 0);
  for (std::size_t p = 0; p < n; ++p)
  {
    std::vector<int> feature;
    for (int e : at[p])
    {
      if (edges[e].type != BackboneType::Seam)
      {
        feature.push_back(e);
      }
    }
    if (feature.size() == 2)
    {
      const Vec3& x = surface.points[p];
      const Vec3 u =
        (x - surface.points[edges[feature[0]].other(static_cast<int>(p))]).normalized();
      const Vec3 v =
        (surface.points[edges[feature[1]].other(static_cast<int>(p))] - x).normalized();
      graph.isCorner[p] = u.dot(v) < straight || edges[feature[0]].type != edges[feature[1]].type;
    }
    else
    {
      graph.isCorner[p] = !feature.empty() || (isTip[p] && !at[p].empty());
    }
    // Also where a cut that runs along a sharp line ends: beyond it the line lies inside a chart.
    isNode[p] = graph.isCorner[p] || (!at[p].empty() && at[p].size() != 2) ||
      (at[p].size() == 2 &&
        (edges[at[p][0]].type != edges[at[p][1]].type ||
          edges[at[p][0]].cut != edges[at[p][1]].cut));
  }

  std::vector<char> used(edges.size(), 0);
  const auto follow = [&](int start, int first) {
    Backbone backbone;
    backbone.type = edges[first].type;
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
