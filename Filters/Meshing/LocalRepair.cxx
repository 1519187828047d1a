// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalRepair.h"

#include "EdgeSwaps.h"
#include "Relaxation.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
using Halfedge = OptimizedMesh::Halfedge;

/// A vertex and a triangle whose normals' cosine is below this face away from each other.
constexpr double WorstCosine = -0.3;

std::array<int, 3> corners(const OptimizedMesh& mesh, int f)
{
  const auto& graph = mesh.graph();
  const Halfedge h = graph.halfedge_handle(OpenMesh::FaceHandle(f));
  return { { graph.from_vertex_handle(h).idx(), graph.to_vertex_handle(h).idx(),
    graph.to_vertex_handle(graph.next_halfedge_handle(h)).idx() } };
}

double faceQuality(const OptimizedMesh& mesh, int f)
{
  const auto t = corners(mesh, f);
  return triangleQuality(mesh, t[0], t[1], t[2]);
}

/// Calls visit(f) for every triangle about v.
template <typename Visit>
void forEachFace(const OptimizedMesh& mesh, int v, const Visit& visit)
{
  const auto& graph = mesh.graph();
  const Halfedge first = graph.halfedge_handle(OptimizedMesh::Vertex(v));
  Halfedge h = first;
  do
  {
    if (!graph.is_boundary(h))
    {
      visit(graph.face_handle(h).idx());
    }
    h = graph.next_halfedge_handle(graph.opposite_halfedge_handle(h));
  } while (h != first);
}

bool improveBySwap(OptimizedMesh& mesh, int f)
{
  const auto& graph = mesh.graph();
  Halfedge h = graph.halfedge_handle(OpenMesh::FaceHandle(f));
  for (int k = 0; k < 3; ++k, h = graph.next_halfedge_handle(h))
  {
    const int edge = graph.edge_handle(h).idx();
    if (!mesh.isSwappable(edge))
    {
      continue;
    }
    const Halfedge g = graph.opposite_halfedge_handle(h);
    const int a = graph.from_vertex_handle(h).idx();
    const int b = graph.to_vertex_handle(h).idx();
    const int c = graph.to_vertex_handle(graph.next_halfedge_handle(h)).idx();
    const int d = graph.to_vertex_handle(graph.next_halfedge_handle(g)).idx();
    const double before = std::min(triangleQuality(mesh, a, b, c), triangleQuality(mesh, b, a, d));
    const double after = std::min(triangleQuality(mesh, d, c, a), triangleQuality(mesh, c, d, b));
    if (after > before + 1e-9 && mesh.swap(edge))
    {
      return true;
    }
  }
  return false;
}
}

bool improveByMove(OptimizedMesh& mesh, int v)
{
  double best = starQuality(mesh, v);
  const double start = best;
  const auto accept = [&]() {
    if (!starExceeds(mesh, v, best + 1e-6))
    {
      return false;
    }
    best = starQuality(mesh, v);
    return true;
  };
  double reach = 0;
  int count = 0;
  Vec3 centre = Vec3::Zero();
  forEachFace(mesh, v, [&](int f) {
    for (int u : corners(mesh, f))
    {
      if (u != v)
      {
        centre += mesh.position(u);
        reach += (mesh.position(u) - mesh.position(v)).norm();
        ++count;
      }
    }
  });
  centre /= count;
  reach /= count;
  if (mesh.freedom(v) == Freedom::Backbone)
  {
    for (double size : { 0.2, 0.05 })
    {
      while (mesh.slideOne(v, size * reach, accept) || mesh.slideOne(v, -size * reach, accept))
      {
      }
    }
    return best > start;
  }
  if (mesh.freedom(v) != Freedom::Surface)
  {
    return false;
  }
  // Where relaxation would go and to the middle of the ring; then a pattern search about the place.
  for (const double share : { 1., 0.5 })
  {
    mesh.moveOne(v, share * (centre - mesh.position(v)), accept);
    mesh.moveOne(v, share * lloydStep(mesh, v), accept);
  }
  // A vertex that has slipped far out of its ring comes back by the way from its neighbours.
  std::vector<int> ring;
  forEachFace(mesh, v, [&](int f) {
    for (int u : corners(mesh, f))
    {
      if (u != v && mesh.freedom(u) == Freedom::Surface)
      {
        ring.push_back(u);
      }
    }
  });
  for (int u : ring)
  {
    mesh.moveOne(v, mesh.place(u), centre - mesh.position(u), accept);
  }
  for (double size = 0.2; size > 0.01; size *= 0.5)
  {
    const Vec3& n = mesh.normal(v);
    const Vec3 e = n.unitOrthogonal();
    const Vec3 g = n.cross(e);
    for (int k = 0; k < 8; ++k)
    {
      const double angle = k * 0.785398163397448;
      mesh.moveOne(v, size * reach * (std::cos(angle) * e + std::sin(angle) * g), accept);
    }
  }
  return best > start;
}

