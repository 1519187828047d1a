// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ConformalMap.h"

#include "HarmonicSystem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stipple
{
namespace
{
/// A rectangle and where its corners sit on the boundary, as fractions of the boundary's length.
struct Placement
{
  std::array<double, 4> corner;
  Vec2 extent;
};

class BoundaryLayout
{
public:
  BoundaryLayout(const TriangleSurface& surface, const ChartMesh& chart)
    : Chart(chart)
  {
    const std::size_t n = chart.boundary.size();
    this->ArcLength.assign(n + 1, 0.);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Vec3& a = surface.points[chart.vertices[chart.boundary[i]]];
      const Vec3& b = surface.points[chart.vertices[chart.boundary[(i + 1) % n]]];
      this->ArcLength[i + 1] = this->ArcLength[i] + (b - a).norm();
    }
  }

  /// Puts the boundary vertices on the rectangle's sides, by arc length between its corners.
  void place(const Placement& placement, std::vector<Vec2>& uv) const
  {
    const int n = static_cast<int>(this->Chart.boundary.size());
    const double total = this->ArcLength[n];
    std::array<int, 4> corner;
    for (int k = 0; k < 4; ++k)
    {
      const double s = (placement.corner[k] - std::floor(placement.corner[k])) * total;
      const auto next = std::lower_bound(this->ArcLength.begin(), this->ArcLength.end() - 1, s);
      int i = static_cast<int>(next - this->ArcLength.begin());
      if (i > 0 && s - this->ArcLength[i - 1] < this->ArcLength[i] - s)
      {
        --i;
      }
      corner[k] = i % n;
    }
    // Corners in cyclic order and on different vertices, whatever the boundary's spacing.
    for (int k = 1; k < 4; ++k)
    {
      const int from = (corner[k] - corner[0] + n) % n;
      const int least = (corner[k - 1] - corner[0] + n) % n + 1;
      corner[k] = (corner[0] + std::clamp(k == 0 ? 0 : from, least, n - 4 + k)) % n;
    }
    const Vec2& e = placement.extent;
    const std::array<Vec2, 5> at = { Vec2(0, 0), Vec2(e.x(), 0), e, Vec2(0, e.y()), Vec2(0, 0) };
    for (int k = 0; k < 4; ++k)
    {
      const int begin = corner[k];
      const int count = (corner[(k + 1) % 4] - begin + n) % n;
      const auto lengthTo = [&](int j) {
        const int i = begin + j;
        return i <= n ? this->ArcLength[i] - this->ArcLength[begin]
                      : total - this->ArcLength[begin] + this->ArcLength[i - n];
      };
      const double side = lengthTo(count);
      for (int j = 0; j < count; ++j)
      {
        const double t = side > 0 ? lengthTo(j) / side : static_cast<double>(j) / count;
        // Exactly on the side: the coordinate that is constant is copied, not computed.
        Vec2 p = at[k] + t * (at[k + 1] - at[k]);
        p[k % 2 == 0 ? 1 : 0] = at[k][k % 2 == 0 ? 1 : 0];
        uv[this->Chart.boundary[(begin + j) % n]] = p;
      }
    }
  }

private:
  const ChartMesh& Chart;
  std::vector<double> ArcLength;
};

/// Mean over the surface of the density A3D / A2D relative to its least possible value, 1.
double meanDensity(
  const std::vector<double>& area, const ChartMesh& chart, const std::vector<Vec2>& uv)
{
  double total = 0;
  double plane = 0;
  double sum = 0;
  for (std::size_t i = 0; i < area.size(); ++i)
  {
    const Triangle& t = chart.triangles[i];
    const double a = 0.5 * orient2(uv[t[0]], uv[t[1]], uv[t[2]]);
    total += area[i];
    plane += std::abs(a);
    sum += area[i] * area[i] / std::max(std::abs(a), 1e-300);
  }
  return sum * plane / (total * total);
}

/// The points as a matrix with a row each.
auto rows(std::vector<Vec2>& uv)
{
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<Matrix>(uv.data()->data(), static_cast<Eigen::Index>(uv.size()), 2);
}

bool isValid(const ChartMesh& chart, const std::vector<Vec2>& uv)
{
  return std::all_of(chart.triangles.begin(), chart.triangles.end(),
    [&](const Triangle& t) { return orient2(uv[t[0]], uv[t[1]], uv[t[2]]) > 0; });
}

void measure(const std::vector<double>& area, const ChartMesh& chart, ConformalMap& map)
{
  const std::size_t n = area.size();
  map.density.resize(n);
  double total = 0;
  double plane = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Triangle& t = chart.triangles[i];
    const double a = 0.5 * orient2(map.uv[t[0]], map.uv[t[1]], map.uv[t[2]]);
    map.density[i] = area[i] / std::max(a, 1e-300);
    total += area[i];
    plane += a;
  }
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  for (double& d : map.density)
  {
    d *= plane / total;
  }
  std::sort(
    order.begin(), order.end(), [&](int a, int b) { return map.density[a] > map.density[b]; });
  double above = 0;
  for (int i : order)
  {
    map.densityRatio = map.density[i];
    above += area[i];
    if (above > 1e-3 * total)
    {
      break;
    }
  }
}
}

ConformalMap mapToRectangle(
  const TriangleSurface& surface, const ChartMesh& chart, const ConformalMapOptions& options)
{
  ConformalMap map;
  map.uv.assign(chart.vertices.size(), Vec2::Zero());
  std::vector<double> area(chart.triangles.size());
  for (std::size_t i = 0; i < area.size(); ++i)
  {
    area[i] = surface.faceArea(chart.faces[i]);
  }
  HarmonicSystem solver(surface, chart, chart.onBoundary);
  const BoundaryLayout layout(surface, chart);

  // One factorization serves every boundary, so several rectangles are tried: an opposite pair of
  // sides of 1, 2 or 4 times the other pair's length, turned by eighths of the boundary.
  std::vector<Placement> placements;
  for (int turn = 0; turn < 2; ++turn)
  {
    placements.push_back(
      { { turn / 8., .25 + turn / 8., .5 + turn / 8., .75 + turn / 8. }, Vec2::Ones() });
  }
  if (!options.square)
  {
    for (double aspect : { 2., 4. })
    {
      const double wide = 0.5 * aspect / (1 + aspect);
      for (int turn = 0; turn < 4; ++turn)
      {
        const double s = turn / 8.;
        placements.push_back({ { s, s + wide, s + 0.5, s + 0.5 + wide }, Vec2(1, 1 / aspect) });
      }
    }
  }
  const auto chooseBest = [&] {
    double best = std::numeric_limits<double>::infinity();
    std::vector<Vec2> uv(map.uv.size(), Vec2::Zero());
    map.valid = false;
    for (const Placement& placement : placements)
    {
      layout.place(placement, uv);
      solver.solve(rows(uv));
      const bool valid = isValid(chart, uv);
      const double cost = meanDensity(area, chart, uv);
      if ((valid && !map.valid) || (valid == map.valid && cost < best))
      {
        best = cost;
        map.uv = uv;
        map.extent = placement.extent;
        map.valid = valid;
      }
    }
  };
  if (solver.factorize(-std::numeric_limits<double>::infinity()))
  {
    chooseBest();
  }
  if (!map.valid)
  {
    map.fallback = true;
    if (solver.factorize(1e-2))
    {
      chooseBest();
    }
  }
  measure(area, chart, map);
  return map;
}
}
