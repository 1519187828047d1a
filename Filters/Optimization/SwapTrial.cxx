// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SwapTrial.h"

#include "LocalRepair.h"
#include "VertexStar.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
using HalfedgeHandle = OptimizedMesh::Halfedge;

/// Rounds of moves after swaps.
constexpr int SpreadingRounds = 3;
constexpr int SettlingRounds = 6;
/// Where a triangle is worse than this (radians), there are other worries.
constexpr double LeastQuality = 0.05;
/// Cosine between the normals of triangles that meet at no crease: below, one is folded over.
constexpr double LeastBend = 0.5;
}

std::array<HalfedgeHandle, 4> cornersAbout(const OptimizedMesh& mesh, int edge)
{
  const auto& graph = mesh.graph();
  const HalfedgeHandle h = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
  const HalfedgeHandle g = graph.opposite_halfedge_handle(h);
  return { { h, g, graph.prev_halfedge_handle(h), graph.prev_halfedge_handle(g) } };
}

void swapAll(OptimizedMesh& mesh, const std::vector<int>& edges)
{
  for (int e : edges)
  {
    mesh.forceSwap(e);
  }
}

void swapBack(OptimizedMesh& mesh, const std::vector<int>& edges)
{
  for (auto e = edges.rbegin(); e != edges.rend(); ++e)
  {
    mesh.forceSwap(*e);
  }
}

SwapTrial::SwapTrial(OptimizedMesh& mesh, const std::vector<int>& edges)
  : Mesh(mesh)
  , Edges(edges)
{
  for (int e : edges)
  {
    for (const HalfedgeHandle h : cornersAbout(mesh, e))
    {
      this->Inner.push_back(mesh.graph().from_vertex_handle(h).idx());
    }
  }
  makeUnique(this->Inner);
  std::vector<int> all = this->Inner;
  for (int v : this->Inner)
  {
    mesh.forEachNeighbour(v, [&](int u) { all.push_back(u); });
  }
  makeUnique(all);
  for (int v : all)
  {
    if (mesh.freedom(v) != Freedom::None)
    {
      this->Vertices.push_back(v);
      this->Before.push_back(standOf(mesh, v));
    }
    mesh.forEachFace(v, [&](int f) { this->Faces.push_back(f); });
  }
  makeUnique(this->Faces);
}

bool SwapTrial::settle(double minimumAngle)
{
  const double wanted = std::min(minimumAngle, this->worstQuality());
  const double bend = std::min(LeastBend, this->worstBend());
  swapAll(this->Mesh, this->Edges);
  if (wanted < LeastQuality)
  {
    return false;
  }
  // From where they stand, or from the middle of their neighbours
  bool isGood = this->improve(minimumAngle, wanted);
  if (!isGood)
  {
    this->putBack();
    this->spread();
    isGood = this->improve(minimumAngle, wanted);
  }
  return isGood && this->worstBend() >= bend;
}

void SwapTrial::takeBack()
{
  swapBack(this->Mesh, this->Edges);
  this->putBack();
}

void SwapTrial::putBack()
{
  for (std::size_t i = 0; i < this->Vertices.size(); ++i)
  {
    this->Mesh.putBack(this->Vertices[i], this->Before[i].footing, this->Before[i].arcLength);
  }
}

double SwapTrial::worstQuality() const
{
  double worst = 10;
  for (int f : this->Faces)
  {
    worst = std::min(worst, faceQuality(this->Mesh, f));
  }
  return worst;
}

/// Least cosine between neighbours of which one touches nothing but creases, so that its quality
/// does not tell folds.
double SwapTrial::worstBend() const
{
  const auto& graph = this->Mesh.graph();
  double worst = 1;
  for (int f : this->Faces)
  {
    const auto t = this->Mesh.corners(f);
    if (std::any_of(
          t.begin(), t.end(), [&](int v) { return this->Mesh.freedom(v) == Freedom::Surface; }))
    {
      continue;
    }
    HalfedgeHandle h = graph.halfedge_handle(OpenMesh::FaceHandle(f));
    for (int k = 0; k < 3; ++k, h = graph.next_halfedge_handle(h))
    {
      const HalfedgeHandle g = graph.opposite_halfedge_handle(h);
      if (this->Mesh.isSwappable(graph.edge_handle(h).idx()))
      {
        worst = std::min(
          worst, this->Mesh.faceNormal(f).dot(this->Mesh.faceNormal(graph.face_handle(g).idx())));
      }
    }
  }
  return worst;
}

/// Of its neighbours on the crease.
void SwapTrial::slideToMiddle(int v)
{
  const auto& graph = this->Mesh.graph();
  const auto unevenness = [&]() {
    std::vector<double> length;
    this->Mesh.forEachHalfedge(v, [&](HalfedgeHandle h) {
      if (this->Mesh.isFeature(graph.edge_handle(h).idx()))
      {
        length.push_back(
          (this->Mesh.position(graph.to_vertex_handle(h)) - this->Mesh.position(v)).norm());
      }
    });
    return length.size() == 2 ? std::abs(length[1] - length[0]) : 0.;
  };
  const double before = unevenness();
  const auto isBetter = [&]() { return unevenness() < before; };
  if (!this->Mesh.trySlide(v, 0.5 * before, isBetter))
  {
    this->Mesh.trySlide(v, -0.5 * before, isBetter);
  }
}

void SwapTrial::spread()
{
  for (int round = 0; round < SpreadingRounds; ++round)
  {
    for (int v : this->Vertices)
    {
      if (this->Mesh.freedom(v) == Freedom::Backbone)
      {
        this->slideToMiddle(v);
        continue;
      }
      Vec3 sum = Vec3::Zero();
      int count = 0;
      this->Mesh.forEachNeighbour(v, [&](int u) {
        sum += this->Mesh.position(u);
        ++count;
      });
      this->Mesh.put(
        v, this->Mesh.footing(this->Mesh.place(v), sum / count - this->Mesh.position(v)));
    }
  }
}

/// Moves vertices whose triangles are not good enough, until all are as good as wanted.
bool SwapTrial::improve(double enough, double wanted)
{
  for (int round = 0; round < SettlingRounds; ++round)
  {
    bool changed = false;
    for (int v : this->Vertices)
    {
      if (starQuality(this->Mesh, v) < enough)
      {
        changed = improveByMove(this->Mesh, v) || changed;
      }
    }
    if (this->worstQuality() >= wanted)
    {
      return true;
    }
    if (!changed)
    {
      break;
    }
  }
  return false;
}
}
