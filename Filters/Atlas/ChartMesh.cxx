// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartMesh.h"

namespace stipple
{
ChartMesh extractChart(const CutSurface& surface, std::vector<int> faces)
{
  ChartMesh chart;
  const int n = static_cast<int>(faces.size());
  // Where the surface's faces are in the chart.
  std::vector<int> localFace(surface.triangles.size(), -1);
  for (int f : faces)
  {
    localFace[f] = 0;
  }
  chart.faces = std::move(faces);
  for (int f = 0, i = 0; i < n; ++f)
  {
    if (localFace[f] == 0)
    {
      chart.faces[i] = f;
      localFace[f] = i++;
    }
  }
  chart.triangles.assign(n, { -1, -1, -1 });
  int cutHalfedges = 0;
  int firstBoundaryHalfedge = -1;
  for (int i = 0; i < n; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int corner = 3 * chart.faces[i] + k;
      cutHalfedges += surface.cut[corner];
      if (surface.cut[corner] && firstBoundaryHalfedge < 0)
      {
        firstBoundaryHalfedge = corner;
      }
      if (chart.triangles[i][k] >= 0)
      {
        continue;
      }
      // A vertex is a fan of corners: turn clockwise to its first, then counterclockwise through
      // all.
      int h = corner;
      while (!surface.cut[h])
      {
        h = nextHalfedge(surface.twin[h]);
        if (h == corner)
        {
          break;
        }
      }
      const int start = h;
      const int vertex = chart.numberOfVertices();
      chart.vertices.push_back(surface.tail(h));
      chart.onBoundary.push_back(surface.cut[start]);
      while (true)
      {
        chart.triangles[localFace[h / 3]][h % 3] = vertex;
        const int previous = previousHalfedge(h);
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
  if (firstBoundaryHalfedge >= 0)
  {
    int h = firstBoundaryHalfedge;
    do
    {
      chart.boundary.push_back(chart.triangles[localFace[h / 3]][h % 3]);
      h = nextHalfedge(h);
      while (!surface.cut[h])
      {
        h = nextHalfedge(surface.twin[h]);
      }
    } while (h != firstBoundaryHalfedge);
    chart.boundaryLoops = static_cast<int>(chart.boundary.size()) == cutHalfedges ? 1 : 2;
  }
  return chart;
}

std::vector<std::vector<int>> chartFaces(const CutSurface& surface)
{
  std::vector<std::vector<int>> charts;
  std::vector<int> chartOf(surface.triangles.size(), -1);
  std::vector<int> faces;
  for (int start = 0; start < surface.numberOfFaces(); ++start)
  {
    if (chartOf[start] >= 0)
    {
      continue;
    }
    const int chart = static_cast<int>(charts.size());
    faces = { start };
    chartOf[start] = chart;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int h = 3 * faces[i] + k;
        const int neighbour = surface.cut[h] ? -1 : surface.twin[h] / 3;
        if (neighbour >= 0 && chartOf[neighbour] < 0)
        {
          chartOf[neighbour] = chart;
          faces.push_back(neighbour);
        }
      }
    }
    charts.emplace_back();
    charts.back().reserve(faces.size());
  }
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    charts[chartOf[f]].push_back(f);
  }
  return charts;
}
}
