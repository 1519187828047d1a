// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Regions that become fewer, pair by pair.
#ifndef stipple_GreedyMerge_h
#define stipple_GreedyMerge_h

#include "ChartRegions.h"

#include <functional>
#include <optional>
#include <queue>
#include <tuple>

namespace stipple
{
/// Merges neighbours, the pair of least area first, down to a number of regions or as far as
/// allowed.
class STIPPLEFILTERSATLAS_EXPORT GreedyMerge
{
public:
  /// Asked once for every pair for the seam to close, if any; and told after a merger, when the
  /// last region has taken b's number.
  using Allowed = std::function<std::optional<SeamArc>(int a, int b)>;
  using Merged = std::function<void(int a, int b)>;
  /// Told before a pair is asked for, with those that are next in the queue: they are likely to be
  /// asked for soon.
  using Foreseen = std::function<void(const std::vector<std::pair<int, int>>& pairs)>;

  /// The regions are borrowed.
  explicit GreedyMerge(ChartRegions& regions);

  /// Ends after no more than a question for every pair of neighbours, and some for each merger:
  /// those of the merged region. merged and foreseen may be empty.
  Status run(int fewest, const Allowed& allowed, const Merged& merged, const Foreseen& foreseen,
    const Progress& progress);

private:
  /// Two regions by serial number, which a merged region gets anew.
  struct Pair
  {
    double area;
    int first;
    int second;
    bool operator<(const Pair& o) const // the least area on top of the queue
    {
      return std::tie(this->area, this->first, this->second) > std::tie(o.area, o.first, o.second);
    }
  };

  bool isLeft(const Pair& pair) const
  {
    return this->Place[pair.first] >= 0 && this->Place[pair.second] >= 0;
  }

  /// As many as there are threads, and no more than the queue has.
  std::vector<std::pair<int, int>> nextPairs();
  void addPairs(int r, bool laterOnly);

  ChartRegions& Regions;
  std::vector<int> Serial; // by region
  std::vector<int> Place;  // the region by serial number, -1 if merged
  std::vector<double> Area;
  std::priority_queue<Pair> Pairs;
};
}

#endif
