// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalEmbedding.h"

#include "EdgeSwaps.h"
#include "LocalRepair.h"
#include "VertexStar.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
using HalfedgeHandle = OptimizedMesh::Halfedge;

constexpr int RelaxationRounds = 60;
constexpr int ImprovementRounds = 6;
/// Angle (radians) up to which triangles are improved.
constexpr double GoodAngle = 0.6;
/// By how much an embedding may lengthen the longest edge.
constexpr double MostGrowth = 1.2;

double longestEdge(const OptimizedMesh& mesh, const std::vector<int>& faces)
{
  double longest = 0;
  for (int f : faces)
  {
    const auto t = mesh.corners(f);
    for (int k = 0; k < 3; ++k)
    {
      longest =
        std::max(longest, (mesh.position(t[k]) - mesh.position(t[(k + 1) % 3])).squaredNorm());
    }
  }
  return std::sqrt(longest);
}
}

LocalEmbedding::LocalEmbedding(OptimizedMesh& mesh, const std::vector<int>& faces, int rings)
  : Mesh(mesh)
{
  std::vector<int> vertices;
  for (int f : faces)
  {
    const auto t = mesh.corners(f);
    vertices.insert(vertices.end(), t.begin(), t.end());
  }
  makeUnique(vertices);
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<int> inner = vertices;
    for (int v : inner)
    {
      mesh.forEachNeighbour(v, [&](int u) { vertices.push_back(u); });
    }
    makeUnique(vertices);
  }
  for (int v : vertices)
  {
    if (mesh.freedom(v) == Freedom::Surface && !mesh.graph().is_boundary(OptimizedMesh::Vertex(v)))
    {
      this->Vertices.push_back(v);
      this->Before.push_back(mesh.footing(v));
      mesh.forEachFace(v, [&](int f) { this->Faces.push_back(f); });
    }
  }
  makeUnique(this->Faces);
}

bool LocalEmbedding::embed()
{
  const double longest = longestEdge(this->Mesh, this->Faces);
  this->placeInwards();
  this->relax();
  this->improve();
  return longestEdge(this->Mesh, this->Faces) <= MostGrowth * longest;
}

void LocalEmbedding::placeInwards()
{
  OptimizedMesh& mesh = this->Mesh;
  std::vector<int> waiting = this->Vertices;
  const auto isWaiting = [&](
                           int v) { return std::binary_search(waiting.begin(), waiting.end(), v); };
  while (!waiting.empty())
  {
    std::vector<int> next;
    std::vector<Footing> places;
    for (int v : waiting)
    {
      Vec3 sum = Vec3::Zero();
      int count = 0;
      int from = -1;
      mesh.forEachNeighbour(v, [&](int u) {
        if (!isWaiting(u))
        {
          sum += mesh.position(u);
          ++count;
          from = u;
        }
      });
      if (count > 0)
      {
        next.push_back(v);
        places.push_back(mesh.footing(mesh.place(from), sum / count - mesh.position(from)));
      }
    }
    if (next.empty())
    {
      break; // nothing around it stays: a whole component
    }
    std::vector<int> rest;
    std::set_difference(
      waiting.begin(), waiting.end(), next.begin(), next.end(), std::back_inserter(rest));
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      mesh.put(next[i], places[i]);
    }
    waiting = std::move(rest);
  }
}

void LocalEmbedding::relax()
{
  OptimizedMesh& mesh = this->Mesh;
  for (int round = 0; round < RelaxationRounds; ++round)
  {
    for (int v : this->Vertices)
    {
      Vec3 sum = Vec3::Zero();
      int count = 0;
      mesh.forEachNeighbour(v, [&](int u) {
        sum += mesh.position(u);
        ++count;
      });
      mesh.put(v, mesh.footing(mesh.place(v), sum / count - mesh.position(v)));
    }
  }
}

void LocalEmbedding::improve()
{
  OptimizedMesh& mesh = this->Mesh;
  for (int round = 0; round < ImprovementRounds; ++round)
  {
    std::vector<int> edges;
    for (int v : this->Vertices)
    {
      mesh.forEachHalfedge(
        v, [&](HalfedgeHandle h) { edges.push_back(mesh.graph().edge_handle(h).idx()); });
    }
    makeUnique(edges);
    for (int edge : edges)
    {
      if (isDelaunaySwap(mesh, edge) && mesh.swap(edge))
      {
        this->Swapped.push_back(edge);
      }
    }
    for (int v : this->Vertices)
    {
      if (starQuality(mesh, v) < GoodAngle)
      {
        improveByMove(mesh, v);
      }
    }
  }
}

void LocalEmbedding::undo()
{
  for (; !this->Swapped.empty(); this->Swapped.pop_back())
  {
    this->Mesh.forceSwap(this->Swapped.back());
  }
  for (std::size_t i = 0; i < this->Vertices.size(); ++i)
  {
    this->Mesh.put(this->Vertices[i], this->Before[i]);
  }
}

std::vector<std::vector<int>> groupsOf(const OptimizedMesh& mesh, const std::vector<int>& faces)
{
  std::vector<std::vector<int>> result;
  std::vector<int> waiting = faces;
  while (!waiting.empty())
  {
    std::vector<int> group = { waiting.front() };
    waiting.erase(waiting.begin());
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      for (int v : mesh.corners(group[i]))
      {
        mesh.forEachFace(v, [&](int f) {
          const auto found = std::lower_bound(waiting.begin(), waiting.end(), f);
          if (found != waiting.end() && *found == f)
          {
            group.push_back(f);
            waiting.erase(found);
          }
        });
      }
    }
    std::sort(group.begin(), group.end());
    result.push_back(std::move(group));
  }
  return result;
}

namespace
{
/// Triangles below are as good as folded.
constexpr double LeastAngle = 0.01; // radians

double sumOfFolds(const OptimizedMesh& mesh, const std::vector<int>& faces)
{
  double sum = 0;
  for (int f : faces)
  {
    const double quality = faceQuality(mesh, f);
    sum += quality < LeastAngle ? 1. - std::min(0., quality) : 0.;
  }
  return sum;
}
}

int unfold(OptimizedMesh& mesh)
{
  constexpr int MostRings = 4;
  const int n = mesh.numberOfFaces();
  std::vector<char> isFolded(n);
  vtkSMPTools::For(0, n, 1024, [&](vtkIdType begin, vtkIdType end) {
    for (int f = static_cast<int>(begin); f < end; ++f)
    {
      isFolded[f] = faceQuality(mesh, f) < LeastAngle ? 1 : 0;
    }
  });
  std::vector<int> folded;
  for (int f = 0; f < n; ++f)
  {
    if (isFolded[f])
    {
      folded.push_back(f);
    }
  }
  int unfolded = 0;
  for (const std::vector<int>& group : groupsOf(mesh, folded))
  {
    const std::vector<int> changed = embedAbout(
      mesh, group, MostRings,
      [&](const std::vector<int>& faces) { return sumOfFolds(mesh, faces); },
      [](double after, double before) { return after < before - 0.5; });
    unfolded += changed.empty() ? 0 : 1;
  }
  return unfolded;
}
}
