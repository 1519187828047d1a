// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Coefficients of error diffusion that vary with the level.
#ifndef stipple_DiffusionCoefficients_h
#define stipple_DiffusionCoefficients_h

#include "StippleFiltersSamplingModule.h"

namespace stipple
{
enum class DiffusionMethod : int
{
  Ostromoukhov = 0, ///< V. Ostromoukhov, A Simple and Efficient Error-Diffusion Algorithm, SIGGRAPH
                    ///< 2001, as in the paper
  ZhouFang = 1 ///< B. Zhou and X. Fang, Improving Mid-Tone Quality of Variable-Coefficient Error
               ///< Diffusion Using Threshold Modulation, SIGGRAPH 2003
};

/// How a pixel of some level becomes a sample or none, and who receives its error.
struct DiffusionCoefficients
{
  float right;      ///< share of the error for the next pixel of the row
  float downLeft;   ///< share for the pixel below the one before; the pixel below receives the rest
  float threshold;  ///< from which on there is a sample
  float modulation; ///< how far noise raises the threshold at most, 0 to 0.5
};

/// Coefficients for a level in [0, 1] (wanted samples in a pixel), linear between the 256 tabulated
/// levels; levels beyond the middle mirror those below it.
///
/// With the threshold 1/2 of the publications, errors have a mean in the steady state that depends
/// on the level: 0.45 next to zero, 0.2 at 1/8, none at 1/2. Each row of pixels must collect it
/// where an image begins (the dead zone) or turns from dense to sparse, and sheds it as surplus
/// samples where it turns dense again. The threshold here is 1/2 less this mean (as measured on
/// large images of constant levels), which shifts all errors by as much and changes no halftone of
/// a constant level: the mean is zero at every level, and densities follow a map that varies.
///
/// Around a quarter Ostromoukhov's coefficients are not the published ones. His give nothing to the
/// pixel below (11, 10, 0 at level 64 of 255): patches of a square lattice form, and their borders
/// are low frequencies, .075 to .12 of white noise's power below half the principal frequency
/// between the levels .24 and .29. Between his keys 44 and 77, level 64 here has .42, .30 and .28
/// and noise of .15 on the threshold, which keeps the lattice from forming; both found by a search
/// for the least of these low frequencies and of the largest peak. The power is .024 at 1/4.
STIPPLEFILTERSSAMPLING_EXPORT DiffusionCoefficients diffusionCoefficients(
  DiffusionMethod method, double level);

/// The same, tabulated at index / DiffusionTableScale for index 0 .. DiffusionTableScale.
constexpr int DiffusionTableScale = 255 * 16;
STIPPLEFILTERSSAMPLING_EXPORT const DiffusionCoefficients* diffusionTable(DiffusionMethod method);
}

#endif
