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

/// The shares of a pixel's error that its three unvisited neighbours receive; they sum to one.
struct DiffusionCoefficients
{
  float right;
  float downLeft;
  float down;
  float modulation; ///< how far noise raises the threshold at most, 0 to 0.5
};

/// Coefficients for a level in [0, 1] (wanted samples in a pixel), linear between the 256 tabulated
/// levels; levels beyond the middle mirror those below it.
STIPPLEFILTERSSAMPLING_EXPORT DiffusionCoefficients diffusionCoefficients(
  DiffusionMethod method, double level);

/// The same, tabulated at index / diffusionTableScale for index 0 .. diffusionTableScale.
constexpr int diffusionTableScale = 255 * 16;
STIPPLEFILTERSSAMPLING_EXPORT const DiffusionCoefficients* diffusionTable(DiffusionMethod method);
}

#endif
