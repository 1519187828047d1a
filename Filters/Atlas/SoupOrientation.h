// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// From triangles that share points to an oriented manifold.
#ifndef stipple_SoupOrientation_h
#define stipple_SoupOrientation_h

#include "TriangleSurface.h"

#include <algorithm>
#include <utility>

namespace stipple
{
/// Calls visit(begin, end) for every edge of the soup, with its halfedges, whichever way they run,
/// ascending.
template <typename Visit>
void forEachEdge(const std::vector<Triangle>& triangles, const Visit& visit)
{
  const auto tail = [&](Halfedge h) { return triangles[faceOf(h).index()][cornerOf(h)]; };
  const auto ends = [&](Halfedge h) -> std::pair<int, int> {
    return std::minmax({ tail(h), tail(nextHalfedge(h)) });
  };
  std::vector<Halfedge> order(3 * triangles.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = Halfedge(static_cast<int>(i));
  }
  std::sort(order.begin(), order.end(), [&](Halfedge g, Halfedge h) {
    return std::make_pair(ends(g), g) < std::make_pair(ends(h), h);
  });
  for (auto begin = order.begin(), end = begin; begin != order.end(); begin = end)
  {
    end = std::find_if(begin, order.end(), [&](Halfedge h) { return ends(h) != ends(*begin); });
    visit(begin, end);
  }
}

/// Turns triangles so that neighbours agree, and duplicates points where the surface is not
/// manifold. sourcePoint, one a point, is extended by the origin of each duplicate.
///
/// Orientation spreads breadth first across edges of two triangles, so that a surface that can't be
/// oriented is cut open along a short line, where fronts meet: a Moebius strip straight across. At
/// an edge of more triangles, each goes on in one that runs along it the other way: among those
/// whose parts of the surface end at such edges only, across the inside of the surface if as many
/// run one way as the other, so that bodies that meet in an edge stay closed; else in the one that
/// is most nearly straight on, so that a sheet goes on beneath what ends on it, and what is left
/// over ends. Around each point, what still holds together gets a point of its own; where that
/// leaves an edge of more than two, these are joined to none.
void orientSoup(
  const std::vector<Vec3>& points, std::vector<Triangle>& triangles, std::vector<int>& sourcePoint);
}

#endif
