// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What a backbone's samples stand for: the surface across it, as far as half a row of the lattice.
#ifndef stipple_BackboneBand_h
#define stipple_BackboneBand_h

#include "ControlImage.h"
#include "SamplingDomain.h"

#include <array>
#include <vector>

namespace stipple
{
/// On each side of a backbone the places whose distance d has d^2 rho < BandLimit stand for its
/// samples: (sqrt(3) / 4)^2 s^2 rho with s^2 rho = 2 / sqrt(3), that is, half the height of a row
/// of the hexagonal lattice of spacing s.
constexpr double BandLimit = 0.21650635094610965; // sqrt(3) / 8

/// The surface on both sides of a backbone, across it at one place.
class STIPPLEFILTERSSAMPLING_EXPORT BandSection
{
public:
  /// Walks straight from an arc length of a backbone to both sides, over seams, and reads the
  /// densities there, for samples of `scale` times the control. `fallback` is the density (per unit
  /// of surface area, not scaled) by which to step where nothing is wanted.
  BandSection(const SamplingDomain& domain, const std::vector<ControlImage>& images, int backbone,
    double arcLength, double scale, double fallback);

  /// Samples wanted per unit of length in the band of this width (1: half a row on each side); what
  /// lies in bands of other backbones too, is shared with them in equal parts, or counted in full.
  double wanted(double width, bool shared) const;
  /// The least width of at least 1 in which that many are wanted, shared; at most
  /// SamplingConstants::WidestBand.
  double widthThatWants(double wanted) const;
  int numberOfSides() const { return this->Sides; }

private:
  struct Step
  {
    double offset; ///< signed distance from the backbone of the step's middle; negative on side 1
    double wanted; ///< samples per unit of length that the step is worth
    double rho;    ///< samples wanted per unit of surface area, over BandLimit
    double extent; ///< the step's length in units of half a row there
  };
  void walk(const SamplingDomain& domain, const std::vector<ControlImage>& images, int backbone,
    const BackboneTrace::Place& place, int side, double scale, double fallback);

  std::vector<Step> Steps;
  std::vector<double> Others; ///< signed distances at which other backbones are met
  int Sides = 0;
};
}

#endif
