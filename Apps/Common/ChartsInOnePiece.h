// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_ChartsInOnePiece_h
#define stipple_ChartsInOnePiece_h

#include "vtkSmartPointer.h"

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// All charts in one surface, with a cell array ChartId.
[[nodiscard]] vtkSmartPointer<vtkPolyData> chartsInOnePiece(
  vtkPartitionedDataSetCollection* charts);
}

#endif
