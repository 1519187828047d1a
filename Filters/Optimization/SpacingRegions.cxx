// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SpacingRegions.h"

#include "Tuning.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
double SpacingRegion::growthAt(double distance) const
{
  const double beyond =
    std::max(0., distance / this->spacing - Tuning::GrowthPlateau * this->growth);
  return this->growth > 1. ? std::max(1., this->growth - Tuning::GrowthSlope * beyond)
                           : std::min(1., this->growth + Tuning::GrowthSlope * beyond);
}

double SpacingRegion::reach() const
{
  return this->spacing *
    (Tuning::GrowthPlateau * this->growth + std::abs(this->growth - 1.) / Tuning::GrowthSlope);
}

void SpacingRegions::add(const TriangleSurface& surface, Face face, const SpacingRegion& region)
{
  const int id = static_cast<int>(this->Regions.size());
  this->Regions.push_back(region);
  const double reach = region.reach();
  std::vector<Face> faces = { face };
  const auto enter = [&](Face f) {
    std::vector<int>& regions = this->OnFace[f];
    if (!regions.empty() && regions.back() == id)
    {
      return false;
    }
    regions.push_back(id);
    return true;
  };
  enter(face);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (const Halfedge h : halfedgesOf(faces[i]))
    {
      const Halfedge twin = surface.twin[h];
      if (twin.valid() &&
        distanceToSegment<3>(
          region.centre, surface.point(surface.tail(h)), surface.point(surface.head(h))) < reach &&
        enter(faceOf(twin)))
      {
        faces.push_back(faceOf(twin));
      }
    }
  }
}

double SpacingRegions::growthAt(Face face, const Vec3& position) const
{
  const auto found = this->OnFace.find(face);
  double most = 1;
  double least = 1;
  if (found != this->OnFace.end())
  {
    for (int id : found->second)
    {
      const SpacingRegion& region = this->Regions[id];
      const double growth = region.growthAt((position - region.centre).norm());
      most = std::max(most, growth);
      least = std::min(least, growth);
    }
  }
  return most * least;
}
}
