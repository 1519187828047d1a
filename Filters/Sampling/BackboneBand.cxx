// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BackboneBand.h"

#include "SamplingConstants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

/// A straight walk on the surface, from the middle of an edge into the face on its left.
class StraightWalk
{
public:
  StraightWalk(const AtlasSurface& surface, int halfedge, const Vec3& bary)
    : Surface(surface)
    , Face(halfedge / 3)
    , Entry(halfedge % 3)
    , Bary(bary)
  {
    this->setDirection(0., 1.);
  }

  int face() const { return this->Face; }
  const Vec3& bary() const { return this->Bary; }

  /// Goes on by a length; calls crossed(halfedge, length left) for every edge on the way, which
  /// says whether it may be crossed. False where the walk ends.
  template <typename F>
  bool advance(double length, F crossed)
  {
    for (;;)
    {
      if (!this->Valid)
      {
        return false;
      }
      double reach = std::numeric_limits<double>::max();
      int corner = -1;
      for (int k = 0; k < 3; ++k)
      {
        // The edge opposite corner k is halfedge k + 1 of the face.
        if (this->Rate[k] < 0 && (k + 1) % 3 != this->Entry)
        {
          const double t = std::max(0., -this->Bary[k] / this->Rate[k]);
          if (t < reach)
          {
            reach = t;
            corner = k;
          }
        }
      }
      if (corner < 0)
      {
        return false;
      }
      if (length <= reach)
      {
        this->Bary = clampedBarycentric(this->Bary + length * this->Rate);
        return true;
      }
      length -= reach;
      const int h = 3 * this->Face + (corner + 1) % 3;
      const int twin = this->Surface.twin[h];
      if (!crossed(h, length) || twin < 0 || ++this->Crossed > Constants::MostFaces)
      {
        return false;
      }
      const Vec3 bary = clampedBarycentric(this->Bary + reach * this->Rate);
      const Vec3 edge =
        (this->Surface.points[this->Surface.head(h)] - this->Surface.points[this->Surface.tail(h)])
          .normalized();
      const double along = std::clamp(this->Direction.dot(edge), -1., 1.);
      const double atTail = bary[h % 3];
      this->Face = twin / 3;
      this->Entry = twin % 3;
      this->Bary = Vec3::Zero();
      this->Bary[nextHalfedge(twin) % 3] = atTail;
      this->Bary[twin % 3] = 1. - atTail;
      // The new face's own direction along its edge is the opposite one.
      this->setDirection(-along, std::sqrt(std::max(0., 1. - along * along)));
    }
  }

private:
  /// A direction in the face, by its parts along the edge of entry and away from it.
  void setDirection(double along, double away)
  {
    const AtlasSurface& s = this->Surface;
    const Vec3& a = s.point(this->Face, 0);
    const Vec3& b = s.point(this->Face, 1);
    const Vec3& c = s.point(this->Face, 2);
    const Vec3 cross = (b - a).cross(c - a);
    const double area = cross.norm(); // twice
    const std::array<Vec3, 3> opposite = { { c - b, a - c, b - a } };
    const Vec3& edge = opposite[(this->Entry + 2) % 3];
    const double length = edge.norm();
    this->Valid = area > 0 && length > 0;
    if (!this->Valid)
    {
      return;
    }
    const Vec3 normal = cross / area;
    const Vec3 unit = edge / length;
    this->Direction = along * unit + away * normal.cross(unit);
    for (int k = 0; k < 3; ++k)
    {
      this->Rate[k] = this->Direction.dot(normal.cross(opposite[k])) / area;
    }
  }

  const AtlasSurface& Surface;
  int Face;
  int Entry; // corner at which the edge of entry begins
  Vec3 Bary;
  Vec3 Direction = Vec3::Zero();
  Vec3 Rate = Vec3::Zero(); // of the barycentric coordinates, per length
  bool Valid = false;
  int Crossed = 0;
};
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
  StraightWalk walk(surface, trace.halfedge[side][place.segment], trace.bary(place, side));
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
