// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GirthSizes.h"

#include "SamplingConstants.h"
#include "SizingFunction.h"
#include "StraightWalk.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

/// Places of a thread's turn.
constexpr vtkIdType Grain = 256;

/// Two walks from one place in opposite directions, step by step.
class WalkBothWays
{
public:
  WalkBothWays(const AtlasSurface& surface, const std::vector<char>& isFeature,
    const SurfacePlace& from, const Vec3& direction)
    : IsFeature(isFeature)
    , Ahead(surface, from.face, from.bary, direction, Constants::MostFaces)
    , Back(surface, from.face, from.bary, -direction, Constants::MostFaces)
  {
  }

  /// False where a feature, or too many faces, are in the way.
  bool advance(double length)
  {
    const auto mayCross = [this](int h, double) { return this->IsFeature[h] == 0; };
    return this->Ahead.advance(length, mayCross) && this->Back.advance(length, mayCross);
  }
  /// From where one is to where the other one is.
  Vec3 chord() const { return this->Back.position() - this->Ahead.position(); }
  /// Of the chord to what both have walked.
  double squaredRatio(double walked) const
  {
    return this->chord().squaredNorm() / (4. * walked * walked);
  }
  /// How fast they come nearer to one another, for the length that both go.
  double approach() const
  {
    return this->chord().dot(this->Ahead.direction() - this->Back.direction());
  }
  bool goOppositeWays() const
  {
    return this->Ahead.direction().dot(this->Back.direction()) < Constants::MeetingCosine;
  }

private:
  const std::vector<char>& IsFeature;
  StraightWalk Ahead;
  StraightWalk Back;
};

class GirthSearch
{
public:
  GirthSearch(const Atlas& atlas, const std::vector<char>& isCrease)
    : Surface(atlas.surface())
    , IsFeature(atlas.halfedgesOn(isCrease))
  {
  }

  /// Length of the loop about a place, if it is shorter than `longest`.
  std::optional<double> girthAt(const SurfacePlace& place, double longest) const
  {
    const Vec3 normal = this->Surface.faceNormal(place.face);
    const Vec3 along = this->Surface.edge(halfedgeOf(Face(place.face), 0)).normalized();
    if (!(normal.squaredNorm() > 0) || !along.allFinite())
    {
      return {};
    }
    const auto directionAt = [&](double angle) -> Vec3 {
      return std::cos(angle) * along + std::sin(angle) * normal.cross(along);
    };
    // Two directions at right angles have the mean of all, and all but one go on straight on a
    // cylinder: nearly everywhere that is enough to know that there is none.
    const double farthest = 0.125 * longest;
    Spokes spokes;
    for (const int i : { 0, 2 })
    {
      spokes[i] = this->ratiosOf(place, directionAt(angleOf(i)), farthest);
      if (!spokes[i].front())
      {
        return {};
      }
    }
    // Where a walk ends early there is no telling.
    const auto last = [&](int i) { return spokes[i].back().value_or(-2.); };
    if (0.5 * (last(0) + last(2)) > 0.5 * (1. + Constants::BentChord * Constants::BentChord))
    {
      return {};
    }
    // Where a loop is an eighth done both ways, the walks are nearer to one another than they have
    // walked. On a cylinder, (chord / walked)^2 = a + b cos 2 angle + c sin 2 angle, as with
    // Euler's normal curvatures, which four directions tell.
    for (const int i : { 1, 3 })
    {
      spokes[i] = this->ratiosOf(place, directionAt(angleOf(i)), farthest);
    }
    for (std::size_t k = 0; k < Constants::ProbesOfGirth.size(); ++k)
    {
      std::array<double, 4> ratio;
      for (int i = 0; i < 4; ++i)
      {
        if (!spokes[i][k])
        {
          return {};
        }
        ratio[i] = *spokes[i][k];
      }
      const double b = 0.5 * (ratio[0] - ratio[2]);
      const double c = 0.5 * (ratio[1] - ratio[3]);
      const double least =
        0.25 * (ratio[0] + ratio[1] + ratio[2] + ratio[3]) - std::sqrt(b * b + c * c);
      if (least < Constants::BentChord * Constants::BentChord)
      {
        const double walked = Constants::ProbesOfGirth[k] * farthest;
        return this->loop(place, directionAt(0.5 * std::atan2(-c, -b)), longest, 0.25 * walked);
      }
    }
    return {};
  }

private:
  /// The squares of (chord / walked) at the probes; none where a walk has ended.
  using Ratios = std::array<std::optional<double>, Constants::ProbesOfGirth.size()>;
  /// In four directions, 45 degrees apart.
  using Spokes = std::array<Ratios, 4>;
  static double angleOf(int spoke) { return 0.25 * Pi * spoke; }

