// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelRun.h"

#include "BlockFiles.h"
#include "BlockwiseRemesher.h"
#include "MeshFile.h"

#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <thread>

namespace stipple
{
namespace
{
/// This rank's threads: those asked for, or its share of the machine's, as if all ranks were on it.
void startThreads(const OptionValues& o, const RankMessages& ranks)
{
  const int asked = o.has("threads") ? o.integer("threads") : 0;
  const int share =
    static_cast<int>(std::thread::hardware_concurrency()) / std::max(1, ranks.size());
  vtkSMPTools::Initialize(asked > 0 ? asked : std::max(1, share));
}

Status remesh(const OptionValues& o, const RankMessages& ranks, vtkPartitionedDataSet* mesh,
  BlockwiseResult& result)
{
  std::vector<std::string> pieces;
  if (Status status = findPieces(o.text("model"), ranks, pieces); !status.ok())
  {
    return status;
  }
  vtkNew<vtkGeometryRemesher> remesher;
  applyOptions(o, remesher);
  remesher->GetMapRenderer()->SetBackendToCPU();
  BlockwiseOptions options;
  options.points = o.integer("points");
  if (o.has("triangles_per_block"))
  {
    options.trianglesPerBlock = static_cast<long long>(o.number("triangles_per_block"));
  }
  return remeshBlockwise(shareOfPieces(pieces, ranks), options, remesher, ranks, {}, mesh, result);
}
}

Status runParallel(const OptionValues& o, const RankMessages& ranks)
{
  startThreads(o, ranks);
  Status status = ranks.rank() == 0 ? OutputFiles::check(o.text("output")) : Status::success();
  status = ranks.agree(status);
  if (!status.ok())
  {
    return status;
  }
  vtkNew<vtkPartitionedDataSet> mesh;
  BlockwiseResult result;
  status = remesh(o, ranks, mesh, result);
  if (status.ok() && result.blocks > 0)
  {
    OutputFiles files;
    status = ranks.agree(writeBlockFiles(mesh, o.text("output"), ranks, files));
    // Pieces first: who sees the file that names them finds them.
    for (int turn = ranks.size() - 1; turn >= 0 && status.ok(); --turn)
    {
      status = ranks.agree(turn == ranks.rank() ? files.commit() : Status::success());
    }
  }
  if (status.ok() && ranks.rank() == 0 && o.flag("verbose"))
  {
    std::fprintf(stderr, "stipple-mpi: %d ranks, %d blocks, %d points on their borders\n",
      ranks.size(), result.blocks, result.borderPoints);
    const char* const phases[] = { "distribution", "borders", "remeshing", "healing", "output" };
    for (std::size_t i = 0; i < result.seconds.size(); ++i)
    {
      std::fprintf(stderr, "stipple-mpi:   %-13s %8.3f s\n", phases[i], result.seconds[i]);
    }
    std::fprintf(stderr, "stipple-mpi:   %.3f MB sent by the first rank\n", 1e-6 * ranks.sent());
  }
  return status;
}
}
