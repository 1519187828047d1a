// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Exactly N: how dense the samples are, and how many each chart receives.
#ifndef stipple_SampleBudget_h
#define stipple_SampleBudget_h

#include "StippleFiltersSamplingModule.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace stipple
{
/// The largest scale for which a count that does not decrease with it stays within the budget; 0 if
/// none. The scale is looked for in (0, most].
STIPPLEFILTERSSAMPLING_EXPORT double largestScale(
  const std::function<double(double)>& count, double budget, double most);

/// Splits a total in proportion to shares (largest remainder, ties to the smaller index), with at
/// least `least` for each. The total is at least the sum of `least`; shares that are all zero count
/// as equal among those that have `least`, or else among all.
STIPPLEFILTERSSAMPLING_EXPORT std::vector<int> apportion(
  int total, const std::vector<double>& shares, const std::vector<int>& least);
}

#endif
