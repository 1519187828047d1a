// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberSearches.h"

#include "DeviationSearch.h"
#include "EdgeLengthSearch.h"
#include "MessageText.h"
#include "PolyDataConversion.h"
#include "SizingFunction.h"
#include "SurfaceDeviation.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace stipple
{
namespace
{
/// The best of the meshes that a search makes, kept while it makes others.
class BestMesh
{
public:
  explicit BestMesh(RemesherRun& run)
    : Run(run)
  {
  }

  Status tryNumber(int points)
  {
    this->IsThere = false;
    return this->Run.tryNumber(points);
  }

  /// The run's mesh is the best, if it has so many points. Says whether it is.
  bool keepIf(int numberOfBest)
  {
    this->IsThere = this->Run.numberOfPoints() == numberOfBest;
    if (this->IsThere)
    {
      this->Number = numberOfBest;
      this->Made = this->Run.stages().made();
    }
    return this->IsThere;
  }

  /// Whether it is what the run has made last.
  bool isThere() const { return this->IsThere; }
  /// Leaves it in the run's stages.
  Status leave()
  {
    return this->isThere() || this->Run.stages().putBack(this->Made)
      ? Status::success()
      : this->Run.tryNumber(this->Number);
  }

private:
  RemesherRun& Run;
  int Number = 0;
  RemesherStages::Made Made;
  bool IsThere = false;
};
}

Status remeshToEdgeLength(RemesherRun& run, int points, double& median)
{
  constexpr double ShareOfFirst = 0.9; // of the time: mostly it is the only one
  run.runner().setProgressRange(0., ShareOfFirst);
  if (Status status = run.remesh(points); !status.ok())
  {
    return status;
  }
  const auto measure = [&] {
    TriangleSurface mesh = fromPolyData(run.mesh());
    mesh.connect();
    median = medianEdgeLength(mesh);
  };
  measure();
  if (median == 0.)
  {
    return Status::success(); // there is nothing
  }
  EdgeLengthSearch search(run.stages().ControlMap->GetEdgeLength());
  search.add(run.numberOfPoints(), run.numberOfPoints(), median);
  BestMesh best(run);
  best.keepIf(search.found());
  while (const int number = search.next())
  {
    if (const Status status = best.tryNumber(number); status.isAbort())
    {
      return status;
    }
    else if (!status.ok())
    {
      break; // so many make no mesh
    }
    measure();
    search.add(number, run.numberOfPoints(), median);
    best.keepIf(search.found());
  }
  if (best.isThere())
  {
    return Status::success(); // and measured
  }
  const Status status = best.leave();
  if (status.ok())
  {
    measure();
  }
  return status;
}

Status remeshWithinDeviation(
  RemesherRun& run, const TriangleSurface& reference, double largest, double& reached)
{
  vtkControlMap* control = run.stages().ControlMap;
  const double diagonal = reference.boundingBoxDiagonal();
  // Other numbers cannot keep the bounds on lengths, with a percent for what pixels are off.
  const auto pointsOf = [&](double length, double none, double share) {
    return length > 0. ? share * reference.area() * densityOfEdges(length) : none;
  };
  // No more than the input has, which may be flat.
  const double first =
    std::min(pointsOfSphere(diagonal, largest), static_cast<double>(reference.points.size()));
  const double all = run.stages().Sampler->GetNumberOfSamplesMaxValue();
  const double most = std::min(all, pointsOf(control->GetSizeMinimum(), all, 0.99));
  DeviationSearch search(largest, first, pointsOf(control->GetSizeMaximum(), 1., 1.01), most);
  run.runner().setProgressRange(0., 0.);
  // A feature that goes to another one takes the mesh as far from the surface.
  run.boundFeatures(largest, reference.area());
  const auto report = [&](double) { return !run.runner().isStopped(); };
  BestMesh best(run);
  while (const int number = search.next())
  {
    const Status status = best.tryNumber(number);
    if (status.code() == StatusCode::TooFewPoints)
    {
      search.add(number, number, std::numeric_limits<double>::infinity());
      continue;
    }
    if (!status.ok() || run.mesh()->GetNumberOfCells() == 0)
    {
      return status;
    }
    DeviationBounds bounds;
    if (Status measured =
          surfaceDeviation(fromPolyData(run.mesh()), reference, 1e-3 * largest, report, bounds);
        !measured.ok())
    {
      return measured;
    }
    search.add(number, run.numberOfPoints(), bounds.upper);
    reached = best.keepIf(search.found()) ? 100. * bounds.upper / diagonal : reached;
  }
  if (search.found() > 0)
  {
    return best.leave();
  }
  std::ostringstream sentence;
  sentence << "No mesh that was tried deviates from the input by at most "
           << 100. * largest / diagonal << " % of its diagonal, the nearest one does by "
           << 100. * search.nearest() / diagonal << " %";
  if (search.tooMany() > 0.)
  {
    sentence << ", and it takes at least some " << countText(twoDigits(search.tooMany()))
             << " points, of which there can be " << static_cast<int>(most);
  }
  sentence << ": allow a larger deviation" << (most < all ? ", or shorter edges." : ".");
  return Status::error(sentence.str());
}
}
