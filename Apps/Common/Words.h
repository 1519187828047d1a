// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Words_h
#define stipple_Words_h

#include <string>
#include <vector>

namespace stipple
{
/// Of some words, the one that was probably meant; empty if none is near.
[[nodiscard]] std::string nearestWord(
  const std::string& typed, const std::vector<std::string>& words);
}

#endif
