// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BorderHealing.h"

#include "BlockStorage.h"
#include "MeshPatch.h"
#include "PolyDataConversion.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_set>

namespace stipple
{
namespace
{
/// How far the surface goes on about what moves, in edges of the mesh: steps end well within.
constexpr double SurfaceReach = 2.;
/// By each rank, where blocks are in files.
constexpr long long PatchesAtATime = 4;

/// Cells of a grid in which there is something.
class PointGrid
{
public:
  explicit PointGrid(double size)
    : Size(size)
  {
  }
  /// The cell of a point and those about it.
  void add(const Vec3& x)
  {
    const std::array<long long, 3> c = this->cellOf(x);
    for (int i = 0; i < 27; ++i)
    {
      this->Cells.insert({ { c[0] + i % 3 - 1, c[1] + i / 3 % 3 - 1, c[2] + i / 9 - 1 } });
    }
  }
  bool touches(const Vec3& least, const Vec3& most) const
  {
    const std::array<long long, 3> a = this->cellOf(least);
    const std::array<long long, 3> b = this->cellOf(most);
    const double cells = (b[0] - a[0] + 1.) * (b[1] - a[1] + 1.) * (b[2] - a[2] + 1.);
    if (cells > static_cast<double>(this->Cells.size()))
    {
      return std::any_of(
        this->Cells.begin(), this->Cells.end(), [&](const std::array<long long, 3>& c) {
          return a[0] <= c[0] && c[0] <= b[0] && a[1] <= c[1] && c[1] <= b[1] && a[2] <= c[2] &&
            c[2] <= b[2];
        });
    }
    for (long long x = a[0]; x <= b[0]; ++x)
    {
      for (long long y = a[1]; y <= b[1]; ++y)
      {
        for (long long z = a[2]; z <= b[2]; ++z)
        {
          if (this->Cells.count({ { x, y, z } }) > 0)
          {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  std::array<long long, 3> cellOf(const Vec3& x) const
  {
    return { { static_cast<long long>(std::floor(x.x() / this->Size)),
      static_cast<long long>(std::floor(x.y() / this->Size)),
      static_cast<long long>(std::floor(x.z() / this->Size)) } };
  }
  double Size;
  std::set<std::array<long long, 3>> Cells;
};

/// What healing knows of a point of a block's mesh.
struct PointState
{
  int curve = -1;        ///< the only one that it is near; -1: none; -2: more than one
  bool isInside = false; ///< not on the outermost ring
  bool isHeld = false;
};

class Healing
{
public:
  Healing(const SurfaceBlocks& blocks, const std::vector<BlockOutline>& outlines,
    const BlockBorders& borders, const OptimizerOptions& options, int rings,
    const RankMessages& ranks, std::vector<BlockMesh>& meshes)
    : Blocks(blocks)
    , Outlines(outlines)
    , Borders(borders)
    , Options(options)
    , Rings(rings)
    , Ranks(ranks)
    , Meshes(meshes)
    , SavesMemory(blocks.isInFiles)
  {
  }

  Status run()
  {
    this->findNear();
    // Curve by curve, each by the rank of its first block.
    std::vector<int> patches;
    for (const BorderCurve& curve : this->Borders.curves)
    {
      patches.push_back(this->Blocks.rankOf(curve.blocks[0], this->Ranks.size()));
    }
    if (Status status = this->heal(patches,
          [](const PointState& state, long long) {
            return state.isInside && !state.isHeld ? state.curve : -1;
          });
        !status.ok())
    {
      return status;
    }
    // What is near several, in parts that are not connected.
    const std::map<long long, int> partOf = this->partsNearSeveral();
    int number = 0;
    for (const auto& [id, part] : partOf)
    {
      number = std::max(number, part + 1);
    }
    patches.clear();
    for (int part = 0; part < number; ++part)
    {
      patches.push_back(part % this->Ranks.size());
    }
    return this->heal(patches, [&](const PointState& state, long long id) {
      return isNearSeveral(state) ? partOf.at(id) : -1;
    });
  }

private:
  static bool isNearSeveral(const PointState& state)
  {
    return state.curve == -2 && state.isInside && !state.isHeld;
  }

  /// Points that move and are near two curves or more, by connected parts of these, which are
  /// numbered by their least ids.
  std::map<long long, int> partsNearSeveral() const
  {
    std::vector<std::array<long long, 2>> own; // edges, and points as edges to themselves
    for (const BlockMesh& mesh : this->Meshes)
    {
      for (const auto& t : mesh.triangles)
      {
        for (int k = 0; k < 3; ++k)
        {
          const long long p = mesh.id[t[k]];
          const long long q = mesh.id[t[(k + 1) % 3]];
          if (isNearSeveral(this->State.at(p)))
          {
            own.push_back({ { p, p < q && isNearSeveral(this->State.at(q)) ? q : p } });
          }
        }
      }
    }
    makeUnique(own);
    std::map<long long, long long> parent;
    const auto find = [&](long long p) {
      while (parent.at(p) != p)
      {
        p = parent[p] = parent.at(parent.at(p));
      }
      return p;
    };
    // An edge that is met from its larger end only is one triangle's, at a boundary.
    for (const auto& [p, q] : this->Ranks.gatherAll(own))
    {
      parent.try_emplace(p, p);
      parent.try_emplace(q, q);
      const long long a = find(p);
      const long long b = find(q);
      parent[std::max(a, b)] = std::min(a, b);
    }
    std::map<long long, int> numberOf;
    std::map<long long, int> result;
    for (const auto& [p, above] : parent)
    {
      const long long root = find(p);
      result[p] = numberOf.try_emplace(root, static_cast<int>(numberOf.size())).first->second;
    }
    return result;
  }

  /// Which curves each point is near, by steps along edges within its block.
  void findNear()
  {
    std::vector<std::array<long long, 3>> ofBorders; // sample, curve, whether it is held
    for (std::size_t b = 0; b < this->Meshes.size(); ++b)
    {
      const BlockMesh& mesh = this->Meshes[b];
      const std::size_t n = mesh.id.size();
      std::vector<std::vector<int>> neighbours(n);
      for (const auto& t : mesh.triangles)
      {
        for (int k = 0; k < 3; ++k)
        {
          neighbours[t[k]].push_back(t[(k + 1) % 3]);
          neighbours[t[k]].push_back(t[(k + 2) % 3]);
        }
      }
      std::map<long long, int> local;
      std::vector<PointState> state(n);
      for (std::size_t p = 0; p < n; ++p)
      {
        local[mesh.id[p]] = static_cast<int>(p);
      }
      for (const auto& line : mesh.lines)
      {
        state[line[0]].isHeld = state[line[1]].isHeld = true;
      }
      std::vector<int> reached(n, -1); // by which curve last
      const int block = this->Blocks.own[b].number;
      for (std::size_t c = 0; c < this->Borders.curves.size(); ++c)
      {
        const BorderCurve& curve = this->Borders.curves[c];
        if (curve.blocks[0] != block && curve.blocks[1] != block)
        {
          continue;
        }
        std::vector<int> ring;
        for (const int s : curve.samples)
        {
          if (const auto found = local.find(s);
              found != local.end() && reached[found->second] != static_cast<int>(c))
          {
            reached[found->second] = static_cast<int>(c);
            ring.push_back(found->second);
          }
        }
        for (int r = 0; r <= this->Rings; ++r)
        {
          std::vector<int> next;
          for (const int p : ring)
          {
            state[p].curve = state[p].curve == -1 ? static_cast<int>(c) : -2;
            state[p].isInside = state[p].isInside || r < this->Rings;
            for (const int q : neighbours[p])
            {
              if (reached[q] != static_cast<int>(c))
              {
                reached[q] = static_cast<int>(c);
                next.push_back(q);
              }
            }
          }
          ring = std::move(next);
        }
      }
      for (std::size_t p = 0; p < n; ++p)
      {
        const long long id = mesh.id[p];
        if (id < static_cast<long long>(this->Borders.samples.size()))
        {
          ofBorders.push_back({ { id, state[p].curve,
            state[p].isHeld || this->Borders.samples[static_cast<std::size_t>(id)].isHeld } });
        }
        else
        {
          this->State[id] = state[p];
        }
      }
    }
    for (const auto& [id, curve, isHeld] : this->Ranks.gatherAll(ofBorders))
    {
      const auto [found, isNew] =
        this->State.try_emplace(id, PointState{ static_cast<int>(curve), true, isHeld != 0 });
      PointState& state = found->second;
      state.curve = isNew || state.curve == curve ? static_cast<int>(curve) : -2;
      state.isHeld = state.isHeld || isHeld != 0;
    }
  }

  /// One color: patch i is optimised by rank patches[i]; patchOf() tells the patch that a point
  /// moves in, or a negative number.
  template <typename PatchOf>
  Status heal(const std::vector<int>& patches, const PatchOf& patchOf)
  {
    // What moves, by block and patch, and the triangles about each point.
    const std::size_t n = this->Meshes.size();
    std::vector<std::map<long long, std::set<int>>> moving(n);
    std::vector<std::vector<std::vector<int>>> about(n);
    std::vector<std::array<long long, 2>> ownRim; // patch, and a point beside one that moves
    for (std::size_t b = 0; b < n; ++b)
    {
      const BlockMesh& mesh = this->Meshes[b];
      about[b].resize(mesh.id.size());
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      {
        for (const int p : mesh.triangles[t])
        {
          about[b][p].push_back(static_cast<int>(t));
        }
      }
      for (std::size_t p = 0; p < mesh.id.size(); ++p)
      {
        const long long patch = patchOf(this->State.at(mesh.id[p]), mesh.id[p]);
        if (!about[b][p].empty() && patch >= 0)
        {
          moving[b][patch].insert(static_cast<int>(p));
        }
      }
      for (const auto& [patch, points] : moving[b])
      {
        std::set<int> rim;
        for (const int p : points)
        {
          for (const int t : about[b][p])
          {
            rim.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
          }
        }
        for (const int p : rim)
        {
          if (points.count(p) == 0)
          {
            ownRim.push_back({ { patch, mesh.id[p] } });
          }
        }
      }
    }
    // All triangles about these points, too, so that no edge comes twice.
    std::multimap<long long, long long> patchOfRim;
    for (const auto& [patch, id] : this->Ranks.gatherAll(ownRim))
    {
      patchOfRim.emplace(id, patch);
    }
    // Some patches at a time, if memory is short: all are made of the mesh as it is, and taken over
    // at the end.
    const long long number = static_cast<long long>(patches.size());
    const long long atATime = this->SavesMemory ? PatchesAtATime * this->Ranks.size() : number;
    Status status = Status::success();
    for (long long first = 0; first < number && status.ok(); first += atATime)
    {
      status = this->healSome(
        patches, first, std::min(number, first + atATime), moving, about, patchOfRim);
    }
    if (!status.ok())
    {
      return status;
    }
    for (std::size_t b = 0; b < this->Meshes.size(); ++b)
    {
      std::vector<HealedPatch>& list = this->Healed[this->Blocks.own[b].number];
      std::sort(list.begin(), list.end(),
        [](const HealedPatch& a, const HealedPatch& c) { return a.patch < c.patch; });
      for (const HealedPatch& healed : list)
      {
        this->take(healed, b);
      }
      list.clear();
    }
    return Status::success();
  }

  /// Those patches from first to before last.
  Status healSome(const std::vector<int>& patches, long long first, long long last,
    std::vector<std::map<long long, std::set<int>>>& moving,
    const std::vector<std::vector<std::vector<int>>>& about,
    const std::multimap<long long, long long>& patchOfRim)
  {
    const auto size = static_cast<std::size_t>(this->Ranks.size());
    const std::size_t n = this->Meshes.size();
    std::vector<Bytes> messages(size);
    for (std::size_t b = 0; b < n; ++b)
    {
      const BlockMesh& mesh = this->Meshes[b];
      std::map<long long, std::set<int>> triangles;
      for (std::size_t p = 0; p < mesh.id.size(); ++p)
      {
        const auto [begin, end] = patchOfRim.equal_range(mesh.id[p]);
        for (auto rim = begin; rim != end && !about[b][p].empty(); ++rim)
        {
          if (rim->second < first || rim->second >= last)
          {
            continue;
          }
          triangles[rim->second].insert(about[b][p].begin(), about[b][p].end());
        }
      }
      for (const auto& [patch, points] : moving[b])
      {
        if (patch < first || patch >= last)
        {
          continue;
        }
        for (const int p : points)
        {
          triangles[patch].insert(about[b][p].begin(), about[b][p].end());
        }
      }
      if (triangles.empty())
      {
        continue;
      }
      const BlockInMemory block(this->Blocks.own[b]);
      const TriangleSurface surface = fromPolyData(block->data);
      for (const auto& [patch, list] : triangles)
      {
        this->makePart(b, *block, surface, moving[b][patch], list)
          .write(patch, messages[patches[static_cast<std::size_t>(patch)]]);
      }
    }
    std::map<long long, std::vector<PatchPart>> parts;
    for (const Bytes& message : this->Ranks.exchange(std::move(messages)))
    {
      for (std::size_t at = 0; at < message.size();)
      {
        long long patch = 0;
        PatchPart part;
        part.read(message, at, patch);
        parts[patch].push_back(std::move(part));
      }
    }
    messages.assign(size, Bytes());
    Status status = Status::success();
    for (auto& [patch, list] : parts)
    {
      std::sort(list.begin(), list.end(),
        [](const PatchPart& a, const PatchPart& b) { return a.block < b.block; });
      HealedPatch healed;
      healed.patch = patch;
      status = guarded([&, &list = list] { return optimizePatch(list, this->Options, healed); });
      if (!status.ok())
      {
        break;
      }
      std::set<int> to;
      for (const PatchPart& part : list)
      {
        to.insert(part.block);
      }
      for (const int block : to)
      {
        healed.write(block, messages[this->Blocks.rankOf(block, this->Ranks.size())]);
      }
      list.clear();
    }
    if (Status all = this->Ranks.agree(status); !all.ok())
    {
      return all;
    }
    for (const Bytes& message : this->Ranks.exchange(std::move(messages)))
    {
      for (std::size_t at = 0; at < message.size();)
      {
        long long block = 0;
        HealedPatch healed;
        healed.read(message, at, block);
        this->Healed[static_cast<int>(block)].push_back(std::move(healed));
      }
    }
    return Status::success();
  }

  /// What a block has of a patch: triangles about points that move and their neighbours, and the
  /// surface there.
  PatchPart makePart(std::size_t b, const SurfaceBlock& block, const TriangleSurface& surface,
    const std::set<int>& moving, const std::set<int>& triangles) const
  {
    const BlockMesh& mesh = this->Meshes[b];
    const BlockOutline& outline = this->Outlines[b];
    PatchPart part;
    part.block = block.number;
    std::map<int, int> newId;
    double length = 0;
    for (const int t : triangles)
    {
      std::array<int, 3> corners;
      for (int k = 0; k < 3; ++k)
      {
        const int p = mesh.triangles[t][k];
        const auto [found, isNew] = newId.try_emplace(p, static_cast<int>(part.id.size()));
        if (isNew)
        {
          part.id.push_back(mesh.id[p]);
          part.position.push_back(mesh.position[p]);
          const PointState& state = this->State.at(mesh.id[p]);
          part.isMovable.push_back(moving.count(p) > 0 ? 1 : 0);
          part.movesLater.push_back(
            state.curve == -2 && state.isInside && !state.isHeld && moving.count(p) == 0 ? 1 : 0);
        }
        corners[k] = found->second;
        length += (mesh.position[p] - mesh.position[mesh.triangles[t][(k + 1) % 3]]).norm();
      }
      part.triangles.push_back(corners);
    }
    length /= 3. * static_cast<double>(triangles.size());
    for (const auto& line : mesh.lines)
    {
      const auto from = newId.find(line[0]);
      const auto to = newId.find(line[1]);
      if (from != newId.end() && to != newId.end())
      {
        part.lines.push_back({ { from->second, to->second } });
      }
    }
    PointGrid grid(SurfaceReach * length);
    for (const Vec3& x : part.position)
    {
      grid.add(x);
    }
    std::map<int, int> surfaceId;
    for (int f = 0; f < block.numberOfOwn; ++f)
    {
      const Triangle& t = surface.triangles[f];
      const Vec3& x = surface.points[t[0]];
      const Vec3& y = surface.points[t[1]];
      const Vec3& z = surface.points[t[2]];
      if (!grid.touches(x.cwiseMin(y).cwiseMin(z), x.cwiseMax(y).cwiseMax(z)))
      {
        continue;
      }
      std::array<int, 3> corners;
      for (int k = 0; k < 3; ++k)
      {
        const auto [found, isNew] =
          surfaceId.try_emplace(t[k], static_cast<int>(part.surfaceId.size()));
        if (isNew)
        {
          part.surfaceId.push_back(block.pointId[t[k]]);
          part.surfacePosition.push_back(surface.points[t[k]]);
          part.density.push_back(outline.density.empty() ? 1. : outline.density[t[k]]);
        }
        corners[k] = found->second;
      }
      part.surfaceTriangles.push_back(corners);
      part.source.push_back({ { block.number, f } });
    }
    for (const auto& crease : outline.creases)
    {
      const auto from = surfaceId.find(crease[0]);
      const auto to = surfaceId.find(crease[1]);
      if (from != surfaceId.end() && to != surfaceId.end())
      {
        part.creases.push_back({ { from->second, to->second } });
      }
    }
    return part;
  }

  /// Puts a patch in place of a block's triangles that it was made of.
  void take(const HealedPatch& healed, std::size_t b)
  {
    BlockMesh& mesh = this->Meshes[b];
    const int block = this->Blocks.own[b].number;
    std::map<long long, int> local;
    for (std::size_t p = 0; p < mesh.id.size(); ++p)
    {
      local[mesh.id[p]] = static_cast<int>(p);
    }
    std::unordered_set<long long> moved;
    for (std::size_t i = 0; i < healed.id.size(); ++i)
    {
      const auto known = static_cast<int>(mesh.id.size());
      const auto [found, isNew] = local.try_emplace(healed.id[i], known);
      if (isNew)
      {
        mesh.id.push_back(healed.id[i]);
        mesh.position.emplace_back();
        mesh.place.emplace_back();
        mesh.data.push_back(-1);
        const bool movesLater = healed.movesLater[i] != 0;
        this->State.try_emplace(
          healed.id[i], PointState{ movesLater ? -2 : -1, movesLater, !movesLater });
      }
      if (isNew || healed.isMovable[i] != 0)
      {
        mesh.position[found->second] = healed.position[i];
        mesh.place[found->second] = healed.place[i];
        mesh.data[found->second] = -1;
      }
      if (healed.isMovable[i] != 0)
      {
        moved.insert(healed.id[i]);
      }
    }
    std::vector<std::array<int, 3>> triangles;
    std::vector<BlockPlace> places;
    std::vector<int> data;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      const auto& t = mesh.triangles[i];
      if (moved.count(mesh.id[t[0]]) + moved.count(mesh.id[t[1]]) + moved.count(mesh.id[t[2]]) == 0)
      {
        triangles.push_back(t);
        places.push_back(mesh.trianglePlace[i]);
        data.push_back(mesh.triangleData[i]);
      }
    }
    for (std::size_t i = 0; i < healed.triangles.size(); ++i)
    {
      if (healed.trianglePlace[i].block == block)
      {
        const auto& t = healed.triangles[i];
        triangles.push_back(
          { { local.at(healed.id[t[0]]), local.at(healed.id[t[1]]), local.at(healed.id[t[2]]) } });
        places.push_back(healed.trianglePlace[i]);
        data.push_back(-1);
      }
    }
    mesh.triangles = std::move(triangles);
    mesh.trianglePlace = std::move(places);
    mesh.triangleData = std::move(data);
  }

  const SurfaceBlocks& Blocks;
  const std::vector<BlockOutline>& Outlines;
  const BlockBorders& Borders;
  const OptimizerOptions& Options;
  int Rings;
  const RankMessages& Ranks;
  std::vector<BlockMesh>& Meshes;
  bool SavesMemory;
  std::map<long long, PointState> State;          // by id
  std::map<int, std::vector<HealedPatch>> Healed; // by block
};
}

Status healBorders(const SurfaceBlocks& blocks, const std::vector<BlockOutline>& outlines,
  const BlockBorders& borders, const OptimizerOptions& options, int rings,
  const RankMessages& ranks, std::vector<BlockMesh>& meshes)
{
  return Healing(blocks, outlines, borders, options, rings, ranks, meshes).run();
}
}
