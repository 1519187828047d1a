// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinedCreases.h"

#include <algorithm>
#include <utility>

namespace stipple
{
namespace
{
bool mayJoin(const Backbone& a, const Backbone& b)
{
  return a.type != BackboneType::Seam && a.type == b.type && a.keep != Keep::Edges &&
    a.keep == b.keep && a.width == b.width && a.pitch == b.pitch;
}
}

JoinedCreases::JoinedCreases(const Atlas& source)
  : Source(source)
{
  const FeatureGraph& before = source.graph();
  // Ends of creases and boundaries, by node.
  std::vector<std::vector<int>> at(source.surface().points.size());
  for (std::size_t b = 0; b < before.backbones.size(); ++b)
  {
    const Backbone& backbone = before.backbones[b];
    if (!backbone.closed && backbone.type != BackboneType::Seam)
    {
      at[backbone.points.front()].push_back(static_cast<int>(b));
      at[backbone.points.back()].push_back(static_cast<int>(b));
    }
  }
  FeatureGraph graph;
  graph.constraints = before.constraints;
  graph.isCorner = before.isCorner;
  graph.regionArray = before.regionArray;
  this->PartOf.assign(before.backbones.size(), { -1, -1 });
  for (std::size_t b = 0; b < before.backbones.size(); ++b)
  {
    if (this->PartOf[b].first < 0)
    {
      this->follow(static_cast<int>(b), at, graph);
    }
  }
  this->Joined = source.withGraph(std::move(graph));
  this->locate();
}

/// Makes the backbone that one is the first part of.
void JoinedCreases::follow(int first, const std::vector<std::vector<int>>& at, FeatureGraph& graph)
{
  const std::vector<Backbone>& backbones = this->Source.graph().backbones;
  // The backbone that goes on beyond a node, or -1.
  const auto next = [&](int b, int node) {
    const std::vector<int>& both = at[node];
    if (this->Source.graph().isCorner[node] != 0 || both.size() != 2)
    {
      return -1;
    }
    const int other = both[0] == b ? both[1] : both[0];
    return mayJoin(backbones[b], backbones[other]) ? other : -1;
  };
  const auto startOf = [&](int b, bool isReversed) {
    return isReversed ? backbones[b].points.back() : backbones[b].points.front();
  };
  using Step = std::pair<int, bool>; // and whether it is walked against its direction
  // From one on, in a direction; its own direction first.
  const auto walk = [&](bool isReversed, bool& isClosed) {
    std::vector<Step> steps = { { first, isReversed } };
    isClosed = backbones[first].closed;
    while (!isClosed && backbones[first].type != BackboneType::Seam)
    {
      const auto [b, against] = steps.back();
      const int node = startOf(b, !against);
      const int other = next(b, node);
      if (other < 0)
      {
        break;
      }
      isClosed = other == first;
      if (!isClosed)
      {
        steps.emplace_back(other, backbones[other].points.front() != node);
      }
    }
    return steps;
  };
  bool isClosed = false;
  std::vector<Step> steps = walk(false, isClosed);
  if (!isClosed)
  {
    std::vector<Step> before = walk(true, isClosed);
    std::reverse(before.begin(), before.end());
    before.pop_back(); // the first itself
    for (Step& step : before)
    {
      step.second = !step.second;
    }
    steps.insert(steps.begin(), before.begin(), before.end());
  }
  Backbone joined = backbones[first];
  joined.closed = isClosed;
  joined.points.clear();
  this->Parts.emplace_back();
  for (const auto& [b, isReversed] : steps)
  {
    std::vector<int> points = backbones[b].points;
    if (isReversed)
    {
      std::reverse(points.begin(), points.end());
    }
    const bool isAlone = steps.size() == 1 && backbones[b].closed;
    joined.points.insert(joined.points.end(), points.begin(), points.end() - (isAlone ? 0 : 1));
    this->PartOf[b] = { static_cast<int>(graph.backbones.size()),
      static_cast<int>(this->Parts.back().size()) };
    this->Parts.back().push_back({ b, isReversed, 0. }); // where it begins the trace will say
  }
  if (!isClosed)
  {
    const auto [b, isReversed] = steps.back();
    joined.points.push_back(startOf(b, !isReversed));
  }
  graph.backbones.push_back(std::move(joined));
}

/// Finds where parts begin, and the nodes inside joined backbones.
void JoinedCreases::locate()
{
  this->NodeAt.assign(this->Source.surface().points.size(), { -1, 0. });
  for (std::size_t j = 0; j < this->Parts.size(); ++j)
  {
    const Backbone& backbone = this->Joined->graph().backbones[j];
    std::size_t point = 0;
    for (std::size_t i = 0; i < this->Parts[j].size(); ++i)
    {
      Part& part = this->Parts[j][i];
      part.begin = this->Joined->traces()[j].arcLength[point];
      const Backbone& of = this->Source.graph().backbones[part.backbone];
      if (i > 0 || (backbone.closed && !of.closed))
      {
        this->NodeAt[backbone.points[point]] = { static_cast<int>(j), part.begin };
      }
      point += of.points.size() - 1;
    }
  }
}

Sample JoinedCreases::joined(const Sample& sample) const
{
  Sample result = sample;
  if (sample.kind == SampleKind::Corner && sample.surfacePoint >= 0 &&
    this->NodeAt[sample.surfacePoint].backbone >= 0)
  {
    const Place& node = this->NodeAt[sample.surfacePoint];
    const SurfacePlace place = this->Joined->placeOfBackbone(node.backbone, node.arcLength);
    result = { SampleKind::Backbone, place.face, place.bary, node.backbone, node.arcLength, -1 };
  }
  else if (sample.kind == SampleKind::Backbone)
  {
    const auto [j, i] = this->PartOf[sample.backbone];
    const Part& part = this->Parts[j][i];
    const double length = this->Source.traces()[sample.backbone].length();
    result.backbone = j;
    result.arcLength =
      part.begin + (part.isReversed ? length - sample.arcLength : sample.arcLength);
  }
  return result;
}

Sample JoinedCreases::original(const Sample& sample) const
{
  Sample result = sample;
  if (sample.kind == SampleKind::Backbone)
  {
    const std::vector<Part>& parts = this->Parts[sample.backbone];
    const auto after = std::upper_bound(parts.begin() + 1, parts.end(), sample.arcLength,
      [](double s, const Part& part) { return s < part.begin; });
    const Part& part = *(after - 1);
    const double length = this->Source.traces()[part.backbone].length();
    const double along = std::clamp(sample.arcLength - part.begin, 0., length);
    result.backbone = part.backbone;
    result.arcLength = part.isReversed ? length - along : along;
  }
  return result;
}

std::vector<Sample> JoinedCreases::joined(std::vector<Sample> samples) const
{
  for (Sample& sample : samples)
  {
    sample = this->joined(sample);
  }
  return samples;
}

std::vector<Sample> JoinedCreases::original(std::vector<Sample> samples) const
{
  for (Sample& sample : samples)
  {
    sample = this->original(sample);
  }
  return samples;
}

std::vector<std::vector<int>> JoinedCreases::joined(
  const std::vector<std::vector<int>>& chains) const
{
  std::vector<std::vector<int>> result;
  for (const std::vector<Part>& parts : this->Parts)
  {
    std::vector<int>& joined = result.emplace_back();
    for (const Part& part : parts)
    {
      std::vector<int> chain = chains[part.backbone];
      if (part.isReversed)
      {
        std::reverse(chain.begin(), chain.end());
      }
      const bool goesOn = !joined.empty() && !chain.empty() && joined.back() == chain.front();
      joined.insert(joined.end(), chain.begin() + (goesOn ? 1 : 0), chain.end());
    }
  }
  return result;
}

std::vector<std::vector<int>> JoinedCreases::original(
  const std::vector<std::vector<int>>& chains) const
{
  std::vector<std::vector<int>> result(this->PartOf.size());
  for (std::size_t j = 0; j < chains.size(); ++j)
  {
    const auto first = std::min_element(this->Parts[j].begin(), this->Parts[j].end(),
      [](const Part& a, const Part& b) { return a.backbone < b.backbone; });
    result[first->backbone] = chains[j];
  }
  return result;
}
}
