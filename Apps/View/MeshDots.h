// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The vertices of a finished mesh as the samples of the left view: what is seen there is true once
// the mesh is there.
#ifndef stipple_MeshDots_h
#define stipple_MeshDots_h

#include "Atlas.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkPolyData;

namespace stipple
{
/// Where a dot reaches into a chart that is not its own.
struct DotBeyond
{
  int dot = 0;
  int chart = 0;
  int face = 0; ///< of the atlas
  Vec2 uv = Vec2::Zero();
};

struct MeshDots
{
  /// A point a vertex, with the arrays of vtkErrorDiffusionSampler's first output: `ChartId`,
  /// `ChartCellId`, `UV`, `SampleKind` (0) and `Density`, in vertices per unit of area.
  vtkSmartPointer<vtkPolyData> samples;
  std::vector<DotBeyond> beyond;
};

/// `mesh` has triangles; each vertex goes to the place on the charts that is nearest to it.
[[nodiscard]] MeshDots placeOnCharts(vtkPolyData* mesh, const Atlas& atlas);
}

#endif
