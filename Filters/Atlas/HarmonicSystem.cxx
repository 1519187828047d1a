// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HarmonicSystem.h"

#include "AtlasConstants.h"
#include "CompressedRows.h"
#include "IntrinsicTriangulation.h"
#include "ParallelFor.h"

#include <algorithm>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Solves L L^T x = b in place for so many right hand sides, from one column of x on. Eigen takes
/// them one by one, and reads the factor for each.
template <int Width>
void substitute(const Eigen::SparseMatrix<double>& lower, Rows& x, Eigen::Index first)
{
  using Row = Eigen::Map<Eigen::Matrix<double, Width, 1>>;
  const auto row = [&](Eigen::Index i) { return Row(&x(i, first)); };
  const Eigen::Index n = lower.cols();
  for (Eigen::Index i = 0; i < n; ++i)
  {
    Eigen::SparseMatrix<double>::InnerIterator it(lower, i); // a column's diagonal comes first
    const Eigen::Matrix<double, Width, 1> here = row(i) / it.value();
    row(i) = here;
    for (++it; it; ++it)
    {
      row(it.row()) -= it.value() * here;
    }
  }
  for (Eigen::Index i = n - 1; i >= 0; --i)
  {
    Eigen::SparseMatrix<double>::InnerIterator it(lower, i);
    const double diagonal = it.value();
    Eigen::Matrix<double, Width, 1> here = row(i);
    for (++it; it; ++it)
    {
      here -= it.value() * row(it.row());
    }
    row(i) = here / diagonal;
  }
}

using Entries = std::vector<Eigen::Triplet<double>>;

/// By an index from 0 to so many; those of the same one stay in order.
template <typename Index>
Entries sortedBy(const Entries& entries, int size, const Index& index)
{
  CompressedRows<Eigen::Triplet<double>> rows(size, [&](const auto& add) {
    for (const Eigen::Triplet<double>& entry : entries)
    {
      add(index(entry), entry);
    }
  });
  return rows.takeValues();
}

/// Adds up those of the same row and column, of which there are so many; by column, and then by
/// row.
Entries addedUp(const Entries& entries, int size)
{
  const Entries sorted =
    sortedBy(sortedBy(entries, size, [](const auto& entry) { return entry.row(); }), size,
      [](const auto& entry) { return entry.col(); });
  Entries sums;
  sums.reserve(entries.size());
  for (const Eigen::Triplet<double>& entry : sorted)
  {
    if (!sums.empty() && sums.back().row() == entry.row() && sums.back().col() == entry.col())
    {
      sums.back() = { entry.row(), entry.col(), sums.back().value() + entry.value() };
    }
    else
    {
      sums.push_back(entry);
    }
  }
  return sums;
}
}

HarmonicSystem::HarmonicSystem(const TriangleSurface& surface, const ChartMesh& chart,
  const std::vector<char>& given, const Stop& stop)
  : Surface(surface)
  , Chart(chart)
  , IsToStop(stop)
{
  this->Unknown.assign(chart.vertices.size(), -1);
  for (std::size_t v = 0; v < chart.vertices.size(); ++v)
  {
    if (!given[v])
    {
      this->Unknown[v] = this->NumberOfUnknowns++;
    }
  }
}

HarmonicSystem::HalfWeights HarmonicSystem::ownWeights() const
{
  HalfWeights weights(3 * this->Chart.triangles.size());
  const ElementRange<Face> faces(0, static_cast<int>(this->Chart.triangles.size()));
  parallelFor(faces, [&](Face f) {
    const Triangle& t = this->Chart.triangles[f.index()];
    for (int k = 0; k < 3; ++k)
    {
      const auto x = [&](int c) -> const Vec3& {
        return this->Surface.points[this->Chart.vertices[t[c % 3]]];
      };
      const auto [a, b] = std::minmax({ t[nextCorner(k)], t[previousCorner(k)] });
      weights[halfedgeOf(f, k).index()] = { a, b, 0.5 * cotangent(x(k), x(k + 1), x(k + 2), 1e3) };
    }
  });
  return weights;
}

HarmonicSystem::HalfWeights HarmonicSystem::delaunayWeights() const
{
  IntrinsicTriangulation triangulation(this->Surface, this->Chart);
  triangulation.flipToDelaunay();
  HalfWeights weights;
  for (const Halfedge h : triangulation.halfedges())
  {
    const auto [a, b] = std::minmax({ triangulation.tail(h), triangulation.head(h) });
    const double weight = 0.5 * triangulation.cotangentOpposite(h);
    if (a != b) // else an edge that comes back to its vertex
    {
      weights.emplace_back(a, b, triangulation.isBoundary(h) ? std::max(0., weight) : weight);
    }
  }
  return weights;
}

HarmonicSystem::HalfWeights HarmonicSystem::uniformWeights() const
{
  HalfWeights weights;
  weights.reserve(3 * this->Chart.triangles.size());
  for (const Triangle& t : this->Chart.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [a, b] = std::minmax({ t[k], t[nextCorner(k)] });
      weights.emplace_back(a, b, 0.5);
    }
  }
  return weights;
}