  Ratios ratiosOf(const SurfacePlace& place, const Vec3& direction, double farthest) const
  {
    Ratios ratios;
    WalkBothWays walk(this->Surface, this->IsFeature, place, direction);
    double walked = 0;
    for (std::size_t k = 0; k < ratios.size(); ++k)
    {
      const double to = Constants::ProbesOfGirth[k] * farthest;
      if (!walk.advance(to - walked))
      {
        break;
      }
      walked = to;
      ratios[k] = walk.squaredRatio(walked);
    }
    return ratios;
  }

  /// Walks both ways until the two pass each other.
  std::optional<double> loop(
    const SurfacePlace& place, const Vec3& direction, double longest, double step) const
  {
    WalkBothWays walk(this->Surface, this->IsFeature, place, direction);
    double before = 0; // of the approach: they walk apart at first
    for (double walked = step; 2. * walked < longest + 2. * step; walked += step)
    {
      if (!walk.advance(step))
      {
        return {};
      }
      const double approach = walk.approach();
      if (before > 0 && approach <= 0)
      {
        const double girth = 2. * (walked - step * approach / (approach - before));
        return walk.goOppositeWays() && walk.chord().norm() < Constants::MissedMeeting * girth &&
            girth < longest
          ? std::make_optional(girth)
          : std::nullopt;
      }
      before = approach;
    }
    return {};
  }

  const AtlasSurface& Surface;
  const std::vector<char> IsFeature;
};

/// A place, and the spacing there.
struct Probe
{
  SurfacePlace place;
  double spacing;
};

/// So many to a wanted sample, evenly over the surface.
std::vector<Probe> placesToLookAt(
  const AtlasSurface& surface, const std::function<double(const SurfacePlace&)>& spacing)
{
  // Within a face, points of a sequence of low discrepancy (Roberts 2018: by the plastic number),
  // folded from the unit square into the triangle.
  constexpr double Plastic = 1.32471795724474602596;
  const auto middleOf = [](int f) { return SurfacePlace{ f, Vec3::Constant(1. / 3.) }; };
  std::vector<double> atMiddle(static_cast<std::size_t>(surface.numberOfFaces()));
  vtkSMPTools::For(0, surface.numberOfFaces(), Grain, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType f = begin; f < end; ++f)
    {
      atMiddle[f] = spacing(middleOf(static_cast<int>(f)));
    }
  });
  std::vector<Probe> probes;
  double mass = 0.5;
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    const double here = atMiddle[f];
    if (!(here > 0))
    {
      continue;
    }
    mass += Constants::PlacesOfGirth * surface.faceArea(f) * densityOfEdges(here);
    const auto number = static_cast<std::size_t>(std::max(0., mass));
    mass -= static_cast<double>(number);
    for (std::size_t i = 0; i < number; ++i)
    {
      double whole;
      double s = std::modf(0.5 + static_cast<double>(i + 1) / Plastic, &whole);
      double t = std::modf(0.5 + static_cast<double>(i + 1) / (Plastic * Plastic), &whole);
      if (s + t > 1.)
      {
        s = 1. - s;
        t = 1. - t;
      }
      const SurfacePlace place =
        number == 1 ? middleOf(f) : SurfacePlace{ f, Vec3(1. - s - t, s, t) };
      const double at = spacing(place);
      if (at > 0)
      {
        probes.push_back({ place, at });
      }
    }
  }
  return probes;
}
}

std::vector<FeatureSize> girthSizes(
  const Atlas& atlas, const std::function<double(const SurfacePlace&)>& spacing, const Stop& stop)
{
  const std::vector<Probe> probes = placesToLookAt(atlas.surface(), spacing);
  const GirthSearch search(atlas, atlas.creasesTo(spacing));
  std::vector<double> size(probes.size(), 0.);
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(probes.size()), Grain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end && !isAsked(stop); ++i)
      {
        const double longest = Constants::EdgesOfLoop * Constants::LargestSize * probes[i].spacing;
        const std::optional<double> girth = search.girthAt(probes[i].place, longest);
        size[i] = girth ? *girth / Constants::EdgesOfLoop : 0.;
      }
    });
  std::vector<FeatureSize> sources;
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    if (size[i] > 0)
    {
      const SurfacePlace& place = probes[i].place;
      sources.push_back(
        { atlas.surface().position(place.face, place.bary), size[i], probes[i].spacing });
    }
  }
  return sources;
}
}
