// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartPartition.h"

#include "VoronoiDiagram.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace stipple
{
namespace
{
/// Cuts the surface between farthest-point Voronoi cells, at least one a component, as many as
/// asked for.
void cutIntoVoronoiCells(CutSurface& surface, int numberOfCells)
{
  VoronoiDiagram diagram(surface);
  std::vector<int> all(surface.numberOfFaces());
  std::iota(all.begin(), all.end(), 0);
  int cells = 0;
  for (const std::vector<int>& component : chartFaces(surface))
  {
    diagram.addSite(component.front(), cells);
    const int far = diagram.farthest(component);
    diagram.forget(component);
    diagram.addSite(far, cells++);
  }
  while (cells < std::min(numberOfCells, surface.numberOfFaces()))
  {
    diagram.addSite(diagram.farthest(all), cells++);
  }
  diagram.removeSpikes(all);
  for (int h = 0; h < 3 * surface.numberOfFaces(); ++h)
  {
    if (!surface.cut[h] && diagram.cell(surface.twin[h] / 3) != diagram.cell(h / 3))
    {
      surface.setCut(h, true);
    }
  }
}

/// Splits a region in two, between a triangle (the densest, or the one farthest from the region's
/// first) and the triangle that is farthest from it. Returns the new region.
int bisect(ChartRegions& regions, int region, int first)
{
  regions.closeSlits(region);
  const std::vector<int>& faces = regions.faces(region);
  VoronoiDiagram diagram(regions.surface());
  if (first < 0)
  {
    diagram.addSite(faces.front(), 0);
    first = diagram.farthest(faces);
    diagram.forget(faces);
  }
  diagram.addSite(first, 0);
  diagram.addSite(diagram.farthest(faces), 1);
  diagram.removeSpikes(faces);
  std::vector<char> side;
  side.reserve(faces.size());
  for (int f : faces)
  {
    side.push_back(diagram.cell(f) == 1);
  }
  return regions.divide(region, side);
}

/// Bisects regions until all are disks.
Status splitIntoDisks(ChartRegions& regions, const Progress& progress)
{
  for (int r = 0; r < regions.size(); ++r)
  {
    if (!report(progress, static_cast<double>(r) / regions.size()))
    {
      return Status::aborted();
    }
    while (!regions.mesh(r).isDisk())
    {
      bisect(regions, r, -1);
    }
  }
  return Status::success();
}

/// Whether two regions glued along all their seams are a disk: they are, if both are disks, when
/// there is one seam.
bool mergeToDisk(const ChartRegions& regions, int a, int b)
{
  const std::vector<SeamArc> arcs = regions.arcs(a, b);
  return arcs.size() == 1 && !arcs.front().closed;
}

/// Merges disks, the pair of least area first, down to the number of charts asked for or as far as
/// disks can be merged.
Status mergeDisks(ChartRegions& regions, int numberOfCharts, const Progress& progress)
{
  const int start = regions.size();
  std::vector<double> area(start);
  for (int r = 0; r < start; ++r)
  {
    area[r] = regions.area(r);
  }
  while (regions.size() > numberOfCharts)
  {
    if (!report(progress, 1 - static_cast<double>(regions.size()) / start))
    {
      return Status::aborted();
    }
    std::array<int, 2> best = { -1, -1 };
    double least = std::numeric_limits<double>::infinity();
    for (int a = 0; a < regions.size(); ++a)
    {
      for (int b : regions.laterNeighbours(a))
      {
        if (area[a] + area[b] < least && mergeToDisk(regions, a, b))
        {
          least = area[a] + area[b];
          best = { a, b };
        }
      }
    }
    if (best[0] < 0)
    {
      break;
    }
    area[best[0]] += area[best[1]];
    area[best[1]] = area.back();
    area.pop_back();
    regions.merge(best[0], best[1]);
  }
  return Status::success();
}

void splitLongestBoundaryEdge(ChartRegions& regions, int region)
{
  const CutSurface& surface = regions.surface();
  int longest = -1;
  double length = -1;
  for (int f : regions.faces(region))
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
    {
      const double l = (surface.points[surface.head(h)] - surface.points[surface.tail(h)]).norm();
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

  Status run(const Progress& progress)
  {
    while (true)
    {
      const std::vector<int> changed = this->prepareChanged();
      if (changed.empty())
      {
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
            chart.map =
              mapToRectangle(this->Regions.surface(), chart.mesh, { this->Options.square });
          }
        });
      for (int r : changed)
      {
        this->Regions.clearChanged(r);
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

  std::vector<FlatChart> takeCharts() { return std::move(this->Charts); }

private:
  struct History
  {
    int cutRounds = 0; ///< how often cuts into the chart have been tried
    double densityRatio = std::numeric_limits<double>::infinity();
  };

  /// Makes the regions that changed ready to be flattened. A rectangle's corners need four boundary
  /// vertices; splitting an edge changes the region across, too.
  std::vector<int> prepareChanged()
  {
    for (int r = 0; r < this->Regions.size(); ++r)
    {
      while (this->Regions.isChanged(r) && this->Regions.mesh(r).boundary.size() < 4)
      {
        splitLongestBoundaryEdge(this->Regions, r);
      }
    }
    std::vector<int> changed;
    for (int r = 0; r < this->Regions.size(); ++r)
    {
      if (this->Regions.isChanged(r))
      {
        this->Regions.splitChords(r);
        changed.push_back(r);
      }
    }
    this->Charts.resize(this->Regions.size());
    this->Histories.resize(this->Regions.size());
    return changed;
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
    const FlatChart& chart = this->Charts[r];
    const ConformalMap& map = chart.map;
    History& history = this->Histories[r];
    if (map.valid && map.densityRatio <= this->Options.maximumDensityRatio)
    {
      return Status::success();
    }
    if (chart.mesh.faces.size() <= 2)
    {
      return Status::error(
        "A chart of two triangles can't be flattened: the surface has triangles too thin "
        "for double precision; repair it first.");
    }
    const bool helping = history.cutRounds == 0 || map.densityRatio < 0.5 * history.densityRatio;
    if (map.valid && helping && history.cutRounds < 8 &&
      cutToDensePlaces(this->Regions, r, chart, this->Options.maximumDensityRatio))
    {
      history = { history.cutRounds + 1, map.densityRatio };
      return Status::success();
    }
    int densest = -1;
    if (map.valid)
    {
      densest =
        chart.mesh
          .faces[std::max_element(map.density.begin(), map.density.end()) - map.density.begin()];
    }
    history = {};
    this->split(r, densest);
    return Status::success();
  }

  /// Splits a region at a triangle, into disks with smooth seams of their own.
  void split(int r, int densest)
  {
    const int first = this->Regions.size();
    bisect(this->Regions, r, densest);
    std::vector<int> parts = { r };
    for (int q = first; q < this->Regions.size(); ++q)
    {
      parts.push_back(q);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      while (!this->Regions.mesh(parts[i]).isDisk())
      {
        parts.push_back(bisect(this->Regions, parts[i], -1));
      }
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      for (std::size_t j = i + 1; j < parts.size(); ++j)
      {
        smoothSeams(this->Regions, parts[i], parts[j], this->Options.placement);
      }
    }
  }

  ChartRegions& Regions;
  const ChartPartitionOptions& Options;
  std::vector<FlatChart> Charts;
  std::vector<History> Histories;
};
}

Status partitionSurface(CutSurface& surface, const ChartPartitionOptions& options,
  std::vector<FlatChart>& charts, const Progress& progress)
{
  charts.clear();
  if (surface.numberOfFaces() == 0)
  {
    return Status::success();
  }
  const auto part = [&](double from, double to) -> Progress {
    return [&, from, to](double f) { return report(progress, from + (to - from) * f); };
  };
  cutIntoVoronoiCells(surface, options.numberOfCharts);
  ChartRegions regions(surface);
  if (const Status status = splitIntoDisks(regions, part(0., .1)); !status.ok())
  {
    return status;
  }
  if (const Status status = mergeDisks(regions, options.numberOfCharts, part(.1, .15));
      !status.ok())
  {
    return status;
  }
  if (const Status status = placeSeams(regions, options.placement, part(.15, .4)); !status.ok())
  {
    return status;
  }
  for (int r = 0; r < regions.size(); ++r)
  {
    regions.closeSlits(r);
  }
  DensityBound bound(regions, options);
  if (const Status status = bound.run(part(.4, 1.)); !status.ok())
  {
    return status;
  }
  charts = bound.takeCharts();
  return Status::success();
}
}
