// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeSwaps.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace stipple
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
using HalfedgeHandle = OptimizedMesh::Halfedge;

/// The four vertices of an edge's two triangles: (a, b, c) and (b, a, d).
struct Quad
{
  int a;
  int b;
  int c;
  int d;
  Quad(const OptimizedMesh& mesh, int edge)
  {
    const auto& graph = mesh.graph();
    const HalfedgeHandle h = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
    const HalfedgeHandle g = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 1);
    this->a = graph.to_vertex_handle(g).idx();
    this->b = graph.to_vertex_handle(h).idx();
    this->c = graph.to_vertex_handle(graph.next_halfedge_handle(h)).idx();
    this->d = graph.to_vertex_handle(graph.next_halfedge_handle(g)).idx();
  }
};

double angleAt(const Vec3& p, const Vec3& q, const Vec3& r)
{
  const Vec3 u = q - p;
  const Vec3 v = r - p;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

double smallestAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  // It is opposite to the shortest edge.
  const double ab = (b - a).squaredNorm();
  const double bc = (c - b).squaredNorm();
  const double ca = (a - c).squaredNorm();
  return ab <= bc && ab <= ca ? angleAt(c, a, b) : bc <= ca ? angleAt(a, b, c) : angleAt(b, c, a);
}

bool exceedsHalfTurn(const OptimizedMesh& mesh, const Quad& q)
{
  const Vec3& a = mesh.position(q.a);
  const Vec3& b = mesh.position(q.b);
  const Vec3 ca = a - mesh.position(q.c);
  const Vec3 cb = b - mesh.position(q.c);
  const Vec3 da = a - mesh.position(q.d);
  const Vec3 db = b - mesh.position(q.d);
  const double cosC = ca.dot(cb);
  const double cosD = da.dot(db);
  if (cosC >= 0 && cosD >= 0)
  {
    return false;
  }
  const double sinC = ca.cross(cb).norm();
  const double sinD = da.cross(db).norm();
  return sinC * cosD + cosC * sinD < -1e-6 * (ca.norm() * cb.norm() * da.norm() * db.norm());
}

double aspect(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
  return perimeter > 0 ? triangleArea(a, b, c) / (perimeter * perimeter) : 0.;
}

template <typename Wish>
int swapWhile(OptimizedMesh& mesh, int maximumNumberOfPasses, const Wish& wish)
{
  int total = 0;
  for (int pass = 0; pass < maximumNumberOfPasses; ++pass)
  {
    int swaps = 0;
    for (int e = 0; e < mesh.numberOfEdges(); ++e)
    {
      if (mesh.isSwappable(e) && wish(e) && mesh.swap(e))
      {
        ++swaps;
      }
    }
    total += swaps;
    if (swaps == 0)
    {
      break;
    }
  }
  return total;
}

/// The same swaps in the same order, for wishes that depend on an edge's two triangles only: all
/// are asked for at once, in parallel, and again only where a swap changed a triangle.
template <typename Wish>
int swapLocallyWhile(OptimizedMesh& mesh, int maximumNumberOfPasses, const Wish& wish)
{
  enum class Answer : char
  {
    No,
    Yes,
    Unknown
  };
  const auto& graph = mesh.graph();
  const int n = mesh.numberOfEdges();
  std::vector<Answer> answer(n);
  vtkSMPTools::For(0, n, 2048, [&](vtkIdType begin, vtkIdType end) {
    for (int e = static_cast<int>(begin); e < end; ++e)
    {
      answer[e] = mesh.isSwappable(e) && wish(e) ? Answer::Yes : Answer::No;
    }
  });
  int total = 0;
  for (int pass = 0; pass < maximumNumberOfPasses; ++pass)
  {
    int swaps = 0;
    for (int e = 0; e < n; ++e)
    {
      if (answer[e] == Answer::Unknown)
      {
        answer[e] = mesh.isSwappable(e) && wish(e) ? Answer::Yes : Answer::No;
      }
      // A refused swap may become possible without a change of its triangles: the answer stays.
      if (answer[e] == Answer::Yes && mesh.swap(e))
      {
        ++swaps;
        answer[e] = Answer::Unknown;
        for (int side = 0; side < 2; ++side)
        {
          const HalfedgeHandle h = graph.halfedge_handle(OpenMesh::EdgeHandle(e), side);
          const HalfedgeHandle next = graph.next_halfedge_handle(h);
          answer[graph.edge_handle(next).idx()] = Answer::Unknown;
          answer[graph.edge_handle(graph.next_halfedge_handle(next)).idx()] = Answer::Unknown;
        }
      }
    }
    total += swaps;
    if (swaps == 0)
    {
      break;
    }
  }
  return total;
}
}

bool isDelaunaySwap(const OptimizedMesh& mesh, int edge)
{
  return mesh.isSwappable(edge) && exceedsHalfTurn(mesh, Quad(mesh, edge));
}

