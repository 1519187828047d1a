// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Ribs.h"

#include "EdgeSwaps.h"
#include "LocalRepair.h"
#include "RibSearch.h"
#include "SurfaceProximity.h"
#include "SwapTrial.h"
#include "VertexStar.h"

#include <algorithm>
#include <array>

namespace stipple
{
namespace
{
using HalfedgeHandle = OptimizedMesh::Halfedge;

/// Angles (radians) that triangles keep when vertices get two neighbours on each side: what can be
/// had at a good angle is not had at a lesser one. Where creases are one edge apart, nothing but
/// the last will do.
constexpr std::array<double, 4> Angles = { 0.5, 0.43, 0.35, 0.26 };
/// And those that are worth a thorough search.
constexpr std::array<double, 2> LastAngles = { 0.35, 0.26 };
constexpr int MostPasses = 10;
/// What is spent on a side: sequences of swaps that are looked at, and tried out. Single swaps come
/// first, for they are cheap, then what most sides are mended with.
struct Effort
{
  int sequences;
  int trials;
};
constexpr Effort SingleSwap = { 1, 10 };
constexpr Effort Brief = { 100, 10 };
constexpr Effort Thorough = { 1000, 50 };
constexpr Effort Long = { 3000, 300 };
constexpr Effort Longest = { 16000, 300 };
/// The longest searches are made where more than one side in so many is left: in coarse meshes,
/// where every one counts.
constexpr int OneInMany = 60;
/// What all sides but for single swaps may spend together, in sequences: about a second.
constexpr int Budget = 110000;
/// Shares of the mesh's largest distance from the surface: what was found in vain may go a little
/// farther at last; moves for the sake of quality may not go as far.
constexpr double LastReach = 1.3;
constexpr double EveningReach = 0.8;
/// Triangles that are worse (radians) are repaired, where vertices moved.
constexpr double PoorAngle = 0.43;
/// Angle (radians) above which evening may make triangles worse.
constexpr double GoodAngle = 0.62;
constexpr int RepairRounds = 3;
constexpr int EveningRounds = 7;
/// Rings about the vertices that had to move, which are repaired and evened out with them.
constexpr int EveningRings = 2;

/// The halfedges along creases, each with a side to its left, about the vertex that it leaves.
std::vector<HalfedgeHandle> sidesOf(const OptimizedMesh& mesh)
{
  const auto& graph = mesh.graph();
  std::vector<HalfedgeHandle> sides;
  for (int v = 0; v < mesh.numberOfVertices(); ++v)
  {
    if (mesh.freedom(v) != Freedom::Backbone)
    {
      continue;
    }
    mesh.forEachHalfedge(v, [&](HalfedgeHandle h) {
      if (mesh.isFeature(graph.edge_handle(h).idx()) && !graph.is_boundary(h))
      {
        sides.push_back(h);
      }
    });
  }
  return sides;
}

int mendAll(RibSearch& search, const std::vector<HalfedgeHandle>& sides, const RibDemand& demand)
{
  int total = 0;
  for (int pass = 0; pass < MostPasses; ++pass)
  {
    int mended = 0;
    for (const HalfedgeHandle h : sides)
    {
      mended += search.mend(h, demand) ? 1 : 0;
    }
    total += mended;
    if (mended == 0)
    {
      break;
    }
  }
  return total;
}

/// Vertices that may move, and so many rings about them.
std::vector<int> withRings(const OptimizedMesh& mesh, std::vector<int> vertices, int rings)
{
  makeUnique(vertices);
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<int> inner = vertices;
    for (int v : inner)
    {
      mesh.forEachNeighbour(v, [&](int u) {
        if (mesh.freedom(u) != Freedom::None)
        {
          vertices.push_back(u);
        }
      });
    }
    makeUnique(vertices);
  }
  return vertices;
}

/// Moves vertices beside poor triangles.
void repair(OptimizedMesh& mesh, const std::vector<int>& vertices, SurfaceLeash& leash)
{
  for (int round = 0; round < RepairRounds; ++round)
  {
    for (int v : vertices)
    {
      const Stand before = standOf(mesh, v);
      if (starQuality(mesh, v) < PoorAngle && improveByMove(mesh, v) && !leash.allows(v))
      {
        mesh.putBack(v, before.footing, before.arcLength);
      }
    }
  }
}
}

int makeRibs(OptimizedMesh& mesh)
{
  const std::vector<HalfedgeHandle> sides = sidesOf(mesh);
  const auto numberLeft = [&]() {
    return static_cast<std::size_t>(std::count_if(
      sides.begin(), sides.end(), [&](HalfedgeHandle h) { return ribExcess(mesh, h) != 0; }));
  };
  if (numberLeft() == 0)
  {
    return 0;
  }
  const SurfaceProximity proximity(mesh);
  const SurfaceReach reach = proximity.largest();
  RibSearch search(mesh, proximity, Budget);
  int mended = 0;
  const auto mend = [&](const Effort& effort, double angle, double share) {
    mended += mendAll(search, sides,
      { effort.sequences, effort.trials, angle, { share * reach.faces, share * reach.creases } });
  };
  for (const double angle : Angles)
  {
    mend(SingleSwap, angle, 1.);
    mend(Brief, angle, 1.);
  }
  for (const double angle : LastAngles)
  {
    mend(Thorough, angle, 1.);
  }
  mend(Long, LastAngles.back(), LastReach);
  if (OneInMany * numberLeft() > sides.size())
  {
    mend(Longest, LastAngles.back(), LastReach);
  }
  SurfaceLeash leash(mesh, proximity, { EveningReach * reach.faces, EveningReach * reach.creases });
  const std::vector<int> about = withRings(mesh, search.moved(), EveningRings);
  repair(mesh, about, leash);
  evenOut(mesh, about, GoodAngle, EveningRounds, [&](int v) { return leash.allows(v); });
  return mended;
}
}
