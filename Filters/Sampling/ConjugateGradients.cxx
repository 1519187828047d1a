// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ConjugateGradients.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <vector>

namespace stipple
{
namespace
{
using Eigen::Index;
using Eigen::VectorXd;

constexpr Index Block = 1024; ///< rows: some 10 us of work

struct Sums
{
  double first = 0;
  double second = 0;
};

/// The sums of what work(first, number) returns, over all blocks of rows; it may write these rows.
template <typename Work>
Sums sumOverBlocks(Index rows, const Work& work)
{
  std::vector<Sums> parts(static_cast<std::size_t>((rows + Block - 1) / Block));
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType b = begin; b < end; ++b)
    {
      const Index first = b * Block;
      parts[static_cast<std::size_t>(b)] = work(first, std::min(Block, rows - first));
    }
  });
  Sums sums;
  for (const Sums& part : parts)
  {
    sums.first += part.first;
    sums.second += part.second;
  }
  return sums;
}

/// A row of a symmetric matrix, which is stored by columns, times a vector.
double timesRow(const ConjugateGradients::Matrix& matrix, Index row, const VectorXd& vector)
{
  double sum = 0;
  for (ConjugateGradients::Matrix::InnerIterator entry(matrix, row); entry; ++entry)
  {
    sum += entry.value() * vector[entry.index()];
  }
  return sum;
}
}

ConjugateGradients::ConjugateGradients(const Matrix& matrix)
  : System(matrix)
  , InverseDiagonal(this->System.diagonal().cwiseInverse())
{
}

Status ConjugateGradients::solve(
  const VectorXd& right, double tolerance, VectorXd& u, const Stop& stop) const
{
  const Matrix& a = this->System;
  const VectorXd& inverse = this->InverseDiagonal;
  const Index n = right.size();
  VectorXd residual(n);
  VectorXd direction(n);
  VectorXd image(n);

  // Of the right side, and the residual of the guess.
  const Sums squares = sumOverBlocks(n, [&](Index first, Index number) {
    for (Index i = first; i < first + number; ++i)
    {
      residual[i] = right[i] - timesRow(a, i, u);
      direction[i] = inverse[i] * residual[i];
    }
    return Sums{ right.segment(first, number).squaredNorm(),
      residual.segment(first, number).squaredNorm() };
  });
  if (squares.first == 0)
  {
    u.setZero();
    return Status::success();
  }
  const double least = tolerance * tolerance * squares.first;
  double left = squares.second;
  double energy = residual.dot(direction);
  for (Index round = 0; left > least; ++round)
  {
    if (isAsked(stop))
    {
      return Status::aborted();
    }
    const double curvature = sumOverBlocks(n, [&](Index first, Index number) {
      for (Index i = first; i < first + number; ++i)
      {
        image[i] = timesRow(a, i, direction);
      }
      return Sums{ image.segment(first, number).dot(direction.segment(first, number)) };
    }).first;
    if (round == 2 * n || !(curvature > 0))
    {
      return Status::error("conjugate gradients do not lead to a solution");
    }
    const double step = energy / curvature;
    const Sums after = sumOverBlocks(n, [&](Index first, Index number) {
      u.segment(first, number) += step * direction.segment(first, number);
      auto r = residual.segment(first, number);
      r -= step * image.segment(first, number);
      return Sums{ r.squaredNorm(), r.dot(inverse.segment(first, number).cwiseProduct(r)) };
    });
    left = after.first;
    const double turn = after.second / energy;
    energy = after.second;
    sumOverBlocks(n, [&](Index first, Index number) {
      auto d = direction.segment(first, number);
      d = inverse.segment(first, number).cwiseProduct(residual.segment(first, number)) + turn * d;
      return Sums();
    });
  }
  return Status::success();
}
}
