// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDiffusion.h"

#include "CompressedRows.h"
#include "ConjugateGradients.h"
#include "SamplingConstants.h"
#include "SparseCholesky.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

constexpr vtkIdType PointGrain = 1024; ///< points or pixels a task

using SparseMatrix = Eigen::SparseMatrix<double>;

/// One implicit step, made ready for a sigma. With few points within a kernel the matrix is close
/// to the diagonal one, and conjugate gradients need some ten rounds; with many a factorization is
/// faster.
struct StepSolver
{
  double sigma = 0;
  std::unique_ptr<SparseCholesky> direct;
  std::unique_ptr<ConjugateGradients> iterative;
  std::vector<Eigen::VectorXd> changes; ///< of each step of the last call that guessed

  Status compute(const SparseMatrix& matrix, double pointsInKernel, const Stop& stop)
  {
    if (pointsInKernel <= 30.)
    {
      this->iterative = std::make_unique<ConjugateGradients>(matrix);
      return Status::success();
    }
    this->direct = std::make_unique<SparseCholesky>();
    return this->direct->factorize(matrix.triangularView<Eigen::Lower>(), stop) ? Status::success()
      : isAsked(stop)                                                           ? Status::aborted()
                                                                                : failure();
  }
  Status solve(
    const Eigen::VectorXd& right, double tolerance, Eigen::VectorXd& u, const Stop& stop) const
  {
    if (this->direct)
    {
      u = this->direct->solve(right);
      return Status::success();
    }
    const Status status = this->iterative->solve(right, tolerance, u, stop);
    return status.ok() || status.isAbort() ? status : failure();
  }
  static Status failure()
  {
    return Status::error("The heat equation on this surface could not be solved: lower Gradation "
                         "or BandPass.");
  }
};

/// A pixel that a point takes its value from, as much as this weight is of the sum of all its
/// pixels'.
struct PixelShare
{
  int pixel = 0; ///< of all charts' images, one after another
  double weight = 0;
};

/// Mass (a third of the triangles around a point) and stiffness (cotangent weights) of linear
/// elements.
void assemble(const RefinedSurface& s, Eigen::VectorXd& mass, SparseMatrix& stiffness)
{
  const auto n = static_cast<Eigen::Index>(s.points.size());
  mass = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * s.triangles.size() + s.points.size());
  for (int i = 0; i < static_cast<int>(n); ++i)
  {
    entries.emplace_back(i, i, 0.); // also where no triangle is
  }
  for (const Triangle& t : s.triangles)
  {
    const double area = triangleArea(s.points[t[0]], s.points[t[1]], s.points[t[2]]);
    for (int k = 0; k < 3; ++k)
    {
      const int p = t[(k + 1) % 3];
      const int q = t[(k + 2) % 3];
      mass[t[k]] += area / 3.;
      const double w = 0.5 * cotangent(s.points[t[k]], s.points[p], s.points[q]);
      entries.emplace_back(p, q, -w);
      entries.emplace_back(q, p, -w);
      entries.emplace_back(p, p, w);
      entries.emplace_back(q, q, w);
    }
  }
  // Points without area, or without triangles, must not make the system singular.
  mass.array() += 1e-12 * mass.sum() / static_cast<double>(std::max<Eigen::Index>(n, 1)) + 1e-300;
  stiffness.resize(n, n);
  stiffness.setFromTriplets(entries.begin(), entries.end());
}
}

struct SurfaceDiffusion::Internals
{
  const AtlasSurface* surface = nullptr;
  std::vector<ControlImage> images; ///< pointers into area and face
  std::vector<std::vector<float>> area;
  std::vector<std::vector<int>> face;
  double longestEdge = 0;

  // For one refinement:
  double longest = -1; ///< that it was made with; -1: there is none yet
  RefinedSurface refined;
  std::vector<std::vector<PixelPlace>> places;    ///< by chart and pixel
  CompressedRows<PixelShare, std::size_t> shares; ///< by point
  Eigen::VectorXd mass;
  SparseMatrix stiffness;
  std::deque<std::unique_ptr<StepSolver>> solvers;

