// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceError.h"

#include "LocalRepair.h"
#include "Relaxation.h"
#include "VertexStar.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace stipple
{
namespace
{
using HalfedgeHandle = OptimizedMesh::Halfedge;

/// Ericson, Real-Time Collision Detection, 5.1.5: the Voronoi region of the triangle that p is in.
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = p - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0)
  {
    return ap.squaredNorm();
  }
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3)
  {
    return bp.squaredNorm();
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    return (ap - d1 / (d1 - d3) * ab).squaredNorm();
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6)
  {
    return cp.squaredNorm();
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    return (ap - d2 / (d2 - d6) * ac).squaredNorm();
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
  {
    return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).squaredNorm();
  }
  const Vec3 n = ab.cross(ac);
  const double square = n.squaredNorm();
  const double height = n.dot(ap);
  return square > 0 ? height * height / square : ap.squaredNorm();
}

std::vector<int> ringOf(const OptimizedMesh& mesh, int v)
{
  std::vector<int> ring;
  mesh.forEachNeighbour(v, [&](int u) { ring.push_back(u); });
  return ring;
}
}

SurfaceError::SurfaceError(const OptimizedMesh& mesh)
  : Mesh(mesh)
{
  const AtlasSurface& surface = mesh.atlas().surface();
  const std::vector<int>& firstNeighbour = mesh.atlas().neighbourBegin();
  const std::vector<int>& neighbour = mesh.atlas().neighbours();
  const int n = static_cast<int>(surface.points.size());
  std::vector<int> owner(n, -1);
  std::vector<double> distance(n, 1e300);
  std::deque<int> queue;
  const auto offer = [&](int p, int v) {
    const double d = (surface.points[p] - mesh.position(v)).squaredNorm();
    if (d < distance[p])
    {
      distance[p] = d;
      owner[p] = v;
      queue.push_back(p);
    }
  };
  for (int v = 0; v < mesh.numberOfVertices(); ++v)
  {
    for (int p : surface.triangles[mesh.place(v).face])
    {
      offer(p, v);
    }
  }
  while (!queue.empty())
  {
    const int p = queue.front();
    queue.pop_front();
    for (int k = firstNeighbour[p]; k < firstNeighbour[p + 1]; ++k)
    {
      offer(neighbour[k], owner[p]);
    }
  }
  this->Begin.assign(mesh.numberOfVertices() + 1, 0);
  for (int v : owner)
  {
    if (v >= 0)
    {
      ++this->Begin[v + 1];
    }
  }
  for (int v = 0; v < mesh.numberOfVertices(); ++v)
  {
    this->Begin[v + 1] += this->Begin[v];
  }
  this->Point.resize(this->Begin.back());
  std::vector<int> next = this->Begin;
  for (int p = 0; p < n; ++p)
  {
    if (owner[p] >= 0)
    {
      this->Point[next[owner[p]]++] = p;
    }
  }
}

SurfaceError::Measure SurfaceError::at(int v) const
{
  Measure result;
  const auto& graph = this->Mesh.graph();
  const Vec3& x = this->Mesh.position(v);
  const HalfedgeHandle first = graph.halfedge_handle(OptimizedMesh::Vertex(v));
  for (int k = this->Begin[v]; k < this->Begin[v + 1]; ++k)
  {
    const Vec3& p = this->Mesh.atlas().surface().points[this->Point[k]];
    double least = 1e300;
    HalfedgeHandle h = first;
    do
    {
      if (!graph.is_boundary(h))
      {
        least = std::min(least,
          squaredDistance(p, x, this->Mesh.position(graph.to_vertex_handle(h)),
            this->Mesh.position(graph.to_vertex_handle(graph.next_halfedge_handle(h)))));
      }
      h = graph.next_halfedge_handle(graph.opposite_halfedge_handle(h));
    } while (h != first);
    result.sum += least;
    if (least > result.largest)
    {
      result.largest = least;
      result.farthest = this->Point[k];
    }
  }
  return result;
}

SurfaceError::Measure SurfaceError::about(int v) const
{
  const Measure unbounded = { 1e300, 1e300, -1 };
  return this->aboutUpTo(v, unbounded);
}

