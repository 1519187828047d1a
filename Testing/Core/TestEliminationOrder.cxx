// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EliminationOrder.h"
#include "GraphLaplacian.h"

#include <Eigen/SparseCholesky>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace stipple;
using namespace graphs;

namespace
{
using Matrix = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
using Links = std::vector<std::pair<int, int>>;

void expectPermutation(const Permutation& order, int n)
{
  ASSERT_EQ(order.size(), n);
  std::vector<char> isTaken(static_cast<std::size_t>(n), 0);
  for (int i = 0; i < n; ++i)
  {
    ASSERT_GE(order.indices()[i], 0);
    ASSERT_LT(order.indices()[i], n);
    EXPECT_FALSE(isTaken[order.indices()[i]]);
    isTaken[order.indices()[i]] = 1;
  }
}

/// Entries of the factor in that order.
Eigen::Index fill(const Matrix& lower, const Permutation& order)
{
  Matrix inOrder(lower.rows(), lower.cols());
  inOrder.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order);
  const Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(inOrder);
  EXPECT_EQ(factor.info(), Eigen::Success);
  return static_cast<Matrix>(factor.matrixL()).nonZeros();
}
}

TEST(EliminationOrder, IsAPermutation)
{
  Links star;
  Links complete;
  for (int i = 1; i < 100; ++i)
  {
    star.emplace_back(0, i);
    for (int j = 0; j < i; ++j)
    {
      complete.emplace_back(j, i);
    }
  }
  Links components = gridLinks(20, 10);
  for (const auto& [a, b] : gridLinks(5, 30))
  {
    components.emplace_back(a + 210, b + 210);
  }
  const std::pair<int, Links> graphs[] = { { 1, {} }, { 50, {} }, { 100, star }, { 100, complete },
    { 370, components }, { 300, gridLinks(300, 1) }, { 900, gridLinks(30, 30) } };
  for (const auto& [n, links] : graphs)
  {
    for (const std::size_t largestPart : { 1, 4, 32, 1000 })
    {
      SCOPED_TRACE(std::to_string(n) + " unknowns, parts of " + std::to_string(largestPart));
      expectPermutation(eliminationOrder(laplacian(n, links), {}, largestPart), n);
    }
  }
  EXPECT_EQ(eliminationOrder(Matrix(0, 0)).size(), 0);
}

// Dissecting a grid fills in hardly more than minimum degrees do, even into parts as small as here,
// which do not see what is around them.
TEST(EliminationOrder, FillsInLittle)
{
  std::mt19937 random(3);
  for (const auto& [width, height] : { std::pair(60, 60), std::pair(200, 20) })
  {
    const int n = width * height;
    std::vector<int> number(static_cast<std::size_t>(n));
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    Links links = gridLinks(width, height);
    for (auto& [a, b] : links)
    {
      a = number[a];
      b = number[b];
    }
    const Matrix lower = laplacian(n, links);
    const Eigen::Index byDegree = fill(lower, eliminationOrder(lower));
    const Eigen::Index dissected = fill(lower, eliminationOrder(lower, {}, 100));
    EXPECT_LT(dissected, 1.4 * byDegree) << width << " x " << height;
  }
}

TEST(EliminationOrder, SeparatesTwoSides)
{
  // Two discs of a grid that one row joins: it comes last, and neither side before is split.
  const Matrix lower = laplacian(21 * 7, gridLinks(21, 7));
  const Permutation order = eliminationOrder(lower, {}, 80);
  int last = -1;
  for (int i = 0; i < order.size(); ++i)
  {
    last = order.indices()[i] == order.size() - 1 ? i : last;
  }
  EXPECT_NEAR(last % 21, 10, 3) << "its column";
}

TEST(EliminationOrder, StopsWhenAsked)
{
  const Matrix lower = laplacian(3600, gridLinks(60, 60));
  for (const int after : { 0, 1, 3, 8 })
  {
    int asked = 0;
    EXPECT_EQ(eliminationOrder(
                lower, [&] { return ++asked > after; }, 100)
                .size(),
      0);
  }
  int asked = 0;
  EXPECT_EQ(eliminationOrder(
              lower,
              [&] {
                ++asked;
                return false;
              },
              100)
              .size(),
    3600);
  EXPECT_GT(asked, 36) << "once for each part, at least";
}
