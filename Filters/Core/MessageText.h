// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What messages say: sentences of VTK's macros without what only a debugger wants to know, numbers
// that are not known to the last digit, counts, and how topologies differ.
#ifndef stipple_MessageText_h
#define stipple_MessageText_h

#include "StippleFiltersCoreModule.h"

#include <string>

namespace stipple
{
struct SurfaceTopology;

/// The sentence within "ERROR: In file, line n\nvtkClass (0x1234): sentence\n\n", on one line.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT std::string sentenceOf(const std::string& vtkMessage);

/// A number of 1 or more rounded to a whole number with two digits that are not 0.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT double twoDigits(double number);

/// A whole number in full, or as 1e+20 where that is easier to read.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT std::string countText(double number);

/// A number and what there are so many of: "1 triangle", "2 triangles".
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT std::string countOf(
  long long number, const std::string& one, const std::string& more);

/// All that differs from the topology that is wanted, as "1 boundary loop instead of 0"; nothing if
/// that is nothing.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT std::string differenceOf(
  const SurfaceTopology& topology, const SurfaceTopology& wanted);
}

#endif
