// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDiffusion.h"

#include "SamplingConstants.h"

#include "vtkSMPTools.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <future>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

using SparseMatrix = Eigen::SparseMatrix<double>;
using Cholesky = Eigen::SimplicialLDLT<SparseMatrix>;
using ConjugateGradient = Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper>;

/// One implicit step, made ready for a sigma. With few points within a kernel the matrix is close
/// to the diagonal one, and conjugate gradients need some ten rounds; with many a factorization is
/// faster.
struct StepSolver
{
  double sigma = 0;
  SparseMatrix matrix;
  std::unique_ptr<Cholesky> cholesky;
  std::unique_ptr<ConjugateGradient> iterative;

  bool compute(double pointsInKernel)
  {
    if (pointsInKernel > 30.)
    {
      this->cholesky = std::make_unique<Cholesky>();
      this->cholesky->compute(this->matrix);
      return this->cholesky->info() == Eigen::Success;
    }
    this->iterative = std::make_unique<ConjugateGradient>();
    this->iterative->compute(this->matrix);
    return this->iterative->info() == Eigen::Success;
  }
  bool solve(const Eigen::VectorXd& right, double tolerance, Eigen::VectorXd& u) const
  {
    if (this->cholesky)
    {
      u = this->cholesky->solve(right);
      return true;
    }
    this->iterative->setTolerance(tolerance);
    u = this->iterative->solveWithGuess(right, u).eval();
    return this->iterative->info() == Eigen::Success;
  }
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
  std::vector<std::vector<PixelPlace>> places; ///< by chart and pixel
  Eigen::VectorXd mass;
  SparseMatrix stiffness;
  std::deque<std::unique_ptr<StepSolver>> solvers;

  /// What is computed beside this thread, also after a run that was stopped; the future waits for
  /// it when it is destroyed.
  std::unique_ptr<StepSolver> pendingSolver;
  double pendingLongest = -1; ///< of the refinement that it is for
  std::future<bool> pending;

  Status setRefinement(double sigma, const Progress& progress);
  Status findSolver(double sigma, const Progress& progress, const StepSolver*& found);
  Status waitForPending(const Progress& progress);
  const StepSolver* keep(std::unique_ptr<StepSolver> solver);
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
  this->longest = wanted;
  return Status::success();
}

