// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartMesh.h"

#include "FaceSets.h"

#include <algorithm>

namespace stipple
{
namespace
{
/// Sorts faces that are all different: marked and collected where that is faster.
void sortFaces(const TriangleSurface& surface, std::vector<Face>& faces)
{
  if (faces.size() * 16 < surface.triangles.size())
  {
    std::sort(faces.begin(), faces.end());
    return;
  }
  ElementArray<Face, char> isThere(surface.triangles.size(), 0);
  for (const Face f : faces)
  {
    isThere[f] = 1;
  }
  faces.clear();
  for (const Face f : surface.faces())
  {
    if (isThere[f])
    {
      faces.push_back(f);
    }
  }
}
}

ChartMesh extractChart(const CutSurface& surface, std::vector<Face> faces)
{
  ChartMesh chart;
  sortFaces(surface, faces);
  chart.faces = std::move(faces);
  const int n = static_cast<int>(chart.faces.size());
  // Where the surface's faces are in the chart; what is left from another chart is never read.
  thread_local ElementArray<Face, int> localFace;
  localFace.resize(std::max(localFace.size(), surface.triangles.size()));
  for (int i = 0; i < n; ++i)
  {
    localFace[chart.faces[i]] = i;
  }
  chart.triangles.assign(n, { -1, -1, -1 });
  const auto vertexAt = [&](Halfedge h) -> int& { // its tail
    return chart.triangles[localFace[faceOf(h)]][cornerOf(h)];
  };
  int cutHalfedges = 0;
  Halfedge firstOnBoundary;
  for (const Face face : chart.faces)
  {
    for (const Halfedge corner : halfedgesOf(face))
    {
      cutHalfedges += surface.cut[corner];
      if (surface.cut[corner] && !firstOnBoundary.valid())
      {
        firstOnBoundary = corner;
      }
      if (vertexAt(corner) >= 0)
      {
        continue;
      }
      // A vertex is a fan of corners: turn clockwise to its first, then counterclockwise through
      // all.
      Halfedge h = corner;
      while (!surface.cut[h])
      {
        h = nextHalfedge(surface.twin[h]);
        if (h == corner)
        {
          break;
        }
      }
      const Halfedge start = h;
      const int vertex = chart.numberOfVertices();
      chart.vertices.push_back(surface.tail(h).index());
      chart.onBoundary.push_back(surface.cut[start]);
      while (true)
      {
        vertexAt(h) = vertex;
        const Halfedge previous = previousHalfedge(h);
        if (surface.cut[previous])
        {
          break;
        }
        h = surface.twin[previous];
        if (h == start)
        {
          break;
        }
      }
    }
  }
  chart.euler = chart.numberOfVertices() - (3 * n + cutHalfedges) / 2 + n;
  if (firstOnBoundary.valid())
  {
    Halfedge h = firstOnBoundary;
    do
    {
      chart.boundary.push_back(vertexAt(h));
      h = surface.nextOnBoundary(h);
    } while (h != firstOnBoundary);
    chart.boundaryLoops = static_cast<int>(chart.boundary.size()) == cutHalfedges ? 1 : 2;
  }
  return chart;
}

std::vector<std::vector<Face>> chartFaces(const CutSurface& surface)
{
  return FaceSets(surface, [&](Halfedge h) { return !surface.cut[h]; }).faces();
}
}
