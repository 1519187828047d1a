// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK <-> plain surfaces.
#ifndef stipple_PolyDataConversion_h
#define stipple_PolyDataConversion_h

#include "Progress.h"
#include "StippleFiltersCoreModule.h"
#include "TriangleSurface.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace stipple
{
/// The triangles of a poly data (polygons are triangulated, strips unrolled, other cells ignored)
/// and its points, unwelded; not yet connected. sourceCell, if asked for, receives the
/// cell of each triangle. Says what is wrong with data whose cells name points that there are not.
STIPPLEFILTERSCORE_EXPORT Status readPolyData(
  vtkPolyData* data, TriangleSurface& surface, std::vector<int>* sourceCell = nullptr);

/// The same for data that is known to be sound.
STIPPLEFILTERSCORE_EXPORT TriangleSurface fromPolyData(
  vtkPolyData* data, std::vector<int>* sourceCell = nullptr);

/// Points (double) and triangles only.
STIPPLEFILTERSCORE_EXPORT vtkSmartPointer<vtkPolyData> toPolyData(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
}

#endif
