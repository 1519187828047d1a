// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartPartition.h"

#include "AtlasConstants.h"
#include "CreasePatches.h"
#include "GreedyMerge.h"
#include "SurfaceCoarsening.h"
#include "VoronoiDiagram.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
/// Cuts the surface between farthest-point Voronoi cells, at least one a component, as many as
/// asked for.
void cutIntoVoronoiCells(CutSurface& surface, int numberOfCells, const Stop& stop)
{
  VoronoiDiagram diagram(surface, stop);
  std::vector<Face> all;
  for (const Face f : surface.faces())
  {
    all.push_back(f);
  }
  int cells = 0;
  for (const std::vector<Face>& component : chartFaces(surface))
  {
    diagram.addSite(component.front(), cells);
    const Face far = diagram.farthest(component);
    diagram.forget(component);
    diagram.addSite(far, cells++);
  }
  while (cells < std::min(numberOfCells, surface.numberOfFaces()) && !isAsked(stop))
  {
    diagram.addSite(diagram.farthest(all), cells++);
  }
  diagram.removeSpikes(all);
  for (const Halfedge h : surface.halfedges())
  {
    if (!surface.cut[h] && diagram.cell(faceOf(surface.twin[h])) != diagram.cell(faceOf(h)))
    {
      surface.setCut(h, true);
    }
  }
}

/// Splits a region in two, between a triangle (the densest, or the one farthest from the region's
/// first) and the triangle that is farthest from it. Both parts are smaller than the region was.
/// Returns the new region.
int bisect(ChartRegions& regions, int region, Face first = {})
{
  regions.closeSlits(region);
  const std::vector<Face>& faces = regions.faces(region);
  VoronoiDiagram diagram(regions.surface(), regions.stop());
  if (!first.valid())
  {
    diagram.addSite(faces.front(), 0);
    first = diagram.farthest(faces);
    diagram.forget(faces);
  }
  diagram.addSite(first, 0);
  diagram.addSite(diagram.farthest(faces), 1);
  const auto sides = [&] {
    std::vector<char> side(faces.size());
    std::transform(
      faces.begin(), faces.end(), side.begin(), [&](Face f) { return diagram.cell(f) == 1; });
    return side;
  };
  std::vector<char> side = sides();
  diagram.removeSpikes(faces);
  // A cell of few triangles may be all spikes: then they stay.
  const std::vector<char> smooth = sides();
  if (std::find(smooth.begin(), smooth.end(), !smooth.front()) != smooth.end())
  {
    side = smooth;
  }
  return regions.divide(region, side);
}

/// Bisects a region until it is a disk; the new regions need not be. It has fewer triangles every
/// time, and a single one is a disk.
void bisectToDisk(ChartRegions& regions, int region)
{
  while (!regions.isStopped() && !regions.mesh(region).isDisk())
  {
    bisect(regions, region);
  }
}

/// Cuts a face of a machined part that has holes (a plate, a tube) open from hole to hole: such a
/// face is one that creases bound, or that can be unrolled. Not if the map would break the bound.
void openToDisk(
  ChartRegions& regions, int region, const ChartMesh& mesh, const ChartPartitionOptions& options)
{
  if (mesh.boundaryLoops < 2)
  {
    return;
  }
  const CutSurface& surface = regions.surface();
  const std::vector<Face>& faces = regions.faces(region);
  const auto isAtCrease = [&](Face f) {
    bool found = false;
    for (const Halfedge h : halfedgesOf(f))
    {
      found = found || (surface.isCrease(h) && surface.cut[h]);
    }
    return found;
  };
  const bool unrolls = isNearlyDevelopable(surface, mesh);
  if (!unrolls && std::none_of(faces.begin(), faces.end(), isAtCrease))
  {
    return;
  }
  const std::vector<Halfedge> opened = joinLoops(regions, region);
  if (regions.mesh(region).isDisk())
  {
    if (unrolls)
    {
      return;
    }
    regions.splitChords(region);
    const ConformalMap map =
      mapToRectangle(surface, regions.mesh(region), { options.square }, regions.stop());
    if (map.valid && map.densityRatio <= options.maximumDensityRatio)
    {
      return;
    }
  }
  regions.closeCuts(region, opened);
}

