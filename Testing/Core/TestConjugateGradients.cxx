// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients, against Eigen's factorization.
#include "ConjugateGradients.h"

#include "vtkSMPTools.h"

#include <Eigen/SparseCholesky>

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace stipple;

namespace
{
using Matrix = ConjugateGradients::Matrix;

/// The Laplacian of a grid with weights that differ a hundredfold, and `more` on the diagonal.
Matrix gridMatrix(int n, double more)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-1., 1.);
  std::vector<Eigen::Triplet<double>> entries;
  const auto link = [&](int a, int b) {
    const double w = std::pow(10., exponent(random));
    entries.emplace_back(a, b, -w);
    entries.emplace_back(b, a, -w);
    entries.emplace_back(a, a, w);
    entries.emplace_back(b, b, w);
  };
  for (int i = 0; i < n * n; ++i)
  {
    entries.emplace_back(i, i, more);
    if (i % n + 1 < n)
    {
      link(i, i + 1);
    }
    if (i + n < n * n)
    {
      link(i, i + n);
    }
  }
  Matrix matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::VectorXd randomVector(Eigen::Index n)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1., 1.);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return value(random); });
}
}

TEST(ConjugateGradients, SolveWhateverTheGuess)
{
  for (const int n : { 1, 7, 60 }) // 60: several blocks, and the last one is not whole
  {
    const Matrix matrix = gridMatrix(n, 0.3);
    const Eigen::VectorXd right = randomVector(n * n);
    const Eigen::VectorXd exact = Eigen::SimplicialLDLT<Matrix>(matrix).solve(right);
    const ConjugateGradients solver(matrix);
    for (const Eigen::VectorXd& guess :
      { Eigen::VectorXd(Eigen::VectorXd::Zero(n * n)), right, exact })
    {
      Eigen::VectorXd u = guess;
      ASSERT_TRUE(solver.solve(right, 1e-10, u).ok());
      EXPECT_LE((matrix * u - right).norm(), 1.01e-10 * right.norm());
      EXPECT_LE((u - exact).norm(), 1e-8 * exact.norm());
    }
  }
}

TEST(ConjugateGradients, ATolerancesResidualIsReachedAndNotMuchMore)
{
  const Matrix matrix = gridMatrix(40, 0.01);
  const Eigen::VectorXd right = randomVector(1600);
  for (const double tolerance : { 1e-2, 1e-5 })
  {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(1600);
    ASSERT_TRUE(ConjugateGradients(matrix).solve(right, tolerance, u).ok());
    const double residual = (matrix * u - right).norm() / right.norm();
    EXPECT_LE(residual, tolerance);
    EXPECT_GE(residual, 0.1 * tolerance);
  }
}

TEST(ConjugateGradients, NothingComesOfNothing)
{
  Eigen::VectorXd u = randomVector(49);
  ASSERT_TRUE(ConjugateGradients(gridMatrix(7, 1.)).solve(Eigen::VectorXd::Zero(49), 1e-7, u).ok());
  EXPECT_EQ(u.norm(), 0.);
}

TEST(ConjugateGradients, AMatrixThatIsNotPositiveDefiniteIsAnError)
{
  Matrix matrix = gridMatrix(7, 1.);
  matrix.coeffRef(20, 20) = -50.;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(49);
  EXPECT_FALSE(ConjugateGradients(matrix).solve(randomVector(49), 1e-10, u).ok());
}

TEST(ConjugateGradients, StopWhenAsked)
{
  const ConjugateGradients solver(gridMatrix(40, 1e-3));
  Eigen::VectorXd u = Eigen::VectorXd::Zero(1600);
  int asked = 0;
  EXPECT_TRUE(solver.solve(randomVector(1600), 1e-12, u, [&] { return ++asked == 4; }).isAbort());
  EXPECT_EQ(asked, 4);
}

TEST(ConjugateGradients, AreTheSameForAnyNumberOfThreads)
{
  const ConjugateGradients solver(gridMatrix(130, 0.1));
  const Eigen::VectorXd right = randomVector(16900);
  std::vector<Eigen::VectorXd> solutions;
  for (const int threads : { 1, 2, 4 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&]() {
      solutions.emplace_back(Eigen::VectorXd::Zero(16900));
      EXPECT_TRUE(solver.solve(right, 1e-9, solutions.back()).ok());
    });
  }
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}
