// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// 1D error diffusion along backbones (paper 3.2), in arc length on the surface.
#ifndef stipple_BackboneSampling_h
#define stipple_BackboneSampling_h

#include "ControlImage.h"
#include "SamplingDomain.h"

namespace stipple
{
/// Samples beside a curve lie in a hexagonal lattice of spacing s = sqrt(2 / (sqrt(3) rho)), rho
/// being the samples wanted per unit of surface area; so the curve wants the integral of ds / s of
/// them (the paper's law x -> 1 - sqrt(1 - x), in continuous terms and with the lattice's
/// constant).
struct STIPPLEFILTERSSAMPLING_EXPORT BackboneDensity
{
  std::vector<double> arcLength; ///< ascending from 0 to the backbone's length
  std::vector<double> wanted;    ///< the integral up to there, for densities times one
  double total() const { return this->wanted.back(); }
  /// The integral up to s; beyond the end it continues periodically.
  double at(double s) const;
  /// Its inverse.
  double place(double wanted) const;
};

/// Densities along all backbones, read from the control images on their sides and averaged.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<BackboneDensity> backboneDensities(
  const SamplingDomain& domain, const std::vector<ControlImage>& images);

/// The density at a place, averaged over the sides.
STIPPLEFILTERSSAMPLING_EXPORT double backboneDensityAt(const SamplingDomain& domain,
  const std::vector<ControlImage>& images, int backbone, double arcLength);

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
