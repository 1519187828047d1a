// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Cutting a surface into disk charts of bounded distortion (paper 2.1, 2.5).
#ifndef stipple_ChartPartition_h
#define stipple_ChartPartition_h

#include "DensityCuts.h"
#include "SeamPlacement.h"

namespace stipple
{
struct ChartPartitionOptions
{
  int numberOfCharts = 1;           ///< at least, >= 1
  double maximumDensityRatio = 100; ///< > 1; bound on ConformalMap::densityRatio
  bool square = false;              ///< ConformalMapOptions::square
  BoundaryPlacement placement = BoundaryPlacement::AreaMedian;
};

/// Marks the cuts on the surface and returns its charts, flattened; their order does not depend on
/// threads. A chart is denser than the bound only if it holds so few of the surface's triangles
/// that splitting them does not help. Several threads at once call progress.
STIPPLEFILTERSATLAS_EXPORT Status partitionSurface(CutSurface& surface,
  const ChartPartitionOptions& options, std::vector<FlatChart>& charts, const Progress& progress);
}

#endif
