// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Shortest edge paths in a chart (Dijkstra 1959).
#ifndef stipple_ShortestPaths_h
#define stipple_ShortestPaths_h

#include "ChartMesh.h"
#include "CompressedRows.h"
#include "ReportingThread.h"

namespace stipple
{
/// Paths along the chart's edges from its vertices to a growing set of them.
class ShortestPaths
{
public:
  /// Surface and chart have to outlive the paths.
  ShortestPaths(const TriangleSurface& surface, const ChartMesh& chart);

  /// Distances are not final if it is stopped.
  void addTargets(const std::vector<int>& targets, const Stop& stop = {});
  /// To the nearest target; infinity if there is none.
  double distance(int vertex) const { return this->Distance[vertex]; }
  /// From the vertex to its target, both included.
  std::vector<int> path(int vertex) const;

private:
  const TriangleSurface& Surface;
  const ChartMesh& Chart;
  CompressedRows<int> Neighbours; // of every vertex, those along inner edges twice
  std::vector<double> Distance;
  std::vector<int> Next; // -1 at a target
};
}

#endif
