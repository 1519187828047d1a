// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSizes.h"

#include "JoinedCreases.h"
#include "SamplingConstants.h"
#include "StraightWalk.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <unordered_map>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

/// A place along a backbone.
struct BackbonePlace
{
  int backbone = -1;
  double arcLength = 0;
};

/// Creases and boundaries as a graph of lengths.
class FeatureLines
{
public:
  FeatureLines(const Atlas& atlas, const std::vector<char>& isCrease)
    : Source(atlas)
    , At(3 * static_cast<std::size_t>(atlas.surface().numberOfFaces()), -1)
    , Segment(this->At.size(), 0)
  {
    const std::vector<BackboneTrace>& traces = atlas.traces();
    for (std::size_t b = 0; b < traces.size(); ++b)
    {
      const Backbone& backbone = atlas.graph().backbones[b];
      if (isCrease[b] == 0)
      {
        continue;
      }
      this->Lines.push_back(static_cast<int>(b));
      for (const std::vector<int>& side : traces[b].halfedge)
      {
        for (std::size_t i = 0; i < side.size(); ++i)
        {
          if (side[i] >= 0)
          {
            this->At[side[i]] = static_cast<int>(b);
            this->Segment[side[i]] = static_cast<int>(i);
          }
        }
      }
      if (!backbone.closed)
      {
        this->Incident[backbone.points.front()].push_back(static_cast<int>(b));
        this->Incident[backbone.points.back()].push_back(static_cast<int>(b));
      }
    }
    this->Ends.resize(traces.size(), { { -1, -1 } });
    for (const int b : this->Lines)
    {
      if (!this->isClosed(b))
      {
        this->Ends[b] = { { this->backbone(b).points.front(), this->backbone(b).points.back() } };
      }
    }
  }

  const std::vector<int>& lines() const { return this->Lines; }
  bool isLine(int halfedge) const { return this->At[halfedge] >= 0; }

  /// The place of the walk, which is at this halfedge.
  BackbonePlace placeOf(int halfedge, const Vec3& bary) const
  {
    const BackboneTrace& trace = this->Source.traces()[this->At[halfedge]];
    const int i = this->Segment[halfedge];
    const double atHead = 1. - bary[halfedge % 3];
    const bool along = trace.halfedge[0][i] == halfedge;
    const double t = along ? atHead : 1. - atHead;
    return { this->At[halfedge],
      trace.arcLength[i] + t * (trace.arcLength[i + 1] - trace.arcLength[i]) };
  }

  /// Whether two backbones end at the same corner.
  bool meet(int a, int b) const
  {
    const auto has = [&](int corner) {
      return corner >= 0 && (corner == this->Ends[b][0] || corner == this->Ends[b][1]);
    };
    return a != b && this->Ends[a] != this->Ends[b] &&
      (has(this->Ends[a][0]) || has(this->Ends[a][1]));
  }

  /// Whether it is no farther from one place to the other along features than this.
  bool areConnected(const BackbonePlace& from, const BackbonePlace& to, double farthest) const
  {
    const double direct = std::abs(from.arcLength - to.arcLength);
    if (from.backbone == to.backbone &&
      (direct <= farthest ||
        (this->isClosed(from.backbone) && this->length(from.backbone) - direct <= farthest)))
    {
      return true;
    }
    if (this->isClosed(from.backbone) || this->isClosed(to.backbone))
    {
      return false;
    }
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::unordered_map<int, double> known;
    const auto reach = [&](int node, double d) {
      if (d <= farthest && (known.count(node) == 0 || d < known[node]))
      {
        known[node] = d;
        open.push({ d, node });
      }
    };
    const Backbone& first = this->backbone(from.backbone);
    reach(first.points.front(), from.arcLength);
    reach(first.points.back(), this->length(from.backbone) - from.arcLength);
    const Backbone& last = this->backbone(to.backbone);
    while (!open.empty())
    {
      const auto [d, node] = open.top();
      open.pop();
      if (d > known[node])
      {
        continue;
      }
      if ((node == last.points.front() && d + to.arcLength <= farthest) ||
        (node == last.points.back() && d + this->length(to.backbone) - to.arcLength <= farthest))
      {
        return true;
      }
      for (int b : this->Incident.at(node))
      {
        reach(this->otherEnd(b, node), d + this->length(b));
      }
    }
    return false;
  }

  double length(int b) const { return this->Source.traces()[b].length(); }
  bool isClosed(int b) const { return this->backbone(b).closed; }
  const Backbone& backbone(int b) const { return this->Source.graph().backbones[b]; }
  int otherEnd(int line, int node) const
  {
    const std::vector<int>& points = this->backbone(line).points;
    return points.front() == node ? points.back() : points.front();
  }

private:
  const Atlas& Source;
  std::vector<int> Lines;
  std::vector<std::array<int, 2>> Ends;               ///< by backbone, its corners
  std::vector<int> At;                                ///< by halfedge, the backbone along it
  std::vector<int> Segment;                           ///< and which of its segments it is
  std::unordered_map<int, std::vector<int>> Incident; ///< by node
};

