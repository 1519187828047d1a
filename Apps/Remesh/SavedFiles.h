// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What lies between the surface and the mesh, in files: charts, maps, samples.
#ifndef stipple_SavedFiles_h
#define stipple_SavedFiles_h

#include "Progress.h"

#include <string>

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
class OutputFiles;

/// .vtpc: one vtkPolyData a chart. .vtp: all charts in one, with a cell array ChartId.
[[nodiscard]] Status saveCharts(
  vtkPartitionedDataSetCollection* charts, const std::string& file, OutputFiles& files);

/// For every chart, chartNNN.vti with all its maps as floats, and a picture chartNNN_Map.png of
/// each.
[[nodiscard]] Status saveMaps(
  vtkPartitionedDataSetCollection* maps, const std::string& folder, OutputFiles& files);

/// .vtp, .vtk with all arrays; .ply positions.
[[nodiscard]] Status saveSamples(vtkPolyData* samples, const std::string& file, OutputFiles& files);
}

#endif