/// Cuts regions open, or bisects them until all are disks: single triangles at the latest.
Status splitIntoDisks(
  ChartRegions& regions, const ChartPartitionOptions& options, const Progress& progress)
{
  for (int r = 0; r < regions.size(); ++r)
  {
    if (!report(progress, static_cast<double>(r) / regions.size()))
    {
      return Status::aborted();
    }
    const ChartMesh mesh = regions.mesh(r);
    if (!mesh.isDisk())
    {
      openToDisk(regions, r, mesh, options);
      bisectToDisk(regions, r);
    }
  }
  return Status::success();
}

/// The seam along which two disks can be glued to one disk: they can if it is their only one.
std::optional<SeamArc> onlySeam(const ChartRegions& regions, int a, int b)
{
  std::vector<SeamArc> arcs = regions.arcs(a, b);
  if (arcs.size() != 1 || arcs.front().closed)
  {
    return {};
  }
  return std::move(arcs.front());
}

/// The longest seam between two regions that is not the whole boundary of both.
std::optional<SeamArc> longestOpenSeam(const ChartRegions& regions, int a, int b)
{
  const std::vector<SeamArc> arcs = regions.arcs(a, b);
  if (arcs.empty())
  {
    return {};
  }
  const SeamArc& arc = longest(regions.surface(), arcs);
  return arc.closed ? std::nullopt : std::make_optional(arc);
}

void splitLongestBoundaryEdge(ChartRegions& regions, int region)
{
  const CutSurface& surface = regions.surface();
  Halfedge longest;
  double length = -1;
  for (const Face f : regions.faces(region))
  {
    for (const Halfedge h : halfedgesOf(f))
    {
      const double l = surface.edgeLength(h);
      if (surface.cut[h] && l > length)
      {
        longest = h;
        length = l;
      }
    }
  }
  regions.splitEdge(longest, 0.5);
}

/// Flattens regions, and cuts or splits those whose density is not bounded, until all charts keep
/// the bound.
class DensityBound
{
public:
  DensityBound(ChartRegions& regions, const ChartPartitionOptions& options)
    : Regions(regions)
    , Options(options)
  {
  }

  /// It ends: what is not flat enough is cut a few times, then split; and of each line of descent
  /// History::splitsLeft falls with every split.
  Status run(const Progress& progress)
  {
    while (true)
    {
      const std::vector<int> changed = this->prepareReshaped();
      if (this->Regions.isStopped())
      {
        return Status::aborted();
      }
      if (changed.empty())
      {
        for (int r = 0; r < this->Regions.size(); ++r)
        {
          this->followSplits(r);
        }
        return Status::success();
      }
      if (!report(progress, this->finishedFraction(changed)))
      {
        return Status::aborted();
      }
      vtkSMPTools::For(
        0, static_cast<vtkIdType>(changed.size()), 1, [&](vtkIdType begin, vtkIdType end) {
          for (vtkIdType i = begin; i < end; ++i)
          {
            FlatChart& chart = this->Charts[changed[i]];
            chart.mesh = this->Regions.mesh(changed[i]);
            chart.map = mapToRectangle(
              this->Regions.surface(), chart.mesh, { this->Options.square }, this->Regions.stop());
          }
        });
      if (this->Regions.isStopped())
      {
        return Status::aborted();
      }
      for (int r : changed)
      {
        this->Regions.clearChanges(r);
      }
      for (int r : changed)
      {
        if (const Status status = this->relieve(r); !status.ok())
        {
          return status;
        }
      }
    }
  }

