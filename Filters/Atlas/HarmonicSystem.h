// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The discrete Laplace equation on a chart: values of some vertices are given, natural boundary
// conditions elsewhere.
#ifndef stipple_HarmonicSystem_h
#define stipple_HarmonicSystem_h

#include "ChartMesh.h"
#include "SparseCholesky.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace stipple
{
/// Cotangent Laplacian (Pinkall and Polthier 1993) with one Cholesky factorization that serves any
/// given values.
class HarmonicSystem
{
public:
  /// One row a vertex, one column a function.
  using Values = Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

  /// The chart has to outlive the system; given: by vertex, whether its value is prescribed. Once
  /// `stop` is true, factorizations fail.
  HarmonicSystem(const TriangleSurface& surface, const ChartMesh& chart,
    const std::vector<char>& given, const Stop& stop = {});

  /// False if the factorization failed. Weights of edges at the vertices in positiveAt, if not
  /// empty, are raised to a positive value where they are below it: around such a vertex values
  /// obey the maximum principle.
  bool factorize(const std::vector<char>& positiveAt = {});

  /// The same with the intrinsic Delaunay triangulation of the chart, whose weights are not
  /// negative: values obey the maximum principle, and slivers do no harm. Interpolated on the
  /// chart's own triangles they may be less smooth.
  bool factorizeDelaunay();

  /// The same with equal weights (Tutte 1963): each value is the mean of its neighbours', whatever
  /// the triangles are like.
  bool factorizeUniform();

  /// Overwrites the rows of free vertices with the harmonic extension of the given rows. Eight
  /// columns take hardly longer than one.
  void solve(Values values) const;

private:
  struct GivenTerm
  {
    int unknown;
    int vertex;
    double weight;
  };
  /// Half the cotangent opposite an edge, of the one triangle and the other.
  using HalfWeights = std::vector<Eigen::Triplet<double>>;
  HalfWeights ownWeights() const;
  HalfWeights delaunayWeights() const;
  HalfWeights uniformWeights() const;
  Eigen::SparseMatrix<double> laplacian(
    const HalfWeights& halves, const std::vector<char>& positiveAt);
  bool factorizeWith(const HalfWeights& weights, const std::vector<char>& positiveAt = {});
  bool isInBlocks() const;
  Eigen::MatrixXd solveByColumns(const Eigen::MatrixXd& rightHandSides) const;

  const TriangleSurface& Surface;
  const ChartMesh& Chart;
  std::vector<int> Unknown; // by vertex, -1 if given
  int NumberOfUnknowns = 0;
  std::vector<GivenTerm> GivenTerms;
  Stop IsToStop;
  /// By columns, or in blocks where there are many unknowns.
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> ByColumns;
  SparseCholesky InBlocks;
};
}

#endif
