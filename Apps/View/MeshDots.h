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
class NearestTriangle;

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

struct PlacedDot
{
  Vec3 position;       ///< goes to the nearest place on the surface
  double area = 0;     ///< of the surface that belongs to it
  int face = -1;       ///< of the atlas, near to it; -1: not known
  bool onFace = false; ///< it is on that face
};

[[nodiscard]] MeshDots placeOnCharts(
  const std::vector<PlacedDot>& dots, const AtlasSurface& surface, const NearestTriangle& nearest);

/// `mesh` has triangles; its vertices.
[[nodiscard]] MeshDots placeOnCharts(vtkPolyData* mesh, const Atlas& atlas);
}

#endif
