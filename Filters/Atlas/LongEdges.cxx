// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LongEdges.h"

#include "AtlasConstants.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace stipple
{
using Constants = AtlasConstants;

double longestEdgeForCharts(const CutSurface& surface)
{
  return std::max(Constants::LeastLongEdge * surface.boundingBoxDiagonal(),
    2. * std::sqrt(2. / std::sqrt(3.) * surface.area() / Constants::PointsForCharts));
}

int splitLongEdges(CutSurface& surface, double longest, int mostPoints)
{
  // By length, then the edge that comes first. A split shortens edges: what does not have the
  // length any more that it had here is met again with its new one.
  std::priority_queue<std::pair<double, int>> edges;
  const auto add = [&](Halfedge h) {
    const double length = surface.edgeLength(h);
    if (length > longest && surface.keep[h] != Keep::Edges)
    {
      edges.emplace(length, -std::max(h, surface.twin[h]).index());
    }
  };
  for (const Halfedge h : surface.halfedges())
  {
    if (surface.twin[h] < h)
    {
      add(h);
    }
  }
  int added = 0;
  while (!edges.empty() && added < mostPoints)
  {
    const auto [length, negative] = edges.top();
    edges.pop();
    const Halfedge h(-negative);
    if (surface.edgeLength(h) != length)
    {
      continue;
    }
    const Halfedge twin = surface.twin[h];
    const int before = surface.numberOfFaces();
    surface.splitEdge(h, 0.5);
    ++added;
    const auto addEdgesOf = [&](Face face) {
      for (const Halfedge g : halfedgesOf(face))
      {
        add(g);
      }
    };
    addEdgesOf(faceOf(h));
    addEdgesOf(Face(before));
    if (twin.valid())
    {
      addEdgesOf(faceOf(twin));
      addEdgesOf(Face(before + 1));
    }
  }
  return added;
}
}
