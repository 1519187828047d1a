// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Charts welded along their backbones into one mesh over the samples (paper 4.1).
#ifndef stipple_ChartStitching_h
#define stipple_ChartStitching_h

#include "ChartTriangulation.h"
#include "StippleFiltersMeshingModule.h"

#include <utility>
#include <vector>

namespace stipple
{
/// What keeps samples from being meshed, if samples inside charts would help.
struct MeshFault
{
  Chart chart;                                ///< that another sample would help, or none
  std::vector<std::pair<Chart, Vec2>> places; ///< parameters where samples would, if known
};

/// Welds chart meshes along the backbone intervals that they share. Swaps inside the charts then
/// see to it that no edge occurs twice, none joins a sample to itself, and no triangle is
/// degenerate in space; at the worst they swap a seam away. hasEdge tells for every backbone
/// interval whether the mesh has an edge for it: for all but such seams. Too few points if swaps do
/// not do; the fault's places are then the middles of edges that they left, none beside another.
STIPPLEFILTERSMESHING_EXPORT Status stitchCharts(const AtlasSurface& surface,
  const FeatureGraph& graph, const BackboneIntervals& intervals,
  const std::vector<ChartTriangulation>& charts, const std::vector<Sample>& samples,
  std::vector<Triangle>& triangles, ElementArray<Label, char>& hasEdge, MeshFault& fault,
  const Stop& stop = {});
}

#endif
