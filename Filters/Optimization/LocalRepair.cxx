// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalRepair.h"

#include "EdgeSwaps.h"
#include "Relaxation.h"
#include "VertexStar.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
using HalfedgeHandle = OptimizedMesh::Halfedge;

/// Vertices of worse triangles (radians) may have got to the wrong side of a crease.
constexpr double SliverAngle = 0.003;

/// By how much (radians) a place may be better than the tangent plane has it.
constexpr double PromisedAngle = 0.05;

bool improveBySwap(OptimizedMesh& mesh, int f)
{
  const auto& graph = mesh.graph();
  HalfedgeHandle h = graph.halfedge_handle(OpenMesh::FaceHandle(f));
  for (int k = 0; k < 3; ++k, h = graph.next_halfedge_handle(h))
  {
    const int edge = graph.edge_handle(h).idx();
    if (!mesh.isSwappable(edge))
    {
      continue;
    }
    const HalfedgeHandle g = graph.opposite_halfedge_handle(h);
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
  const VertexStar star(mesh, v);
  double best = star.quality(mesh.footing(v));
  const double start = best;
  const auto isBetter = [&](const Footing& there) {
    if (!star.exceeds(there, best + 1e-6))
    {
      return false;
    }
    best = star.quality(there);
    return true;
  };
  double reach = 0;
  int count = 0;
  Vec3 centre = Vec3::Zero(); // each neighbour weighs as much as it has triangles here
  std::vector<int> ring;
  mesh.forEachFace(v, [&](int f) {
    for (int u : mesh.corners(f))
    {
      if (u != v)
      {
        if (std::find(ring.begin(), ring.end(), u) == ring.end())
        {
          ring.push_back(u);
        }
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
    const auto accept = [&]() { return isBetter(mesh.footing(v)); };
    for (double size : { 0.2, 0.05 })
    {
      while (mesh.trySlide(v, size * reach, accept) || mesh.trySlide(v, -size * reach, accept))
      {
      }
    }
    return best > start;
  }
  if (mesh.freedom(v) != Freedom::Surface)
  {
    return false;
  }
  const auto attempt = [&](const SurfacePlace& from, const Vec3& step, bool isNear = false) {
    // Walks take most of the time: where the tangent plane promises far less, there is none.
    if (isNear && best > PromisedAngle)
    {
      Footing promised = mesh.footing(v);
      promised.position += step;
      if (!star.exceeds(promised, best - PromisedAngle))
      {
        return;
      }
    }
    const Footing there = mesh.footing(from, step);
    if (isBetter(there))
    {
      mesh.put(v, there);
    }
  };
  // Where relaxation would go and to the middle of the ring; then a pattern search about the place.
  for (const double share : { 1., 0.5 })
  {
    attempt(mesh.place(v), share * (centre - mesh.position(v)));
    attempt(mesh.place(v), share * lloydStep(mesh, v));
  }
  // A vertex that has slipped far out of its ring comes back by the way from its neighbours.
  for (int u : ring)
  {
    if (best < SliverAngle && mesh.freedom(u) == Freedom::Surface)
    {
      const Footing there = mesh.footing(mesh.place(u), centre - mesh.position(u));
      if ((there.position - centre).norm() < reach && isBetter(there))
      {
        mesh.put(v, there);
      }
    }
  }
  for (double size = 0.2; size > 0.01; size *= 0.5)
  {
    const Vec3& n = mesh.normal(v);
    const Vec3 e = n.unitOrthogonal();
    const Vec3 g = n.cross(e);
    for (int k = 0; k < 8; ++k)
    {
      const double angle = k * 0.785398163397448;
      attempt(mesh.place(v), size * reach * (std::cos(angle) * e + std::sin(angle) * g), true);
    }
  }
  return best > start;
}

int repairTriangles(
  OptimizedMesh& mesh, double threshold, bool maySwap, bool mayMove, int maximumNumberOfPasses)
{
  const int n = mesh.numberOfFaces();
  int bad = 0;
  enum class Known : char
  {
    Nothing,
    Good,
    Stuck ///< nothing that its repair looks at has changed since it failed
  };
  std::vector<Known> known(n, Known::Nothing);
  const auto touch = [&](int v) {
    mesh.forEachFace(v, [&](int f) {
      known[f] = Known::Nothing;
      for (int u : mesh.corners(f))
      {
        mesh.forEachFace(
          u, [&](int g) { known[g] = known[g] == Known::Stuck ? Known::Nothing : known[g]; });
      }
    });
  };
  const auto improve = [&](int v) {
    const bool moved = improveByMove(mesh, v);
    if (moved)
    {
      touch(v);
    }
    return moved;
  };
  for (int pass = 0; pass < maximumNumberOfPasses; ++pass)
  {
    vtkSMPTools::For(0, n, 1024, [&](vtkIdType begin, vtkIdType end) {
      for (int f = static_cast<int>(begin); f < end; ++f)
      {
        if (known[f] == Known::Nothing && faceQuality(mesh, f) >= threshold)
        {
          known[f] = Known::Good;
        }
      }
    });
    bad = 0;
    bool changed = false;
    for (int f = 0; f < n; ++f)
    {
      if (known[f] == Known::Good ||
        (known[f] == Known::Nothing && faceQuality(mesh, f) >= threshold))
      {
        continue;
      }
      ++bad;
      if (known[f] == Known::Stuck)
      {
        continue;
      }
      bool helped = false;
      if (maySwap && improveBySwap(mesh, f))
      {
        changed = helped = true;
        for (int v : mesh.corners(f))
        {
          touch(v);
        }
        if (faceQuality(mesh, f) >= threshold)
        {
          continue;
        }
      }
      const auto t = mesh.corners(f);
      for (int k = 0; mayMove && k < 3 && faceQuality(mesh, f) < threshold; ++k)
      {
        helped = improve(t[k]) || helped;
      }
      const bool isFold = faceQuality(mesh, f) < 0;
      // The neighbours of a fold may stand in the way.
      for (int k = 0; mayMove && k < 3 && faceQuality(mesh, f) < 0; ++k)
      {
        std::vector<int> ring;
        mesh.forEachFace(t[k], [&](int g) {
          for (int u : mesh.corners(g))
          {
            ring.push_back(u);
          }
        });
        makeUnique(ring);
        for (int u : ring)
        {
          helped = improve(u) || helped;
        }
      }
      changed = changed || helped;
      if (!helped && !isFold)
      {
        known[f] = Known::Stuck;
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
/// Where a triangle is worse than this (radians), valences are the lesser worry.
constexpr double LeastQuality = 0.05;

/// Swaps an edge and moves the vertices about it until all triangles there are good; false, and
/// nothing is changed, if that does not succeed.
bool swapAndSettle(OptimizedMesh& mesh, int edge, double threshold)
{
  const auto& graph = mesh.graph();
  const HalfedgeHandle h = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
  const HalfedgeHandle g = graph.opposite_halfedge_handle(h);
  const std::array<int, 4> quad = { { graph.from_vertex_handle(h).idx(),
    graph.to_vertex_handle(h).idx(), graph.to_vertex_handle(graph.next_halfedge_handle(h)).idx(),
    graph.to_vertex_handle(graph.next_halfedge_handle(g)).idx() } };
  std::vector<int> movable;
  for (int v : quad)
  {
    mesh.forEachFace(v, [&](int f) {
      for (int u : mesh.corners(f))
      {
        if (mesh.freedom(u) == Freedom::Surface)
        {
          movable.push_back(u);
        }
      }
    });
  }
  makeUnique(movable);
  std::vector<Footing> before;
  for (int v : movable)
  {
    before.push_back(mesh.footing(v));
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
    mesh.put(movable[i], before[i]);
  }
  return false;
}
}

int repairValences(OptimizedMesh& mesh, double threshold, int maximumNumberOfPasses)
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
      const HalfedgeHandle h = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
      const HalfedgeHandle g = graph.opposite_halfedge_handle(h);
      const std::array<HalfedgeHandle, 4> corner = { { h, g, graph.prev_halfedge_handle(h),
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
        const int before = valenceExcess(mesh, corner[i]);
        change += irregularity(before + (i < 2 ? -1 : 1)) - irregularity(before);
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

namespace
{
/// Squared sides of a triangle, under the wanted density.
double squaresOf(const OptimizedMesh& mesh, int a, int b, int c)
{
  const Vec3& p = mesh.position(a);
  const Vec3& q = mesh.position(b);
  const Vec3& r = mesh.position(c);
  return (mesh.density(a) + mesh.density(b) + mesh.density(c)) / 3. *
    ((q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm());
}

/// Sum over the triangles about v of the squares of that: least where they are alike and regular.
double unevenness(const OptimizedMesh& mesh, int v)
{
  double sum = 0;
  mesh.forEachFace(v, [&](int f) {
    const auto t = mesh.corners(f);
    const double s = squaresOf(mesh, t[0], t[1], t[2]);
    sum += s * s;
  });
  return sum;
}
}

void evenOut(OptimizedMesh& mesh, const std::vector<int>& vertices, double enough, int rounds,
  const std::function<bool(int)>& accept)
{
  for (int round = 0; round < rounds; ++round)
  {
    for (int v : vertices)
    {
      const VertexStar star(mesh, v);
      const double bound = std::min(enough, starQuality(mesh, v)) - 1e-9;
      const Vec3& x = mesh.position(v);
      const double before = unevenness(mesh, v);
      const auto isBetter = [&]() {
        return star.exceeds(mesh.footing(v), bound) && unevenness(mesh, v) < before && accept(v);
      };
      Vec3 sum = Vec3::Zero();
      double total = 0;
      mesh.forEachFace(v, [&](int f) {
        const auto t = mesh.corners(f);
        const double s = squaresOf(mesh, t[0], t[1], t[2]);
        sum += s * (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2]) - 3. * x);
        total += 2. * s;
      });
      const Vec3 step = sum / total;
      if (mesh.freedom(v) == Freedom::Backbone)
      {
        const double length = step.norm();
        mesh.trySlide(v, length, isBetter) || mesh.trySlide(v, -length, isBetter) ||
          mesh.trySlide(v, 0.3 * length, isBetter) || mesh.trySlide(v, -0.3 * length, isBetter);
        continue;
      }
      for (const double share : { 1., 0.5, 0.2 })
      {
        if (mesh.tryOut(v, mesh.footing(mesh.place(v), share * step), isBetter))
        {
          break;
        }
      }
    }
  }
}
}
