// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BackboneBand.h"

#include "SamplingConstants.h"
#include "StraightWalk.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;
}

BandSection::BandSection(const SamplingDomain& domain, const std::vector<ControlImage>& images,
  int backbone, double arcLength, double scale, double fallback)
{
  const BackboneTrace& trace = domain.traces()[backbone];
  const BackboneTrace::Place place = trace.locate(arcLength);
  for (int side = 0; side < 2; ++side)
  {
    if (trace.chart[side] >= 0)
    {
      ++this->Sides;
      this->walk(domain, images, backbone, place, side, scale, fallback);
    }
  }
}

void BandSection::walk(const SamplingDomain& domain, const std::vector<ControlImage>& images,
  int backbone, const BackboneTrace::Place& place, int side, double scale, double fallback)
{
  const AtlasSurface& surface = domain.surface();
  const BackboneTrace& trace = domain.traces()[backbone];
  const double sign = side == 0 ? 1. : -1.;
  StraightWalk walk(
    surface, trace.halfedge[side][place.segment], trace.bary(place, side), Constants::MostFaces);
  const auto density = [&] {
    const int chart = surface.faceChart[walk.face()];
    const ControlImage& image = images[chart];
    return image.density(image.pixelAt(surface.parameter(walk.face(), walk.bary())));
  };
  double rho = density();
  const auto advance = [&](double from, double to) {
    return walk.advance(to - from, [&](int h, double left) {
      if (domain.onBackbone[h])
      {
        this->Others.push_back(sign * (to - left));
      }
      return true;
    });
  };
  double middle = 0;
  double length = 0;
  for (int i = 0; i < Constants::MostSteps; ++i)
  {
    const double halfRow = std::sqrt(BandLimit / (scale * (rho > 0 ? rho : fallback)));
    const double before = 0.5 * length;
    length = (middle < halfRow ? 1. : 2.) * Constants::StepInRows * halfRow;
    const double next = middle + before + 0.5 * length;
    if (!std::isfinite(length) || !advance(middle, next))
    {
      return;
    }
    middle = next;
    rho = density();
    const double scaled = scale * rho / BandLimit;
    const double inRows = std::sqrt(scaled);
    this->Steps.push_back({ sign * middle, length * scale * rho, scaled, length * inRows });
    if (rho > 0 ? middle * inRows > Constants::WidestBand : i > Constants::MostSteps / 2)
    {
      return;
    }
  }
}

double BandSection::wanted(double width, bool shared) const
{
  double sum = 0;
  for (const Step& s : this->Steps)
  {
    const double root = std::sqrt(s.rho);
    // The last step within the band counts by the part of it that is.
    const double inside =
      s.extent > 0 ? std::clamp((width - std::abs(s.offset) * root) / s.extent + 0.5, 0., 1.) : 0.;
    if (inside <= 0)
    {
      continue;
    }
    int owners = 1;
    if (shared)
    {
      for (double other : this->Others)
      {
        owners += std::abs(s.offset - other) * root < width ? 1 : 0;
      }
    }
    sum += inside * s.wanted / owners;
  }
  return sum;
}

double BandSection::widthThatWants(double wanted) const
{
  double low = 1;
  double had = this->wanted(low, true);
  while (had < wanted && low < Constants::WidestBand)
  {
    const double high = std::min(low + 0.1, Constants::WidestBand);
    const double has = this->wanted(high, true);
    if (has >= wanted)
    {
      return low + (high - low) * (wanted - had) / (has - had);
    }
    low = high;
    had = has;
  }
  return low;
}
}