double starQuality(const OptimizedMesh& mesh, int v)
{
  double worst = 10;
  double folded = 0;
  forEachFace(mesh, v, [&](int f) {
    const double q = faceQuality(mesh, f);
    worst = std::min(worst, q);
    folded += std::min(0., q);
  });
  return folded < 0 ? folded : worst;
}

bool starExceeds(const OptimizedMesh& mesh, int v, double bound)
{
  if (bound < 0)
  {
    return starQuality(mesh, v) > bound;
  }
  const auto& graph = mesh.graph();
  const Halfedge first = graph.halfedge_handle(OptimizedMesh::Vertex(v));
  Halfedge h = first;
  do
  {
    if (!graph.is_boundary(h) && !(faceQuality(mesh, graph.face_handle(h).idx()) > bound))
    {
      return false;
    }
    h = graph.next_halfedge_handle(graph.opposite_halfedge_handle(h));
  } while (h != first);
  return true;
}

double triangleQuality(const OptimizedMesh& mesh, int a, int b, int c)
{
  const Vec3& p = mesh.position(a);
  const Vec3& q = mesh.position(b);
  const Vec3& r = mesh.position(c);
  const Vec3 u = q - p;
  const Vec3 w = r - q;
  const Vec3 z = p - r;
  const Vec3 n = u.cross(-z);
  const double area = n.norm();
  const double cosine = mesh.agreement(a, b, c, n);
  if (cosine < OptimizedMesh::minimumAgreement())
  {
    return cosine - 1.;
  }
  // A vertex that has slipped out of its ring turns its back on some of its triangles, though these
  // may agree on average.
  for (int v : { a, b, c })
  {
    const double own = mesh.freedom(v) == Freedom::Surface ? n.dot(mesh.normal(v)) : 0.;
    if (own < WorstCosine * area)
    {
      return own / area;
    }
  }
  // The smallest angle is opposite to the shortest edge.
  const double uu = u.squaredNorm();
  const double ww = w.squaredNorm();
  const double zz = z.squaredNorm();
  const double dot = uu <= ww && uu <= zz ? w.dot(z) : ww <= zz ? u.dot(z) : u.dot(w);
  return std::atan2(area, -dot);
}

int repairTriangles(
  OptimizedMesh& mesh, double threshold, bool maySwap, bool mayMove, int maximumNumberOfPasses)
{
  const int n = mesh.numberOfFaces();
  int bad = 0;
  std::vector<char> isGood(n, 0); // as far as known: no one has touched the triangle since
  const auto touch = [&](int v) { forEachFace(mesh, v, [&](int f) { isGood[f] = 0; }); };
  for (int pass = 0; pass < maximumNumberOfPasses; ++pass)
  {
    vtkSMPTools::For(0, n, 1024, [&](vtkIdType begin, vtkIdType end) {
      for (int f = static_cast<int>(begin); f < end; ++f)
      {
        isGood[f] = isGood[f] || faceQuality(mesh, f) >= threshold ? 1 : 0;
      }
    });
    bad = 0;
    bool changed = false;
    for (int f = 0; f < n; ++f)
    {
      if (isGood[f] || faceQuality(mesh, f) >= threshold)
      {
        continue;
      }
      ++bad;
      if (maySwap && improveBySwap(mesh, f))
      {
        changed = true;
        for (int v : corners(mesh, f))
        {
          touch(v);
        }
        if (faceQuality(mesh, f) >= threshold)
        {
          continue;
        }
      }
      const auto t = corners(mesh, f);
      for (int k = 0; mayMove && k < 3 && faceQuality(mesh, f) < threshold; ++k)
      {
        changed = improveByMove(mesh, t[k]) || changed;
        touch(t[k]);
      }
      // The neighbours of a fold may stand in the way.
      for (int k = 0; mayMove && k < 3 && faceQuality(mesh, f) < 0; ++k)
      {
        std::vector<int> ring;
        forEachFace(mesh, t[k], [&](int g) {
          for (int u : corners(mesh, g))
          {
            ring.push_back(u);
          }
        });
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        for (int u : ring)
        {
          changed = improveByMove(mesh, u) || changed;
          touch(u);
        }
      }
    }
    if (!changed)
    {
      break;
    }
  }
  return bad;
}

