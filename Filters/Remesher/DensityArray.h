// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// An input's array that says where points go.
#ifndef stipple_DensityArray_h
#define stipple_DensityArray_h

#include "Progress.h"
#include "StippleFiltersRemesherModule.h"

class vtkPolyData;

namespace stipple
{
/// Whether an array of importances can be used, if the input has one of that name: all
/// numbers are finite, and the name is not that of an array of Stipple's own, which would take its
/// place on the way. Another name may be a map's.
[[nodiscard]] STIPPLEFILTERSREMESHER_EXPORT Status checkDensityArray(
  vtkPolyData* input, const char* name);

/// Whether an array of lengths of edges can be used, if the input has one of that name: as above,
/// and each is one number above 0.
[[nodiscard]] STIPPLEFILTERSREMESHER_EXPORT Status checkSizeArray(
  vtkPolyData* input, const char* name);
}

#endif
