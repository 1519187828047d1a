// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Smooth gradation (paper 3.3): low-pass of an image a chart, measured on the surface.
#ifndef stipple_SurfaceDiffusion_h
#define stipple_SurfaceDiffusion_h

#include "SurfaceRefinement.h"

#include <memory>

namespace stipple
{
/// Lets heat flow over the surface for the time sigma^2 / 2, which is a Gaussian of standard
/// deviation sigma where the surface is flat: "in the ideal case, the local size of the filter
/// kernel should be driven by the area map" (section 3.3). The heat equation is solved by linear
/// finite elements on the surface itself (cotangent weights, U. Pinkall and K. Polthier, Computing
/// Discrete Minimal Surfaces, 1993; six implicit Euler steps), whose points are shared by all
/// charts, so that seams do not exist for it. Pixels give their values to the points around them,
/// and take back what the points then have, interpolated: the result is continuous over the
/// surface.
class STIPPLEFILTERSSAMPLING_EXPORT SurfaceDiffusion
{
public:
  SurfaceDiffusion();
  ~SurfaceDiffusion();

  /// Takes the surface, which is borrowed, and copies of the images' sizes, areaDistortion and
  /// faceIndex (one image a chart).
  void setDomain(const AtlasSurface& surface, const std::vector<ControlImage>& images);

  /// The heat equation counts as solved where what is left is so small, over its right side. The
  /// default is the strictest that is of use to floats. From SamplingConstants::GuessedTolerance
  /// on, what is looked for begins with the changes of the last call: results depend on it, within
  /// the tolerance, and images that have changed little take a few rounds.
  void setTolerance(double tolerance);

  /// Smooths values[c], the pixels of chart c, in place; sigma > 0 in the surface's unit of length.
  /// Negative values and NaN count as zero. What is made for a sigma is kept for the next call with
  /// the same one.
  Status smooth(
    const std::vector<float*>& values, double sigma, const Progress& progress = nullptr);

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
  double Tolerance = 1e-7;
};
}

#endif
