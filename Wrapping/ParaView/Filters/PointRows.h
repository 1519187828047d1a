// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Points that come by a connection as rows of options.
#ifndef stipple_PointRows_h
#define stipple_PointRows_h

#include "OptionTable.h"
#include "Progress.h"

class vtkPolyData;

namespace stipple
{
/// Adds points to the option "constraints". Null adds none.
void addConstraints(vtkPolyData* points, OptionValues& values);

/// Adds points with the point arrays "radius" and "strength" to the option "strokes". Null adds
/// none.
Status addStrokes(vtkPolyData* points, OptionValues& values);
}

#endif
