// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapSizing.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
constexpr int smallestSide = 32;
constexpr int largestSide = 4096;
constexpr int leastRows = 4;

std::array<int, 2> withAspect(const Vec2& extent, int longer, int least)
{
  const double ratio = std::min(extent.x(), extent.y()) / std::max(extent.x(), extent.y());
  const int shorter = std::clamp(static_cast<int>(std::lround(longer * ratio)), least, longer);
  return extent.x() >= extent.y() ? std::array<int, 2>{ longer, shorter }
                                  : std::array<int, 2>{ shorter, longer };
}
} // namespace

namespace
{
/// densityRatio() for some fractions, ascending.
std::vector<double> densityRatios(const MapChart& chart, const std::vector<double>& fractions)
{
  struct Density
  {
    double value;
    double area;
  };
  std::vector<Density> densities;
  double area3D = 0.;
  double area2D = 0.;
  for (int f = 0; f < chart.numberOfTriangles(); ++f)
  {
    const auto& t = chart.triangles[f];
    const double plane = 0.5 * std::abs(orient2(chart.uv[t[0]], chart.uv[t[1]], chart.uv[t[2]]));
    const double space = chart.area[f];
    area3D += space;
    area2D += plane;
    if (plane > 0.)
    {
      densities.push_back({ space / plane, space });
    }
  }
  std::vector<double> ratios(fractions.size(), 1.);
  if (densities.empty() || area3D <= 0.)
  {
    return ratios;
  }
  std::sort(densities.begin(), densities.end(),
    [](const Density& a, const Density& b) { return a.value > b.value; });
  double above = 0.;
  auto d = densities.begin();
  double quantile = d->value;
  for (std::size_t i = 0; i < fractions.size(); ++i)
  {
    for (; d != densities.end() && above <= fractions[i] * area3D; ++d)
    {
      quantile = d->value;
      above += d->area;
    }
    ratios[i] = std::max(1., quantile * area2D / area3D);
  }
  return ratios;
}
}

double densityRatio(const MapChart& chart, double fraction)
{
  return densityRatios(chart, { fraction }).front();
}

MapDemand demandOf(const MapChart& chart)
{
  MapDemand demand;
  demand.extent = chart.extent;
  for (const float area : chart.area)
  {
    demand.area += area;
  }
  std::vector<double> fractions;
  for (double fraction = NegligibleFraction; fraction < 1.; fraction *= 2.)
  {
    fractions.push_back(fraction);
  }
  demand.coarseRatios = densityRatios(chart, fractions);
  demand.densityRatio = demand.coarseRatios.front();
  demand.coarseRatios.erase(demand.coarseRatios.begin());
  return demand;
}

double MapDemand::ratioFor(double samples) const
{
  double ratio = this->densityRatio;
  double fraction = 2. * NegligibleFraction;
  for (auto next = this->coarseRatios.begin();
       next != this->coarseRatios.end() && fraction * samples <= MissedSample;
       ++next, fraction *= 2.)
  {
    ratio = *next;
  }
  return ratio;
}

std::array<int, 2> automaticMapSize(const MapDemand& demand, double samples)
{
  const double pixels = 2. * std::max(0., samples) * demand.ratioFor(samples);
  const double ratio =
    std::min(demand.extent.x(), demand.extent.y()) / std::max(demand.extent.x(), demand.extent.y());
  const double needed = std::sqrt(pixels / ratio);
  int longer = smallestSide;
  for (int rung = 1; longer < needed && longer < largestSide; ++rung)
  {
    longer = static_cast<int>(std::lround(smallestSide * std::pow(2., 0.5 * rung)));
  }
  longer = std::min(longer, largestSide);
  // The shorter side of a long rectangle: its pixels are square, if they are as many as in the
  // least square.
  return withAspect(demand.extent, longer,
    std::clamp(smallestSide * smallestSide / longer, leastRows, smallestSide));
}

std::vector<std::array<int, 2>> automaticMapSizes(
  const std::vector<MapDemand>& demands, double samples)
{
  double area = 0.;
  double largestRatio = 1.;
  for (const MapDemand& demand : demands)
  {
    area += demand.area;
  }
  const auto share = [&](const MapDemand& demand) {
    return area > 0. ? samples * demand.area / area : 0.;
  };
  for (const MapDemand& demand : demands)
  {
    largestRatio = std::max(largestRatio, demand.ratioFor(share(demand)));
  }
  const double most = std::max(MostPixels, 32. * samples);
  std::vector<std::array<int, 2>> sizes(demands.size());
  for (double ratio = largestRatio;; ratio = std::max(1., 0.5 * ratio)) // 1 at last
  {
    double pixels = 0.;
    for (std::size_t i = 0; i < demands.size(); ++i)
    {
      MapDemand demand = demands[i];
      demand.densityRatio = std::min(demand.ratioFor(share(demand)), ratio);
      demand.coarseRatios.clear();
      sizes[i] = automaticMapSize(demand, share(demand));
      pixels += static_cast<double>(sizes[i][0]) * sizes[i][1];
    }
    if (pixels <= most || ratio <= 1.)
    {
      return sizes;
    }
  }
}

std::array<int, 2> fixedMapSize(const Vec2& extent, int longer)
{
  return withAspect(extent, longer, std::min(longer, 2));
}
} // namespace stipple
