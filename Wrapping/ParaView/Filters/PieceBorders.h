// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Pieces of one surface, back together.
#ifndef stipple_PieceBorders_h
#define stipple_PieceBorders_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace stipple
{
/// Closes the cracks of pieces that were appended in their order: what is one point of the surface
/// becomes one, the first piece's. These are points of the same global id where the pieces have
/// global ids, and otherwise points on the borders of two pieces that are nearer to each other than
/// a millionth of the diagonal and a quarter of their shortest border edge: a source that computes
/// its pieces apart makes the copies differ in their last bits.
vtkSmartPointer<vtkPolyData> joinPieces(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkPolyData* appended);
}

#endif
