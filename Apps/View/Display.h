// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Display_h
#define stipple_Display_h

#include "Progress.h"

namespace stipple
{
/// Whether a window can be opened here; VTK itself would end the program without saying more.
[[nodiscard]] Status checkDisplay();
}

#endif
