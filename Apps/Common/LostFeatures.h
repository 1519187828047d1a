// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the mesh has not the features that the input has: they were simplified for want of room.
#ifndef stipple_LostFeatures_h
#define stipple_LostFeatures_h

#include "vtkSmartPointer.h"

class vtkGeometryRemesher;
class vtkPolyData;

namespace stipple
{
/// What of the segments of the sharp lines of `before`, without those that are rounded off, is far
/// from all sharp lines and boundaries of `after`, over the length of the segment there: a line a
/// stretch. Both have the cell array BackboneType.
[[nodiscard]] vtkSmartPointer<vtkPolyData> lostFeatures(vtkPolyData* before, vtkPolyData* after);

/// Corners and points of creases that went to others in a remesher's last run.
[[nodiscard]] int numberOfSimplifiedFeatures(vtkGeometryRemesher* remesher);

/// Those of a remesher's last run; null where it has simplified nothing.
[[nodiscard]] vtkSmartPointer<vtkPolyData> lostFeatures(vtkGeometryRemesher* remesher);
}

#endif
