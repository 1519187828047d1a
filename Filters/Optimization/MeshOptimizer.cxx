// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOptimizer.h"

#include "AcuteCorners.h"
#include "EdgeSwaps.h"
#include "LocalEmbedding.h"
#include "LocalRepair.h"
#include "Relaxation.h"
#include "Ribs.h"
#include "SelfIntersections.h"
#include "SmallComponents.h"
#include "SurfaceError.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>

namespace stipple
{
namespace
{
using Swaps = OptimizerOptions::Swaps;
using Moves = OptimizerOptions::Moves;

/// Lloyd's step goes `overRelaxation` times as far, and keeps the share `momentum` of the step
/// before. What is too much for rest stirs the vertices out of poor arrangements, so it comes
/// first.
struct Pace
{
  double overRelaxation;
  double momentum;
};

/// Found by trial: better meshes in 42 rounds than with one pace (1.5, 0.7) in 60. Where the
/// density changes from vertex to vertex, steps die down later, and need more of the time for it.
Pace paceAt(double progress, bool uniform)
{
  constexpr Pace Stirring = { 1.7, 0.85 };
  constexpr Pace Resting = { 1., 0.3 };
  constexpr Pace StirringWithDensity = { 1.5, 0.85 };
  constexpr Pace RestingWithDensity = { 1.5, 0.5 };
  const Pace& from = uniform ? Stirring : StirringWithDensity;
  const Pace& to = uniform ? Resting : RestingWithDensity;
  const double begin = uniform ? 0.8 : 0.;
  const double t = std::max(0., (progress - begin) / (1. - begin));
  return { from.overRelaxation + t * (to.overRelaxation - from.overRelaxation),
    from.momentum + t * (to.momentum - from.momentum) };
}

/// Longest step over the mean length of the edges about a vertex: beyond, the one-ring says
/// nothing.
constexpr double LongestStep = 0.5;
/// Time step of the weighted Laplacian.
constexpr double LaplacianStep = 0.3;
constexpr int Grain = 256;

/// Angles (radians) below which triangles are repaired at the end.
constexpr double SmallAngle = 0.62;
/// Smallest angle (degrees) that swaps for regularity may make. They come last: mixed with Delaunay
/// swaps and moves they cost quality, for the moves spread what they disturb.
constexpr double RegularityAngle = 36.;
/// Angles (radians) that triangles keep when valences are repaired: what can be had at a good angle
/// is not had at a lesser one.
constexpr std::array<double, 2> ValenceAngles = { 0.613, 0.577 };
/// And when the error is reduced.
constexpr double ErrorAngle = 0.616;
/// And when triangles that pass through each other are parted.
constexpr double PartingAngle = 0.5;
/// By how much more (radians) creases are opened than asked for: Lloyd's method does not place
/// their first points to the point.
constexpr double AcuteMargin = 0.01;
/// In between, once the first rounds have brought order, those below this one and all folds are.
constexpr double SliverAngle = 0.25;
/// Rounds between repairs.
constexpr int RepairInterval = 10;

void swapEdges(OptimizedMesh& mesh, Swaps swaps, int passes)
{
  if (swaps == Swaps::Regularity)
  {
    delaunaySwaps(mesh, passes);
  }
  else if (swaps == Swaps::Aspect)
  {
    aspectSwaps(mesh, passes);
  }
}

Vec3 nextStep(const OptimizedMesh& mesh, const FaceMeasures& measures,
  const OptimizerOptions& options, const Pace& pace, int v, const Vec3& last)
{
  if (options.moves == Moves::Lloyd)
  {
    const bool isDelaunay = options.swaps == Swaps::Regularity;
    const Vec3 step = pace.momentum * last +
      pace.overRelaxation * towardsRidges(mesh, v, lloydStep(mesh, measures, v, isDelaunay));
    const double length = step.norm();
    return exceedsEdges(mesh, v, length, LongestStep)
      ? Vec3(LongestStep * meanEdgeLength(mesh, v) / length * step)
      : step;
  }
  return LaplacianStep * laplacianStep(mesh, v, options.moves == Moves::Density);
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
  FaceMeasures measures;
  std::vector<Vec3> step(n, Vec3::Zero());
  std::vector<double> arcLength(n, 0.);
  SmallComponents small(mesh);
  for (int i = 0; i < options.iterations; ++i)
  {
    const double done = static_cast<double>(i) / options.iterations;
    if (!report(progress, done))
    {
      return Status::aborted();
    }
    const Pace pace = paceAt(done, mesh.uniform());
    swapEdges(mesh, options.swaps, i == 0 ? 10 : 2);
    if (i == 0 && options.moves == Moves::Lloyd && options.acuteCornerAngle > 0)
    {
      mesh.coarsen(findAcuteCorners(mesh, options.acuteCornerAngle + AcuteMargin));
    }
    if (moves)
    {
      measures.update(mesh);
      vtkSMPTools::For(0, n, Grain, [&](vtkIdType begin, vtkIdType end) {
        for (int v = static_cast<int>(begin); v < end; ++v)
        {
          arcLength[v] = mesh.arcLength(v);
          if (mesh.freedom(v) == Freedom::Surface)
          {
            step[v] = small.rests(v) ? Vec3(Vec3::Zero())
                                     : nextStep(mesh, measures, options, pace, v, step[v]);
          }
        }
      });
      relaxBackbones(mesh, arcLength);
      small.note();
      mesh.move(step, arcLength);
      small.restore();
    }
    if (i % RepairInterval == 2)
    {
      const bool isFirst = i < RepairInterval;
      if (repairTriangles(mesh, isFirst ? 0. : SliverAngle, swaps, moves, 3) > 0 && moves && swaps)
      {
        unfold(mesh);
      }
    }
  }
  swapEdges(mesh, options.swaps, 10);
  if (options.swaps == Swaps::Regularity)
  {
    regularitySwaps(mesh, RegularityAngle, 2);
  }
  repairTriangles(mesh, SmallAngle, swaps, moves, 5);
  if (moves && swaps && unfold(mesh) > 0)
  {
    repairTriangles(mesh, SmallAngle, swaps, moves, 5);
  }
  if (moves && options.swaps == Swaps::Regularity)
  {
    for (const double angle : ValenceAngles)
    {
      repairValences(mesh, angle, 3);
    }
    repairTriangles(mesh, SmallAngle, false, true, 2);
    if (options.ribs)
    {
      makeRibs(mesh);
    }
  }
  if (moves && options.errorReduction > 0)
  {
    reduceSurfaceError(mesh, ErrorAngle, options.errorReduction);
  }
  if (moves)
  {
    resolveSelfIntersections(mesh, PartingAngle, 8);
  }
  return report(progress, 1.) ? Status::success() : Status::aborted();
}
}
