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
  explicit GirthSearch(const Atlas& atlas)
    : Surface(atlas.surface())
    , IsFeature(atlas.halfedgesOn({ BackboneType::Sharp, BackboneType::Boundary }))
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
    double mean = 0;
    for (const double angle : { 0., std::acos(0.) })
    {
      WalkBothWays walk(this->Surface, this->IsFeature, place, directionAt(angle));
      mean += walk.advance(farthest) ? 0.5 * walk.squaredRatio(farthest) : -1.; // no telling
    }
    if (mean > 0.5 * (1. + Constants::BentChord * Constants::BentChord))
    {
      return {};
    }
    // Where a loop is an eighth done both ways, the walks are nearer to one another than they have
    // walked. On a cylinder, (chord / walked)^2 = a + b cos 2 angle + c sin 2 angle, as with
    // Euler's normal curvatures, which four directions tell.
    std::vector<WalkBothWays> walks;
    for (int i = 0; i < 4; ++i)
    {
      walks.emplace_back(
        this->Surface, this->IsFeature, place, directionAt(i * std::atan(1.))); // by 45 degrees
    }
    double walked = 0;
    for (double share : Constants::ProbesOfGirth)
    {
      const double step = share * farthest - walked;
      walked += step;
      std::array<double, 4> ratio;
      for (int i = 0; i < 4; ++i)
      {
        if (!walks[i].advance(step))
        {
          return {};
        }
        ratio[i] = walks[i].squaredRatio(walked);
      }
      const double b = 0.5 * (ratio[0] - ratio[2]);
      const double c = 0.5 * (ratio[1] - ratio[3]);
      const double least =
        0.25 * (ratio[0] + ratio[1] + ratio[2] + ratio[3]) - std::sqrt(b * b + c * c);
      if (least < Constants::BentChord * Constants::BentChord)
      {
        return this->loop(place, directionAt(0.5 * std::atan2(-c, -b)), longest, 0.25 * walked);
      }
    }
    return {};
  }

private:
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
  std::vector<Probe> probes;
  double mass = 0.5;
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    const SurfacePlace middle = { f, Vec3::Constant(1. / 3.) };
    const double here = spacing(middle);
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
      const SurfacePlace place = { f, number == 1 ? middle.bary : Vec3(1. - s - t, s, t) };
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
  const GirthSearch search(atlas);
  std::vector<double> size(probes.size(), 0.);
  constexpr vtkIdType Grain = 256;
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
