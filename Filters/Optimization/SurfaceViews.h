// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Places on edges and vertices of the surface belong to several faces.
#ifndef stipple_SurfaceViews_h
#define stipple_SurfaceViews_h

#include "SurfaceWalk.h"

#include <algorithm>

namespace stipple
{
/// A place, and the same seen from every other face that it lies on: it is on an edge where its
/// barycentric coordinate is at most `onEdge`.
inline std::vector<SurfacePlace> viewsOf(
  const TriangleSurface& surface, const SurfacePlace& place, double onEdge)
{
  constexpr std::size_t Most = 100; // faces about a vertex
  std::vector<SurfacePlace> views = { place };
  for (std::size_t i = 0; i < views.size() && views.size() < Most; ++i)
  {
    const SurfacePlace view = views[i];
    for (int k = 0; k < 3; ++k)
    {
      const Halfedge h = halfedgeOf(Face(view.face), nextCorner(k)); // opposite to corner k
      const Halfedge g = surface.twin[h];
      if (view.bary[k] > onEdge || !g.valid() ||
        std::any_of(views.begin(), views.end(),
          [g](const SurfacePlace& v) { return v.face == faceOf(g).index(); }))
      {
        continue;
      }
      SurfacePlace other;
      other.face = faceOf(g).index();
      other.bary[cornerOf(g)] = view.bary[cornerOf(nextHalfedge(h))];
      other.bary[cornerOf(nextHalfedge(g))] = view.bary[cornerOf(h)];
      other.bary = clampedBarycentric(other.bary);
      views.push_back(other);
    }
  }
  return views;
}
}

#endif