bool HarmonicSystem::isInBlocks() const
{
  return this->NumberOfUnknowns > Constants::MostUnknownsByColumns;
}

bool HarmonicSystem::factorize(const std::vector<char>& positiveAt)
{
  return this->factorizeWith(this->ownWeights(), positiveAt);
}

bool HarmonicSystem::factorizeDelaunay()
{
  return this->factorizeWith(this->delaunayWeights());
}

bool HarmonicSystem::factorizeUniform()
{
  return this->factorizeWith(this->uniformWeights());
}

Eigen::SparseMatrix<double> HarmonicSystem::laplacian(
  const HalfWeights& halves, const std::vector<char>& positiveAt)
{
  this->GivenTerms.clear();
  // Each triangle contributes half an edge's weight; clamping has to see the whole weight.
  const Entries edges = addedUp(halves, this->Chart.numberOfVertices());
  std::vector<double> diagonal(this->NumberOfUnknowns, 0.);
  Entries below; // the diagonal; rows ascend in each column, as unknowns do with vertices
  below.reserve(edges.size());
  std::vector<int> next(this->NumberOfUnknowns, 1); // entries of each column
  for (const Eigen::Triplet<double>& edge : edges)
  {
    const int a = this->Unknown[edge.row()];
    const int b = this->Unknown[edge.col()];
    const bool positive = !positiveAt.empty() && (positiveAt[edge.row()] || positiveAt[edge.col()]);
    const double w =
      positive ? std::max(edge.value(), Constants::LeastPositiveWeight) : edge.value();
    if (a >= 0)
    {
      diagonal[a] += w;
    }
    if (b >= 0)
    {
      diagonal[b] += w;
    }
    if (a >= 0 && b >= 0)
    {
      below.emplace_back(b, a, -w);
      ++next[a];
    }
    else if (a >= 0 || b >= 0)
    {
      this->GivenTerms.push_back({ a >= 0 ? a : b, a >= 0 ? edge.col() : edge.row(), w });
    }
  }
  Eigen::SparseMatrix<double> result(this->NumberOfUnknowns, this->NumberOfUnknowns);
  result.resizeNonZeros(static_cast<Eigen::Index>(below.size() + diagonal.size()));
  const auto put = [&result](int at, int row, double value) {
    result.innerIndexPtr()[at] = row;
    result.valuePtr()[at] = value;
  };
  int end = 0;
  for (int column = 0; column < this->NumberOfUnknowns; ++column)
  {
    const int begin = end;
    end += next[column];
    result.outerIndexPtr()[column] = begin;
    put(begin, column, diagonal[column]);
    next[column] = begin + 1;
  }
  result.outerIndexPtr()[this->NumberOfUnknowns] = end;
  for (const Eigen::Triplet<double>& entry : below)
  {
    put(next[entry.col()]++, entry.row(), entry.value());
  }
  return result;
}

bool HarmonicSystem::factorizeWith(const HalfWeights& weights, const std::vector<char>& positiveAt)
{
  if (isAsked(this->IsToStop))
  {
    return false;
  }
  const Eigen::SparseMatrix<double> laplacian = this->laplacian(weights, positiveAt);
  if (this->isInBlocks())
  {
    return this->InBlocks.factorize(laplacian, this->IsToStop);
  }
  this->ByColumns.compute(laplacian);
  return this->ByColumns.info() == Eigen::Success;
}

Eigen::MatrixXd HarmonicSystem::solveByColumns(const Eigen::MatrixXd& rightHandSides) const
{
  Rows x = this->ByColumns.permutationP() * rightHandSides;
  const Eigen::SparseMatrix<double>& lower = this->ByColumns.matrixL().nestedExpression();
  constexpr int AtOnce = 8; // a line of the cache
  Eigen::Index column = 0;
  for (; column + AtOnce <= x.cols(); column += AtOnce)
  {
    substitute<AtOnce>(lower, x, column);
  }
  for (; column + 2 <= x.cols(); column += 2)
  {
    substitute<2>(lower, x, column);
  }
  for (; column < x.cols(); ++column)
  {
    substitute<1>(lower, x, column);
  }
  return this->ByColumns.permutationPinv() * x;
}

void HarmonicSystem::solve(Values values) const
{
  if (this->NumberOfUnknowns == 0)
  {
    return;
  }
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(this->NumberOfUnknowns, values.cols());
  for (const GivenTerm& term : this->GivenTerms)
  {
    rhs.row(term.unknown) += term.weight * values.row(term.vertex);
  }
  const Eigen::MatrixXd x =
    this->isInBlocks() ? this->InBlocks.solve(rhs) : this->solveByColumns(rhs);
  for (Eigen::Index v = 0; v < values.rows(); ++v)
  {
    if (this->Unknown[v] >= 0)
    {
      values.row(v) = x.row(this->Unknown[v]);
    }
  }
}
}
