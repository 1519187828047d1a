// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalEmbedding.h"

#include "EdgeSwaps.h"
#include "LocalRepair.h"
#include "ParallelFor.h"
#include "Relaxation.h"
#include "TriangleDistance.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
struct EdgeLengths
{
  double shortest = 1e300;
  double mean = 0;
  double longest = 0;
};

EdgeLengths edgeLengths(const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  EdgeLengths lengths;
  for (const Face f : faces)
  {
    const auto t = mesh.corners(f);
    for (int k = 0; k < 3; ++k)
    {
      const double length = (mesh.position(t[k]) - mesh.position(t[(k + 1) % 3])).norm();
      lengths.shortest = std::min(lengths.shortest, length);
      lengths.mean += length / (3. * static_cast<double>(faces.size()));
      lengths.longest = std::max(lengths.longest, length);
    }
  }
  return lengths;
}

/// The way to a place in space from one of the vertices, the last one first, that ends near it:
/// from a crease or a corner, walks may begin on the wrong side of it.
SurfacePoint walkFromOneOf(
  const OptimizedMesh& mesh, const std::vector<Vertex>& vertices, const Vec3& there)
{
  SurfacePoint best;
  double least = 0;
  for (auto from = vertices.rbegin(); from != vertices.rend(); ++from)
  {
    const Vec3 step = there - mesh.position(*from);
    const SurfacePoint end = mesh.walk(mesh.place(*from), step);
    const double distance = (end.position - there).norm();
    if (from == vertices.rbegin() || distance < least)
    {
      best = end;
      least = distance;
    }
    if (distance <= Tuning::FarthestOffEdge * step.norm())
    {
      break;
    }
  }
  return best;
}

/// Ring by ring, to the middle of the neighbours that have their place.
void placeInwards(MeshEdit& edit, std::vector<Vertex> waiting)
{
  const OptimizedMesh& mesh = edit.mesh();
  while (!waiting.empty())
  {
    std::vector<std::pair<Vertex, SurfacePoint>> next;
    for (const Vertex v : waiting)
    {
      Vec3 sum = Vec3::Zero();
      std::vector<Vertex> from;
      mesh.forEachNeighbour(v, [&](Vertex u) {
        if (!std::binary_search(waiting.begin(), waiting.end(), u))
        {
          sum += mesh.position(u);
          from.push_back(u);
        }
      });
      if (!from.empty())
      {
        next.emplace_back(v, walkFromOneOf(mesh, from, sum / static_cast<double>(from.size())));
      }
    }
    if (next.empty())
    {
      return; // nothing around it stays: a whole component
    }
    for (const auto& [v, place] : next)
    {
      edit.put(v, place);
      waiting.erase(std::lower_bound(waiting.begin(), waiting.end(), v));
    }
  }
}

/// Swaps, if it may, and moves for good angles.
void improve(MeshEdit& edit, const std::vector<Vertex>& vertices, bool maySwap)
{
  for (const Edge e : maySwap ? edgesAbout(edit.mesh(), vertices) : std::vector<Edge>())
  {
    if (isDelaunaySwap(edit.mesh(), e))
    {
      edit.swap(e);
    }
  }
  for (const Vertex v : vertices)
  {
    if (starQuality(edit.mesh(), v) < Tuning::AngleOfEmbedding)
    {
      improveByMove(edit, v);
    }
  }
}

/// Whether one of the triangles at least is no farther from a place than a distance.
bool isNear(
  const OptimizedMesh& mesh, const Vec3& place, const std::vector<Face>& faces, double distance)
{
  return std::any_of(faces.begin(), faces.end(), [&](Face f) {
    const auto [a, b, c] = mesh.corners(f);
    return squaredDistanceToTriangle(place, mesh.position(a), mesh.position(b), mesh.position(c)) <=
      distance * distance;
  });
}

double sumOfFolds(const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  double sum = 0;
  for (const Face f : faces)
  {
    const double quality = faceQuality(mesh, f);
    sum += quality < Tuning::AngleOfFold ? 1. - std::min(0., quality) : 0.;
  }
  return sum;
}
}

