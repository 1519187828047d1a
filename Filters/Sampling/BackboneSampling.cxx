// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BackboneSampling.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// Pieces of a backbone between fixed places (or its ends), as (begin, end) in arc length.
std::vector<std::array<double, 2>> pieces(const SamplingDomain& domain, int b)
{
  const std::vector<double>& fixed = domain.fixedPlaces[b];
  const double length = domain.traces[b].length();
  std::vector<std::array<double, 2>> result;
  if (!domain.graph.backbones[b].closed)
  {
    double begin = 0;
    for (double s : fixed)
    {
      result.push_back({ { begin, s } });
      begin = s;
    }
    result.push_back({ { begin, length } });
  }
  else if (!fixed.empty())
  {
    for (std::size_t i = 0; i + 1 < fixed.size(); ++i)
    {
      result.push_back({ { fixed[i], fixed[i + 1] } });
    }
    result.push_back({ { fixed.back(), fixed.front() + length } });
  }
  return result; // none: a closed backbone free to turn
}

int rounded(double wanted, int least)
{
  return std::max(least, static_cast<int>(std::min(wanted + 0.5, 1e9)));
}

std::size_t segmentAt(const std::vector<double>& knots, double x)
{
  const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
  return static_cast<std::size_t>(next - knots.begin()) - 1;
}
}

double BackboneDensity::at(double s) const
{
  const double length = this->arcLength.back();
  if (s > length)
  {
    return this->total() + this->at(s - length);
  }
  const std::size_t i = segmentAt(this->arcLength, s);
  const double a = this->arcLength[i];
  const double b = this->arcLength[i + 1];
  const double t = b > a ? (s - a) / (b - a) : 0.;
  return this->wanted[i] + t * (this->wanted[i + 1] - this->wanted[i]);
}

double BackboneDensity::place(double w) const
{
  if (w > this->total())
  {
    return this->arcLength.back() + this->place(w - this->total());
  }
  const std::size_t i = segmentAt(this->wanted, w);
  const double a = this->wanted[i];
  const double b = this->wanted[i + 1];
  const double t = b > a ? (w - a) / (b - a) : 0.;
  return this->arcLength[i] + t * (this->arcLength[i + 1] - this->arcLength[i]);
}

double backboneDensityAt(const SamplingDomain& domain, const std::vector<ControlImage>& images,
  int backbone, double arcLength)
{
  const BackboneTrace& trace = domain.traces[backbone];
  const BackboneTrace::Place place = trace.locate(arcLength);
  double sum = 0;
  int sides = 0;
  for (int side = 0; side < 2; ++side)
  {
    if (trace.hasSide(side))
    {
      const ControlImage& image = images[trace.chart[side]];
      sum += image.density(image.pixelAt(trace.parameter(domain.surface, place, side)));
      ++sides;
    }
  }
  return sides > 0 ? sum / sides : 0.;
}

std::vector<BackboneDensity> backboneDensities(
  const SamplingDomain& domain, const std::vector<ControlImage>& images)
{
  std::vector<BackboneDensity> result(domain.traces.size());
  for (std::size_t b = 0; b < domain.traces.size(); ++b)
  {
    const BackboneTrace& trace = domain.traces[b];
    BackboneDensity& density = result[b];
    density.arcLength = { 0 };
    density.wanted = { 0 };
    // Keeps the integral invertible where nothing is wanted, and is worth a billionth of a sample.
    const double least = trace.length() > 0 ? 1e-9 / trace.length() : 0.;
    for (std::size_t i = 0; i + 1 < trace.arcLength.size(); ++i)
    {
      double pixels = 1;
      for (int side = 0; side < 2; ++side)
      {
        if (trace.hasSide(side))
        {
          const ControlImage& image = images[trace.chart[side]];
          const Vec2 d = trace.parameter(domain.surface, { static_cast<int>(i), 1. }, side) -
            trace.parameter(domain.surface, { static_cast<int>(i), 0. }, side);
          pixels = std::max({ pixels, std::abs(d.x()) * image.width / image.extent.x(),
            std::abs(d.y()) * image.height / image.extent.y() });
        }
      }
      const int steps = static_cast<int>(std::ceil(std::min(pixels, 1e4)));
      const double begin = trace.arcLength[i];
      const double step = (trace.arcLength[i + 1] - begin) / steps;
      for (int k = 0; k < steps; ++k)
      {
        const double rho =
          backboneDensityAt(domain, images, static_cast<int>(b), begin + (k + 0.5) * step);
        density.arcLength.push_back(
          k + 1 == steps ? trace.arcLength[i + 1] : begin + (k + 1) * step);
        density.wanted.push_back(
          density.wanted.back() + step * (std::sqrt(rho * std::sqrt(3.) / 2.) + least));
      }
    }
  }
  return result;
}

std::vector<BackboneDensity> uniformBackboneDensities(const SamplingDomain& domain)
{
  std::vector<BackboneDensity> result;
  for (const BackboneTrace& trace : domain.traces)
  {
    result.push_back({ { 0, trace.length() }, { 0, trace.length() } });
  }
  return result;
}

std::size_t countOnBackbones(
  const SamplingDomain& domain, const std::vector<BackboneDensity>& densities, double scale)
{
  const double root = std::sqrt(scale);
  std::size_t count = 0;
  for (std::size_t b = 0; b < densities.size(); ++b)
  {
    const bool closed = domain.graph.backbones[b].closed;
    if (domain.fixedPlaces[b].empty())
    {
      const double wanted = root * densities[b].total();
      count += closed ? rounded(wanted, 3) : rounded(wanted, 1) - 1;
      continue;
    }
    for (const auto& [begin, end] : pieces(domain, static_cast<int>(b)))
    {
      count += rounded(root * (densities[b].at(end) - densities[b].at(begin)), 1);
    }
    count -= closed ? 0 : 1;
  }
  return count;
}

BackbonePlaces placeOnBackbones(
  const SamplingDomain& domain, const std::vector<BackboneDensity>& densities, double scale)
{
  const double root = std::sqrt(scale);
  BackbonePlaces result(densities.size());
  for (std::size_t b = 0; b < densities.size(); ++b)
  {
    const BackboneDensity& density = densities[b];
    const double length = domain.traces[b].length();
    const bool closed = domain.graph.backbones[b].closed;
    std::vector<double>& places = result[b];
    if (closed && domain.fixedPlaces[b].empty())
    {
      const int n = rounded(root * density.total(), 3);
      for (int i = 0; i < n; ++i)
      {
        places.push_back(density.place((i + 0.5) / n * density.total()));
      }
      continue;
    }
    for (const auto& [begin, end] : pieces(domain, static_cast<int>(b)))
    {
      const double low = density.at(begin);
      const double high = density.at(end);
      const int n = rounded(root * (high - low), 1);
      for (int i = 1; i < n; ++i)
      {
        const double s = density.place(low + (high - low) * i / n);
        places.push_back(s >= length ? s - length : s);
      }
      if (closed || end < length)
      {
        places.push_back(end >= length ? end - length : end);
      }
    }
    std::sort(places.begin(), places.end());
  }
  return result;
}
}
