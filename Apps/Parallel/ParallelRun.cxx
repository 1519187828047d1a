// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelRun.h"

#include "BlockFiles.h"
#include "BlockGhosts.h"
#include "BlockwiseRemesher.h"
#include "MeshFile.h"
#include "Program.h"

#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <thread>

#include <unistd.h>

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
  useThreads(asked > 0 ? asked : std::max(1, share));
}

/// Memory, in MB, of a rank without a surface, and of the blocks that remain for as long as one is
/// remeshed; in bytes, what remeshing takes for each triangle of a block. Measured: see
/// Documentation/Scaling.md.
constexpr double BaseMemory = 120;
constexpr double BytesPerTriangle = 2600;

/// A folder for blocks, as long as this lives.
class BlockFolder
{
public:
  ~BlockFolder()
  {
    std::error_code code;
    if (!this->Name.empty())
    {
      std::filesystem::remove_all(this->Name, code);
    }
  }
  BlockFolder() = default;
  BlockFolder(const BlockFolder&) = delete;
  BlockFolder& operator=(const BlockFolder&) = delete;
  Status make(const std::string& output)
  {
    const std::string name = output + ".blocks." + std::to_string(getpid());
    std::error_code code;
    if (!std::filesystem::create_directory(name, code))
    {
      return Status::error("cannot make the folder '" + name + "'");
    }
    this->Name = name;
    return Status::success();
  }
  const std::string& name() const { return this->Name; }

private:
  std::string Name;
};

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
  BlockFolder folder;
  if (o.has("memory_limit") && o.number("memory_limit") > 0)
  {
    const double room = std::max(20., o.number("memory_limit") - BaseMemory);
    options.trianglesPerBlock = std::clamp(
      static_cast<long long>(1e6 * room / BytesPerTriangle), 1000LL, options.trianglesPerBlock);
    if (Status status = ranks.agree(folder.make(o.text("output"))); !status.ok())
    {
      return status;
    }
    options.folder = folder.name();
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
    const int ghostLevels = o.has("ghost_levels") ? o.integer("ghost_levels") : 0;
    status = addGhostCells(ghostLevels, ranks, mesh);
    if (status.ok())
    {
      status = ranks.agree(writeBlockFiles(mesh, o.text("output"), ghostLevels, ranks, files));
    }
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