  /// Merges neighbours as long as the bound is kept and more charts than asked for are left.
  Status merge(const Progress& progress)
  {
    return GreedyMerge(this->Regions)
      .run(
        this->Options.numberOfCharts, [this](int a, int b) { return this->tryToMerge(a, b); },
        [this](int a, int b) {
          this->Charts[a] = std::move(this->Merged.chart);
          if (b + 1 != static_cast<int>(this->Charts.size()))
          {
            this->Charts[b] = std::move(this->Charts.back());
          }
          this->Charts.pop_back();
          this->Regions.clearChanges(a);
        },
        [this](const std::vector<std::pair<int, int>>& pairs) { this->flattenTogether(pairs); },
        progress);
  }

  std::vector<FlatChart> takeCharts() { return std::move(this->Charts); }

private:
  struct History
  {
    int cutRounds = 0; ///< how often cuts into the chart have been tried
    double densityRatio = std::numeric_limits<double>::infinity();
    /// How often the region, and what becomes of it, may still be split, one within the other.
    int splitsLeft = std::numeric_limits<int>::max();
  };

  /// Makes the regions whose shape changed ready to be flattened. A rectangle's corners need four
  /// boundary vertices.
  std::vector<int> prepareReshaped()
  {
    for (int r = 0; r < this->Regions.size() && !this->Regions.isStopped(); ++r)
    {
      while (this->Regions.isReshaped(r) && this->Regions.numberOfCuts(r, 4) < 4)
      {
        splitLongestBoundaryEdge(this->Regions, r);
      }
    }
    std::vector<int> changed;
    for (int r = 0; r < this->Regions.size() && !this->Regions.isStopped(); ++r)
    {
      if (this->Regions.isReshaped(r))
      {
        this->Regions.splitChords(r);
        changed.push_back(r);
      }
    }
    this->Charts.resize(this->Regions.size());
    this->Histories.resize(this->Regions.size());
    return changed;
  }

  /// Carries on the map of a chart whose triangles were split along edges, by a neighbour's cuts or
  /// seams: split triangles are mapped as before.
  void followSplits(int r)
  {
    if (this->Regions.splits(r).empty() || this->Regions.isReshaped(r))
    {
      return;
    }
    FlatChart& chart = this->Charts[r];
    ElementArray<Halfedge, Vec2>& at = this->UV;
    at.resize(this->Regions.surface().numberOfHalfedges());
    spread(chart.mesh, chart.map.uv, at);
    for (const ChartRegions::Split& split : this->Regions.splits(r))
    {
      const Vec2& tail = at[split.halfedge];
      const Vec2& head = at[nextHalfedge(split.halfedge)];
      // In this form a coordinate that both ends share is kept to the bit.
      const Vec2 middle = tail + split.t * (head - tail);
      followSplit(at, split.halfedge, split.added, middle);
    }
    chart.mesh = this->Regions.mesh(r);
    chart.map.uv.resize(chart.mesh.vertices.size());
    for (std::size_t i = 0; i < chart.mesh.faces.size(); ++i)
    {
      for (const Halfedge h : halfedgesOf(chart.mesh.faces[i]))
      {
        chart.map.uv[chart.mesh.triangles[i][cornerOf(h)]] = at[h];
      }
    }
    measureMap(this->Regions.surface(), chart.mesh, chart.map);
    this->Regions.clearChanges(r);
  }

  double finishedFraction(const std::vector<int>& changed) const
  {
    std::size_t open = 0;
    for (int r : changed)
    {
      open += this->Regions.faces(r).size();
    }
    return 1 - static_cast<double>(open) / this->Regions.surface().numberOfFaces();
  }

