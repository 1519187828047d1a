// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Matrices as maps have them, for tests of what solves them.
#ifndef stipple_GraphLaplacian_h
#define stipple_GraphLaplacian_h

#include <Eigen/SparseCore>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace graphs
{
/// A Laplacian over links, the lower triangle of it, and a little more on the diagonal.
inline Eigen::SparseMatrix<double> laplacian(
  int n, const std::vector<std::pair<int, int>>& links, double more = 1e-3)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> weight(0.1, 2.);
  std::vector<Eigen::Triplet<double>> entries;
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
  Eigen::SparseMatrix<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Of a grid of triangles.
inline std::vector<std::pair<int, int>> gridLinks(int width, int height)
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
}

#endif
