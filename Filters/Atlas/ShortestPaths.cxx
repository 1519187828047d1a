// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShortestPaths.h"

#include <functional>
#include <limits>
#include <queue>

namespace stipple
{
ShortestPaths::ShortestPaths(const TriangleSurface& surface, const ChartMesh& chart)
  : Surface(surface)
  , Chart(chart)
  , Neighbours(chart.vertices.size(),
      [&](const auto& add) {
        for (const Triangle& t : chart.triangles)
        {
          for (int k = 0; k < 3; ++k)
          {
            add(t[k], t[nextCorner(k)]);
            add(t[k], t[previousCorner(k)]);
          }
        }
      })
  , Distance(chart.vertices.size(), std::numeric_limits<double>::infinity())
  , Next(chart.vertices.size(), -1)
{
}

void ShortestPaths::addTargets(const std::vector<int>& targets, const Stop& stop)
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (int v : targets)
  {
    this->Distance[v] = 0;
    this->Next[v] = -1;
    front.push({ 0., v });
  }
  // A vertex comes back only with a smaller distance, of finitely many.
  while (!front.empty() && !isAsked(stop))
  {
    const auto [d, v] = front.top();
    front.pop();
    if (d > this->Distance[v])
    {
      continue;
    }
    for (const int w : this->Neighbours[v])
    {
      const double there = d +
        (this->Surface.points[this->Chart.vertices[w]] -
          this->Surface.points[this->Chart.vertices[v]])
          .norm();
      if (there < this->Distance[w])
      {
        this->Distance[w] = there;
        this->Next[w] = v;
        front.push({ there, w });
      }
    }
  }
}

std::vector<int> ShortestPaths::path(int vertex) const
{
  std::vector<int> path = { vertex };
  while (this->Next[path.back()] >= 0)
  {
    path.push_back(this->Next[path.back()]);
  }
  return path;
}
}
