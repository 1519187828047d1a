// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleSurface.h"

#include "CompressedRows.h"

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

HalfedgeTwins halfedgeTwins(const std::vector<Triangle>& triangles)
{
  // Halfedges bucketed by their smaller end point: linear time, and the order does not depend on
  // hashing.
  int numberOfPoints = 0;
  for (const Triangle& t : triangles)
  {
    numberOfPoints = std::max({ numberOfPoints, t[0] + 1, t[1] + 1, t[2] + 1 });
  }
  struct Entry
  {
    int far; ///< the larger end point
    Halfedge halfedge;
    bool leaves; ///< from the smaller end point
    bool operator<(const Entry& e) const { return this->far < e.far; }
  };
  CompressedRows<Entry> bySmaller(numberOfPoints, [&](const auto& add) {
    for (const Face f : ElementRange<Face>(0, static_cast<int>(triangles.size())))
    {
      const Triangle& t = triangles[f.index()];
      for (int k = 0; k < 3; ++k)
      {
        const int p = t[k];
        const int q = t[nextCorner(k)];
        add(std::min(p, q), Entry{ std::max(p, q), halfedgeOf(f, k), p <= q });
      }
    }
  });
  HalfedgeTwins twin(static_cast<int>(triangles.size()) * 3);
  const auto match = [&](const Entry* first, const Entry* last) {
    for (const Entry* e = first; e != last; ++e)
    {
      int same = 0;
      int opposite = 0;
      Halfedge other;
      for (const Entry* g = first; g != last; ++g)
      {
        if (g->far == e->far && g->leaves == e->leaves)
        {
          ++same;
        }
        else if (g->far == e->far)
        {
          ++opposite;
          other = g->halfedge;
        }
      }
      twin[e->halfedge] = same > 1 || opposite > 1 ? NonManifoldTwin : other;
    }
  };
  constexpr int Many = 32; // the hub of a fan: every pair of its edges would be too much
  for (int p = 0; p < numberOfPoints; ++p)
  {
    auto [first, last] = bySmaller[p];
    if (last - first <= Many)
    {
      match(first, last);
      continue;
    }
    std::sort(first, last);
    while (first != last)
    {
      Entry* end = std::upper_bound(first, last, *first);
      match(first, end);
      first = end;
    }
  }
  return twin;
}

Halfedge findHalfedge(
  const TriangleSurface& surface, const ElementArray<Vertex, Halfedge>& first, Vertex p, Vertex q)
{
  const Halfedge start = first[p];
  Halfedge h = start;
  while (h.valid())
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
  return {};
}

Vec3 TriangleSurface::faceNormal(Face face) const
{
  const Vec3 n = (this->point(face, 1) - this->point(face, 0))
                   .cross(this->point(face, 2) - this->point(face, 0));
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3::Zero();
}

double TriangleSurface::area() const
{
  double sum = 0;
  for (const Face f : this->faces())
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
  Vec3 low = this->point(Face(0), 0);
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

ElementArray<Vertex, Halfedge> TriangleSurface::vertexHalfedges() const
{
  ElementArray<Vertex, Halfedge> first(this->points.size());
  for (const Halfedge h : this->halfedges())
  {
    Halfedge& slot = first[this->tail(h)];
    // On a boundary, start where turning counterclockwise about the vertex reaches every triangle.
    if (!slot.valid() || this->isBoundary(h))
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
  std::vector<int> component(this->points.size());
  std::iota(component.begin(), component.end(), 0);
  std::vector<int> loop = component;
  ElementArray<Vertex, char> onBoundary(this->points.size(), 0);
  int edges = 0;
  for (const Halfedge h : this->halfedges())
  {
    const Halfedge t = this->twin[h];
    if (t > h)
    {
      continue; // the edge's turn comes
    }
    ++edges;
    const Vertex p = this->tail(h);
    const Vertex q = this->head(h);
    unite(component, p.index(), q.index());
    if (!t.valid())
    {
      result.manifold = result.manifold && t != NonManifoldTwin;
      unite(loop, p.index(), q.index());
      onBoundary[p] = onBoundary[q] = 1;
    }
  }
  // The corners about a point are one fan: turning one way and the other from any of them reaches
  // all.
  ElementArray<Halfedge, char> visited(this->twin.size(), 0);
  ElementArray<Vertex, char> hasFan(this->points.size(), 0);
  int vertices = 0;
  for (const Halfedge h : this->halfedges())
  {
    if (visited[h])
    {
      continue;
    }
    const Vertex p = this->tail(h);
    if (hasFan[p])
    {
      result.manifold = false;
    }
    else
    {
      hasFan[p] = 1;
      ++vertices;
      result.components += findRoot(component, p.index()) == p.index();
      result.boundaryLoops += onBoundary[p] && findRoot(loop, p.index()) == p.index();
    }
    Halfedge g = h;
    do
    {
      visited[g] = 1;
      g = this->twin[previousHalfedge(g)];
    } while (g.valid() && g != h);
    for (g = this->twin[h]; g.valid() && !visited[nextHalfedge(g)]; g = this->twin[nextHalfedge(g)])
    {
      visited[nextHalfedge(g)] = 1;
    }
  }
  result.euler = vertices - edges + this->numberOfFaces();
  return result;
}
}