  Status setRefinement(double sigma, const Progress& progress);
  Status findSolver(double sigma, const Stop& stop, StepSolver*& found);
  template <typename Visit>
  void forEachShare(const Visit& visit) const;
  void gatherShares();
  Eigen::VectorXd pixelsToPoints(const std::vector<float*>& values) const;
  void pointsToPixels(const Eigen::VectorXd& u, const std::vector<float*>& values) const;
};

Status SurfaceDiffusion::Internals::setRefinement(double sigma, const Progress& progress)
{
  // Elements as large as the kernel make it wider by some percent. Where none is larger, every
  // refinement is the surface itself.
  const double wanted = std::min(sigma, this->longestEdge);
  if (wanted == this->longest)
  {
    return Status::success();
  }
  this->longest = -1;
  this->solvers.clear();
  this->refined = refine(*this->surface, this->images, wanted);
  if (!report(progress, 0.1))
  {
    return Status::aborted();
  }
  this->places.assign(this->images.size(), {});
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(this->images.size()), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType c = begin; c < end; ++c)
      {
        this->places[c] =
          placePixels(*this->surface, this->refined, static_cast<int>(c), this->images[c]);
      }
    });
  if (!report(progress, 0.2))
  {
    return Status::aborted();
  }
  assemble(this->refined, this->mass, this->stiffness);
  this->gatherShares();
  this->longest = wanted;
  return Status::success();
}

Status SurfaceDiffusion::Internals::findSolver(double sigma, const Stop& stop, StepSolver*& found)
{
  for (const auto& solver : this->solvers)
  {
    if (solver->sigma == sigma)
    {
      found = solver.get();
      return Status::success();
    }
  }
  SparseMatrix matrix = (0.5 * sigma * sigma / Constants::HeatSteps) * this->stiffness;
  matrix.diagonal() += this->mass;
  const double pointsInKernel =
    sigma * sigma * static_cast<double>(this->refined.points.size()) / this->mass.sum();
  auto solver = std::make_unique<StepSolver>();
  solver->sigma = sigma;
  if (Status status = solver->compute(matrix, pointsInKernel, stop); !status.ok())
  {
    return status;
  }
  if (this->solvers.size() >= Constants::KeptSolvers)
  {
    this->solvers.pop_front();
  }
  this->solvers.push_back(std::move(solver));
  found = this->solvers.back().get();
  return Status::success();
}

/// Every point takes the mean of the pixels around it, by area and nearness; a point that no pixel
/// is near to takes the pixel that it lies in. visit(point, pixel, weight).
template <typename Visit>
void SurfaceDiffusion::Internals::forEachShare(const Visit& visit) const
{
  constexpr double OwnPixel = 1e-3;
  std::vector<int> firstPixel;
  int numberOfPixels = 0;
  for (std::size_t c = 0; c < this->images.size(); ++c)
  {
    firstPixel.push_back(numberOfPixels);
    numberOfPixels += this->images[c].numberOfPixels();
    const double pixelArea = this->images[c].pixelArea();
    for (std::size_t i = 0; i < this->places[c].size(); ++i)
    {
      const PixelPlace& place = this->places[c][i];
      const double area = this->area[c][i] > 0 ? this->area[c][i] * pixelArea : 0.;
      for (int k = 0; k < 3; ++k)
      {
        visit(this->refined.triangles[place.triangle][k], firstPixel[c] + static_cast<int>(i),
          place.bary[k] * area);
      }
    }
  }
  for (int t = 0; t < this->refined.numberOfTriangles(); ++t)
  {
    const int c = this->surface->faceChart[this->refined.face[t]];
    for (int k = 0; k < 3; ++k)
    {
      const int p = this->refined.triangles[t][k];
      visit(p, firstPixel[c] + this->images[c].pixelAt(this->refined.uv[t][k]),
        OwnPixel * this->mass[p]);
    }
  }
}

void SurfaceDiffusion::Internals::gatherShares()
{
  this->shares = { this->refined.points.size(), [this](const auto& add) {
                    this->forEachShare([&](int point, int pixel, double weight) {
                      if (weight > 0)
                      {
                        add(point, PixelShare{ pixel, weight });
                      }
                    });
                  } };
}

