// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Factorizations in dense blocks, against Eigen's.
#include "SparseCholesky.h"

#include <Eigen/SparseCholesky>

#include <gtest/gtest.h>

#include <random>

using namespace stipple;

namespace
{
using Matrix = SparseCholesky::Matrix;
using Entries = std::vector<Eigen::Triplet<double>>;

/// A Laplacian over links, the lower triangle of it, and a little more on the diagonal.
Matrix laplacian(int n, const std::vector<std::pair<int, int>>& links, double more = 1e-3)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> weight(0.1, 2.);
  Entries entries;
  for (const auto& [a, b] : links)
  {
    const double w = weight(random);
    entries.emplace_back(std::max(a, b), std::min(a, b), -w);
    entries.emplace_back(a, a, w);
    entries.emplace_back(b, b, w);
  }
  for (int i = 0; i < n; ++i)
  {
    entries.emplace_back(i, i, more);
  }
  Matrix result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Of a grid of triangles.
std::vector<std::pair<int, int>> gridLinks(int width, int height)
{
  std::vector<std::pair<int, int>> links;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const int i = y * width + x;
      for (const auto& [dx, dy] : { std::pair(1, 0), std::pair(0, 1), std::pair(1, 1) })
      {
        if (x + dx < width && y + dy < height)
        {
          links.emplace_back(i, i + dy * width + dx);
        }
      }
    }
  }
  return links;
}

void expectToSolve(const Matrix& lower)
{
  SparseCholesky cholesky;
  ASSERT_TRUE(cholesky.factorize(lower));
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(lower.rows(), 3);
  const Eigen::MatrixXd x = cholesky.solve(b);
  const Eigen::SimplicialLLT<Matrix> reference(lower);
  ASSERT_EQ(reference.info(), Eigen::Success);
  const Eigen::MatrixXd expected = reference.solve(b);
  EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm()) << lower.rows() << " unknowns";
}
}

TEST(SparseCholesky, SolvesWhatEigenSolves)
{
  expectToSolve(laplacian(1, {}));
  expectToSolve(laplacian(2, { { 0, 1 } }));
  expectToSolve(laplacian(40, {})); // a diagonal
  for (const auto& [width, height] :
    { std::pair(3, 2), std::pair(7, 7), std::pair(40, 1), std::pair(100, 3), std::pair(90, 80) })
  {
    expectToSolve(laplacian(width * height, gridLinks(width, height)));
  }
  // Several components, and points that belong to none.
  auto links = gridLinks(20, 10);
  for (const auto& [a, b] : gridLinks(5, 30))
  {
    links.emplace_back(a + 210, b + 210);
  }
  expectToSolve(laplacian(370, links));
  // One row that is full, first and last, and a matrix that is.
  for (const int hub : { 0, 299 })
  {
    links = gridLinks(15, 20);
    for (int i = 0; i < 300; ++i)
    {
      if (i != hub)
      {
        links.emplace_back(hub, i);
      }
    }
    expectToSolve(laplacian(300, links));
  }
  links.clear();
  for (int i = 0; i < 200; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      links.emplace_back(i, j);
    }
  }
  expectToSolve(laplacian(200, links));
}

TEST(SparseCholesky, SolvesRandomMatrices)
{
  std::mt19937 random(11);
  for (int draw = 0; draw < 60; ++draw)
  {
    const int n = 2 + static_cast<int>(random() % 200);
    std::vector<std::pair<int, int>> links;
    for (unsigned int i = 0; i < random() % 600; ++i)
    {
      const int a = static_cast<int>(random() % static_cast<unsigned int>(n));
      const int b = static_cast<int>(random() % static_cast<unsigned int>(n));
      if (a != b)
      {
        links.emplace_back(a, b);
      }
    }
    expectToSolve(laplacian(n, links, 0.01));
  }
}

TEST(SparseCholesky, GivesTheSameTwice)
{
  const Matrix lower = laplacian(900, gridLinks(30, 30));
  const Eigen::MatrixXd b = Eigen::MatrixXd::Ones(900, 1);
  SparseCholesky one;
  SparseCholesky other;
  ASSERT_TRUE(one.factorize(lower) && other.factorize(lower));
  EXPECT_EQ(one.solve(b), other.solve(b));
  ASSERT_TRUE(one.factorize(laplacian(4, gridLinks(2, 2)))); // another one after it
  EXPECT_EQ(one.solve(Eigen::MatrixXd::Ones(4, 1)).rows(), 4);
  ASSERT_TRUE(one.factorize(lower));
  EXPECT_EQ(one.solve(b), other.solve(b));
}

TEST(SparseCholesky, TellsWhatIsNotPositiveDefinite)
{
  SparseCholesky cholesky;
  EXPECT_FALSE(cholesky.factorize(laplacian(100, gridLinks(10, 10), -0.5)));
  Matrix zero(3, 3);
  zero.insert(0, 0) = 1.;
  zero.insert(1, 1) = 0.;
  zero.insert(2, 2) = 1.;
  EXPECT_FALSE(cholesky.factorize(zero));
  EXPECT_TRUE(cholesky.factorize(Matrix(0, 0)));
  EXPECT_EQ(cholesky.solve(Eigen::MatrixXd(0, 2)).rows(), 0);
}

TEST(SparseCholesky, StopsWhenAsked)
{
  const Matrix lower = laplacian(10000, gridLinks(100, 100));
  SparseCholesky cholesky;
  int asked = 0;
  EXPECT_FALSE(cholesky.factorize(lower, [&asked] { return ++asked > 50; }));
  EXPECT_EQ(asked, 51);
  EXPECT_TRUE(cholesky.factorize(lower, [] { return false; }));
}
