// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BackboneSampling.h"

#include "BackboneBand.h"
#include "SamplingConstants.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

/// Pieces of a backbone between fixed places (or its ends), as (begin, end) in arc length.
std::vector<std::array<double, 2>> pieces(const SamplingDomain& domain, int b)
{
  const std::vector<double>& fixed = domain.fixedPlaces[b];
  const double length = domain.traces()[b].length();
  std::vector<std::array<double, 2>> result;
  if (!domain.graph().backbones[b].closed)
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

BackboneDensity densityAlong(const SamplingDomain& domain, const std::vector<ControlImage>& images,
  int backbone, double scale, double fallback)
{
  const double length = domain.traces()[backbone].length();
  const double root = std::sqrt(scale);
  // Keeps the integral (in samples / root) invertible where nothing is wanted; worth a billionth of
  // a sample, and no more than a millionth of one on the smallest of surfaces.
  const double least = length > 0 ? std::min(1e-9, 1e-6 / root) / length : 0.;
  if (domain.graph().backbones[backbone].keep == Keep::Edges)
  {
    return { { 0, length }, { 0, least * length }, { 1 }, { 0 } };
  }
  BackboneDensity result;
  result.arcLength = { 0 };
  result.wanted = { 0 };
  const double longest = length / 4.;
  const double shortest = length * 2e-5;
  double step = longest;
  for (double begin = 0; begin < length;)
  {
    step = std::min(step, length - begin);
    double perLength = 0;
    double alone = 0; // were there no other backbone
    double width = 1;
    for (;; step *= 0.5)
    {
      const BandSection section(domain, images, backbone, begin + 0.5 * step, scale, fallback);
      // The samples on a boundary stand for twice what its only side wants.
      const double sides = 2. / std::max(1, section.numberOfSides());
      perLength = sides * section.wanted(1., false);
      const double shared = sides * section.wanted(1., true);
      alone = perLength;
      if (shared < perLength)
      {
        perLength = std::min(perLength, sides * section.wanted(Constants::WidestBand, true));
        width = section.widthThatWants(perLength / sides);
      }
      if (step * perLength <= 2. * Constants::StepInSpacings || step <= shortest)
      {
        break;
      }
    }
    begin = begin + step < length ? begin + step : length;
    result.arcLength.push_back(begin);
    result.wanted.push_back(result.wanted.back() + step * (perLength / root + least));
    result.width.push_back(width);
    result.density.push_back(alone * alone * 2. / std::sqrt(3.) / scale);
    step = std::min(2. * step, perLength > 0 ? Constants::StepInSpacings / perLength : longest);
    step = std::clamp(step, shortest, longest);
  }
  if (result.width.empty())
  {
    return { { 0, length }, { 0, least }, { 1 }, { 0 } };
  }
  return result;
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

double BackboneDensity::densityAt(double s) const
{
  return this->density[segmentAt(this->arcLength, s)];
}

double BackboneDensity::widthAt(double s) const
{
  return this->width[segmentAt(this->arcLength, s)];
}

double BackboneDensity::widest(double begin, double end) const
{
  std::size_t i = segmentAt(this->arcLength, begin);
  double most = this->width[i];
  while (++i < this->width.size() && this->arcLength[i] <= end)
  {
    most = std::max(most, this->width[i]);
  }
  return most;
}

std::vector<BackboneDensity> backboneDensities(const SamplingDomain& domain,
  const std::vector<ControlImage>& images, double scale, double meanDensity, const Stop& stop)
{
  std::vector<BackboneDensity> result(domain.traces().size());
  // The longest ones first, so that no thread is left waiting for one.
  std::vector<int> order(result.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return domain.traces()[a].length() > domain.traces()[b].length(); });
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(order.size()), 1, [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType i = first; i < last && !isAsked(stop); ++i)
      {
        const int b = order[i];
        result[b] = densityAlong(domain, images, b, scale, meanDensity);
      }
    });
  return result;
}

std::vector<BackboneDensity> uniformBackboneDensities(const SamplingDomain& domain)
{
  std::vector<BackboneDensity> result;
  for (const BackboneTrace& trace : domain.traces())
  {
    result.push_back({ { 0, trace.length() }, { 0, trace.length() }, { 1 }, { 1 } });
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
    const bool closed = domain.graph().backbones[b].closed;
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
    const double length = domain.traces()[b].length();
    const bool closed = domain.graph().backbones[b].closed;
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
