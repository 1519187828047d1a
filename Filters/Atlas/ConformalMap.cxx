// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ConformalMap.h"

#include "AtlasConstants.h"
#include "HarmonicSystem.h"
#include "RectangleLayout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
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

/// Dirichlet energies of the two coordinates: integrals of their squared gradients over the
/// surface.
Vec2 dirichletEnergies(const TriangleSurface& surface, const std::vector<double>& area,
  const ChartMesh& chart, const std::vector<Vec2>& uv)
{
  Vec2 energy = Vec2::Zero();
  for (std::size_t i = 0; i < area.size(); ++i)
  {
    // The gradient of a corner's hat function is the edge opposite, turned, over twice the area.
    Eigen::Matrix<double, 3, 2> sum = Eigen::Matrix<double, 3, 2>::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += surface.edge(halfedgeOf(chart.faces[i], nextCorner(k))) *
        uv[chart.triangles[i][k]].transpose();
    }
    energy += area[i] > 0 ? Vec2(sum.colwise().squaredNorm().transpose() / (4 * area[i]))
                          : Vec2(Vec2::Zero());
  }
  return energy;
}

/// The extent of the rectangle with which a map is closest to conformal: both coordinates have the
/// same energy then.
Vec2 fittingExtent(const Vec2& energies, const Vec2& extent)
{
  if (!(energies.minCoeff() > 0))
  {
    return extent;
  }
  const double ratio = std::clamp(extent.y() / extent.x() * std::sqrt(energies.x() / energies.y()),
    1 / Constants::LongestRectangle, Constants::LongestRectangle);
  return Vec2(1, ratio) / std::max(1., ratio);
}

void scale(std::vector<Vec2>& uv, const Vec2& from, const Vec2& to)
{
  if (from != to)
  {
    const Vec2 factor = to.cwiseQuotient(from);
    for (Vec2& p : uv)
    {
      p = p.cwiseProduct(factor);
    }
  }
}

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The points as a matrix with a row each.
auto rows(std::vector<Vec2>& uv)
{
  return Eigen::Map<Rows>(uv.data()->data(), static_cast<Eigen::Index>(uv.size()), 2);
}

bool isValid(const ChartMesh& chart, const std::vector<Vec2>& uv)
{
  return std::all_of(chart.triangles.begin(), chart.triangles.end(),
    [&](const Triangle& t) { return orient2(uv[t[0]], uv[t[1]], uv[t[2]]) > 0; });
}

/// Whether a triangle's smallest angle in the plane is one that samples can be told apart by: where
/// the surface reaches deep behind a narrow place, maps lie flat on their boundary.
bool hasAngles(const Vec2& a, const Vec2& b, const Vec2& c)
{
  std::array<double, 3> squared = { { (b - a).squaredNorm(), (c - b).squaredNorm(),
    (a - c).squaredNorm() } };
  std::sort(squared.begin(), squared.end());
  return orient2(a, b, c) > Constants::LeastAngle * std::sqrt(squared[1] * squared[2]);
}

/// Marks the vertices of triangles that are not counterclockwise in the plane, and so many rings of
/// neighbours around everything marked.
void markFlipped(
  const ChartMesh& chart, const std::vector<Vec2>& uv, int rings, std::vector<char>& marked)
{
  for (const Triangle& t : chart.triangles)
  {
    if (!(orient2(uv[t[0]], uv[t[1]], uv[t[2]]) > 0))
    {
      marked[t[0]] = marked[t[1]] = marked[t[2]] = 1;
    }
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<char> before = marked;
    for (const Triangle& t : chart.triangles)
    {
      if (before[t[0]] || before[t[1]] || before[t[2]])
      {
        marked[t[0]] = marked[t[1]] = marked[t[2]] = 1;
      }
    }
  }
}

std::vector<double> areas(const TriangleSurface& surface, const ChartMesh& chart)
{
  std::vector<double> area(chart.faces.size());
  std::transform(chart.faces.begin(), chart.faces.end(), area.begin(),
    [&](Face f) { return surface.faceArea(f); });
  return area;
}
}

void measureMap(const TriangleSurface& surface, const ChartMesh& chart, ConformalMap& map)
{
  map.area = areas(surface, chart);
  const std::vector<double>& area = map.area;
  map.valid = isValid(chart, map.uv);
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
  for (double& d : map.density)
  {
    d *= plane / total;
  }
  map.densityRatio = densityQuantile(map, NegligibleArea);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Triangle& t = chart.triangles[i];
    if (map.density[i] > map.densityRatio && !hasAngles(map.uv[t[0]], map.uv[t[1]], map.uv[t[2]]))
    {
      map.densityRatio = map.density[i];
    }
  }
}