  /// Cuts or splits a region if its chart breaks the bound.
  Status relieve(int r)
  {
    this->followSplits(r);
    FlatChart& chart = this->Charts[r];
    const ConformalMap& map = chart.map;
    History& history = this->Histories[r];
    if (map.valid && map.densityRatio <= this->Options.maximumDensityRatio)
    {
      return Status::success();
    }
    const int splitsLeft =
      std::min(history.splitsLeft, this->Regions.numberOfInputTriangles(r)) - 1;
    const bool canBeSplit =
      splitsLeft >= Constants::FewestToSplit - 1 && chart.mesh.faces.size() > 2;
    if (!map.valid && !canBeSplit)
    {
      chart.map = mapByMeans(this->Regions.surface(), chart.mesh, this->Regions.stop());
      if (this->Regions.isStopped())
      {
        return Status::aborted();
      }
      return map.valid
        ? Status::success()
        : Status::error("A chart of " + std::to_string(chart.mesh.faces.size()) +
            " triangles can't be flattened: the surface has triangles too thin for double "
            "precision; repair it first.");
    }
    if (history.cutRounds == 0 && cutDeepSleeve(this->Regions, chart))
    {
      ++history.cutRounds;
      return Status::success();
    }
    const bool helping =
      history.cutRounds == 0 || map.densityRatio < Constants::HelpfulCut * history.densityRatio;
    if (map.valid && helping && history.cutRounds < Constants::MostCutRounds &&
      cutToDensePlaces(this->Regions, r, chart, this->Options.maximumDensityRatio))
    {
      ++history.cutRounds;
      history.densityRatio = map.densityRatio;
      return Status::success();
    }
    if (!canBeSplit)
    {
      return Status::success(); // denser than the bound, but a map
    }
    Face densest;
    if (map.valid)
    {
      densest =
        chart.mesh
          .faces[std::max_element(map.density.begin(), map.density.end()) - map.density.begin()];
    }
    const std::vector<int> parts = this->split(r, densest);
    this->Histories.resize(this->Regions.size());
    for (int part : parts)
    {
      this->Histories[part] = {};
      this->Histories[part].splitsLeft = splitsLeft;
    }
    return Status::success();
  }

  /// Splits a region at a triangle, into disks with smooth seams of their own. Returns all parts.
  std::vector<int> split(int r, Face densest)
  {
    const int first = bisect(this->Regions, r, densest);
    bisectToDisk(this->Regions, r);
    std::vector<int> parts = { r };
    for (int q = first; q < this->Regions.size() && !this->Regions.isStopped(); ++q)
    {
      bisectToDisk(this->Regions, q);
      parts.push_back(q);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      for (std::size_t j = i + 1; j < parts.size() && !this->Regions.isStopped(); ++j)
      {
        smoothSeams(this->Regions, parts[i], parts[j], this->Options.placement);
      }
    }
    return parts;
  }

  /// Two regions as one chart.
  struct Candidate
  {
    SeamArc seam; // to close
    FlatChart chart;
  };
  /// By the first triangles of two regions: whatever becomes of others, it stays theirs until they
  /// are merged.
  using Key = std::pair<Face, Face>;
  Key keyOf(int a, int b) const
  {
    return std::minmax(this->Regions.faces(a).front(), this->Regions.faces(b).front());
  }

