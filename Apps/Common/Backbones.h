// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_Backbones_h
#define stipple_Backbones_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace stipple
{
/// The polylines of a type, by the cell array BackboneType; nothing if there is no such array.
[[nodiscard]] vtkSmartPointer<vtkPolyData> backbonesOfType(vtkPolyData* lines, int type);

/// The polylines along sharp edges that are creases to the mesh whose vertices on them are these
/// samples, by the point array BackboneId: where an edge is rounded off, by the cell array Width,
/// short edges go around, unless all are creases, as to quads. Without samples, what no mesh should
/// lose.
[[nodiscard]] vtkSmartPointer<vtkPolyData> creasesTo(
  vtkPolyData* lines, vtkPolyData* samples, bool allAreCreases = false);
}

#endif