double densityQuantile(const ConformalMap& map, double share)
{
  const std::vector<double>& area = map.area;
  const double total = std::accumulate(area.begin(), area.end(), 0.);
  std::vector<int> order(area.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(
    order.begin(), order.end(), [&](int a, int b) { return map.density[a] > map.density[b]; });
  double above = 0;
  double quantile = 0;
  for (int i : order)
  {
    quantile = map.density[i];
    above += area[i];
    if (above > share * total)
    {
      break;
    }
  }
  return quantile;
}

ConformalMap mapToRectangle(const TriangleSurface& surface, const ChartMesh& chart,
  const ConformalMapOptions& options, const Stop& stop)
{
  ConformalMap map;
  map.uv.assign(chart.vertices.size(), Vec2::Zero());
  const std::vector<double> area = areas(surface, chart);
  HarmonicSystem solver(surface, chart, chart.onBoundary, stop);
  const RectangleLayout layout(surface, chart);

  // One factorization serves every boundary, so several rectangles are tried.
  const std::vector<RectanglePlacement> placements = layout.placements(options.square);
  const bool isLong = std::any_of(
    placements.begin(), placements.end(), [](const RectanglePlacement& p) { return p.fits; });
  const RectanglePlacement* best = nullptr;
  const auto solve = [&](const RectanglePlacement& placement, std::vector<Vec2>& uv) {
    layout.place(placement, uv);
    solver.solve(rows(uv));
  };
  const auto judge = [&](
                       const RectanglePlacement& placement, std::vector<Vec2>& uv, double& least) {
    double cost = meanDensity(area, chart, uv);
    Vec2 extent = placement.extent;
    if (isLong)
    {
      const Vec2 energies = dirichletEnergies(surface, area, chart, uv);
      extent = placement.fits ? fittingExtent(energies, placement.extent) : placement.extent;
      const Vec2 scaled = energies.cwiseProduct(extent.cwiseQuotient(placement.extent).cwiseAbs2());
      const double stretch = 0.5 * scaled.sum() / (extent.x() * extent.y());
      cost *= std::max(1., stretch / Constants::MostStretch);
    }
    if (cost < least)
    {
      least = cost;
      best = &placement;
      std::swap(map.uv, uv);
      map.extent = extent;
    }
  };
  const auto tryAll = [&] {
    double least = std::numeric_limits<double>::infinity();
    std::vector<Vec2> uv(map.uv.size(), Vec2::Zero());
    for (std::size_t first = 0; first < placements.size(); first += Constants::MapsAtOnce)
    {
      if (isAsked(stop))
      {
        return;
      }
      const int n = static_cast<int>(std::min(Constants::MapsAtOnce, placements.size() - first));
      Rows all = Rows::Zero(static_cast<Eigen::Index>(uv.size()), 2 * n);
      for (int i = 0; i < n; ++i)
      {
        layout.place(placements[first + i], uv);
        all.middleCols<2>(2 * i) = rows(uv);
      }
      solver.solve(all);
      for (int i = 0; i < n && !isAsked(stop); ++i)
      {
        rows(uv) = all.middleCols<2>(2 * i);
        judge(placements[first + i], uv, least);
      }
    }
    map.valid = best && isValid(chart, map.uv);
  };
  if (solver.factorize())
  {
    tryAll();
  }
  // What is long has long slivers, as a rule, which flip; Delaunay triangles in their place do not.
  if (!map.valid && isLong && !isAsked(stop) && solver.factorizeDelaunay())
  {
    tryAll();
  }
  if (isAsked(stop))
  {
    return map;
  }
  if (!best)
  {
    best = &placements.front();
    map.extent = best->extent;
  }
  // Where triangles are flipped, and a wider neighbourhood every time, weights are made positive.
  std::vector<char> positiveAt(map.uv.size(), 0);
  for (int repair = 0; repair < Constants::MostMapRepairs && !map.valid; ++repair)
  {
    map.fallback = true;
    if (repair + 1 == Constants::MostMapRepairs)
    {
      positiveAt.assign(map.uv.size(), 1);
    }
    else
    {
      markFlipped(chart, map.uv, repair, positiveAt);
    }
    if (isAsked(stop))
    {
      return map;
    }
    if (solver.factorize(positiveAt))
    {
      solve(*best, map.uv);
      map.valid = isValid(chart, map.uv);
    }
  }
  scale(map.uv, best->extent, map.extent);
  measureMap(surface, chart, map);
  return map;
}

ConformalMap mapByMeans(const TriangleSurface& surface, const ChartMesh& chart, const Stop& stop)
{
  ConformalMap map;
  map.fallback = true;
  map.uv.assign(chart.vertices.size(), Vec2::Zero());
  RectangleLayout(surface, chart).place({ { 0., 0.25, 0.5, 0.75 }, map.extent }, map.uv);
  HarmonicSystem solver(surface, chart, chart.onBoundary, stop);
  if (solver.factorizeUniform())
  {
    solver.solve(rows(map.uv));
  }
  measureMap(surface, chart, map);
  return map;
}
}