SurfaceError::Measure SurfaceError::aboutUpTo(int v, const Measure& bound) const
{
  Measure result = this->at(v);
  const auto& graph = this->Mesh.graph();
  const HalfedgeHandle first = graph.halfedge_handle(OptimizedMesh::Vertex(v));
  HalfedgeHandle h = first;
  do
  {
    const Measure m = this->at(graph.to_vertex_handle(h).idx());
    result.sum += m.sum;
    if (m.largest > result.largest)
    {
      result.largest = m.largest;
      result.farthest = m.farthest;
    }
    h = graph.next_halfedge_handle(graph.opposite_halfedge_handle(h));
  } while (h != first && result.sum < bound.sum && result.largest <= bound.largest);
  return result;
}

namespace
{
/// An attempt must lower the error by this share of it at least.
constexpr double LeastGain = 0.01;
/// No triangle becomes smaller than this share of the mean about its vertex, or larger than the
/// mean over it, unless one was.
constexpr double LeastArea = 0.6;
/// What a swap must leave of the error about it, at most.
constexpr double LeastGainOfSwap = 0.8;
/// Where a triangle is worse than this (radians), the error is the lesser worry.
constexpr double LeastQuality = 0.05;
/// Where a point is farther away than this share of the edges' mean length, a tip is cut off: there
/// areas may become this uneven, and angles (radians) this small.
constexpr double FarAway = 0.33;
constexpr double LeastAreaAtTip = 0.5;
constexpr double AngleAtTip = 0.577;

/// Smallest and largest area of the triangles about a vertex.
std::pair<double, double> areasAbout(const OptimizedMesh& mesh, int v)
{
  double smallest = 1e300;
  double largest = 0;
  mesh.forEachFace(v, [&](int f) {
    auto t = mesh.corners(f);
    std::rotate(t.begin(), std::find(t.begin(), t.end(), v), t.end());
    const double area = triangleArea(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    smallest = std::min(smallest, area);
    largest = std::max(largest, area);
  });
  return { smallest, largest };
}

bool moveNearer(OptimizedMesh& mesh, const SurfaceError& error, int v, double minimumAngle)
{
  SurfaceError::Measure best = error.about(v);
  const double far = FarAway * meanEdgeLength(mesh, v);
  const bool isTip = best.largest > far * far;
  const VertexStar star(mesh, v);
  const double quality = std::min(
    isTip ? std::min(AngleAtTip, minimumAngle) : minimumAngle, star.quality(mesh.footing(v)));
  if (quality < LeastQuality)
  {
    return false;
  }
  const double leastArea = isTip ? LeastAreaAtTip : LeastArea;
  const auto [smallest, largest] = areasAbout(mesh, v);
  const double mean = 0.5 * (smallest + largest);
  const double least = std::min(smallest, leastArea * mean);
  const double most = std::max(largest, mean / leastArea);
  bool changed = false;
  const auto accept = [&]() {
    const auto area = areasAbout(mesh, v);
    if (area.first < least || area.second > most)
    {
      return false;
    }
    const SurfaceError::Measure bound = { (1. - LeastGain) * best.sum, best.largest, -1 };
    const SurfaceError::Measure e = error.aboutUpTo(v, bound);
    if (e.sum >= bound.sum || e.largest > bound.largest)
    {
      return false;
    }
    best = e;
    changed = true;
    return true;
  };
  const auto isSound = [&](const Footing& there) { return star.exceeds(there, quality - 1e-9); };
  const double reach = meanEdgeLength(mesh, v);
  if (mesh.freedom(v) == Freedom::Backbone)
  {
    const auto acceptSound = [&]() { return isSound(mesh.footing(v)) && accept(); };
    for (const double size : { 0.2, 0.07 })
    {
      while (
        mesh.trySlide(v, size * reach, acceptSound) || mesh.trySlide(v, -size * reach, acceptSound))
      {
      }
    }
    return changed;
  }
  if (mesh.freedom(v) != Freedom::Surface)
  {
    return false;
  }
  const auto attempt = [&](const SurfacePlace& from, const Vec3& step) {
    const Footing there = mesh.footing(from, step);
    if (isSound(there))
    {
      mesh.tryOut(v, there, accept);
    }
  };
  if (best.farthest >= 0)
  {
    attempt(mesh.atlas().placeOfPoint(best.farthest), Vec3::Zero());
  }
  for (const double size : { 0.2, 0.07 })
  {
    const Vec3& n = mesh.normal(v);
    const Vec3 e = n.unitOrthogonal();
    const Vec3 g = n.cross(e);
    for (int k = 0; k < 8; ++k)
    {
      const double angle = k * 0.785398163397448;
      attempt(mesh.place(v), size * reach * (std::cos(angle) * e + std::sin(angle) * g));
    }
  }
  return changed;
}

/// Swaps an edge near a tip that is cut off and moves the four vertices about it; false, and
/// nothing is changed, if that brings the mesh no nearer.
bool swapNearer(OptimizedMesh& mesh, const SurfaceError& error, int edge)
{
  const auto& graph = mesh.graph();
  const OpenMesh::EdgeHandle e(edge);
  if (!mesh.isSwappable(edge) || !graph.is_flip_ok(e))
  {
    return false;
  }
  const HalfedgeHandle h = graph.halfedge_handle(e, 0);
  const HalfedgeHandle g = graph.halfedge_handle(e, 1);
  const std::array<int, 4> quad = { { graph.from_vertex_handle(h).idx(),
    graph.to_vertex_handle(h).idx(), graph.to_vertex_handle(graph.next_halfedge_handle(h)).idx(),
    graph.to_vertex_handle(graph.next_halfedge_handle(g)).idx() } };
  std::vector<int> all(quad.begin(), quad.end());
  std::array<Footing, 4> before;
  for (int i = 0; i < 4; ++i)
  {
    if (mesh.freedom(quad[i]) != Freedom::Surface)
    {
      return false;
    }
    before[i] = mesh.footing(quad[i]);
    const std::vector<int> ring = ringOf(mesh, quad[i]);
    all.insert(all.end(), ring.begin(), ring.end());
  }
  makeUnique(all);
  const auto errorOfAll = [&]() {
    double sum = 0;
    for (int v : all)
    {
      sum += error.at(v).sum;
    }
    return sum;
  };
  const auto worst = [&]() {
    double q = 10;
    for (int v : all)
    {
      q = std::min(q, starQuality(mesh, v));
    }
    return q;
  };
  const auto irregular = [&]() {
    return std::count_if(all.begin(), all.end(),
      [&mesh](int v) { return mesh.valence(v) < 5 || mesh.valence(v) > 7; });
  };
  const double sum = errorOfAll();
  const auto irregularBefore = irregular();
  const double quality = std::min(AngleAtTip, worst());
  if (quality < LeastQuality)
  {
    return false;
  }
  mesh.forceSwap(edge);
  for (int round = 0; round < 2 && irregular() <= irregularBefore; ++round)
  {
    for (int v : quad)
    {
      if (starQuality(mesh, v) < quality)
      {
        improveByMove(mesh, v);
      }
      moveNearer(mesh, error, v, AngleAtTip);
    }
  }
  if (irregular() <= irregularBefore && worst() >= quality && errorOfAll() < LeastGainOfSwap * sum)
  {
    return true;
  }
  mesh.forceSwap(edge);
  for (int i = 0; i < 4; ++i)
  {
    mesh.put(quad[i], before[i]);
  }
  return false;
}

/// The edges of the triangles about a vertex.
std::vector<int> edgesAbout(const OptimizedMesh& mesh, int v)
{
  const auto& graph = mesh.graph();
  std::vector<int> edges;
  mesh.forEachHalfedge(v, [&](HalfedgeHandle h) {
    edges.push_back(graph.edge_handle(h).idx());
    if (!graph.is_boundary(h))
    {
      edges.push_back(graph.edge_handle(graph.next_halfedge_handle(h)).idx());
    }
  });
  return edges;
}
}

int reduceSurfaceError(OptimizedMesh& mesh, double minimumAngle, double share)
{
  const SurfaceError error(mesh);
  const int n = mesh.numberOfVertices();
  std::vector<double> largest(n);
  vtkSMPTools::For(0, n, 256, [&](vtkIdType begin, vtkIdType end) {
    for (int v = static_cast<int>(begin); v < end; ++v)
    {
      largest[v] = error.at(v).largest;
    }
  });
  std::vector<int> order;
  for (int v = 0; v < n; ++v)
  {
    if (largest[v] > 0)
    {
      order.push_back(v);
    }
  }
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return largest[a] > largest[b] || (largest[a] == largest[b] && a < b); });
  order.resize(std::min(order.size(), static_cast<std::size_t>(share * n)));
  int moved = 0;
  for (int v : order)
  {
    moved += moveNearer(mesh, error, v, minimumAngle) ? 1 : 0;
    for (int u : ringOf(mesh, v))
    {
      moved += moveNearer(mesh, error, u, minimumAngle) ? 1 : 0;
    }
    const double far = FarAway * meanEdgeLength(mesh, v);
    if (error.at(v).largest > far * far)
    {
      for (int edge : edgesAbout(mesh, v))
      {
        moved += swapNearer(mesh, error, edge) ? 1 : 0;
      }
    }
  }
  return moved;
}
}
