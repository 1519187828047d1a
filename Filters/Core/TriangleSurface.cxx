// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleSurface.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace stipple
{
namespace
{
int findRoot(std::vector<int>& parent, int i)
{
  while (parent[i] != i)
  {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

void unite(std::vector<int>& parent, int a, int b)
{
  parent[findRoot(parent, a)] = findRoot(parent, b);
}
}

std::vector<int> halfedgeTwins(const std::vector<Triangle>& triangles)
{
  // Halfedges bucketed by their smaller end point: linear time, and the order does not depend on
  // hashing.
  const int n = static_cast<int>(triangles.size()) * 3;
  int numberOfPoints = 0;
  for (const Triangle& t : triangles)
  {
    numberOfPoints = std::max({ numberOfPoints, t[0] + 1, t[1] + 1, t[2] + 1 });
  }
  std::vector<int> begin(numberOfPoints + 1, 0);
  const auto ends = [&](int h) {
    const Triangle& t = triangles[h / 3];
    return std::array<int, 2>{ t[h % 3], t[h % 3 == 2 ? 0 : h % 3 + 1] };
  };
  for (int h = 0; h < n; ++h)
  {
    const auto e = ends(h);
    ++begin[std::min(e[0], e[1]) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> bucket(n);
  std::vector<int> fill(begin.begin(), begin.end() - 1);
  for (int h = 0; h < n; ++h)
  {
    const auto e = ends(h);
    bucket[fill[std::min(e[0], e[1])]++] = h;
  }
  std::vector<int> twin(n, -1);
  const auto larger = [&](int h) { return std::max(ends(h)[0], ends(h)[1]); };
  for (int p = 0; p < numberOfPoints; ++p)
  {
    std::sort(bucket.begin() + begin[p], bucket.begin() + begin[p + 1],
      [&](int g, int h) { return larger(g) != larger(h) ? larger(g) < larger(h) : g < h; });
    for (int i = begin[p], j = i; i < begin[p + 1]; i = j)
    {
      // The halfedges of one edge: [i, j).
      int forward = 0;
      for (; j < begin[p + 1] && larger(bucket[j]) == larger(bucket[i]); ++j)
      {
        forward += ends(bucket[j])[0] == p;
      }
      if (forward > 1 || j - i - forward > 1)
      {
        std::for_each(bucket.begin() + i, bucket.begin() + j, [&](int h) { twin[h] = -2; });
      }
      else if (j - i == 2)
      {
        twin[bucket[i]] = bucket[i + 1];
        twin[bucket[i + 1]] = bucket[i];
      }
    }
  }
  return twin;
}

int findHalfedge(const TriangleSurface& surface, const std::vector<int>& first, int p, int q)
{
  const int start = first[p];
  int h = start;
  while (h >= 0)
  {
    if (surface.head(h) == q)
    {
      return h;
    }
    h = surface.twin[previousHalfedge(h)];
    if (h == start)
    {
      break;
    }
  }
  return -1;
}

Vec3 TriangleSurface::faceNormal(int face) const
{
  const Vec3 n = (this->point(face, 1) - this->point(face, 0))
                   .cross(this->point(face, 2) - this->point(face, 0));
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3::Zero();
}

double TriangleSurface::area() const
{
  double sum = 0;
  for (int f = 0; f < this->numberOfFaces(); ++f)
  {
    sum += this->faceArea(f);
  }
  return sum;
}

double TriangleSurface::boundingBoxDiagonal() const
{
  if (this->triangles.empty())
  {
    return 0;
  }
  Vec3 low = this->point(0, 0);
  Vec3 high = low;
  for (const Triangle& t : this->triangles)
  {
    for (int p : t)
    {
      low = low.cwiseMin(this->points[p]);
      high = high.cwiseMax(this->points[p]);
    }
  }
  return (high - low).norm();
}

std::vector<int> TriangleSurface::vertexHalfedges() const
{
  std::vector<int> first(this->points.size(), -1);
  for (int h = 0; h < 3 * this->numberOfFaces(); ++h)
  {
    int& slot = first[this->tail(h)];
    // On a boundary, start where turning counterclockwise about the vertex reaches every triangle.
    if (slot < 0 || this->twin[h] < 0)
    {
      slot = h;
    }
  }
  return first;
}

SurfaceTopology TriangleSurface::topology() const
{
  SurfaceTopology result;
  result.manifold = true;
  const int n = 3 * this->numberOfFaces();
  std::vector<int> component(this->points.size());
  std::iota(component.begin(), component.end(), 0);
  std::vector<int> fan(n); // corners joined around their vertex
  std::iota(fan.begin(), fan.end(), 0);
  std::vector<int> loop(this->points.size());
  std::iota(loop.begin(), loop.end(), 0);
  std::vector<char> onBoundary(this->points.size(), 0);
  int edges = 0;
  for (int h = 0; h < n; ++h)
  {
    unite(component, this->tail(h), this->head(h));
    const int t = this->twin[h];
    if (t == -2)
    {
      result.manifold = false;
    }
    if (t < 0)
    {
      ++edges;
      unite(loop, this->tail(h), this->head(h));
      onBoundary[this->tail(h)] = onBoundary[this->head(h)] = 1;
    }
    else
    {
      edges += h < t;
      unite(fan, h, nextHalfedge(t));
      unite(fan, nextHalfedge(h), t);
    }
  }
  std::vector<int> fanOf(this->points.size(), -1);
  int vertices = 0;
  for (int h = 0; h < n; ++h)
  {
    const int p = this->tail(h);
    const int root = findRoot(fan, h);
    if (fanOf[p] < 0)
    {
      fanOf[p] = root;
      ++vertices;
      result.components += findRoot(component, p) == p;
      result.boundaryLoops += onBoundary[p] && findRoot(loop, p) == p;
    }
    else if (fanOf[p] != root)
    {
      result.manifold = false;
    }
  }
  result.euler = vertices - edges + this->numberOfFaces();
  return result;
}
}
