// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What VTK's message macros wrote, without what only a debugger wants to know.
#ifndef stipple_MessageText_h
#define stipple_MessageText_h

#include "StippleFiltersCoreModule.h"

#include <string>

namespace stipple
{
/// The sentence within "ERROR: In file, line n\nvtkClass (0x1234): sentence\n\n", on one line.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT std::string sentenceOf(const std::string& vtkMessage);
}

#endif
