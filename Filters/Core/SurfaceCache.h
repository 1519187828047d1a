// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The old name of the atlas, until all callers know the new one.
#ifndef stipple_SurfaceCache_h
#define stipple_SurfaceCache_h

#include "Atlas.h"

namespace stipple
{
using SurfaceCache = Atlas;
}

#endif