Eigen::VectorXd SurfaceDiffusion::Internals::pixelsToPoints(const std::vector<float*>& values) const
{
  std::size_t number = 0;
  for (const ControlImage& image : this->images)
  {
    number += static_cast<std::size_t>(image.numberOfPixels());
  }
  std::vector<float> all;
  all.reserve(number);
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    all.insert(all.end(), values[c], values[c] + this->images[c].numberOfPixels());
  }
  Eigen::VectorXd means(static_cast<Eigen::Index>(this->refined.points.size()));
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(means.size()), PointGrain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType p = begin; p < end; ++p)
      {
        double sum = 0;
        double weight = 0;
        for (const PixelShare& share : this->shares[p])
        {
          const float v = all[share.pixel];
          sum += share.weight * (v > 0.F ? static_cast<double>(v) : 0.);
          weight += share.weight;
        }
        means[p] = weight > 0 ? sum / weight : 0.;
      }
    });
  return means;
}

void SurfaceDiffusion::Internals::pointsToPixels(
  const Eigen::VectorXd& u, const std::vector<float*>& values) const
{
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->places[c].size()), PointGrain,
      [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const PixelPlace& place = this->places[c][i];
          const Triangle& t = this->refined.triangles[place.triangle];
          const double v =
            place.bary[0] * u[t[0]] + place.bary[1] * u[t[1]] + place.bary[2] * u[t[2]];
          values[c][i] = static_cast<float>(v);
        }
      });
  }
}

SurfaceDiffusion::SurfaceDiffusion() = default;
SurfaceDiffusion::~SurfaceDiffusion() = default;

void SurfaceDiffusion::setDomain(
  const AtlasSurface& surface, const std::vector<ControlImage>& images)
{
  this->Data = std::make_unique<Internals>();
  Internals& d = *this->Data;
  d.surface = &surface;
  d.images = images;
  for (ControlImage& image : d.images)
  {
    const auto n = static_cast<std::size_t>(image.numberOfPixels());
    d.area.emplace_back(image.areaDistortion, image.areaDistortion + n);
    d.face.emplace_back(image.faceIndex, image.faceIndex + n);
    image.control = nullptr;
    image.areaDistortion = d.area.back().data();
    image.faceIndex = d.face.back().data();
  }
  for (int h = 0; h < 3 * surface.numberOfFaces(); ++h)
  {
    d.longestEdge = std::max(
      d.longestEdge, (surface.points[surface.head(h)] - surface.points[surface.tail(h)]).norm());
  }
}

void SurfaceDiffusion::setTolerance(double tolerance)
{
  this->Tolerance = tolerance;
}

Status SurfaceDiffusion::smooth(
  const std::vector<float*>& values, double sigma, const Progress& progress)
{
  Internals& d = *this->Data;
  if (Status status = d.setRefinement(sigma, progress); !status.ok())
  {
    return status;
  }
  if (!report(progress, 0.3))
  {
    return Status::aborted();
  }
  double done = 0.3;
  const Stop stop = [&] { return !report(progress, done); };
  StepSolver* solver = nullptr;
  if (Status status = d.findSolver(sigma, stop, solver); !status.ok())
  {
    return status;
  }
  Eigen::VectorXd u = d.pixelsToPoints(values);
  // Obtuse triangles make weights negative, and results a little wider than the values that went
  // in.
  const double low = u.minCoeff();
  const double high = u.maxCoeff();
  const bool guesses = this->Tolerance >= Constants::GuessedTolerance;
  if (guesses && solver->changes.empty())
  {
    solver->changes.assign(Constants::HeatSteps, Eigen::VectorXd::Zero(u.size()));
  }
  for (int k = 0; k < Constants::HeatSteps; ++k)
  {
    done = 0.6 + 0.35 * k / Constants::HeatSteps;
    if (stop())
    {
      return Status::aborted();
    }
    const Eigen::VectorXd before = u;
    if (guesses)
    {
      u += solver->changes[k];
    }
    if (Status status = solver->solve(d.mass.cwiseProduct(before), this->Tolerance, u, stop);
        !status.ok())
    {
      return status;
    }
    u = u.cwiseMax(low).cwiseMin(high);
    if (guesses)
    {
      solver->changes[k] = u - before;
    }
  }
  d.pointsToPixels(u, values);
  return Status::success();
}
}