/// Finds the sizes along one feature after the other.
class SizeSearch
{
public:
  SizeSearch(const Atlas& atlas, const FeatureLines& lines,
    const std::function<double(const SurfacePlace&)>& spacing)
    : Source(atlas)
    , Lines(lines)
    , Spacing(spacing)
  {
  }

  std::vector<FeatureSize> of(int line) const
  {
    std::vector<FeatureSize> sources;
    this->addGaps(line, sources);
    if (this->Lines.isClosed(line))
    {
      this->addLoop(line, sources);
    }
    else
    {
      const std::vector<int>& points = this->Lines.backbone(line).points;
      this->addShortLine(line, points.front(), sources);
      this->addShortLine(line, points.back(), sources);
    }
    return sources;
  }

private:
  SurfacePlace placeAt(const BackbonePlace& place) const
  {
    return this->Source.placeOfBackbone(place.backbone, place.arcLength);
  }
  /// Unless it is too large to matter.
  void add(
    const SurfacePlace& place, double spacing, double size, std::vector<FeatureSize>& to) const
  {
    if (size < Constants::LargestSize * spacing)
    {
      to.push_back({ this->Source.surface().position(place.face, place.bary), size, spacing });
    }
  }

  /// Across one side, to the next feature that is not as near along features; at most `reach`.
  double gapBeside(const BackbonePlace& from, int side, double reach) const
  {
    const BackboneTrace& trace = this->Source.traces()[from.backbone];
    if (trace.chart[side] < 0)
    {
      return reach;
    }
    const BackboneTrace::Place place = trace.locate(from.arcLength);
    StraightWalk walk(this->Source.surface(), trace.halfedge[side][place.segment],
      trace.bary(place, side), Constants::MostFaces);
    double gap = reach;
    walk.advance(reach, [&](int h, double left) {
      if (!this->Lines.isLine(h))
      {
        return true;
      }
      const double d = reach - left;
      const BackbonePlace to = this->Lines.placeOf(h, walk.bary());
      if (!this->Lines.meet(from.backbone, to.backbone) &&
        !this->Lines.areConnected(from, to, Constants::DetourOverGap * d))
      {
        gap = d;
      }
      return false;
    });
    return gap;
  }

  void addGaps(int line, std::vector<FeatureSize>& sources) const
  {
    const double length = this->Lines.length(line);
    double spacing = 0;
    for (double s = 0; s < length;)
    {
      const BackbonePlace from = { line, s };
      const SurfacePlace place = this->placeAt(from);
      // Where maps have a hole, as in a triangle without width, that of the place before.
      const double here = this->Spacing(place);
      spacing = here > 0 ? here : spacing;
      if (!(spacing > 0))
      {
        return;
      }
      const double reach = spacing * Constants::LargestSize / Constants::SizeOverGap;
      const double gap = std::min(this->gapBeside(from, 0, reach), this->gapBeside(from, 1, reach));
      this->add(place, spacing, Constants::SizeOverGap * gap, sources);
      // As often as the finest size asks for, whatever the gaps are.
      s += std::max(0.5 * gap, 0.5 * Constants::FinestSize * spacing);
    }
  }

  void addLoop(int line, std::vector<FeatureSize>& sources) const
  {
    const double length = this->Lines.length(line);
    for (int i = 0; i < Constants::EdgesOfLoop; ++i)
    {
      const SurfacePlace place = this->placeAt({ line, length * i / Constants::EdgesOfLoop });
      this->add(place, this->Spacing(place), length / Constants::EdgesOfLoop, sources);
    }
  }

  void addShortLine(int line, int corner, std::vector<FeatureSize>& sources) const
  {
    const SurfacePlace place = this->Source.placeOfPoint(corner);
    this->add(place, this->Spacing(place), this->Lines.length(line), sources);
  }

  const Atlas& Source;
  const FeatureLines& Lines;
  const std::function<double(const SurfacePlace&)>& Spacing;
};
}

std::vector<FeatureSize> featureSizes(
  const Atlas& atlas, const std::function<double(const SurfacePlace&)>& spacing, const Stop& stop)
{
  const JoinedCreases& creases = atlas.joinedCreases();
  const Atlas& joined = creases.atlas();
  const FeatureLines lines(joined, joined.creasesTo(spacing));
  const SizeSearch search(joined, lines, spacing);
  std::vector<std::vector<FeatureSize>> found(lines.lines().size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(found.size()), 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end && !isAsked(stop); ++i)
    {
      found[i] = search.of(lines.lines()[i]);
    }
  });
  std::vector<FeatureSize> sources;
  for (const std::vector<FeatureSize>& some : found)
  {
    sources.insert(sources.end(), some.begin(), some.end());
  }
  return sources;
}

std::vector<SizeSource> sizesFrom(const std::vector<FeatureSize>& features, double finest)
{
  std::vector<SizeSource> sources;
  for (const FeatureSize& f : features)
  {
    const double least = finest * f.spacing;
    if (f.size >= Constants::LeastSize * least)
    {
      sources.push_back({ f.position, std::max(f.size, least) });
    }
  }
  return sources;
}
}
