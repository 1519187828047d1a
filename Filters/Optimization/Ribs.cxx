// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Ribs.h"

#include "EdgeSwaps.h"
#include "LocalRepair.h"
#include "MeshRegion.h"
#include "RibSearch.h"
#include "SurfaceProximity.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <array>

namespace stipple
{
namespace
{
/// The halfedges along creases, each with a side to its left, about the vertex that it leaves.
std::vector<Halfedge> sidesOf(const OptimizedMesh& mesh)
{
  std::vector<Halfedge> sides;
  for (const Vertex v : mesh.vertices())
  {
    if (mesh.freedom(v) == Freedom::Backbone)
    {
      mesh.forEachCorner(v, [&](Halfedge h) {
        if (mesh.isCrease(mesh.edge(h)))
        {
          sides.push_back(h);
        }
      });
    }
  }
  return sides;
}

int mendAll(
  RibSearch& search, const std::vector<Halfedge>& sides, const RibDemand& demand, const Stop& stop)
{
  int total = 0;
  for (int pass = 0; pass < Tuning::RibPasses; ++pass)
  {
    int mended = 0;
    for (const Halfedge h : sides)
    {
      if (isAsked(stop))
      {
        return total + mended;
      }
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

/// Moves vertices beside poor triangles.
void repair(MeshEdit& edit, const std::vector<Vertex>& vertices, ProximityGuard& guard)
{
  for (int round = 0; round < Tuning::RibRepairRounds; ++round)
  {
    for (const Vertex v : vertices)
    {
      if (starQuality(edit.mesh(), v) < Tuning::PoorRibAngle)
      {
        edit.attempt([&]() { return improveByMove(edit, v) && guard.allows(v); });
      }
    }
  }
}
}

int makeRibs(MeshEdit& edit, const Stop& stop)
{
  const OptimizedMesh& mesh = edit.mesh();
  const std::vector<Halfedge> sides = sidesOf(mesh);
  const auto numberLeft = [&]() {
    return std::count_if(
      sides.begin(), sides.end(), [&](Halfedge h) { return ribExcess(mesh, h) != 0; });
  };
  if (numberLeft() == 0)
  {
    return 0;
  }
  const SurfaceProximity proximity(mesh);
  const SurfaceDistances largest = proximity.largest();
  const auto within = [&](double share) {
    return SurfaceDistances{ share * largest.faces, share * largest.creases };
  };
  RibSearch search(
    edit, proximity, Tuning::RibBudget + Tuning::RibBudgetOfSide * static_cast<int>(sides.size()));
  int mended = 0;
  const auto mend = [&](const Tuning::RibEffort& effort, double angle, double share) {
    mended +=
      mendAll(search, sides, { effort.sequences, effort.trials, angle, within(share) }, stop);
  };
  const auto areMany = [&]() {
    return Tuning::RibsOneInMany * numberLeft() > static_cast<std::ptrdiff_t>(sides.size());
  };
  for (const double angle : Tuning::RibAngles)
  {
    mend(Tuning::SingleSwap, angle, 1.);
    mend(Tuning::BriefSearch, angle, 1.);
  }
  const double least = Tuning::RibAngles.back();
  mend(Tuning::ThoroughSearch, least, 1.);
  mend(Tuning::LongSearch, least, 1.);
  if (areMany())
  {
    for (const Tuning::RibEffort& effort :
      { Tuning::SingleSwap, Tuning::BriefSearch, Tuning::ThoroughSearch })
    {
      mend(effort, Tuning::LastRibAngle, 1.);
    }
    mend(Tuning::LongSearch, Tuning::LastRibAngle, Tuning::LastRibDistance);
  }
  if (areMany())
  {
    mend(Tuning::LongestSearch, Tuning::LastRibAngle, Tuning::LastRibDistance);
  }
  if (isAsked(stop))
  {
    return mended;
  }
  ProximityGuard guard(mesh, proximity, within(Tuning::RibEqualizingDistance));
  const std::vector<Vertex> about = withRings(mesh, search.moved(), Tuning::RibRings,
    [&](Vertex v) { return mesh.freedom(v) != Freedom::None; });
  repair(edit, about, guard);
  equalizeTriangles(edit, about, Tuning::SmallAngle, Tuning::RibEqualizingRounds,
    [&](Vertex v) { return guard.allows(v); });
  return mended;
}
}
