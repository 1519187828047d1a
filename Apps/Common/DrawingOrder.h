// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Polygons in an order in which they are drawn quickly.
#ifndef stipple_DrawingOrder_h
#define stipple_DrawingOrder_h

#include "vtkSmartPointer.h"

class vtkCellArray;
class vtkPolyData;

namespace stipple
{
/// The mesh's polygons along a curve that visits near ones soon after each other: Z-order of their
/// middles (G. M. Morton, A Computer Oriented Geodetic Data Base, 1966). Whoever draws them keeps
/// the latest vertices, and transforms a vertex that is shared once or twice, not six times.
[[nodiscard]] vtkSmartPointer<vtkCellArray> inDrawingOrder(vtkPolyData* mesh);
}

#endif
