// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A surface is remeshed block by block: the whole algorithm, without a pipeline about it.
#ifndef stipple_BlockwiseRemesher_h
#define stipple_BlockwiseRemesher_h

#include "BlockRemeshing.h"

#include <array>

class vtkGeometryRemesher;
class vtkPartitionedDataSet;

namespace stipple
{
struct BlockwiseOptions
{
  long long points = 0;                 ///< of the whole mesh; 0: half as many as triangles
  long long trianglesPerBlock = 300000; ///< at most
  std::string folder;   ///< of files for blocks that nobody works on; empty: they are in memory
  int healingRings = 6; ///< edges to each side of borders
};

struct BlockwiseResult
{
  int blocks = 0;
  int borderPoints = 0;
  vtkSmartPointer<vtkPolyData> borders; ///< polylines, with `BlockIds`; null with one block
  int least = 0;                        ///< with too few points: a number that may work
  std::array<double, 5> seconds = {};   ///< vtkPGeometryRemesher::PhaseType
};

/// Shares of a number: the whole parts of what is wanted, and one more where most is missing
/// (largest remainder, of equals the first), so that they add up to it. None is less than its
/// least. Empty if the number is less than the sum of these.
STIPPLEFILTERSPARALLEL_EXPORT std::vector<int> sharesOf(
  long long number, const std::vector<double>& wanted, const std::vector<int>& least);

/// All ranks call it, with the same options and a remesher of the same parameters.
[[nodiscard]] STIPPLEFILTERSPARALLEL_EXPORT Status remeshBlockwise(const SurfacePieces& pieces,
  const BlockwiseOptions& options, vtkGeometryRemesher* remesher, const RankMessages& ranks,
  const Progress& progress, vtkPartitionedDataSet* output, BlockwiseResult& result);
}

#endif
