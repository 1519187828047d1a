// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockwiseRemesher.h"

#include "BlockOutput.h"
#include "BlockStorage.h"
#include "BorderHealing.h"

#include "vtkConformalAtlas.h"
#include "vtkGeometryRemesher.h"
#include "vtkMath.h"
#include "vtkRemeshOptimizer.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace stipple
{
namespace
{
/// How often the points of blocks are shared anew after one had too few.
constexpr int RoundsOfSharing = 6;

class Blockwise
{
public:
  Blockwise(const BlockwiseOptions& options, vtkGeometryRemesher* remesher,
    const RankMessages& ranks, const Progress& progress, BlockwiseResult& result)
    : Options(options)
    , Remesher(remesher)
    , Ranks(ranks)
    , Report(progress)
    , Result(result)
  {
  }

  Status run(const SurfacePieces& pieces, vtkPartitionedDataSet* output)
  {
    Status status = makeBlocks(pieces, this->Options.trianglesPerBlock, this->Options.points,
      this->Options.folder, this->Ranks, this->Blocks);
    this->Result.blocks = this->Blocks.count;
    this->lap(0);
    if (!status.ok() || this->Blocks.numberOfTriangles == 0)
    {
      return status;
    }
    status = this->makeBorders();
    this->lap(1);
    if (status.ok())
    {
      status = this->remesh();
      this->lap(2);
    }
    if (status.ok() && this->Blocks.count > 1)
    {
      status = healBorders(this->Blocks, this->Outlines, this->Borders, this->healingOptions(),
        this->Options.healingRings, this->Ranks, this->Meshes);
      this->lap(3);
    }
    if (status.ok())
    {
      status = writeBlocks(this->Blocks, this->Meshes, this->Ranks, output);
      this->lap(4);
    }
    return status;
  }

private:
  void lap(int phase)
  {
    const double now = vtkTimerLog::GetUniversalTime();
    this->Result.seconds[static_cast<std::size_t>(phase)] += now - this->Since;
    this->Since = now;
  }

  OptimizerOptions healingOptions() const
  {
    vtkRemeshOptimizer* optimizer = this->Remesher->GetOptimizer();
    OptimizerOptions options;
    options.swaps = static_cast<OptimizerOptions::Swaps>(optimizer->GetConnectivity());
    options.moves = static_cast<OptimizerOptions::Moves>(optimizer->GetSmoothing());
    options.iterations = optimizer->GetNumberOfIterations();
    options.errorReduction = 0.; // the patch ends where the surface goes on
    options.acuteCornerAngle = 0.;
    options.featureTolerance = 0.;
    options.refinesFaults = false;
    return options;
  }

  /// Features, densities and borders of this rank's blocks.
  Status outline()
  {
    this->Outlines.clear();
    Status status = Status::success();
    for (const SurfaceBlock& block : this->Blocks.own)
    {
      this->Outlines.emplace_back();
      status = guarded([&] {
        return outlineBlock(
          *BlockInMemory(block), this->Remesher, this->Blocks.diagonal, this->Outlines.back());
      });
      if (!status.ok())
      {
        break;
      }
    }
    return this->Ranks.agree(status);
  }

  Status makeBorders()
  {
    this->Points =
      this->Options.points > 0 ? this->Options.points : this->Blocks.numberOfTriangles / 2;
    if (this->Points > std::numeric_limits<int>::max())
    {
      return Status::error("A mesh has at most 2147483647 points: ask for less.");
    }
    if (this->Blocks.count > 1 && this->Remesher->GetAtlas()->GetKeepTextureSeams())
    {
      return Status::error("The seams of a texture are kept in one block only: use "
                           "vtkGeometryRemesher, or blocks that are larger.");
    }
    Status status = this->outline();
    const double length = edgeLengthOf(this->Blocks.area, static_cast<double>(this->Points));
    // First downwards: else neighbours may exchange what they have.
    for (int round = 0; round < 2 && status.ok() && this->Blocks.count > 1; ++round)
    {
      std::vector<std::array<long long, 2>> own;
      for (std::size_t b = 0; b < this->Blocks.own.size(); ++b)
      {
        const auto slivers =
          findSlivers(*BlockInMemory(this->Blocks.own[b]), this->Outlines[b], length, round == 0);
        own.insert(own.end(), slivers.begin(), slivers.end());
      }
      std::map<long long, int> newOwner;
      for (const auto& [triangle, block] : this->Ranks.gatherAll(own))
      {
        newOwner[triangle] = static_cast<int>(block);
      }
      moveTriangles(newOwner, this->Blocks);
      status = this->outline();
    }
    if (!status.ok())
    {
      return status;
    }
    struct Wanted
    {
      int block;
      double wanted;
    };
    std::vector<Wanted> own;
    std::vector<OpenEdge> open;
    for (std::size_t b = 0; b < this->Blocks.own.size(); ++b)
    {
      own.push_back({ this->Blocks.own[b].number, this->Outlines[b].wanted });
      open.insert(
        open.end(), this->Outlines[b].openEdges.begin(), this->Outlines[b].openEdges.end());
    }
    this->Wanted.assign(static_cast<std::size_t>(this->Blocks.count), 0.);
    this->IsEmpty.assign(static_cast<std::size_t>(this->Blocks.count), 1);
    for (const auto& [block, wanted] : this->Ranks.gatherAll(own))
    {
      this->Wanted[block] = wanted;
      this->IsEmpty[block] = 0;
    }
    const double total = std::accumulate(this->Wanted.begin(), this->Wanted.end(), 0.);
    if (!(total > 0) || !std::isfinite(total))
    {
      return Status::error("The surface has no area, or no importance anywhere.");
    }
    const double scale = static_cast<double>(this->Points) / total;
    if (this->Blocks.count > 1)
    {
      status = sampleBorders(this->Ranks.gatherAll(open), scale, this->Borders);
      if (!status.ok())
      {
        return status; // the same on all ranks
      }
    }
    this->Result.borderPoints = static_cast<int>(this->Borders.samples.size());
    this->Result.borders = toPolyData(this->Borders);
    for (double& wanted : this->Wanted)
    {
      wanted *= scale;
    }
    for (const BorderSample& sample : this->Borders.samples)
    {
      for (const int block : sample.blocks)
      {
        this->Wanted[block] -= 1. / static_cast<double>(sample.blocks.size());
      }
    }
    return Status::success();
  }

  /// All blocks, until none has too few points.
  Status remesh()
  {
    const auto n = static_cast<std::size_t>(this->Blocks.count);
    std::vector<int> least(n, 1);
    for (std::size_t b = 0; b < n; ++b)
    {
      if (this->IsEmpty[b] != 0)
      {
        least[b] = 0;
        this->Wanted[b] = 0;
      }
    }
    const long long inside = this->Points - static_cast<long long>(this->Borders.samples.size());
    std::vector<int> before(n, -1);
    std::vector<int> share;
    this->Meshes.resize(this->Blocks.own.size());
    for (int round = 0;; ++round)
    {
      share = sharesOf(inside, this->Wanted, least);
      const long long needed =
        std::accumulate(least.begin(), least.end(), 0LL) + this->Points - inside;
      if (share.empty())
      {
        this->Result.least = static_cast<int>(needed);
        return Status::tooFewPoints("The surface cut into " + std::to_string(n) +
            " blocks has no mesh of " + std::to_string(this->Points) +
            " points: ask for at least " + std::to_string(needed) + ", or for larger blocks.",
          static_cast<int>(needed));
      }
      Status status = Status::success();
      std::vector<std::array<int, 2>> lacking; // block, and what it needs
      std::string sentence;
      for (std::size_t b = 0; b < this->Blocks.own.size() && status.ok(); ++b)
      {
        const int block = this->Blocks.own[b].number;
        if (share[block] == before[block])
        {
          continue;
        }
        double told = 0; // a block may be remeshed more than once
        const Progress ofBlock = [&](double fraction) {
          told = std::max(told, fraction);
          return report(this->Report,
            0.1 +
              0.7 * (static_cast<double>(b) + told) / static_cast<double>(this->Blocks.own.size()));
        };
        if (!ofBlock(0.))
        {
          status = Status::aborted();
          break;
        }
        status = guarded([&] {
          return remeshBlock(*BlockInMemory(this->Blocks.own[b]), this->Outlines[b], this->Borders,
            share[block], this->Blocks.count == 1, this->Remesher, ofBlock, this->Meshes[b]);
        });
        if (status.code() == StatusCode::TooFewPoints)
        {
          sentence = status.message();
          lacking.push_back(
            { { block, std::max(status.leastNumberOfPoints(), share[block] + 1) } });
          status = Status::success();
        }
      }
      if (Status all = this->Ranks.agree(status); !all.ok())
      {
        return all;
      }
      const std::vector<std::array<int, 2>> ofAll = this->Ranks.gatherAll(lacking);
      if (ofAll.empty())
      {
        break;
      }
      before = share;
      for (const auto& [block, needs] : ofAll)
      {
        least[block] = needs;
        before[block] = -1;
      }
      if (this->Blocks.count == 1 || round + 1 == RoundsOfSharing)
      {
        this->Result.least = this->Blocks.count == 1 ? least[0] : 0;
        const Status said = sentence.empty() ? Status::success() : Status::tooFewPoints(sentence);
        return this->Ranks.agree(said);
      }
    }
    // Ids of all.
    std::vector<long long> first(n + 1, static_cast<long long>(this->Borders.samples.size()));
    for (std::size_t b = 0; b < n; ++b)
    {
      first[b + 1] = first[b] + share[b];
    }
    for (std::size_t b = 0; b < this->Meshes.size(); ++b)
    {
      for (long long& id : this->Meshes[b].id)
      {
        id = id < 0 ? first[static_cast<std::size_t>(this->Blocks.own[b].number)] - 1 - id : id;
      }
    }
    return this->partEdges();
  }

  /// Two blocks may have an edge between the same two points of their border: one of them swaps it.
  Status partEdges()
  {
    const auto samples = static_cast<long long>(this->Borders.samples.size());
    using Edge = std::array<long long, 2>;
    std::set<Edge> chords;
    for (const BorderCurve& curve : this->Borders.curves)
    {
      for (std::size_t i = 1; i < curve.samples.size(); ++i)
      {
        chords.insert({ { std::min(curve.samples[i - 1], curve.samples[i]),
          std::max(curve.samples[i - 1], curve.samples[i]) } });
      }
    }
    std::vector<std::map<Edge, std::vector<int>>> inside(this->Meshes.size());
    std::vector<std::array<long long, 3>> own;
    for (std::size_t b = 0; b < this->Meshes.size(); ++b)
    {
      const BlockMesh& mesh = this->Meshes[b];
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          const long long p = mesh.id[mesh.triangles[t][k]];
          const long long q = mesh.id[mesh.triangles[t][(k + 1) % 3]];
          if (p < samples && q < samples)
          {
            inside[b][{ { std::min(p, q), std::max(p, q) } }].push_back(static_cast<int>(t));
          }
        }
      }
      for (const auto& [edge, triangles] : inside[b])
      {
        if (triangles.size() == 2)
        {
          own.push_back({ { edge[0], edge[1], this->Blocks.own[b].number } });
        }
      }
    }
    std::map<Edge, std::set<int>> blocksOf;
    for (const auto& [p, q, block] : this->Ranks.gatherAll(own))
    {
      blocksOf[{ { p, q } }].insert(static_cast<int>(block));
    }
    Status status = Status::success();
    for (std::size_t b = 0; b < this->Meshes.size(); ++b)
    {
      const int block = this->Blocks.own[b].number;
      for (const auto& [edge, blocks] : blocksOf)
      {
        const bool isExtra = chords.count(edge) > 0 || *blocks.begin() != block;
        if (isExtra && blocks.count(block) > 0 && !swap(this->Meshes[b], edge))
        {
          status =
            Status::tooFewPoints("Points on the borders of blocks are so few that blocks "
                                 "would share triangles: use more points, or larger blocks.");
        }
      }
    }
    return this->Ranks.agree(status);
  }

  static bool swap(BlockMesh& mesh, const std::array<long long, 2>& edge)
  {
    std::vector<std::size_t> both;
    std::array<int, 2> apex = { { -1, -1 } };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      int ends = 0;
      int other = -1;
      for (const int p : mesh.triangles[t])
      {
        const bool isEnd = mesh.id[p] == edge[0] || mesh.id[p] == edge[1];
        ends += isEnd ? 1 : 0;
        other = isEnd ? other : p;
      }
      if (ends == 2 && both.size() < 2)
      {
        apex[both.size()] = other;
        both.push_back(t);
      }
    }
    if (both.size() != 2)
    {
      return false;
    }
    for (const auto& t : mesh.triangles)
    {
      if (std::count(t.begin(), t.end(), apex[0]) > 0 &&
        std::count(t.begin(), t.end(), apex[1]) > 0)
      {
        return false;
      }
    }
    // Of each triangle, one end of the edge becomes the other's apex.
    auto& first = mesh.triangles[both[0]];
    auto& second = mesh.triangles[both[1]];
    const auto a =
      std::find_if(first.begin(), first.end(), [&](int p) { return mesh.id[p] == edge[0]; });
    const auto c =
      std::find_if(second.begin(), second.end(), [&](int p) { return mesh.id[p] == edge[1]; });
    *a = apex[1];
    *c = apex[0];
    return true;
  }

  const BlockwiseOptions& Options;
  vtkGeometryRemesher* Remesher;
  const RankMessages& Ranks;
  const Progress& Report;
  BlockwiseResult& Result;
  double Since = vtkTimerLog::GetUniversalTime();
  SurfaceBlocks Blocks;
  std::vector<BlockOutline> Outlines; // by own block
  std::vector<BlockMesh> Meshes;
  BlockBorders Borders;
  std::vector<double> Wanted; // points, by block
  std::vector<char> IsEmpty;
  long long Points = 0;
};
}

