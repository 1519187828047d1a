// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GreedyMerge.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace stipple
{
GreedyMerge::GreedyMerge(ChartRegions& regions)
  : Regions(regions)
{
  for (int r = 0; r < regions.size(); ++r)
  {
    this->Serial.push_back(r);
    this->Place.push_back(r);
    this->Area.push_back(regions.area(r));
  }
  for (int r = 0; r < regions.size(); ++r)
  {
    this->addPairs(r, true);
  }
}

Status GreedyMerge::run(int fewest, const Allowed& allowed, const Merged& merged,
  const Foreseen& foreseen, const Progress& progress)
{
  // A pair is asked for once, and new ones come only with a region less.
  std::size_t asked = 0;
  while (this->Regions.size() > fewest && !this->Pairs.empty())
  {
    const double done = static_cast<double>(asked++);
    if (!report(progress, done / (done + static_cast<double>(this->Pairs.size()))))
    {
      return Status::aborted();
    }
    if (foreseen && this->isLeft(this->Pairs.top()))
    {
      foreseen(this->nextPairs());
    }
    const Pair pair = this->Pairs.top();
    this->Pairs.pop();
    const int a = std::min(this->Place[pair.first], this->Place[pair.second]);
    const int b = std::max(this->Place[pair.first], this->Place[pair.second]);
    const std::optional<SeamArc> seam = this->isLeft(pair) ? allowed(a, b) : std::nullopt;
    if (!seam)
    {
      continue;
    }
    this->Place[pair.first] = -1;
    this->Place[pair.second] = -1;
    this->Regions.merge(a, b, *seam);
    const int last = this->Regions.size();
    this->Area[a] += this->Area[b];
    this->Area[b] = this->Area[last];
    this->Area.pop_back();
    this->Serial[b] = this->Serial[last];
    this->Serial.pop_back();
    if (b != last)
    {
      this->Place[this->Serial[b]] = b;
    }
    this->Serial[a] = static_cast<int>(this->Place.size());
    this->Place.push_back(a);
    this->addPairs(a, false);
    if (merged)
    {
      merged(a, b);
    }
  }
  return Status::success();
}

std::vector<std::pair<int, int>> GreedyMerge::nextPairs()
{
  const auto most = static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  std::vector<std::pair<int, int>> result;
  std::vector<Pair> taken;
  while (result.size() < most && !this->Pairs.empty())
  {
    taken.push_back(this->Pairs.top());
    this->Pairs.pop();
    if (this->isLeft(taken.back()))
    {
      result.push_back(
        std::minmax(this->Place[taken.back().first], this->Place[taken.back().second]));
    }
  }
  for (const Pair& pair : taken)
  {
    this->Pairs.push(pair);
  }
  return result;
}

void GreedyMerge::addPairs(int r, bool laterOnly)
{
  for (int q : this->Regions.neighbours(r))
  {
    if (q > r || !laterOnly)
    {
      this->Pairs.push({ this->Area[r] + this->Area[q], this->Serial[r], this->Serial[q] });
    }
  }
}
}
