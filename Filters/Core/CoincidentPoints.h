// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Points at the very same place, which are one point of the surface.
#ifndef stipple_CoincidentPoints_h
#define stipple_CoincidentPoints_h

#include "StippleFiltersCoreModule.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace stipple
{
/// A position that maps and sets find by its exact coordinates, which have to be numbers.
using Place = std::array<double, 3>;

[[nodiscard]] inline Place placeOf(const double* x)
{
  return { { x[0] + 0., x[1] + 0., x[2] + 0. } }; // -0 is 0
}

/// By point, the first one at the very same place: files of triangles that share no points (STL)
/// have edges in common all the same. Coordinates may be no numbers.
STIPPLEFILTERSCORE_EXPORT std::vector<vtkIdType> firstAtPlace(vtkPolyData* data);
}

#endif
