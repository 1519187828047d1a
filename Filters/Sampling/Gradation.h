// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Smooth gradation (paper 3.3): low-pass of the importance, measured on the surface.
#ifndef stipple_Gradation_h
#define stipple_Gradation_h

#include "StippleFiltersSamplingModule.h"

namespace stipple
{
/// Low-passes a chart's values in place with a Gaussian of standard deviation sigma in the
/// surface's unit of length: heat flows for the time sigma^2 / 2. On a conformal map the surface's
/// Laplacian is the plane's divided by the area distortion, so that A u_t = u_xx + u_yy with A the
/// area map makes the kernel's local size follow it, as section 3.3 of the paper wishes. Implicit
/// steps, one direction at a time, are stable for every sigma and keep the integral of the values
/// over the surface. Heat stops at the chart's border.
STIPPLEFILTERSSAMPLING_EXPORT void smoothOnSurface(float* values, const float* areaDistortion,
  int width, int height, double pixelWidth, double pixelHeight, double sigma);
}

#endif
