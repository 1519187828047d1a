// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinedCreases.h"

#include <algorithm>
#include <optional>
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
  EndsAt at; // of creases and boundaries
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
void JoinedCreases::follow(int first, const EndsAt& at, FeatureGraph& graph)
{
  const std::vector<Backbone>& backbones = this->Source.graph().backbones;
  struct Step
  {
    int backbone;
    bool isReversed; ///< walked against its direction

    Step turned() const { return { this->backbone, !this->isReversed }; }
  };
  const auto endOf = [&](const Step& step) {
    const std::vector<int>& points = backbones[step.backbone].points;
    return step.isReversed ? points.front() : points.back();
  };
  // What goes on beyond the end of a step.
  const auto next = [&](const Step& step) -> std::optional<Step> {
    const Backbone& backbone = backbones[step.backbone];
    const int node = endOf(step);
    if (backbone.closed || backbone.type == BackboneType::Seam ||
      this->Source.graph().isCorner[node] != 0 || at.at(node).size() != 2)
    {
      return {};
    }
    const std::vector<int>& both = at.at(node);
    const int other = both[0] == step.backbone ? both[1] : both[0];
    return mayJoin(backbone, backbones[other])
      ? std::optional(Step{ other, backbones[other].points.front() != node })
      : std::nullopt;
  };
  // Back to where it begins, or around to itself.
  Step start = { first, false };
  bool isClosed = backbones[first].closed;
  for (std::optional<Step> step = next(start.turned()); step && !isClosed;
       step = next(start.turned()))
  {
    isClosed = step->backbone == first;
    start = isClosed ? Step{ first, false } : step->turned();
  }
  std::vector<Step> steps = { start };
  for (std::optional<Step> step = next(start); step && step->backbone != start.backbone;
       step = next(*step))
  {
    steps.push_back(*step);
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
    joined.points.push_back(endOf(steps.back()));
  }
  graph.backbones.push_back(std::move(joined));
}

/// Finds where parts begin, and the nodes inside joined backbones.
void JoinedCreases::locate()
{
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
  const auto node = this->NodeAt.find(sample.surfacePoint);
  if (sample.kind == SampleKind::Corner && node != this->NodeAt.end())
  {
    const auto [backbone, arcLength] = node->second;
    const SurfacePlace place = this->Joined->placeOfBackbone(backbone, arcLength);
    result = { SampleKind::Backbone, place.face, place.bary, backbone, arcLength, -1 };
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
