// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HarmonicSystem.h"

#include "AtlasConstants.h"

#include <algorithm>

namespace stipple
{
using Constants = AtlasConstants;

HarmonicSystem::HarmonicSystem(
  const TriangleSurface& surface, const ChartMesh& chart, const std::vector<char>& given)
  : Chart(chart)
{
  this->Unknown.assign(chart.vertices.size(), -1);
  for (std::size_t v = 0; v < chart.vertices.size(); ++v)
  {
    if (!given[v])
    {
      this->Unknown[v] = this->NumberOfUnknowns++;
    }
  }
  this->Cotangents.resize(chart.triangles.size());
  for (std::size_t i = 0; i < chart.triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto x = [&](int c) -> const Vec3& {
        return surface.points[chart.vertices[chart.triangles[i][c % 3]]];
      };
      this->Cotangents[i][k] = 0.5 * cotangent(x(k), x(k + 1), x(k + 2), 1e3);
    }
  }
}

bool HarmonicSystem::factorize(const std::vector<char>& positiveAt)
{
  this->GivenTerms.clear();
  // Each triangle contributes half an edge's weight; clamping has to see the whole weight.
  std::vector<Eigen::Triplet<double>> edges;
  edges.reserve(3 * this->Chart.triangles.size());
  const int n = this->Chart.numberOfVertices();
  for (std::size_t i = 0; i < this->Chart.triangles.size(); ++i)
  {
    const Triangle& t = this->Chart.triangles[i];
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[nextCorner(k)];
      const int b = t[previousCorner(k)];
      edges.emplace_back(std::min(a, b), std::max(a, b), this->Cotangents[i][k]);
    }
  }
  Eigen::SparseMatrix<double> weights(n, n);
  weights.setFromTriplets(edges.begin(), edges.end());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * this->Chart.triangles.size());
  for (int column = 0; column < n; ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator it(weights, column); it; ++it)
    {
      const int a = this->Unknown[it.row()];
      const int b = this->Unknown[it.col()];
      const bool positive = !positiveAt.empty() && (positiveAt[it.row()] || positiveAt[it.col()]);
      const double w = positive ? std::max(it.value(), Constants::LeastPositiveWeight) : it.value();
      if (a >= 0 && b >= 0)
      {
        entries.emplace_back(std::max(a, b), std::min(a, b), -w);
      }
      if (a >= 0)
      {
        entries.emplace_back(a, a, w);
      }
      if (b >= 0)
      {
        entries.emplace_back(b, b, w);
      }
      if ((a >= 0) != (b >= 0))
      {
        this->GivenTerms.push_back(
          { a >= 0 ? a : b, static_cast<int>(a >= 0 ? it.col() : it.row()), w });
      }
    }
  }
  Eigen::SparseMatrix<double> laplacian(this->NumberOfUnknowns, this->NumberOfUnknowns);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  this->Cholesky.compute(laplacian);
  return this->Cholesky.info() == Eigen::Success;
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
  const Eigen::MatrixXd x = this->Cholesky.solve(rhs);
  for (Eigen::Index v = 0; v < values.rows(); ++v)
  {
    if (this->Unknown[v] >= 0)
    {
      values.row(v) = x.row(this->Unknown[v]);
    }
  }
}
}
