// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShortestPaths.h"

#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace stipple
{
ShortestPaths::ShortestPaths(const TriangleSurface& surface, const ChartMesh& chart)
  : Surface(surface)
  , Chart(chart)
  , First(chart.vertices.size() + 1, 0)
  , Distance(chart.vertices.size(), std::numeric_limits<double>::infinity())
  , Next(chart.vertices.size(), -1)
{
  for (const Triangle& t : chart.triangles)
  {
    for (const int v : t)
    {
      this->First[v + 1] += 2;
    }
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  this->Neighbours.resize(this->First.back());
  std::vector<int> next = this->First;
  for (const Triangle& t : chart.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Neighbours[next[t[k]]++] = t[nextCorner(k)];
      this->Neighbours[next[t[k]]++] = t[previousCorner(k)];
    }
  }
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
    for (int i = this->First[v]; i < this->First[v + 1]; ++i)
    {
      const int w = this->Neighbours[i];
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
