// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers in text, independent of the locale: on the command line, and in small files of the
// user's.
#ifndef stipple_TextNumbers_h
#define stipple_TextNumbers_h

#include "StippleFiltersCoreModule.h"

#include <string>
#include <string_view>

namespace stipple
{
/// The whole text is one finite number.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT bool parseNumber(const std::string& text, double& value);

/// The whole text is one number, infinite ones and "nan" among them: the files of others have them.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT bool parseAnyNumber(std::string_view text, double& value);

/// The whole text is one whole number: digits, and perhaps a minus.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT bool parseWhole(std::string_view text, long long& value);

/// The whole text is one whole number within the range.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT bool parseInteger(
  const std::string& text, long long low, long long high, int& value);

/// The shortest text that reads back as the same double.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT std::string shortestText(double value);
}

#endif
