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

/// The polylines along sharp edges that are creases to a mesh whose edges are so long: where they
/// are rounded off, by the cell array Width, short ones go around. With 0, what no mesh should
/// lose.
[[nodiscard]] vtkSmartPointer<vtkPolyData> creasesTo(vtkPolyData* lines, double edgeLength);
}

#endif
