// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DeviationSearch.h"

#include "Geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
namespace
{
// A mesh this near to what is wanted is fine enough, as is one with so few more points than one
// that is not near enough: deviations are maxima, which jump by some percent from mesh to mesh.
constexpr double NearEnough = 0.85;
constexpr double FewMore = 1.08;
/// With more points than so many times those that are not near enough, it is not known yet what
/// the fewest are: where bends are features of the one mesh and none of the other, deviations do
/// not fall as they do else.
constexpr double ManyTimes = 2.;
constexpr double Aim = 0.92;
/// A step at most.
constexpr double LargestStep = 8.;
/// Half of the slope that bends have: more points do not help where it is less.
constexpr double LeastSlope = 0.25;
/// From that on it is known to be less.
constexpr double LeastTellingStep = 2.;
constexpr int MostTrials = 14;
}

double pointsOfSphere(double diagonal, double deviation)
{
  const double radius = diagonal / (2. * std::sqrt(3.));
  const double squaredEdge = 6. * radius * deviation;
  const double area = 4. * Pi * radius * radius;
  return 2. / std::sqrt(3.) * area / squaredEdge;
}

DeviationSearch::DeviationSearch(double wanted, double first, double least, double most)
  : Wanted(wanted)
  , Least(std::max(1., std::ceil(least)))
  , Most(std::floor(most))
  // Of a first that is NaN, the least.
  , Next(
      static_cast<int>(std::min(std::max(this->Least, first), std::max(this->Least, this->Most))))
  , Nearest(std::numeric_limits<double>::infinity())
{
}

void DeviationSearch::add(int asked, int got, double deviation)
{
  ++this->Trials;
  this->Nearest = std::min(this->Nearest, deviation);
  const Trial before = this->Bad;
  if (deviation <= this->Wanted)
  {
    this->Good = { got, deviation };
  }
  else
  {
    this->Bad = { got, deviation };
  }
  const bool over = this->Trials == MostTrials ||
    (this->Good.points > 0 && (got > asked || (this->isNearEnough() && !this->isFarAbove())));
  this->Next = over          ? 0
    : this->Good.points == 0 ? this->more(before)
    : this->Bad.points == 0  ? this->fewer()
                             : this->between();
}

double DeviationSearch::slope(const Trial& from, const Trial& to)
{
  return std::log(from.deviation / to.deviation) /
    std::log(static_cast<double>(to.points) / from.points);
}

int DeviationSearch::more(const Trial& before)
{
  const Trial& now = this->Bad;
  double slope = 1.;
  if (before.points > 0 && std::isfinite(before.deviation))
  {
    slope = DeviationSearch::slope(before, now);
    // Deviations are maxima, and jump: over a small step that tells nothing yet.
    const bool isTold = now.points >= LeastTellingStep * before.points;
    if (slope >= LeastSlope)
    {
      this->Stalls = 0;
    }
    else if (isTold)
    {
      this->StalledFrom = this->Stalls == 0 ? before : this->StalledFrom;
      ++this->Stalls;
    }
  }
  const double ratio = now.deviation / (Aim * this->Wanted);
  if (std::isfinite(ratio) && now.points * ratio > this->Most)
  {
    this->TooMany = now.points * ratio;
  }
  // They may fall slowly, and fall all the same.
  const auto isHopeless = [&] {
    const double slow = DeviationSearch::slope(this->StalledFrom, now);
    return !(slow > 0. && now.points * std::pow(ratio, 1. / slow) <= this->Most);
  };
  if ((this->Stalls >= 2 && isHopeless()) || this->TooMany > 0 || now.points >= this->Most)
  {
    return 0;
  }
  const double likely =
    std::isfinite(ratio) ? std::pow(ratio, 1. / std::clamp(slope, 0.5, 1.)) : 2.;
  const double step = slope < LeastSlope ? std::max(likely, LeastTellingStep) : likely;
  return static_cast<int>(
    std::min(this->Most, std::ceil(now.points * std::clamp(step, FewMore, LargestStep))));
}

int DeviationSearch::fewer() const
{
  const double ratio = this->Good.deviation / (Aim * this->Wanted);
  const double points = this->Good.points * std::max(ratio, 1. / LargestStep);
  return this->Good.points <= this->Least
    ? 0
    : static_cast<int>(std::max(this->Least, std::floor(points)));
}

bool DeviationSearch::isNearEnough() const
{
  return this->Good.deviation >= NearEnough * this->Wanted;
}

bool DeviationSearch::isFarAbove() const
{
  return this->Bad.points > 0 && this->Good.points > ManyTimes * this->Bad.points;
}

int DeviationSearch::between() const
{
  const double low = this->Bad.points;
  const double high = this->Good.points;
  if (high <= FewMore * low)
  {
    return 0;
  }
  const double part = std::isfinite(this->Bad.deviation) && !this->isNearEnough()
    ? std::log(this->Bad.deviation / (Aim * this->Wanted)) /
      std::log(this->Bad.deviation / std::max(this->Good.deviation, 1e-9 * this->Wanted))
    : 0.5;
  // Away from both ends, so that the interval shrinks.
  const double points = low * std::pow(high / low, std::clamp(part, 0.15, 0.85));
  return static_cast<int>(std::clamp(points, low + 1., high - 1.));
}
}
