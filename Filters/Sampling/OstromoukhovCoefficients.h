// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Variable coefficients of error diffusion (V. Ostromoukhov, A Simple and Efficient Error-Diffusion
// Algorithm, SIGGRAPH 2001).
#ifndef stipple_OstromoukhovCoefficients_h
#define stipple_OstromoukhovCoefficients_h

#include "StippleFiltersSamplingModule.h"

namespace stipple
{
/// The shares of a pixel's error that its three unvisited neighbours receive; they sum to one.
struct DiffusionCoefficients
{
  float right;
  float downLeft;
  float down;
  float unused; ///< pads to 16 bytes
};

/// Coefficients for a level in [0, 1] (wanted samples in a pixel), linear between the 256 tabulated
/// levels; levels beyond the middle mirror those below it.
STIPPLEFILTERSSAMPLING_EXPORT DiffusionCoefficients ostromoukhovCoefficients(double level);

/// The same, tabulated at index / diffusionTableScale for index 0 .. diffusionTableScale.
constexpr int diffusionTableScale = 255 * 16;
STIPPLEFILTERSSAMPLING_EXPORT const DiffusionCoefficients* diffusionTable();
}

#endif
