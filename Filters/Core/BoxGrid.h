// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of all sizes that overlap, while they move.
#ifndef stipple_BoxGrid_h
#define stipple_BoxGrid_h

#include "CompressedRows.h"
#include "StippleFiltersCoreModule.h"
#include "TriangleIntersections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace stipple
{
/// Hashed grids of cells, one for every level of sizes a factor of 16 apart: a box is in all the
/// cells of its level that it touches, which are few, and what is near a box is looked for in the
/// cells of every level that it touches, or among all boxes of a level where those are fewer.
class STIPPLEFILTERSCORE_EXPORT BoxGrid
{
public:
  /// Boxes that are smaller than `leastSize` have cells as if they were so large: where nothing
  /// smaller is looked for, there is no need to look into more cells than that.
  explicit BoxGrid(std::vector<Box> boxes = {}, double leastSize = 0);

  int size() const { return static_cast<int>(this->Boxes.size()); }
  const Box& box(int i) const { return this->Boxes[static_cast<std::size_t>(i)]; }
  /// The mean of the boxes' longest sides, as they were at first, or of leastSize where that is
  /// more; 1 if they are points.
  double meanSize() const { return this->MeanSize; }

  void move(int i, const Box& box);
  /// Adds one, whose number is the least that none has.
  void add(const Box& box);

  /// Calls visit(i) once for every box that overlaps another one, in no order.
  template <typename Visit>
  void forEachNear(const Box& box, const Visit& visit)
  {
    this->fill();
    for (int level = 0; level < NumberOfLevels; ++level)
    {
      this->forEachNearOf(level, box, visit);
    }
  }
  /// Whether there is one.
  bool hasNear(const Box& box)
  {
    this->fill();
    bool found = false;
    for (int level = 0; level < NumberOfLevels && !found; ++level)
    {
      found = this->anyNearOf(level, box, [](int) { return true; });
    }
    return found;
  }

  /// The pairs that overlap and that `isWanted(i, j)`, which is asked once for each, from several
  /// threads; in an order of their own, the same for any number of threads.
  template <typename IsWanted>
  std::vector<std::array<int, 2>> pairs(const IsWanted& isWanted)
  {
    Pairs all;
    bool isOneLevel = true;
    for (int l = 0; l < NumberOfLevels; ++l)
    {
      const std::size_t n = this->Levels[l].boxes.size();
      isOneLevel = isOneLevel && (n == 0 || n == this->Boxes.size());
      this->addPairsOf(l, isWanted, all);
    }
    if (!isOneLevel)
    {
      this->addPairsAcross(isWanted, all);
    }
    return all;
  }

private:
  static constexpr int NumberOfLevels = 15; ///< sizes 2^-31 to 2^29 of the mean, about
  static constexpr std::size_t Chunk = 256; ///< boxes, or buckets

  /// A box in one of the cells that it touches.
  struct Entry
  {
    int box;
    int next; ///< in the same bucket, or -1
    std::uint64_t cell;
  };
  struct Level
  {
    double cellSize = 1;
    std::vector<int> boxes; ///< in no order
    std::vector<Entry> entries;
    std::vector<int> buckets; ///< first entry, or -1; as many as a power of two
  };
  using Index = std::array<std::int64_t, 3>;

  struct InCell
  {
    std::uint64_t cell;
    int box;
  };
  using Pairs = std::vector<std::array<int, 2>>;

  static void forEachChunk(std::size_t n, const std::function<void(std::size_t)>& visit);
  double sizeOf(const Box& box) const
  {
    return std::max(this->LeastSize, (box.high - box.low).maxCoeff());
  }
  int levelOf(const Box& box) const;
  void enter(int i);
  void leave(int i);
  /// The boxes of a level in their cells, by bucket.
  CompressedRows<InCell, std::size_t> sorted(int l);
  void fill();
  void insert(int i);
  void remove(int i);

  static Index indexOf(const Level& level, const Vec3& p)
  {
    const auto index = [&](double x) {
      return static_cast<std::int64_t>(std::floor(x / level.cellSize));
    };
    return { { index(p.x()), index(p.y()), index(p.z()) } };
  }
  /// Cells 2^21 apart share a number; a comparison of boxes tells what is in them apart.
  static std::uint64_t numberOf(const Index& index)
  {
    constexpr std::uint64_t Mask = (1U << 21) - 1;
    return (static_cast<std::uint64_t>(index[0]) & Mask) |
      (static_cast<std::uint64_t>(index[1]) & Mask) << 21 |
      (static_cast<std::uint64_t>(index[2]) & Mask) << 42;
  }
  /// Whether test(cell, bucket) is true for a cell that a box touches.
  template <typename Test>
  static bool anyCell(const Level& level, const Box& box, const Test& test)
  {
    const Index low = indexOf(level, box.low);
    const Index high = indexOf(level, box.high);
    for (std::int64_t i = low[0]; i <= high[0]; ++i)
    {
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
      {
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
        {
          // Teschner et al., Optimized Spatial Hashing (2003).
          const std::uint64_t hash = (static_cast<std::uint64_t>(i) * 73856093) ^
            (static_cast<std::uint64_t>(j) * 19349663) ^ (static_cast<std::uint64_t>(k) * 83492791);
          if (test(numberOf({ { i, j, k } }),
                static_cast<std::size_t>(hash & (level.buckets.size() - 1))))
          {
            return true;
          }
        }
      }
    }
    return false;
  }
  /// Calls visit(cell, bucket) for every cell that a box touches.
  template <typename Visit>
  static void forEachCell(const Level& level, const Box& box, const Visit& visit)
  {
    anyCell(level, box, [&](std::uint64_t cell, std::size_t bucket) {
      visit(cell, bucket);
      return false;
    });
  }
  /// Whether a box touches more cells than there are boxes.
  static bool isWide(const Level& level, const Box& box)
  {
    const Vec3 cells = (box.high - box.low) / level.cellSize + Vec3::Ones();
    return cells.prod() > static_cast<double>(level.boxes.size());
  }
  /// Whether boxes overlap and do so from this cell on: of all cells that both touch, one.
  static bool countsIn(const Level& level, std::uint64_t cell, const Box& box, const Box& other)
  {
    return box.overlaps(other) && numberOf(indexOf(level, box.low.cwiseMax(other.low))) == cell;
  }
  /// Whether test(i) is true for a box of a level that overlaps another one.
  template <typename Test>
  bool anyNearOf(int l, const Box& box, const Test& test) const
  {
    const Level& level = this->Levels[l];
    if (level.boxes.empty())
    {
      return false;
    }
    if (isWide(level, box))
    {
      return std::any_of(level.boxes.begin(), level.boxes.end(),
        [&](int i) { return box.overlaps(this->Boxes[i]) && test(i); });
    }
    return anyCell(level, box, [&](std::uint64_t cell, std::size_t bucket) {
      for (int e = level.buckets[bucket]; e >= 0; e = level.entries[e].next)
      {
        const Entry& entry = level.entries[e];
        const Box& other = this->Boxes[entry.box];
        if (entry.cell == cell && countsIn(level, cell, box, other) && test(entry.box))
        {
          return true;
        }
      }
      return false;
    });
  }
  template <typename Visit>
  void forEachNearOf(int l, const Box& box, const Visit& visit) const
  {
    this->anyNearOf(l, box, [&](int i) {
      visit(i);
      return false;
    });
  }

  /// Of one level: each with each in its cell.
  template <typename IsWanted>
  void addPairsOf(int l, const IsWanted& isWanted, Pairs& all)
  {
    const CompressedRows<InCell, std::size_t> buckets = this->sorted(l);
    const Level& level = this->Levels[l];
    std::vector<Pairs> found(buckets.numberOfRows() / Chunk);
    forEachChunk(found.size(), [&](std::size_t chunk) {
      for (std::size_t b = chunk * Chunk; b < (chunk + 1) * Chunk; ++b)
      {
        const auto bucket = buckets[b];
        for (const InCell* f = bucket.begin(); f != bucket.end(); ++f)
        {
          for (const InCell* g = f + 1; g != bucket.end(); ++g)
          {
            const auto [cell, i] = *f;
            const int j = g->box;
            if (g->cell == cell && countsIn(level, cell, this->Boxes[i], this->Boxes[j]) &&
              isWanted(i, j))
            {
              found[chunk].push_back({ { i, j } });
            }
          }
        }
      }
    });
    append(found, all);
  }

  /// Of boxes of two levels: that of the lower one looks for the other.
  template <typename IsWanted>
  void addPairsAcross(const IsWanted& isWanted, Pairs& all)
  {
    this->fill();
    std::vector<Pairs> found((this->Boxes.size() + Chunk - 1) / Chunk);
    forEachChunk(found.size(), [&](std::size_t chunk) {
      const auto end = static_cast<int>(std::min(this->Boxes.size(), (chunk + 1) * Chunk));
      for (auto i = static_cast<int>(chunk * Chunk); i < end; ++i)
      {
        for (int l = this->LevelOf[i] + 1; l < NumberOfLevels; ++l)
        {
          this->forEachNearOf(l, this->Boxes[i], [&](int j) {
            if (isWanted(i, j))
            {
              found[chunk].push_back({ { i, j } });
            }
          });
        }
      }
    });
    append(found, all);
  }

  static void append(const std::vector<Pairs>& found, Pairs& all)
  {
    for (const Pairs& some : found)
    {
      all.insert(all.end(), some.begin(), some.end());
    }
  }

  std::vector<Box> Boxes;
  std::vector<signed char> LevelOf; ///< by box
  std::vector<int> PlaceOf;         ///< by box, among those of its level
  std::array<Level, NumberOfLevels> Levels;
  double LeastSize;
  double MeanSize = 1;
  bool IsFilled = false;
};
}

#endif