std::vector<int> sharesOf(
  long long number, const std::vector<double>& wanted, const std::vector<int>& least)
{
  if (std::accumulate(least.begin(), least.end(), 0LL) > number)
  {
    return {};
  }
  // Those whose share would be below their least get that, and the rest is shared by the others.
  std::vector<char> isHeld(wanted.size(), 0);
  std::vector<int> share(wanted.size(), 0);
  for (;;)
  {
    long long left = number;
    double sum = 0;
    std::size_t free = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      left -= isHeld[i] != 0 ? least[i] : 0;
      sum += isHeld[i] != 0 ? 0. : std::max(0., wanted[i]);
      free += isHeld[i] != 0 ? 0 : 1;
    }
    std::vector<std::pair<double, std::size_t>> missing;
    long long given = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      if (isHeld[i] != 0)
      {
        share[i] = least[i];
        continue;
      }
      const double exact = sum > 0 ? static_cast<double>(left) * std::max(0., wanted[i]) / sum
                                   : static_cast<double>(left) / static_cast<double>(free);
      share[i] = static_cast<int>(std::floor(exact));
      given += share[i];
      missing.emplace_back(share[i] - exact, i);
    }
    std::sort(missing.begin(), missing.end());
    for (std::size_t k = 0; k < missing.size() && given < left; ++k, ++given)
    {
      ++share[missing[k].second];
    }
    bool isDone = true;
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      if (share[i] < least[i])
      {
        isHeld[i] = 1; // one more each round
        isDone = false;
      }
    }
    if (isDone)
    {
      return share;
    }
  }
}

Status remeshBlockwise(const SurfacePieces& pieces, const BlockwiseOptions& options,
  vtkGeometryRemesher* remesher, const RankMessages& ranks, const Progress& progress,
  vtkPartitionedDataSet* output, BlockwiseResult& result)
{
  result = {};
  return Blockwise(options, remesher, ranks, progress, result).run(pieces, output);
}
}
