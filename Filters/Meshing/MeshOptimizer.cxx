// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOptimizer.h"

#include "EdgeSwaps.h"
#include "LocalRepair.h"
#include "Relaxation.h"

#include "vtkSMPTools.h"

namespace stipple
{
namespace
{
using Swaps = OptimizerOptions::Swaps;
using Moves = OptimizerOptions::Moves;

/// Lloyd's step goes this much too far, and keeps this share of the step before: found by trial to reach in 40 rounds what
/// plain steps reach in 300.
constexpr double OverRelaxation = 1.5;
constexpr double Momentum = 0.7;
/// Time step of the weighted Laplacian.
constexpr double LaplacianStep = 0.3;
constexpr int Grain = 256;

/// Angles (radians) below which triangles are repaired at the end.
constexpr double SmallAngle = 0.62;
/// Rounds between repairs of folds.
constexpr int RepairInterval = 10;

/// Rounds that begin with swaps for regularity, then move without Delaunay swaps so that the new connectivity can settle.
struct RegularityRounds
{
  int period = 0;
  int settle = 0;
  bool swaps(int i) const { return this->period > 0 && i > 0 && i % this->period == 0; }
  bool settles(int i) const
  {
    return this->period > 0 && i >= this->period && i % this->period <= this->settle;
  }
};

Vec3 nextStep(const OptimizedMesh& mesh, Moves moves, int v, const Vec3& last)
{
  if (moves == Moves::Lloyd)
  {
    return Momentum * last + OverRelaxation * towardsRidges(mesh, v, lloydStep(mesh, v));
  }
  return LaplacianStep * laplacianStep(mesh, v, moves == Moves::Density);
}
}

Status optimizeMesh(OptimizedMesh& mesh, const OptimizerOptions& options, const Progress& progress)
{
  if (options.iterations <= 0)
  {
    return Status::success();
  }
  const int n = mesh.numberOfVertices();
  const bool moves = options.moves != Moves::None;
  const bool swaps = options.swaps != Swaps::None;
  RegularityRounds regularity;
  regularity.period = getenv("RP") ? atoi(getenv("RP")) : 0;
  regularity.settle = getenv("RS") ? atoi(getenv("RS")) : 3;
  int lastreg = options.iterations - (getenv("RL") ? atoi(getenv("RL")) : 10);
  double ra = getenv("RA") ? atof(getenv("RA")) : 15;
  std::vector<Vec3> step(n, Vec3::Zero());
  std::vector<double> arcLength(n, 0.);
  for (int i = 0; i < options.iterations; ++i)
  {
    if (!report(progress, static_cast<double>(i) / options.iterations))
    {
      return Status::aborted();
    }
    if (options.swaps == Swaps::Aspect)
    {
      aspectSwaps(mesh);
    }
    else if (swaps && i < lastreg && regularity.swaps(i))
    {
      regularitySwaps(mesh, ra);
    }
    else if (swaps && !(i < lastreg && regularity.settles(i)))
    {
      delaunaySwaps(mesh);
    }
    if (moves)
    {
      vtkSMPTools::For(0, n, Grain, [&](vtkIdType begin, vtkIdType end) {
        for (int v = static_cast<int>(begin); v < end; ++v)
        {
          arcLength[v] = mesh.arcLength(v);
          if (mesh.freedom(v) == Freedom::Surface)
          {
            step[v] = nextStep(mesh, options.moves, v, step[v]);
          }
        }
      });
      relaxBackbones(mesh, arcLength);
      mesh.move(step, arcLength);
    }
    if (i % RepairInterval == 2)
    {
      repairTriangles(mesh, 0., swaps, moves, 3);
    }
  }
  if (options.swaps == Swaps::Aspect)
  {
    aspectSwaps(mesh);
  }
  else if (swaps)
  {
    delaunaySwaps(mesh);
  }
  repairTriangles(mesh, SmallAngle, swaps, moves, 5);
  return report(progress, 1.) ? Status::success() : Status::aborted();
}
}
