// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_DensityImages_h
#define stipple_DensityImages_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;
class vtkPartitionedDataSetCollection;

namespace stipple
{
/// How dense samples are wanted, in the colours of densityBar(): an image a chart, as fine as its
/// image with `Control` and `AreaDistortion`, 3 unsigned chars a pixel. Empty if one lacks these.
[[nodiscard]] std::vector<vtkSmartPointer<vtkImageData>> densityImages(
  vtkPartitionedDataSetCollection* controls);
}

#endif
