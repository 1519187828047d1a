// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceError.h"

#include "LocalRepair.h"
#include "MeshRegion.h"
#include "ParallelFor.h"
#include "Relaxation.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace stipple
{
SurfaceError::SurfaceError(const OptimizedMesh& mesh)
  : Mesh(mesh)
{
  const AtlasSurface& surface = mesh.atlas().surface();
  const CompressedRows<int>& neighbours = mesh.atlas().vertexNeighbours().of;
  const int n = static_cast<int>(surface.points.size());
  std::vector<Vertex> owner(n);
  std::vector<double> distance(n, 1e300);
  std::deque<int> queue;
  const auto offer = [&](int p, Vertex v) {
    const double d = (surface.points[p] - mesh.position(v)).squaredNorm();
    if (d < distance[p])
    {
      distance[p] = d;
      owner[p] = v;
      queue.push_back(p);
    }
  };
  for (const Vertex v : mesh.vertices())
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
    for (const int neighbour : neighbours[p])
    {
      offer(neighbour, owner[p]);
    }
  }
  this->Points = CompressedRows<int>(mesh.vertices().size(), [&](const auto& add) {
    for (int p = 0; p < n; ++p)
    {
      if (owner[p].valid())
      {
        add(owner[p].index(), p);
      }
    }
  });
}

SurfaceError::Measure SurfaceError::at(Vertex v) const
{
  return this->atUpTo(v, 0., { 1e300, 1e300, -1 });
}

SurfaceError::Measure SurfaceError::atUpTo(Vertex v, double sumOfOthers, const Measure& bound) const
{
  Measure result;
  const OptimizedMesh& mesh = this->Mesh;
  std::vector<std::array<const Vec3*, 2>> edges; // of the triangles, opposite to v
  edges.reserve(8);
  mesh.forEachCorner(v, [&](Halfedge h) {
    edges.push_back({ { &mesh.position(mesh.to(h)), &mesh.position(mesh.apex(h)) } });
  });
  for (const int point : this->Points[v.index()])
  {
    if (sumOfOthers + result.sum >= bound.sum || result.largest > bound.largest)
    {
      break;
    }
    const Vec3& p = mesh.atlas().surface().points[point];
    double least = 1e300;
    for (const auto& [q, r] : edges)
    {
      least = std::min(least, squaredDistanceToTriangle(p, mesh.position(v), *q, *r));
    }
    result.sum += least;
    if (least > result.largest)
    {
      result.largest = least;
      result.farthest = point;
    }
  }
  return result;
}

SurfaceError::Measure SurfaceError::about(Vertex v) const
{
  return this->aboutUpTo(v, { 1e300, 1e300, -1 });
}

SurfaceError::Measure SurfaceError::aboutUpTo(Vertex v, const Measure& bound) const
{
  Measure result = this->atUpTo(v, 0., bound);
  const Halfedge first = this->Mesh.halfedge(v);
  Halfedge h = first;
  do
  {
    const Measure m = this->atUpTo(this->Mesh.to(h), result.sum, bound);
    result.sum += m.sum;
    if (m.largest > result.largest)
    {
      result.largest = m.largest;
      result.farthest = m.farthest;
    }
    h = this->Mesh.next(this->Mesh.opposite(h));
  } while (h != first && result.sum < bound.sum && result.largest <= bound.largest);
  return result;
}