  /// Flattens pairs of regions as one chart each, several at a time, that have not been so far.
  /// Large ones are not worth the time.
  void flattenTogether(const std::vector<std::pair<int, int>>& pairs)
  {
    if (this->Candidates.count(this->keyOf(pairs.front().first, pairs.front().second)) > 0)
    {
      return;
    }
    CutSurface& surface = this->Regions.surface();
    std::vector<Candidate*> added;
    for (const auto& [a, b] : pairs)
    {
      // Glued along one seam two disks are a disk; what others they have stay cut.
      const bool isSmall =
        this->Regions.faces(a).size() + this->Regions.faces(b).size() <= Constants::LargestMerger;
      std::optional<SeamArc> seam =
        isSmall ? longestOpenSeam(this->Regions, a, b) : std::optional<SeamArc>();
      const auto [place, isNew] = this->Candidates.try_emplace(this->keyOf(a, b));
      if (!isNew || !seam)
      {
        continue;
      }
      place->second.emplace();
      Candidate& candidate = *place->second;
      candidate.seam = std::move(*seam);
      for (const Halfedge h : candidate.seam.halfedges)
      {
        surface.setCut(h, false);
      }
      std::vector<Face> faces = this->Regions.faces(a);
      faces.insert(faces.end(), this->Regions.faces(b).begin(), this->Regions.faces(b).end());
      candidate.chart.mesh = extractChart(surface, std::move(faces));
      for (const Halfedge h : candidate.seam.halfedges)
      {
        surface.setCut(h, true);
      }
      added.push_back(&candidate);
    }
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(added.size()), 1, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType i = begin; i < end; ++i)
        {
          FlatChart& chart = added[i]->chart;
          chart.map =
            mapToRectangle(surface, chart.mesh, { this->Options.square }, this->Regions.stop());
        }
      });
  }

  /// The seam to close, if two regions as one keep the bound.
  std::optional<SeamArc> tryToMerge(int a, int b)
  {
    std::optional<Candidate>& candidate = this->Candidates[this->keyOf(a, b)];
    if (!candidate)
    {
      return {};
    }
    this->Merged = std::move(*candidate);
    candidate.reset(); // a pair is asked for once
    if (!this->isWorthMerging(this->Merged.seam, a, b))
    {
      return {};
    }
    const Face first = this->Regions.faces(a).front();
    const Face second = this->Regions.faces(b).front();
    for (auto it = this->Candidates.begin(); it != this->Candidates.end();)
    {
      const auto& [one, other] = it->first;
      const bool isOld = one == first || one == second || other == first || other == second;
      it = isOld ? this->Candidates.erase(it) : std::next(it);
    }
    return this->Merged.seam;
  }

  /// Whether the merged chart keeps the bound. A seam on creases is a good one: it goes only if
  /// next to nothing becomes dense, or no denser than it is. Faces that meet at right angles have
  /// corners that no rectangle has, and a map is infinitely dense at these: seen over 1e-3 of the
  /// area many a corner is missed, and the few samples of its surroundings are missing.
  bool isWorthMerging(const SeamArc& seam, int a, int b) const
  {
    const ConformalMap& map = this->Merged.chart.map;
    const CutSurface& surface = this->Regions.surface();
    const double bound = this->Options.maximumDensityRatio;
    if (!map.valid || map.densityRatio > bound)
    {
      return false;
    }
    if (!seam.isSharp(surface))
    {
      return true;
    }
    const auto quantile = [&](const FlatChart& chart) {
      return densityQuantile(chart.map, 0.1 * NegligibleArea);
    };
    const double merged = quantile(this->Merged.chart);
    return merged <= Constants::DensityAtCreases * bound || merged <= quantile(this->Charts[a]) ||
      merged <= quantile(this->Charts[b]);
  }

  ChartRegions& Regions;
  const ChartPartitionOptions& Options;
  Candidate Merged;
  std::map<Key, std::optional<Candidate>> Candidates; // none: not as one
  ElementArray<Halfedge, Vec2> UV;                    // of its tail; scratch
  std::vector<FlatChart> Charts;
  std::vector<History> Histories;
};

/// Parts of one progress, and what to ask in between whether to stop.
class Stages
{
public:
  explicit Stages(const Progress& progress)
    : All(progress)
  {
  }
  Progress part(double from, double to)
  {
    return [this, from, to](double f) {
      this->Told = from + (to - from) * f;
      return report(this->All, this->Told);
    };
  }
  Stop stop()
  {
    return [this] { return !report(this->All, this->Told); };
  }

private:
  const Progress& All;
  std::atomic<double> Told{ 0. };
};

