// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Charts welded along their backbones into one mesh over the samples (paper 4.1).
#ifndef stipple_ChartStitching_h
#define stipple_ChartStitching_h

#include "ChartTriangulation.h"
#include "StippleFiltersMeshingModule.h"

namespace stipple
{
/// Welds chart meshes along the backbone intervals that they share. Swaps inside the charts then
/// see to it that no edge occurs twice, none joins a sample to itself, and no triangle is
/// degenerate in space; at the worst they swap a seam away. hasEdge tells for every backbone
/// interval whether the mesh has an edge for it: for all but such seams. Too few points if swaps do
/// not do; chartAtFault is then the one that they left an edge in.
STIPPLEFILTERSMESHING_EXPORT Status stitchCharts(const AtlasSurface& surface,
  const FeatureGraph& graph, const BackboneIntervals& intervals,
  const std::vector<ChartTriangulation>& charts, const std::vector<Sample>& samples,
  std::vector<Triangle>& triangles, ElementArray<Label, char>& hasEdge, Chart& chartAtFault,
  const Stop& stop = {});
}

#endif
