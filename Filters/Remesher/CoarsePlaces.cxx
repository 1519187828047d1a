// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CoarsePlaces.h"

#include "MeshOverlaps.h"
#include "MeshQuality.h"

#include <algorithm>

namespace stipple
{
std::vector<CoarsePlace> coarsePlaces(const TriangleSurface& mesh, const std::vector<char>& isFree,
  const std::function<std::vector<Box>()>& known, const Stop& stop)
{
  const auto meanEdge = [&](Face f) {
    double sum = 0;
    for (const Halfedge h : halfedgesOf(f))
    {
      sum += mesh.edgeLength(h);
    }
    return sum / 3.;
  };
  std::vector<CoarsePlace> places;
  for (const MeshOverlap& overlap : findOverlaps(mesh, known, stop))
  {
    const auto [f, g] = overlap.faces;
    places.push_back({ overlap.position, 0.5 * (meanEdge(f) + meanEdge(g)), true });
  }
  for (const Face f : mesh.faces())
  {
    if (isTimeToAsk(f.index()) && isAsked(stop))
    {
      break;
    }
    const Triangle& t = mesh.triangles[f.index()];
    if (std::any_of(t.begin(), t.end(), [&](int p) { return isFree[p] != 0; }) &&
      measureTriangle(mesh, f).smallestAngle < SmallestGoodAngle)
    {
      const Vec3 sum = mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]];
      places.push_back({ sum / 3., meanEdge(f), false });
    }
  }
  return places;
}
}
