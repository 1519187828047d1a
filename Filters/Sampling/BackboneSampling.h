// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// 1D error diffusion along backbones (paper 3.2), in arc length on the surface.
#ifndef stipple_BackboneSampling_h
#define stipple_BackboneSampling_h

#include "ControlImage.h"
#include "ReportingThread.h"
#include "SamplingDomain.h"

namespace stipple
{
/// Samples beside a curve lie in a hexagonal lattice of spacing s = sqrt(2 / (sqrt(3) rho)), rho
/// being the samples wanted per unit of surface area; so the curve wants the integral of ds / s of
/// them (the paper's law x -> 1 - sqrt(1 - x), in continuous terms and with the lattice's
/// constant). This is what the surface wants in the curve's band, half a row on each side, and from
/// there it is taken: the densities beside the curve may differ from that on it. Where backbones
/// lie in each other's bands, these are widened until they hold what all of them want.
struct STIPPLEFILTERSSAMPLING_EXPORT BackboneDensity
{
  std::vector<double> arcLength; ///< ascending from 0 to the backbone's length
  std::vector<double> wanted;    ///< the integral up to there, over the root of the scale
  std::vector<double> width;     ///< of the band from there on, 1 for half a row on each side
  /// The samples wanted per unit of surface area from there on, over the scale: those that make a
  /// lattice of the spacing that the curve would have alone.
  std::vector<double> density;
  double total() const { return this->wanted.back(); }
  /// The integral up to s; beyond the end it continues periodically.
  double at(double s) const;
  /// Its inverse.
  double place(double wanted) const;
  double densityAt(double s) const;
  double widthAt(double s) const;
  /// The greatest width between two arc lengths, in ascending order.
  double widest(double begin, double end) const;
};

/// Densities along all backbones for samples of about `scale` times the control, whose mean per
/// unit of surface area is meanDensity. Those that come after `stop` has become true are empty.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<BackboneDensity> backboneDensities(
  const SamplingDomain& domain, const std::vector<ControlImage>& images, double scale,
  double meanDensity, const Stop& stop = {});

/// As if every backbone wanted the same number of samples per length.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<BackboneDensity> uniformBackboneDensities(
  const SamplingDomain& domain);

/// Number of samples inside all backbones for densities times scale; not decreasing with scale.
STIPPLEFILTERSSAMPLING_EXPORT std::size_t countOnBackbones(
  const SamplingDomain& domain, const std::vector<BackboneDensity>& densities, double scale);

/// Their places: on an open backbone a whole number of intervals, at least one; on a closed one at
/// least three samples, with the same share of an interval on each side of the line's arbitrary
/// first point.
STIPPLEFILTERSSAMPLING_EXPORT BackbonePlaces placeOnBackbones(
  const SamplingDomain& domain, const std::vector<BackboneDensity>& densities, double scale);
}

#endif
