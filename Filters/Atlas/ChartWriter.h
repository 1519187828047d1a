// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Hands the flattened charts over as VTK data, with every array of the input.
#ifndef stipple_ChartWriter_h
#define stipple_ChartWriter_h

#include "ChartPartition.h"
#include "Curvature.h"
#include "FeatureGraph.h"
#include "FlatFaceCells.h"
#include "SurfaceRepair.h"

#include <set>

class vtkDoubleArray;
class vtkPartitionedDataSetCollection;
class vtkPoints;
class vtkPolyData;

namespace stipple
{
STIPPLEFILTERSATLAS_EXPORT Status writeCharts(vtkPolyData* input, const RepairedSurface& repaired,
  const CutSurface& surface, const std::vector<FlatChart>& flat, const Curvature& curvature,
  const FlatFaceCells& flatFaces, vtkPartitionedDataSetCollection* output,
  const Progress& progress);

/// Appends the place on the surface nearest to each point. An error if one has a coordinate that is
/// no finite number.
STIPPLEFILTERSATLAS_EXPORT Status locateConstraints(const CutSurface& surface,
  const std::vector<FlatChart>& flat, vtkPoints* points, std::vector<ConstraintPoint>& constraints);

/// The input's cells that the places nearest to points are in.
STIPPLEFILTERSATLAS_EXPORT std::set<int> nearestCells(
  const RepairedSurface& repaired, vtkPoints* points);

/// Appends places given as chart, u, v. An error if one is not in its chart.
STIPPLEFILTERSATLAS_EXPORT Status locateChartConstraints(const CutSurface& surface,
  const std::vector<FlatChart>& flat, vtkDoubleArray* places,
  std::vector<ConstraintPoint>& constraints);

/// Appends surface points that were found to matter and are not on the graph already.
STIPPLEFILTERSATLAS_EXPORT void constrainPoints(const CutSurface& surface,
  const std::vector<FlatChart>& flat, const std::vector<int>& points,
  std::vector<ConstraintPoint>& constraints);
}

#endif