bool embed(
  MeshEdit& edit, const std::vector<Vertex>& vertices, const std::vector<Face>& faces, bool maySwap)
{
  const OptimizedMesh& mesh = edit.mesh();
  const EdgeLengths before = edgeLengths(mesh, faces);
  std::vector<Vec3> places;
  for (const Vertex v : vertices)
  {
    places.push_back(mesh.position(v));
  }
  placeInwards(edit, vertices);
  double longest = Tuning::SettledStep * before.mean;
  for (int round = 0;
       round < Tuning::RoundsOfEmbedding && longest >= Tuning::SettledStep * before.mean; ++round)
  {
    longest = 0;
    for (const Vertex v : vertices)
    {
      const Vec3 step = stepToMiddle(mesh, v);
      longest = std::max(longest, step.norm());
      edit.put(v, mesh.walk(mesh.place(v), step));
    }
  }
  for (int round = 0; round < Tuning::RoundsAfterEmbedding; ++round)
  {
    improve(edit, vertices, maySwap);
  }
  const EdgeLengths after = edgeLengths(mesh, faces);
  // Where a vertex has come home from afar, others lie by now.
  const std::vector<Face> about =
    facesAbout(mesh, withRings(mesh, cornersOf(mesh, faces), Tuning::RingsAboutEmbedding));
  return after.longest <= Tuning::GrowthByEmbedding * before.longest &&
    after.shortest >= std::min(before.shortest, Tuning::OnEdge * before.longest) &&
    std::all_of(places.begin(), places.end(),
      [&](const Vec3& p) { return isNear(mesh, p, about, Tuning::FarthestLeft * before.mean); });
}

std::vector<std::vector<Face>> groupsOf(const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  std::vector<std::vector<Face>> result;
  std::vector<Face> waiting = faces;
  while (!waiting.empty())
  {
    std::vector<Face> group = { waiting.front() };
    waiting.erase(waiting.begin());
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      for (const Vertex v : mesh.corners(group[i]))
      {
        mesh.forEachFace(v, [&](Face f) {
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

FailedEmbeddings::Group FailedEmbeddings::groupOf(
  const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  Group group{ faces.size(), Vec3::Zero(), 0 };
  for (const Face f : faces)
  {
    const auto t = mesh.corners(f);
    for (int k = 0; k < 3; ++k)
    {
      group.centre += mesh.position(t[k]);
      group.edge += (mesh.position(t[k]) - mesh.position(t[(k + 1) % 3])).norm();
    }
  }
  const double corners = 3. * static_cast<double>(faces.size());
  group.centre /= corners;
  group.edge /= corners;
  return group;
}

bool FailedEmbeddings::contains(const OptimizedMesh& mesh, const std::vector<Face>& faces) const
{
  const Group group = groupOf(mesh, faces);
  return std::any_of(this->Groups.begin(), this->Groups.end(), [&](const Group& known) {
    return known.size == group.size &&
      (known.centre - group.centre).norm() < Tuning::SamePlace * std::min(known.edge, group.edge);
  });
}

void FailedEmbeddings::add(const OptimizedMesh& mesh, const std::vector<Face>& faces)
{
  this->Groups.push_back(groupOf(mesh, faces));
}

int& FailedEmbeddings::budget(const OptimizedMesh& mesh)
{
  return this->Budget ? *this->Budget
                      : this->Budget.emplace(Tuning::EmbeddingBudget *
                          std::max(mesh.faces().size(), Tuning::FewTriangles));
}

int unfold(MeshEdit& edit, bool maySwap, FailedEmbeddings& failed)
{
  const OptimizedMesh& mesh = edit.mesh();
  ElementArray<Face, char> isFolded(static_cast<std::size_t>(mesh.faces().size()));
  parallelFor(mesh.faces(),
    [&](Face f) { isFolded[f] = faceQuality(mesh, f) < Tuning::AngleOfFold ? 1 : 0; });
  std::vector<Face> folded;
  for (const Face f : mesh.faces())
  {
    if (isFolded[f])
    {
      folded.push_back(f);
    }
  }
  int unfolded = 0;
  int& budget = failed.budget(mesh);
  const int kept = budget / 2; // for later, when the mesh is in better order
  for (const std::vector<Face>& group : groupsOf(mesh, folded))
  {
    if (budget <= kept)
    {
      break;
    }
    const std::vector<Face> changed = embedAbout(
      edit, group, Tuning::RingsOfUnfolding, maySwap, failed,
      [&](const std::vector<Face>& faces) {
        budget -= static_cast<int>(faces.size());
        return sumOfFolds(mesh, faces);
      },
      [](double after, double before) { return after < before - Tuning::LeastGainOfFolds; });
    unfolded += changed.empty() ? 0 : 1;
  }
  return unfolded;
}
}
