// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One run of the program: read, remesh, write.
#ifndef stipple_Run_h
#define stipple_Run_h

#include "Progress.h"

namespace stipple
{
class OptionValues;

/// An error is the one sentence for stderr.
[[nodiscard]] Status run(const OptionValues& options);
}

#endif