namespace
{
/// Smallest and largest area of the triangles about a vertex.
std::pair<double, double> areasAbout(const OptimizedMesh& mesh, Vertex v)
{
  double smallest = 1e300;
  double largest = 0;
  mesh.forEachCorner(v, [&](Halfedge h) {
    const double area =
      triangleArea(mesh.position(v), mesh.position(mesh.to(h)), mesh.position(mesh.apex(h)));
    smallest = std::min(smallest, area);
    largest = std::max(largest, area);
  });
  return { smallest, largest };
}

/// The mesh cuts off a tip there: a point of the surface is that far away.
bool isTip(const OptimizedMesh& mesh, Vertex v, const SurfaceError::Measure& error)
{
  const double far = Tuning::DistanceOfTip * meanEdgeLength(mesh, v);
  return error.largest > far * far;
}

bool moveNearer(MeshEdit& edit, const SurfaceError& error, Vertex v, double minimumAngle)
{
  const OptimizedMesh& mesh = edit.mesh();
  if (!edit.mayMove(v))
  {
    return false;
  }
  SurfaceError::Measure best = error.about(v);
  const bool atTip = isTip(mesh, v, best);
  const double reach = meanEdgeLength(mesh, v);
  const VertexStar star(mesh, v);
  const double quality = std::min(minimumAngle, star.quality(mesh.state(v)));
  if (quality < Tuning::HopelessAngle)
  {
    return false;
  }
  const double evenness = atTip ? Tuning::EvennessAtTip : Tuning::EvennessOfAreas;
  const auto [smallest, largest] = areasAbout(mesh, v);
  const double mean = 0.5 * (smallest + largest);
  const double least = std::min(smallest, evenness * mean);
  const double most = std::max(largest, mean / evenness);
  bool changed = false;
  const auto isNearer = [&]() {
    const auto area = areasAbout(mesh, v);
    if (area.first < least || area.second > most)
    {
      return false;
    }
    const SurfaceError::Measure bound = { (1. - Tuning::LeastGainOfError) * best.sum, best.largest,
      -1 };
    const SurfaceError::Measure e = error.aboutUpTo(v, bound);
    if (e.sum >= bound.sum || e.largest > bound.largest)
    {
      return false;
    }
    best = e;
    changed = true;
    return true;
  };
  const auto isSound = [&](const SurfacePoint& there) {
    return star.exceeds(there, quality - Tuning::RoundingOfAngle);
  };
  const auto attempt = [&](const SurfacePoint& there) {
    if (isSound(there))
    {
      edit.tryPut(v, there, isNearer);
    }
  };
  if (mesh.isFree(v) && best.farthest >= 0)
  {
    attempt(mesh.pointAt(mesh.atlas().placeOfPoint(best.farthest)));
  }
  for (const double size : Tuning::ErrorSizes)
  {
    edit.tryAround(
      v, size * reach, [&](const Vec3& step) { attempt(mesh.walk(mesh.place(v), step)); },
      [&]() { return isSound(mesh.state(v)) && isNearer(); });
  }
  return changed;
}

/// Swaps an edge near a tip that is cut off and moves the four vertices about it; false, and
/// nothing is changed, if that brings the mesh no nearer.
bool swapNearer(MeshEdit& edit, const SurfaceError& error, Edge e, double minimumAngle)
{
  const OptimizedMesh& mesh = edit.mesh();
  if (!mesh.isSwappable(e) || !mesh.keepsManifold(e) || !edit.maySwap(e))
  {
    return false;
  }
  const auto quad = mesh.wingVertices(e);
  if (!std::all_of(quad.begin(), quad.end(), [&](Vertex v) { return mesh.isFree(v); }))
  {
    return false;
  }
  const std::vector<Vertex> all = withRings(mesh, { quad.begin(), quad.end() }, 1);
  const std::vector<Face> faces = facesAbout(mesh, all);
  const auto errorOfAll = [&]() {
    double sum = 0;
    for (const Vertex v : all)
    {
      sum += error.at(v).sum;
    }
    return sum;
  };
  const auto irregular = [&]() {
    return std::count_if(all.begin(), all.end(),
      [&mesh](Vertex v) { return mesh.valence(v) < 5 || mesh.valence(v) > 7; });
  };
  const double sum = errorOfAll();
  const auto irregularBefore = irregular();
  const double quality = std::min(minimumAngle, worstQuality(mesh, faces));
  return quality >= Tuning::HopelessAngle && edit.attempt([&]() {
    edit.flip(e);
    for (int round = 0; round < 2 && irregular() <= irregularBefore; ++round)
    {
      for (const Vertex v : quad)
      {
        if (starQuality(mesh, v) < quality)
        {
          improveByMove(edit, v);
        }
        moveNearer(edit, error, v, minimumAngle);
      }
    }
    return irregular() <= irregularBefore && worstQuality(mesh, faces) >= quality &&
      errorOfAll() < Tuning::ErrorAfterSwap * sum;
  });
}
}

int reduceSurfaceError(MeshEdit& edit, double minimumAngle, double share)
{
  const OptimizedMesh& mesh = edit.mesh();
  const SurfaceError error(mesh);
  ElementArray<Vertex, double> largest(static_cast<std::size_t>(mesh.vertices().size()));
  parallelFor(mesh.vertices(), [&](Vertex v) { largest[v] = error.at(v).largest; });
  std::vector<Vertex> order;
  for (const Vertex v : mesh.vertices())
  {
    if (largest[v] > 0)
    {
      order.push_back(v);
    }
  }
  std::sort(order.begin(), order.end(), [&](Vertex a, Vertex b) {
    return largest[a] > largest[b] || (largest[a] == largest[b] && a < b);
  });
  order.resize(std::min(order.size(), static_cast<std::size_t>(share * mesh.vertices().size())));
  int changes = 0;
  for (const Vertex v : order)
  {
    changes += moveNearer(edit, error, v, minimumAngle) ? 1 : 0;
    mesh.forEachNeighbour(
      v, [&](Vertex u) { changes += moveNearer(edit, error, u, minimumAngle) ? 1 : 0; });
    if (!isTip(mesh, v, error.at(v)))
    {
      continue;
    }
    std::vector<Edge> edges; // of the triangles about it
    mesh.forEachHalfedge(v, [&](Halfedge h) {
      edges.push_back(mesh.edge(h));
      if (!mesh.isBoundary(h))
      {
        edges.push_back(mesh.edge(mesh.next(h)));
      }
    });
    for (const Edge e : edges)
    {
      changes += swapNearer(edit, error, e, minimumAngle) ? 1 : 0;
    }
  }
  return changes;
}
}