namespace
{
/// What a vertex costs whose valence is off by `excess`: one too many or too few is as good as any.
int irregularity(int excess)
{
  const int beyond = std::abs(excess) - 1;
  return beyond > 0 ? 1 + beyond * beyond : 0;
}

/// What one neighbour too many beside a crease weighs against irregular vertices elsewhere.
constexpr int RibWeight = 8;

/// Where a triangle is worse than this (radians), valences are the lesser worry.
constexpr double LeastQuality = 0.05;

/// Swaps an edge and moves the vertices about it until all triangles there are good; false, and
/// nothing is changed, if that does not succeed.
bool swapAndSettle(OptimizedMesh& mesh, int edge, double threshold)
{
  const auto& graph = mesh.graph();
  const Halfedge h = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
  const Halfedge g = graph.opposite_halfedge_handle(h);
  const std::array<int, 4> quad = { { graph.from_vertex_handle(h).idx(),
    graph.to_vertex_handle(h).idx(), graph.to_vertex_handle(graph.next_halfedge_handle(h)).idx(),
    graph.to_vertex_handle(graph.next_halfedge_handle(g)).idx() } };
  std::vector<int> movable;
  for (int v : quad)
  {
    forEachFace(mesh, v, [&](int f) {
      for (int u : corners(mesh, f))
      {
        if (mesh.freedom(u) == Freedom::Surface)
        {
          movable.push_back(u);
        }
      }
    });
  }
  std::sort(movable.begin(), movable.end());
  movable.erase(std::unique(movable.begin(), movable.end()), movable.end());
  std::vector<SurfacePlace> before;
  for (int v : movable)
  {
    before.push_back(mesh.place(v));
  }
  const auto worst = [&]() {
    double q = 10;
    for (int v : movable)
    {
      q = std::min(q, starQuality(mesh, v));
    }
    for (int v : quad)
    {
      q = std::min(q, starQuality(mesh, v));
    }
    return q;
  };
  const double wanted = std::min(threshold, worst());
  if (wanted < LeastQuality)
  {
    return false;
  }
  mesh.forceSwap(edge);
  constexpr int Rounds = 4;
  for (int round = 0; round < Rounds; ++round)
  {
    bool changed = false;
    for (int v : movable)
    {
      if (starQuality(mesh, v) < threshold)
      {
        changed = improveByMove(mesh, v) || changed;
      }
    }
    if (worst() >= wanted)
    {
      return true;
    }
    if (!changed)
    {
      break;
    }
  }
  mesh.forceSwap(edge);
  for (std::size_t i = 0; i < movable.size(); ++i)
  {
    mesh.moveOne(movable[i], before[i], Vec3::Zero(), []() { return true; });
  }
  return false;
}
}

int repairValences(OptimizedMesh& mesh, double threshold, int maximumNumberOfPasses, bool ribs)
{
  const auto& graph = mesh.graph();
  // A swap can only gain where one of the four valences is bad.
  std::vector<char> isRegular(mesh.numberOfVertices());
  const auto look = [&](int v) {
    isRegular[v] = mesh.freedom(v) == Freedom::Surface &&
      !graph.is_boundary(OptimizedMesh::Vertex(v)) && irregularity(mesh.valence(v) - 6) == 0;
  };
  vtkSMPTools::For(0, mesh.numberOfVertices(), 1024, [&](vtkIdType begin, vtkIdType end) {
    for (int v = static_cast<int>(begin); v < end; ++v)
    {
      look(v);
    }
  });
  int total = 0;
  for (int pass = 0; pass < maximumNumberOfPasses; ++pass)
  {
    int swaps = 0;
    for (int edge = 0; edge < mesh.numberOfEdges(); ++edge)
    {
      if (!mesh.isSwappable(edge))
      {
        continue;
      }
      const Halfedge h = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
      const Halfedge g = graph.opposite_halfedge_handle(h);
      const std::array<Halfedge, 4> corner = { { h, g, graph.prev_halfedge_handle(h),
        graph.prev_halfedge_handle(g) } };
      std::array<int, 4> quad;
      for (int i = 0; i < 4; ++i)
      {
        quad[i] = graph.from_vertex_handle(corner[i]).idx();
      }
      if (std::all_of(quad.begin(), quad.end(), [&](int v) { return isRegular[v] != 0; }))
      {
        continue;
      }
      int change = 0;
      for (int i = 0; i < 4; ++i)
      {
        const bool isRib = ribs && mesh.freedom(quad[i]) == Freedom::Backbone;
        const int before = isRib ? ribExcess(mesh, corner[i]) : valenceExcess(mesh, corner[i]);
        const int after = before + (i < 2 ? -1 : 1);
        change += isRib ? RibWeight * (after * after - before * before)
                        : irregularity(after) - irregularity(before);
      }
      if (change < 0 && graph.is_flip_ok(OpenMesh::EdgeHandle(edge)) &&
        swapAndSettle(mesh, edge, threshold))
      {
        ++swaps;
        std::for_each(quad.begin(), quad.end(), look);
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