int delaunaySwaps(OptimizedMesh& mesh, int maximumNumberOfPasses)
{
  return swapLocallyWhile(
    mesh, maximumNumberOfPasses, [&](int e) { return exceedsHalfTurn(mesh, Quad(mesh, e)); });
}

int aspectSwaps(OptimizedMesh& mesh, int maximumNumberOfPasses)
{
  return swapLocallyWhile(mesh, maximumNumberOfPasses, [&](int e) {
    const Quad q(mesh, e);
    const Vec3& a = mesh.position(q.a);
    const Vec3& b = mesh.position(q.b);
    const Vec3& c = mesh.position(q.c);
    const Vec3& d = mesh.position(q.d);
    return std::min(aspect(d, c, a), aspect(c, d, b)) >
      (1. + 1e-9) * std::min(aspect(a, b, c), aspect(b, a, d));
  });
}

namespace
{
/// Triangles of the sector of v between creases or boundaries that start is in, and its angle, if
/// that is wanted.
std::pair<int, double> sectorOf(
  const OptimizedMesh& mesh, HalfedgeHandle start, bool withAngle = true)
{
  const auto& graph = mesh.graph();
  const OptimizedMesh::Vertex v = graph.from_vertex_handle(start);
  // Turn clockwise to the first edge of the sector, then count and measure counterclockwise.
  HalfedgeHandle first = start;
  while (!mesh.isFeature(graph.edge_handle(first).idx()))
  {
    const HalfedgeHandle right = graph.opposite_halfedge_handle(first);
    if (graph.is_boundary(right))
    {
      break;
    }
    first = graph.next_halfedge_handle(right);
    if (first == start)
    {
      break;
    }
  }
  int triangles = 0;
  double angle = 0;
  HalfedgeHandle h = first;
  do
  {
    const HalfedgeHandle last = graph.prev_halfedge_handle(h);
    if (withAngle)
    {
      angle += angleAt(mesh.position(v), mesh.position(graph.to_vertex_handle(h)),
        mesh.position(graph.from_vertex_handle(last)));
    }
    ++triangles;
    if (mesh.isFeature(graph.edge_handle(last).idx()))
    {
      break;
    }
    h = graph.opposite_halfedge_handle(last);
  } while (h != first && !graph.is_boundary(h));
  return { triangles, angle };
}

bool isOrdinary(const OptimizedMesh& mesh, OptimizedMesh::Vertex v)
{
  return mesh.freedom(v.idx()) == Freedom::Surface && !mesh.graph().is_boundary(v);
}
}

int valenceExcess(const OptimizedMesh& mesh, HalfedgeHandle start)
{
  const OptimizedMesh::Vertex v = mesh.graph().from_vertex_handle(start);
  if (isOrdinary(mesh, v))
  {
    return mesh.valence(v.idx()) - 6;
  }
  const auto [triangles, angle] = sectorOf(mesh, start);
  return triangles - std::max(1, static_cast<int>(std::lround(angle / (Pi / 3.))));
}

int ribExcess(const OptimizedMesh& mesh, HalfedgeHandle start)
{
  const OptimizedMesh::Vertex v = mesh.graph().from_vertex_handle(start);
  return mesh.freedom(v.idx()) == Freedom::Backbone ? sectorOf(mesh, start, false).first - 3
                                                    : valenceExcess(mesh, start);
}

int irregularity(int excess)
{
  const int beyond = std::abs(excess) - 1;
  return beyond > 0 ? 1 + beyond * beyond : 0;
}

int dispersionChange(const OptimizedMesh& mesh, int edge)
{
  const auto& graph = mesh.graph();
  const HalfedgeHandle h = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
  const HalfedgeHandle g = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 1);
  const int a = valenceExcess(mesh, h);
  const int b = valenceExcess(mesh, g);
  const int c = valenceExcess(mesh, graph.prev_halfedge_handle(h));
  const int d = valenceExcess(mesh, graph.prev_halfedge_handle(g));
  // (x - 1)^2 - x^2 at the ends, (x + 1)^2 - x^2 at the others
  return (1 - 2 * a) + (1 - 2 * b) + (1 + 2 * c) + (1 + 2 * d);
}

int regularitySwaps(OptimizedMesh& mesh, double minimumAngle, int maximumNumberOfPasses)
{
  const double bound = minimumAngle * Pi / 180.;
  return swapWhile(mesh, maximumNumberOfPasses, [&](int e) {
    if (dispersionChange(mesh, e) >= 0)
    {
      return false;
    }
    const Quad q(mesh, e);
    const Vec3& a = mesh.position(q.a);
    const Vec3& b = mesh.position(q.b);
    const Vec3& c = mesh.position(q.c);
    const Vec3& d = mesh.position(q.d);
    const double after = std::min(smallestAngle(d, c, a), smallestAngle(c, d, b));
    return after > bound || after > std::min(smallestAngle(a, b, c), smallestAngle(b, a, d));
  });
}
}
