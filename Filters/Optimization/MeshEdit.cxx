// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshEdit.h"

#include "MeshCrossings.h"
#include "ParallelFor.h"
#include "Tuning.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stipple
{
bool MeshEdit::swap(Edge e)
{
  const OptimizedMesh& mesh = this->Edited;
  if (!mesh.isSwappable(e) || !mesh.keepsManifold(e) || !this->maySwap(e))
  {
    return false;
  }
  const auto [a, b, c, d] = mesh.wing(e);
  const int after = mesh.isSound({ { d, c, a } }) + mesh.isSound({ { c, d, b } });
  if (after < 2 && after < mesh.isSound({ { a, b, c } }) + mesh.isSound({ { b, a, d } }))
  {
    return false;
  }
  // Edges of the boundary are not swapped: from a triangle without an area beside one, as at the
  // tip of a slit, hardly a way leads on.
  const auto isFlatAtBoundary = [&mesh](Halfedge corner, const TriangleCorners& triangle) {
    return mesh.isBoundary(mesh.from(corner)) && mesh.isFlat(triangle);
  };
  if (isFlatAtBoundary(a, { { d, c, a } }) || isFlatAtBoundary(b, { { c, d, b } }))
  {
    return false;
  }
  if (!swapStaysApart(mesh, e))
  {
    return false;
  }
  this->flip(e);
  return true;
}

void MeshEdit::flip(Edge e)
{
  this->Edited.Graph.flip(OptimizedMesh::raw(e));
  if (this->Depth > 0)
  {
    this->Log.push_back({ e, Vertex(), {} });
  }
}

void MeshEdit::put(Vertex v, const SurfacePoint& there)
{
  this->note(v);
  this->Edited.put(v, there);
}

void MeshEdit::slide(Vertex v, double step)
{
  this->note(v);
  this->Edited.putOnBackbone(v, this->Edited.arcLength(v) + step);
}

void MeshEdit::note(Vertex v)
{
  if (this->Depth > 0)
  {
    this->Log.push_back({ Edge(), v, this->Edited.state(v) });
  }
}

void MeshEdit::undo(std::size_t begin)
{
  for (; this->Log.size() > begin; this->Log.pop_back())
  {
    const Change& change = this->Log.back();
    if (change.flipped.valid())
    {
      // A flip turns the edge by a quarter: one more would leave it turned around, and its two
      // triangles exchanged, which others know by their ids.
      for (int quarter = 1; quarter < 4; ++quarter)
      {
        this->Edited.Graph.flip(OptimizedMesh::raw(change.flipped));
      }
    }
    else
    {
      this->Edited.State[change.moved] = change.before;
    }
  }
}

bool MeshEdit::hasRoom(Vertex v, double step) const
{
  const OptimizedMesh& mesh = this->Edited;
  if (mesh.freedom(v) != Freedom::Backbone || !this->mayMove(v))
  {
    return false;
  }
  double room = 1e300; // to its neighbours on the backbone
  mesh.forEachHalfedge(v, [&](Halfedge h) {
    if (mesh.isCrease(mesh.edge(h)))
    {
      room = std::min(room, (mesh.position(mesh.to(h)) - mesh.position(v)).norm());
    }
  });
  const double length = mesh.atlas().traces()[mesh.backbone(v)].length();
  const double target = mesh.arcLength(v) + step;
  const bool closed = mesh.atlas().graph().backbones[mesh.backbone(v)].closed;
  return std::abs(step) <= 0.5 * room && (closed || (target > 0 && target < length));
}

std::array<Vec3, 8> MeshEdit::stepsAround(Vertex v, double length) const
{
  const Vec3& n = this->Edited.normal(v);
  const Vec3 e = n.unitOrthogonal();
  const Vec3 g = n.cross(e);
  std::array<Vec3, 8> steps;
  for (int k = 0; k < 8; ++k)
  {
    const double angle = k * 0.785398163397448;
    steps[k] = length * (std::cos(angle) * e + std::sin(angle) * g);
  }
  return steps;
}

void MeshEdit::moveAll(
  ElementArray<Vertex, Vec3>& step, const ElementArray<Vertex, double>& arcLength)
{
  OptimizedMesh& mesh = this->Edited;
  const SurfaceWalk& surface = mesh.surfaceWalk();
  this->Before.resize(mesh.State.size());
  ElementArray<Vertex, double> share(mesh.State.size(), 1.);
  std::vector<Vertex> drawnBack;
  const auto walk = [&](Vertex v) {
    const VertexState& before = this->Before[v];
    if (!this->mayMove(v))
    {
      return;
    }
    if (mesh.freedom(v) == Freedom::Backbone)
    {
      mesh.putOnBackbone(v, before.arcLength + share[v] * (arcLength[v] - before.arcLength));
    }
    else if (mesh.isFree(v))
    {
      mesh.State[v].place =
        share[v] > 0 ? surface.walk(before.place, share[v] * step[v]) : before.place;
    }
  };
  const auto arrive = [&](Vertex v) {
    if (mesh.isFree(v) && this->mayMove(v))
    {
      mesh.put(v, mesh.pointAt(mesh.place(v)));
    }
  };
  const auto moveVertex = [&](Vertex v) {
    walk(v);
    arrive(v);
  };
  // Most of the time is spent waiting for memory. So faces are fetched ahead, and what is asked for
  // where vertices arrive, one independent of the other, is asked for in a loop of its own.
  constexpr int Ahead = 4;
  parallelForBlocks(mesh.vertices(), [&](const ElementRange<Vertex>& block) {
    const Vertex last((*block.end()).index() - 1);
    for (const Vertex v : block)
    {
      surface.prefetch(mesh.place(std::min(Vertex(v.index() + Ahead), last)).face);
      this->Before[v] = mesh.State[v];
      walk(v);
      const Face there(mesh.place(v).face);
      __builtin_prefetch(&mesh.smoothNormal(there.index()));
      __builtin_prefetch(&mesh.atlas().surface().uv[halfedgeOf(there, 0)]);
      __builtin_prefetch(&mesh.atlas().surface().faceChart[there]);
    }
    std::for_each(block.begin(), block.end(), arrive);
  });
  // Triangles that are unsound now, and were not, draw their vertices back: to a half, a quarter,
  // at last all the way.
  ElementArray<Face, char> isSoundNow(static_cast<std::size_t>(mesh.faces().size()));
  const auto look = [&](Face f) { isSoundNow[f] = mesh.isSound(f); };
  parallelFor(mesh.faces(), look);
  for (int round = 0; round < Tuning::RoundsOfDrawingBack; ++round)
  {
    // Most rounds end here; only now look back at how the few were before.
    std::vector<Vertex> back;
    std::swap(mesh.State, this->Before);
    for (const Face f : mesh.faces())
    {
      if (!isSoundNow[f] && mesh.isSound(f))
      {
        const auto corners = mesh.corners(f);
        back.insert(back.end(), corners.begin(), corners.end());
      }
    }
    std::swap(mesh.State, this->Before);
    makeUnique(back);
    for (const Vertex v : back)
    {
      share[v] = round < 2 ? 0.5 * share[v] : 0.;
      moveVertex(v);
    }
    for (const Vertex v : back) // no other triangle is another one now
    {
      mesh.forEachFace(v, look);
    }
    drawnBack.insert(drawnBack.end(), back.begin(), back.end());
    if (back.empty())
    {
      break;
    }
    if (round + 1 == Tuning::RoundsOfDrawingBack) // it spread on and on
    {
      std::fill(share.begin(), share.end(), 0.);
      std::for_each(mesh.vertices().begin(), mesh.vertices().end(), moveVertex);
    }
  }
  for (const Vertex v : drawnBack) // no momentum into what was refused
  {
    step[v] = Vec3::Zero();
  }
}
}
