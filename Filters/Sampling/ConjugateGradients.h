// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients on all threads: Eigen's take one.
#ifndef stipple_ConjugateGradients_h
#define stipple_ConjugateGradients_h

#include "Progress.h"
#include "StippleFiltersSamplingModule.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace stipple
{
/// M. Hestenes and E. Stiefel, Methods of Conjugate Gradients for Solving Linear Systems, 1952,
/// with the diagonal as the preconditioner. Sums are taken by blocks of fixed sizes: what comes out
/// does not depend on the number of threads.
class STIPPLEFILTERSSAMPLING_EXPORT ConjugateGradients
{
public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// Symmetric and positive definite, both triangles.
  explicit ConjugateGradients(const Matrix& matrix);

  /// Makes matrix * u = right from the guess u, until the residual is at most `tolerance` (above 0)
  /// of the right side. An error if so many rounds as twice the number of rows do not.
  Status solve(const Eigen::VectorXd& right, double tolerance, Eigen::VectorXd& u,
    const Stop& stop = {}) const;

private:
  Matrix System;
  Eigen::VectorXd InverseDiagonal;
};
}

#endif
