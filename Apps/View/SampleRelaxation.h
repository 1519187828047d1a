// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Samples as the mesh will nearly have them, while a slider moves: error diffusion leaves chains
// along seams and worms, which the mesh's smoothing takes away. A few steps do so in a preview.
#ifndef stipple_SampleRelaxation_h
#define stipple_SampleRelaxation_h

#include "MeshDots.h"

#include <memory>
#include <vector>

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
class NearestTriangle;

class SampleRelaxation
{
public:
  /// Charts and their feature graph, which are read, not kept.
  SampleRelaxation(vtkPartitionedDataSetCollection* charts, vtkPolyData* graph);
  ~SampleRelaxation();

  /// The sampler's first output, spread: those on features, boundaries and constraints stay. Null
  /// where it would take longer than a frame has.
  [[nodiscard]] std::shared_ptr<const MeshDots> relax(vtkPolyData* samples) const;

private:
  Atlas::Pointer Charted;
  std::unique_ptr<NearestTriangle> Nearest; ///< null: the surface is too large
  std::vector<bool> IsSeam;                 ///< by backbone
};
}

#endif
