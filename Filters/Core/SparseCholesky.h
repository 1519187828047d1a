// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Cholesky factorizations of large sparse matrices in dense blocks: several times faster than
// column by column (Eigen::SimplicialLLT), and they stop when asked.
#ifndef stipple_SparseCholesky_h
#define stipple_SparseCholesky_h

#include "ReportingThread.h"
#include "StippleFiltersCoreModule.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace stipple
{
/// The multifrontal method (Duff and Reid 1983; Liu 1992) in the order of approximate minimum
/// degrees. Neighbouring columns with hardly more than the same rows are eliminated as one dense
/// front; what that leaves of its rows is added to the front of the first of them.
class STIPPLEFILTERSCORE_EXPORT SparseCholesky
{
public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// Takes the lower triangle of a symmetric matrix, diagonal included. False if the matrix is not
  /// positive definite, or `stop` became true.
  bool factorize(const Matrix& lower, const Stop& stop = {});
  /// After a factorization that succeeded: what the matrix maps to each column.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides) const;

private:
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

  struct Front
  {
    int begin = 0;        ///< first column
    int end = 0;          ///< behind its last one
    std::size_t rows = 0; ///< in Rows: its columns, then the rows below them
    std::size_t rowsEnd = 0;
    std::size_t panel = 0;    ///< in Panels: its part of the factor, by columns
    int numberOfChildren = 0; ///< fronts that add to it

    int numberOfColumns() const { return this->end - this->begin; }
    int numberOfRows() const { return static_cast<int>(this->rowsEnd - this->rows); }
    int numberBelow() const { return this->numberOfRows() - this->numberOfColumns(); }
  };
  Matrix permuted(const Matrix& lower) const;
  /// These two are false if they are stopped.
  bool order(const Matrix& lower, const Stop& stop);
  bool findFronts(const Matrix& lower, const Stop& stop);
  bool eliminate(const Matrix& lower, const Stop& stop);
  int row(const Front& front, int i) const
  {
    return this->Rows[front.rows + static_cast<std::size_t>(i)];
  }

  Permutation Order;         // from a column's number to that in which it is eliminated
  std::vector<Front> Fronts; // children first
  std::vector<int> Rows;
  Eigen::VectorXd Panels;
};
}

#endif
