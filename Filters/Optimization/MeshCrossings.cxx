// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshCrossings.h"

#include "MeshRegion.h"

#include <algorithm>

namespace stipple
{
bool swapStaysApart(const OptimizedMesh& mesh, Edge e)
{
  const auto corners = mesh.wingVertices(e);
  const auto [a, b, c, d] = corners;
  if (std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return mesh.isFree(v); }))
  {
    return true;
  }
  const std::vector<Face> about = facesAbout(mesh, { a, b, c, d });
  const Face first = mesh.face(mesh.halfedge(e, 0));
  const Face second = mesh.face(mesh.halfedge(e, 1));
  const auto crossings = [&](const MeshTriangle& s, const MeshTriangle& t) {
    return std::count_if(about.begin(), about.end(), [&](Face f) {
      return f != first && f != second &&
        (intersect(mesh, s, mesh.corners(f)) || intersect(mesh, t, mesh.corners(f)));
    });
  };
  const auto after = crossings({ { d, c, a } }, { { c, d, b } });
  return after == 0 || after <= crossings({ { a, b, c } }, { { b, a, d } });
}
}
