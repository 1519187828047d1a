// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOptimizer.h"

#include "AcuteCorners.h"
#include "BridgeSwaps.h"
#include "EdgeSwaps.h"
#include "FarPlaces.h"
#include "FeatureSimplification.h"
#include "LocalEmbedding.h"
#include "LocalRefinement.h"
#include "LocalRepair.h"
#include "MeshFaults.h"
#include "MeshQuality.h"
#include "MeshRegion.h"
#include "ParallelFor.h"
#include "Relaxation.h"
#include "Ribs.h"
#include "SelfIntersections.h"
#include "SmallComponents.h"
#include "SurfaceError.h"
#include "Tuning.h"
#include "UnsteadyCreases.h"
#include "VertexStar.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stipple
{
namespace
{
using Swaps = OptimizerOptions::Swaps;
using Moves = OptimizerOptions::Moves;

/// Where the density changes from vertex to vertex, steps die down later, and need more of the time
/// for it.
Tuning::Pace paceAt(double progress, bool uniform)
{
  const Tuning::Pace& from = uniform ? Tuning::Stirring : Tuning::StirringWithDensity;
  const Tuning::Pace& to = uniform ? Tuning::Resting : Tuning::RestingWithDensity;
  const double begin = uniform ? Tuning::BeginOfRest : 0.;
  const double t = std::max(0., (progress - begin) / (1. - begin));
  return { from.overRelaxation + t * (to.overRelaxation - from.overRelaxation),
    from.momentum + t * (to.momentum - from.momentum) };
}

bool maySimplify(const OptimizerOptions& options)
{
  return options.moves != Moves::None && options.swaps != Swaps::None &&
    options.featureTolerance > 0;
}

/// When all is done. Ribs are, by then, and would be lost.
bool maySimplifyAtLast(const OptimizerOptions& options)
{
  return maySimplify(options) && !options.ribs;
}

void swapEdges(MeshEdit& edit, Swaps swaps, int passes)
{
  if (swaps == Swaps::Regularity)
  {
    delaunaySwaps(edit, passes);
  }
  else if (swaps == Swaps::Aspect)
  {
    aspectSwaps(edit, passes);
  }
}

Vec3 nextStep(const OptimizedMesh& mesh, const FaceMeasures& measures,
  const OptimizerOptions& options, const Tuning::Pace& pace, Vertex v, const Vec3& last)
{
  if (options.moves == Moves::Lloyd)
  {
    const bool isDelaunay = options.swaps == Swaps::Regularity;
    const Vec3 step = pace.momentum * last +
      pace.overRelaxation * towardsRidges(mesh, v, lloydStep(mesh, measures, v, isDelaunay));
    const double length = step.norm();
    return exceedsEdges(mesh, v, length, Tuning::LongestStep)
      ? Vec3(Tuning::LongestStep * meanEdgeLength(mesh, v) / length * step)
      : step;
  }
  return Tuning::LaplacianStep * laplacianStep(mesh, v, options.moves == Moves::Density);
}

/// Backbones, by id, that even out as a whole, as slides one by one would take too long to open
/// acute corners before features are simplified; where corners stay closed, first points stay as
/// far out as they are.
std::vector<char> backbonesToEvenOut(
  const OptimizedMesh& mesh, const std::vector<char>& closed, bool withCoarse)
{
  std::vector<char> result = closed;
  result.resize(mesh.chains().size(), 0);
  for (std::size_t c = 0; withCoarse && c < result.size(); ++c)
  {
    const OptimizedMesh::Chain& chain = mesh.chains()[c];
    result[c] = result[c] != 0 ||
      std::any_of(chain.begin(), chain.end(),
        [&](const BackboneVertex& v) { return mesh.isCoarse(v.vertex); });
  }
  return result;
}

/// Rounds of swaps and moves (paper 4.4), with repairs in between; with a first one other than 0
/// the last of them once more, after a change.
Status relax(OptimizedMesh& mesh, MeshEdit& edit, const OptimizerOptions& options, int firstRound,
  KnownOverlaps& overlaps, const Progress& progress)
{
  const bool moves = options.moves != Moves::None;
  const bool lloyd = options.moves == Moves::Lloyd;
  const bool swaps = options.swaps != Swaps::None;
  const auto n = static_cast<std::size_t>(mesh.vertices().size());
  FaceMeasures measures;
  ElementArray<Vertex, Vec3> step(n, Vec3::Zero());
  ElementArray<Vertex, double> arcLength(n, 0.);
  const std::vector<char> all(mesh.chains().size(), 1);
  std::vector<char> closed; // by backbone: leaves an acute corner that stays closed
  std::optional<SmallComponents> small(mesh);
  const bool slides = lloyd && options.swaps == Swaps::Regularity; // cells need a Delaunay mesh
  const bool opensCorners = lloyd && options.acuteCornerAngle > 0;
  std::optional<AcuteCorners> acute;
  for (int i = firstRound; i < options.iterations; ++i)
  {
    const double done = static_cast<double>(i) / options.iterations;
    if (!report(progress, done))
    {
      return Status::aborted();
    }
    if (i == 0)
    {
      // Triangles across a concave corner of a chart may lie over what is no surface; once vertices
      // have been drawn there, swaps alone are no help.
      repairTriangles(edit, 0., swaps, false, Tuning::ManyPasses);
    }
    if (i > 0 && i % Tuning::AcuteInterval == 0 && firstRound == 0 && maySimplify(options))
    {
      const int changes = mesh.numberOfChanges();
      const double poorAngle = options.ribs ? Tuning::SliverAngle : Tuning::PoorFeatureAngle;
      if (options.givesUpCreases)
      {
        giveUpUnsteadyCreases(mesh, options.featureTolerance, poorAngle);
      }
      const Status status = simplifyFeatures(mesh, options.featureTolerance, poorAngle);
      if (!status.ok())
      {
        return status;
      }
      if (mesh.numberOfChanges() > changes)
      {
        small.emplace(mesh); // triangles have new ids
      }
    }
    const Tuning::Pace pace = paceAt(done, mesh.uniform());
    swapEdges(edit, options.swaps, i == 0 ? Tuning::ManyPasses : Tuning::PassesInRound);
    if (i % Tuning::AcuteInterval == 0 && lloyd && firstRound == 0)
    {
      if (i == 0)
      {
        acute.emplace(mesh, opensCorners ? options.acuteCornerAngle + Tuning::AcuteMargin : 0.);
      }
      else
      {
        acute->correct(mesh);
      }
      mesh.coarsen(acute->regions(mesh));
      closed = acute->closedCreases(mesh);
    }
    if (moves)
    {
      measures.update(mesh);
      parallelFor(mesh.vertices(), [&](Vertex v) {
        arcLength[v] = mesh.arcLength(v);
        if (!edit.mayMove(v))
        {
          return;
        }
        if (mesh.freedom(v) == Freedom::Backbone && slides)
        {
          arcLength[v] += lloydSlide(mesh, measures, v);
        }
        else if (mesh.isFree(v))
        {
          step[v] = small->rests(v) ? Vec3(Vec3::Zero())
                                    : nextStep(mesh, measures, options, pace, v, step[v]);
        }
      });
      relaxBackbones(mesh,
        slides ? backbonesToEvenOut(mesh, closed, i < Tuning::RoundsOfEvening) : all, arcLength);
      small->note();
      edit.moveAll(step, arcLength);
      small->restore(edit);
    }
    if (i % Tuning::RepairInterval == Tuning::FirstRepair)
    {
      const double threshold = i == Tuning::FirstRepair ? 0. : Tuning::SliverAngle;
      const bool isBad = repairTriangles(edit, threshold, swaps, moves, Tuning::PassesOfRepair) > 0;
      if (moves && isBad)
      {
        unfold(edit, swaps, overlaps.folds);
      }
      if (moves && swaps)
      {
        // Layers that lie over one another are small at first; Lloyd's method gives each its share.
        resolveSelfIntersections(edit, Tuning::PassesOfEarlyParting, overlaps);
      }
    }
  }
  return Status::success();
}

/// What makes the mesh good in the end, triangle by triangle.
Status finish(MeshEdit& edit, const OptimizerOptions& options, KnownOverlaps& overlaps,
  const Progress& progress)
{
  const bool moves = options.moves != Moves::None;
  const bool swaps = options.swaps != Swaps::None;
  const auto repair = [&](bool maySwap, bool mayMove, int passes) {
    repairTriangles(edit, Tuning::SmallAngle, maySwap, mayMove, passes);
  };
  const auto reduceError = [&]() {
    if (options.errorReduction > 0)
    {
      reduceSurfaceError(edit, Tuning::SmallAngle, options.errorReduction);
    }
  };
  swapEdges(edit, options.swaps, Tuning::ManyPasses);
  if (options.swaps == Swaps::Regularity)
  {
    regularitySwaps(edit, Tuning::RegularityAngle, Tuning::PassesInRound);
  }
  repair(swaps, moves, Tuning::LastPassesOfRepair);
  if (!moves)
  {
    return Status::success();
  }
  if (!report(progress, 1.))
  {
    return Status::aborted();
  }
  if (unfold(edit, swaps, overlaps.folds) > 0)
  {
    repair(swaps, moves, Tuning::LastPassesOfRepair);
  }
  if (options.swaps == Swaps::Regularity)
  {
    repairValences(edit, Tuning::SmallAngle, Tuning::PassesOfRepair);
    repair(false, true, Tuning::PassesInRound);
    if (options.ribs)
    {
      reduceError(); // so that ribs are held against what is possible without them
      makeRibs(edit, [&] { return !report(progress, 1.); }); // seconds where there is no room
    }
  }
  if (!report(progress, 1.))
  {
    return Status::aborted();
  }
  reduceError();
  if (!report(progress, 1.))
  {
    return Status::aborted();
  }
  resolveSelfIntersections(edit, Tuning::PassesOfParting, overlaps);
  return report(progress, 1.) ? Status::success() : Status::aborted();
}

/// A ball in which nothing is to be done.
struct Avoided
{
  Vec3 centre;
  double radius;
};

bool isAvoided(const std::vector<Avoided>& avoided, const Vec3& place)
{
  return std::any_of(avoided.begin(), avoided.end(),
    [&](const Avoided& ball) { return (place - ball.centre).norm() < ball.radius; });
}

/// Vertices for what the mesh has lost all the same: tips, and pockets. As it was is noted before
/// it changes; `left` are triangles that pass through each other afterwards.
Status reachPlacesOutside(const std::vector<Avoided>& avoided, OptimizedMesh& mesh, MeshEdit& edit,
  const OptimizerOptions& options, KnownOverlaps& overlaps, std::optional<OptimizedMesh>& before,
  int& left, const Progress& progress)
{
  const int changes = mesh.numberOfChanges();
  for (int i = 0; i < Tuning::LooksAtFarPlaces; ++i)
  {
    const int known = mesh.numberOfChanges();
    std::vector<FarPlace> places;
    Status status = farPlaces(mesh, Tuning::FarShare, progress, places);
    places.erase(std::remove_if(places.begin(), places.end(),
                   [&](const FarPlace& place) { return isAvoided(avoided, place.position); }),
      places.end());
    if (status.ok() && !places.empty())
    {
      if (!before)
      {
        before = mesh;
      }
      status = reachPlaces(mesh, places, options.featureTolerance);
    }
    if (!status.ok())
    {
      return status;
    }
    if (mesh.numberOfChanges() == known)
    {
      break;
    }
    repairTriangles(edit, Tuning::SmallAngle, true, true, Tuning::LastPassesOfRepair);
  }
  const int swaps = swapBridges(edit, Tuning::FarShare, options.featureTolerance);
  if (swaps > 0)
  {
    repairTriangles(edit, Tuning::SmallAngle, false, true, Tuning::LastPassesOfRepair);
  }
  if (mesh.numberOfChanges() > changes || swaps > 0)
  {
    left = resolveSelfIntersections(edit, Tuning::PassesOfParting, overlaps);
  }
  return Status::success();
}

/// The same, but not where the mesh passes through itself for it, as in a hole three edges around.
Status reachFarPlaces(OptimizedMesh& mesh, MeshEdit& edit, const OptimizerOptions& options,
  KnownOverlaps& overlaps, const Progress& progress)
{
  std::vector<Avoided> avoided;
  std::optional<OptimizedMesh> before;
  for (int i = 0; i < Tuning::LooksAtFarPlaces; ++i)
  {
    int left = 0;
    const Status status =
      reachPlacesOutside(avoided, mesh, edit, options, overlaps, before, left, progress);
    if (!status.ok() || left == 0 || !before)
    {
      return status;
    }
    if (static_cast<int>(overlapsOf(*before, SelfIntersections(*before), overlaps).size()) >= left)
    {
      return status; // what passes through itself does so anyway
    }
    for (const Face f : SelfIntersections(mesh).faces())
    {
      const auto [a, b, c] = mesh.corners(f);
      avoided.push_back({ (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3.,
        Tuning::EdgesAvoided * meanEdgeLength(mesh, a) });
    }
    mesh = *before;
    overlaps.left.reset();
  }
  return Status::success();
}

/// Shorter edges about some triangles, and what that needs: rounds of the mesh there, and all that
/// makes it good in the end.
Status refineAndFinish(OptimizedMesh& mesh, MeshEdit& edit, const std::vector<Face>& faces,
  const OptimizerOptions& options, KnownOverlaps& overlaps, const Progress& progress)
{
  std::vector<Vertex> changed;
  Status status = refineAbout(mesh, faces, changed);
  if (status.ok())
  {
    status = simplifyFeatures(mesh, options.featureTolerance);
  }
  if (!status.ok())
  {
    return status;
  }
  ElementArray<Vertex, char> isMoving(static_cast<std::size_t>(mesh.vertices().size()), 0);
  for (const Vertex v : withRings(mesh, changed, Tuning::RingsOfRefinement))
  {
    isMoving[v] = 1;
  }
  edit.restrictTo(std::move(isMoving));
  status = relax(mesh, edit, options, std::max(1, options.iterations - Tuning::RoundsOfRefinement),
    overlaps, progress);
  if (status.ok())
  {
    status = finish(edit, options, overlaps, progress);
  }
  if (status.ok())
  {
    status = reachFarPlaces(mesh, edit, options, overlaps, progress);
  }
  edit.restrictTo({});
  return status;
}

/// How far the surface is from the mesh, and the mesh from the surface, at most; 0 for what is not
/// far (Tuning::FarShare), and does not show (Tuning::VisibleDistance).
struct Distances
{
  double ofSurface = -1; // not yet known
  double ofMesh = 0;

  bool isNoMoreThan(const Distances& o) const
  {
    return this->ofSurface <= o.ofSurface && this->ofMesh <= o.ofMesh;
  }
  double largest() const { return std::max(this->ofSurface, this->ofMesh); }
};

/// Of the triangles' centroids and the edges' middles.
Status measureDistanceOfMesh(const OptimizedMesh& mesh, const Progress& progress, double& distance)
{
  std::vector<Vec3> places;
  for (const Face f : mesh.faces())
  {
    const auto [a, b, c] = mesh.corners(f);
    places.push_back((mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3.);
  }
  for (const Edge e : mesh.edges())
  {
    const Halfedge h = mesh.halfedge(e);
    places.push_back(0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
  }
  const AtlasSurface& surface = mesh.atlas().surface();
  const double visible = Tuning::VisibleDistance * surface.boundingBoxDiagonal();
  std::vector<NearestTriangle::Hit> nearest;
  const Status status = nearestPlaces(places, surface, progress, nearest, visible);
  double farthest = 0;
  for (const NearestTriangle::Hit& hit : nearest)
  {
    farthest = std::max(farthest, std::sqrt(hit.squaredDistance));
  }
  distance = farthest > visible ? farthest : 0.;
  return status;
}

Status measureDistances(const OptimizedMesh& mesh, const Progress& progress, Distances& distances)
{
  std::vector<FarPlace> places;
  const Status status = farPlaces(mesh, Tuning::FarShare, progress, places);
  distances.ofSurface = places.empty() ? 0. : places.front().distance;
  return status.ok() ? measureDistanceOfMesh(mesh, progress, distances.ofMesh) : status;
}

/// Shorter edges where the mesh is wrong or poor for want of them. It is kept only if it is better
/// for it, and no farther from the surface, nor that from it; where that is no help, it is not
/// tried again.
Status refineFaults(OptimizedMesh& mesh, MeshEdit& edit, const OptimizerOptions& options,
  KnownOverlaps& overlaps, const Progress& progress)
{
  std::vector<Avoided> avoided;
  MeshFaults faults(mesh, overlaps);
  Distances distances;
  int inVain = 0;
  for (int i = 0; i < Tuning::Refinements && inVain < Tuning::RefinementsInVain; ++i)
  {
    std::vector<Face> faces;
    std::vector<Avoided> reach;
    for (const MeshFaults::Fault& fault : faults.all())
    {
      if (!isAvoided(avoided, fault.position))
      {
        faces.push_back(fault.face);
        reach.push_back({ fault.position, meanEdgeLength(mesh, mesh.corners(fault.face)[0]) });
      }
    }
    if (faces.empty() ||
      static_cast<double>(faces.size()) > Tuning::RefinedShare * mesh.faces().size())
    {
      break;
    }
    Status status = Status::success();
    if (distances.ofSurface < 0)
    {
      status = measureDistances(mesh, progress, distances);
    }
    OptimizedMesh before = mesh;
    if (status.ok())
    {
      status = refineAndFinish(mesh, edit, faces, options, overlaps, progress);
    }
    if (!status.ok())
    {
      return status;
    }
    MeshFaults after(mesh, overlaps);
    const FaultSum sum = faults.sum();
    const FaultSum sumAfter = after.sum();
    const bool isBetter = sumAfter < sum;
    Distances distancesAfter;
    if (isBetter)
    {
      status = measureDistances(mesh, progress, distancesAfter);
      if (!status.ok())
      {
        return status;
      }
    }
    const std::size_t known = avoided.size();
    for (const Avoided& fault : reach)
    {
      const double radius = Tuning::ReachOfFault * fault.radius;
      if (!(after.sumNear(fault.centre, radius) < faults.sumNear(fault.centre, radius)))
      {
        avoided.push_back({ fault.centre, Tuning::ReachOfFailure * fault.radius });
      }
    }
    if (isBetter && distancesAfter.isNoMoreThan(distances))
    {
      inVain = sumAfter.isMuchLessThan(sum) ? 0 : inVain + 1;
      distances = distancesAfter;
      faults = std::move(after);
      continue;
    }
    mesh = std::move(before);
    overlaps.left.reset();
    ++inVain;
    if (avoided.size() == known)
    {
      break; // it would be the same once more
    }
  }
  return Status::success();
}

/// How poor triangles are; less is better.
struct Lack
{
  int flat = 0;   ///< triangles that have as good as no angle
  double sum = 0; ///< of the squares of what triangles lack of an angle that is good enough: one
                  ///< that lacks much is worse than some that lack little

  explicit Lack(const OptimizedMesh& mesh)
  {
    for (const Face f : mesh.faces())
    {
      const double angle = faceQuality(mesh, f);
      this->flat += angle < Tuning::NoAngle ? 1 : 0;
      this->sum += std::pow(std::max(0., Tuning::PoorFeatureAngle - angle), 2);
    }
  }
  bool operator<(const Lack& o) const
  {
    return this->flat != o.flat ? this->flat < o.flat : this->sum < o.sum;
  }
};

/// All of it, but for the look at what came of the creases that were given up.
Status optimizeOnce(OptimizedMesh& mesh, const OptimizerOptions& options, const Progress& progress)
{
  MeshEdit edit(mesh);
  KnownOverlaps overlaps;
  Status status = relax(mesh, edit, options, 0, overlaps, progress);
  if (status.ok())
  {
    status = finish(edit, options, overlaps, progress);
  }
  if (!status.ok())
  {
    return status;
  }
  // Edges were swapped since features were simplified last; each time fewer are left for that. What
  // helps in one place may hurt in another: the best of these meshes is kept.
  const Progress goesOn = [&](double) { return report(progress, 1.); }; // it does not go back
  Lack least(mesh);
  std::optional<OptimizedMesh> best;
  bool isNearlyDone = maySimplifyAtLast(options);
  for (int i = 0; i < Tuning::LastSimplifications && isNearlyDone && least.sum > 0; ++i)
  {
    if (!best)
    {
      best = mesh;
    }
    const int changes = mesh.numberOfChanges();
    if (options.givesUpCreases)
    {
      giveUpUnsteadyCreases(mesh, options.featureTolerance);
    }
    status = simplifyFeatures(mesh, options.featureTolerance);
    if (!status.ok())
    {
      return status;
    }
    const int made = mesh.numberOfChanges() - changes;
    if (made == 0)
    {
      break;
    }
    status = relax(mesh, edit, options, std::max(1, options.iterations - Tuning::AcuteInterval),
      overlaps, goesOn);
    if (status.ok())
    {
      status = finish(edit, options, overlaps, goesOn);
    }
    if (!status.ok())
    {
      return status;
    }
    const Lack lack(mesh);
    if (lack < least)
    {
      least = lack;
      best.reset();
    }
    isNearlyDone = Tuning::VerticesPerLastChange * made <= mesh.vertices().size();
  }
  if (best && least < Lack(mesh))
  {
    mesh = std::move(*best);
    overlaps.left.reset();
  }
  // What swaps have left without an angle, at last with no rounds that swap any more.
  for (int i = 0; i < Tuning::LastOpenings && maySimplifyAtLast(options); ++i)
  {
    const int changes = mesh.numberOfChanges();
    status = simplifyFeatures(mesh, options.featureTolerance, Tuning::NoAngle);
    if (!status.ok() || mesh.numberOfChanges() == changes)
    {
      break;
    }
    repairTriangles(edit, Tuning::SmallAngle, true, true, Tuning::LastPassesOfRepair);
    overlaps.left.reset();
  }
  if (!status.ok())
  {
    return status;
  }
  if (maySimplifyAtLast(options))
  {
    status = reachFarPlaces(mesh, edit, options, overlaps, goesOn);
    if (status.ok() && options.refinesFaults)
    {
      status = refineFaults(mesh, edit, options, overlaps, goesOn);
    }
    if (!status.ok())
    {
      return status;
    }
  }
  return report(progress, 1.) ? Status::success() : Status::aborted();
}

bool hasGivenUpCreases(const OptimizedMesh& before, const OptimizedMesh& after)
{
  for (std::size_t b = 0; b < after.chains().size(); ++b)
  {
    const int backbone = static_cast<int>(b);
    if (before.isCreaseBackbone(backbone) && !after.isCreaseBackbone(backbone))
    {
      return true;
    }
  }
  return false;
}
}

Status optimizeMesh(OptimizedMesh& mesh, const OptimizerOptions& options, const Progress& progress)
{
  if (options.iterations <= 0)
  {
    return Status::success();
  }
  const OptimizedMesh before = mesh;
  Status status = optimizeOnce(mesh, options, progress);
  if (!status.ok() || !hasGivenUpCreases(before, mesh))
  {
    return status;
  }
  // What a crease is worth by itself is known, but not what goes with many.
  const double farthest = Tuning::FartherWithoutCreases * Tuning::VisibleDistance *
    mesh.atlas().surface().boundingBoxDiagonal();
  const Progress goesOn = [&](double) { return report(progress, 1.); }; // it does not go back
  Distances distances;
  status = measureDistances(mesh, goesOn, distances);
  if (!status.ok() || distances.largest() <= farthest)
  {
    return status;
  }
  OptimizedMesh other = before;
  OptimizerOptions keeping = options;
  keeping.givesUpCreases = false;
  status = optimizeOnce(other, keeping, goesOn);
  Distances distancesOfOther;
  if (status.ok())
  {
    status = measureDistances(other, goesOn, distancesOfOther);
  }
  if (status.ok() &&
    Tuning::FartherWithoutCreases * distancesOfOther.largest() < distances.largest())
  {
    mesh = std::move(other);
  }
  return status;
}
}