Status SurfaceDiffusion::Internals::waitForPending(const Progress& progress)
{
  while (this->pending.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
  {
    if (!report(progress, 0.3))
    {
      return Status::aborted();
    }
  }
  return Status::success();
}

const StepSolver* SurfaceDiffusion::Internals::keep(std::unique_ptr<StepSolver> solver)
{
  if (this->solvers.size() >= Constants::KeptSolvers)
  {
    this->solvers.pop_front();
  }
  this->solvers.push_back(std::move(solver));
  return this->solvers.back().get();
}

/// Null is found if the system cannot be solved.
Status SurfaceDiffusion::Internals::findSolver(
  double sigma, const Progress& progress, const StepSolver*& found)
{
  found = nullptr;
  for (const auto& solver : this->solvers)
  {
    if (solver->sigma == sigma)
    {
      found = solver.get();
      return Status::success();
    }
  }
  if (this->pending.valid())
  {
    if (Status status = this->waitForPending(progress); !status.ok())
    {
      return status;
    }
    const bool done = this->pending.get();
    if (done && this->pendingSolver->sigma == sigma && this->pendingLongest == this->longest)
    {
      found = this->keep(std::move(this->pendingSolver));
      return Status::success();
    }
  }
  auto solver = std::make_unique<StepSolver>();
  solver->sigma = sigma;
  solver->matrix = (0.5 * sigma * sigma / Constants::HeatSteps) * this->stiffness;
  solver->matrix.diagonal() += this->mass;
  const double pointsInKernel =
    sigma * sigma * static_cast<double>(this->refined.points.size()) / this->mass.sum();
  if (this->refined.points.size() < Constants::ManyPoints)
  {
    found = solver->compute(pointsInKernel) ? this->keep(std::move(solver)) : nullptr;
    return Status::success();
  }
  // Eigen's factorization cannot be interrupted, but it can be left alone.
  this->pendingSolver = std::move(solver);
  this->pendingLongest = this->longest;
  this->pending = std::async(std::launch::async,
    [work = this->pendingSolver.get(), pointsInKernel] { return work->compute(pointsInKernel); });
  if (Status status = this->waitForPending(progress); !status.ok())
  {
    return status;
  }
  found = this->pending.get() ? this->keep(std::move(this->pendingSolver)) : nullptr;
  return Status::success();
}

/// Every point takes the mean of the pixels around it, by area and nearness; a point that no pixel
/// is near to takes the pixel that it lies in.
Eigen::VectorXd SurfaceDiffusion::Internals::pixelsToPoints(const std::vector<float*>& values) const
{
  const auto n = static_cast<Eigen::Index>(this->refined.points.size());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(n);
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    const double pixelArea = this->images[c].pixelArea();
    for (std::size_t i = 0; i < this->places[c].size(); ++i)
    {
      const PixelPlace& place = this->places[c][i];
      const double v = values[c][i] > 0 ? values[c][i] : 0.;
      const double area = this->area[c][i] > 0 ? this->area[c][i] * pixelArea : 0.;
      for (int k = 0; k < 3; ++k)
      {
        const int p = this->refined.triangles[place.triangle][k];
        sum[p] += place.bary[k] * area * v;
        weight[p] += place.bary[k] * area;
      }
    }
  }
  for (int t = 0; t < this->refined.numberOfTriangles(); ++t)
  {
    const int c = this->surface->faceChart[this->refined.face[t]];
    for (int k = 0; k < 3; ++k)
    {
      const int p = this->refined.triangles[t][k];
      const float v = values[c][this->images[c].pixelAt(this->refined.uv[t][k])];
      sum[p] += 1e-3 * this->mass[p] * (v > 0 ? v : 0.);
      weight[p] += 1e-3 * this->mass[p];
    }
  }
  return sum.array() / weight.array().max(1e-300);
}

void SurfaceDiffusion::Internals::pointsToPixels(
  const Eigen::VectorXd& u, const std::vector<float*>& values) const
{
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(values.size()), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType c = begin; c < end; ++c)
      {
        for (std::size_t i = 0; i < this->places[c].size(); ++i)
        {
          const PixelPlace& place = this->places[c][i];
          const Triangle& t = this->refined.triangles[place.triangle];
          const double v =
            place.bary[0] * u[t[0]] + place.bary[1] * u[t[1]] + place.bary[2] * u[t[2]];
          values[c][i] = static_cast<float>(v);
        }
      }
    });
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
  const Status failure =
    Status::error("The heat equation on this surface could not be solved: lower Gradation or "
                  "BandPass.");
  const StepSolver* solver = nullptr;
  if (Status status = d.findSolver(sigma, progress, solver); !status.ok())
  {
    return status;
  }
  if (!solver)
  {
    return failure;
  }
  Eigen::VectorXd u = d.pixelsToPoints(values);
  // Obtuse triangles make weights negative, and results a little wider than the values that went
  // in.
  const double low = u.minCoeff();
  const double high = u.maxCoeff();
  for (int k = 0; k < Constants::HeatSteps; ++k)
  {
    if (!report(progress, 0.6 + 0.35 * k / Constants::HeatSteps))
    {
      return Status::aborted();
    }
    const Eigen::VectorXd right = d.mass.cwiseProduct(u);
    if (!solver->solve(right, this->Tolerance, u))
    {
      return failure;
    }
    u = u.cwiseMax(low).cwiseMin(high);
  }
  d.pointsToPixels(u, values);
  return Status::success();
}
}
