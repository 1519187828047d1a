// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Serpentine error diffusion of a float image (paper 3.2).
#ifndef stipple_ErrorDiffusion_h
#define stipple_ErrorDiffusion_h

#include "DiffusionCoefficients.h"
#include "ReportingThread.h"
#include "StippleFiltersSamplingModule.h"

#include <functional>
#include <vector>

namespace stipple
{
struct ErrorDiffusionOptions
{
  double scale = 1.; ///< factor on every pixel's wanted samples, > 0
  DiffusionMethod method = DiffusionMethod::Ostromoukhov;
  Stop stop; ///< the result is of no use once this is true
};

/// Samples that each pixel of row y wants; valid until the next call.
using WantedRow = std::function<const float*(int y)>;

/// The pixels (row-major indices, ascending) that become samples. wanted gives the samples that
/// each of the width x height pixels wants, at most one. Where it is zero no sample ever falls, and
/// the error passes on; nor where it is negative, and what passes on grows by as much.
///
/// The paper runs over a flipped copy of the image first, so that the errors are in their steady
/// state when row 0 begins and no dead zone shows. Here the thresholds make zero the mean of the
/// steady state (see DiffusionCoefficients), so that there is nothing to wait for. Measured: the
/// counts in windows at the top deviate by .21 of Poisson's, in those inside by .23, at levels from
/// 1/100 to 1/8.
STIPPLEFILTERSSAMPLING_EXPORT void diffuseErrors(const WantedRow& wanted, int width, int height,
  const ErrorDiffusionOptions& options, std::vector<int>& samples);

/// The same for an image in memory.
STIPPLEFILTERSSAMPLING_EXPORT void diffuseErrors(const float* wanted, int width, int height,
  const ErrorDiffusionOptions& options, std::vector<int>& samples);
}

#endif