/// Makes disks of regions, as few as one seam each can join.
Status layOutCharts(
  ChartRegions& regions, const ChartPartitionOptions& options, const Progress& progress)
{
  Stages stages(progress);
  if (const Status status = splitIntoDisks(regions, options, stages.part(0., .3)); !status.ok())
  {
    return status;
  }
  const auto canBeGlued = [&](int a, int b) {
    std::optional<SeamArc> seam = onlySeam(regions, a, b);
    return seam && !seam->isSharp(regions.surface()) ? seam : std::nullopt;
  };
  return GreedyMerge(regions).run(options.numberOfCharts, canBeGlued, {}, {}, stages.part(.3, 1.));
}

/// Whether that is trivial: a disk, or a sphere that is cut in two.
bool isLaidOutAtOnce(const CutSurface& surface, int numberOfCharts)
{
  for (const Halfedge h : surface.halfedges())
  {
    if (surface.cut[h] && !surface.isBoundary(h))
    {
      return false;
    }
  }
  const SurfaceTopology topology = surface.topology();
  return numberOfCharts <= 2 && topology.components == 1 && topology.boundaryLoops <= 1 &&
    topology.euler + topology.boundaryLoops == 2;
}

/// All of that, and seams between alike areas, on a surface of few triangles, for it depends on
/// large shapes alone; then the surface is cut as that one is.
Status layOutChartsCoarsely(
  CutSurface& surface, const ChartPartitionOptions& options, const Progress& progress)
{
  Stages stages(progress);
  const SurfaceCoarsening coarsening(surface, Constants::CoarseTriangles, stages.stop());
  CutSurface coarse = coarsening.coarse();
  cutAlongCreases(coarse);
  cutIntoVoronoiCells(coarse, options.numberOfCharts, stages.stop());
  ChartRegions regions(coarse, stages.stop());
  Status status = layOutCharts(regions, options, stages.part(.2, .6));
  if (status.ok())
  {
    status = balanceAreas(regions, options.placement, stages.part(.6, .9));
  }
  if (status.ok())
  {
    const ElementArray<Halfedge, char> cuts = coarsening.prolong(coarse, stages.stop());
    for (const Halfedge h : surface.halfedges())
    {
      surface.setCut(h, cuts[h] != 0);
    }
  }
  return status;
}
}

Status partitionSurface(CutSurface& surface, const ChartPartitionOptions& options,
  std::vector<FlatChart>& charts, const Progress& progress)
{
  charts.clear();
  if (surface.numberOfFaces() == 0)
  {
    return Status::success();
  }
  Stages stages(progress);
  if (!report(progress, 0.))
  {
    return Status::aborted();
  }
  cutAlongCreases(surface);
  const bool isLarge = options.placement != BoundaryPlacement::Voronoi &&
    surface.numberOfFaces() >= Constants::LeastTimesCoarse * Constants::CoarseTriangles &&
    !isLaidOutAtOnce(surface, options.numberOfCharts);
  Status status = Status::success();
  if (isLarge)
  {
    status = layOutChartsCoarsely(surface, options, stages.part(0., .2));
  }
  else
  {
    cutIntoVoronoiCells(surface, options.numberOfCharts, stages.stop());
  }
  if (!status.ok())
  {
    return status;
  }
  ChartRegions regions(surface, stages.stop());
  status = isLarge ? splitIntoDisks(regions, options, stages.part(.2, .25)) // they are, as a rule
                   : layOutCharts(regions, options, stages.part(0., .2));
  if (status.ok())
  {
    status = isLarge ? cutSeams(regions, options.placement, true, stages.part(.25, .4))
                     : placeSeams(regions, options.placement, stages.part(.2, .4));
  }
  if (!status.ok())
  {
    return status;
  }
  for (int r = 0; r < regions.size(); ++r)
  {
    regions.closeSlits(r);
  }
  DensityBound bound(regions, options);
  status = bound.run(stages.part(.4, .8));
  if (status.ok())
  {
    status = bound.merge(stages.part(.8, 1.));
  }
  if (!status.ok())
  {
    return status;
  }
  charts = bound.takeCharts();
  return Status::success();
}
}
