// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartPartition.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace stipple
{
namespace
{
using Faces = std::vector<int>;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Geodesic Voronoi regions on the dual graph, grown face by face; seeds may be added one at a
/// time.
class VoronoiRegions
{
public:
  explicit VoronoiRegions(const CutSurface& surface)
    : Surface(surface)
    , Distance(surface.triangles.size(), Infinity)
    , Owner(surface.triangles.size(), -1)
  {
  }

  void addSeed(int face, int owner)
  {
    this->Distance[face] = 0;
    this->Owner[face] = owner;
    this->Front.push({ 0., face });
    while (!this->Front.empty())
    {
      const auto [d, f] = this->Front.top();
      this->Front.pop();
      if (d > this->Distance[f])
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        const int h = 3 * f + k;
        if (this->Surface.cut[h])
        {
          continue;
        }
        const int g = this->Surface.twin[h] / 3;
        const double step = (this->center(g) - this->center(f)).norm();
        if (d + step < this->Distance[g])
        {
          this->Distance[g] = d + step;
          this->Owner[g] = owner;
          this->Front.push({ d + step, g });
        }
      }
    }
  }

  int farthest(const Faces& faces) const
  {
    return *std::max_element(faces.begin(), faces.end(),
      [&](int a, int b) { return this->Distance[a] < this->Distance[b]; });
  }

  void forget(const Faces& faces)
  {
    for (int f : faces)
    {
      this->Distance[f] = Infinity;
      this->Owner[f] = -1;
    }
  }

  int owner(int face) const { return this->Owner[face]; }

  /// Gives triangles that hang on their region by one edge only to the region that surrounds them:
  /// on a straight boundary they would have next to no area in the plane. Every step shortens the
  /// regions' boundaries.
  void removeSpikes(const Faces& faces)
  {
    bool changed = true;
    while (changed)
    {
      changed = false;
      for (int f : faces)
      {
        for (int k = 0; k < 3; ++k)
        {
          changed = this->removeSpike(3 * f + k) || changed;
        }
      }
    }
  }

private:
  /// Neighbour's owner across a halfedge, -1 where the surface is cut.
  int ownerAcross(int h) const
  {
    return this->Surface.cut[h] ? -1 : this->Owner[this->Surface.twin[h] / 3];
  }

  /// The triangle of h goes to the other region if it is held by the edge opposite h's tail alone,
  /// and if that region has the whole fan around the tail (else its boundary would touch itself
  /// there).
  bool removeSpike(int h)
  {
    const int other = this->ownerAcross(h);
    const int own = this->Owner[h / 3];
    if (other < 0 || other == own || this->ownerAcross(previousHalfedge(h)) != other ||
      this->ownerAcross(nextHalfedge(h)) != own)
    {
      return false;
    }
    for (int g = this->Surface.twin[previousHalfedge(h)]; g != h;
         g = this->Surface.twin[previousHalfedge(g)])
    {
      if (this->Surface.cut[previousHalfedge(g)] || this->Owner[g / 3] != other)
      {
        return false;
      }
    }
    this->Owner[h / 3] = other;
    return true;
  }

  Vec3 center(int f) const
  {
    return (this->Surface.point(f, 0) + this->Surface.point(f, 1) + this->Surface.point(f, 2)) / 3.;
  }

  const CutSurface& Surface;
  std::vector<double> Distance;
  std::vector<int> Owner;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Front;
};

/// Cuts along every edge between faces of different owners, then returns the faces by owner.
std::vector<Faces> cutBetweenOwners(
  CutSurface& surface, const VoronoiRegions& regions, const Faces& faces, int numberOfOwners)
{
  std::vector<Faces> parts(numberOfOwners);
  for (int f : faces)
  {
    parts[regions.owner(f)].push_back(f);
    for (int k = 0; k < 3; ++k)
    {
      const int h = 3 * f + k;
      if (!surface.cut[h] && regions.owner(surface.twin[h] / 3) != regions.owner(f))
      {
        surface.setCut(h, true);
      }
    }
  }
  return parts;
}

/// Removes the cuts inside a chart, those with the chart on both sides.
void closeInnerCuts(CutSurface& surface, const Faces& faces)
{
  const std::vector<int> sorted = [&] {
    Faces copy = faces;
    std::sort(copy.begin(), copy.end());
    return copy;
  }();
  for (int f : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int h = 3 * f + k;
      if (surface.cut[h] && surface.twin[h] >= 0 &&
        std::binary_search(sorted.begin(), sorted.end(), surface.twin[h] / 3))
      {
        surface.setCut(h, false);
      }
    }
  }
}

/// Splits a chart in two, between a face (the densest, or the one farthest from the chart's first)
/// and the face that is farthest from it.
std::vector<Faces> bisect(CutSurface& surface, const Faces& faces, int first)
{
  closeInnerCuts(surface, faces);
  VoronoiRegions regions(surface);
  if (first < 0)
  {
    regions.addSeed(faces.front(), 0);
    first = regions.farthest(faces);
    regions.forget(faces);
  }
  regions.addSeed(first, 0);
  regions.addSeed(regions.farthest(faces), 1);
  regions.removeSpikes(faces);
  return cutBetweenOwners(surface, regions, faces, 2);
}

/// Cuts from the densest place of every region denser than the bound to the chart's boundary, along
/// shortest edge paths (Gu, Gortler, Hoppe 2002). False if there was nothing to cut.
bool cutToDensePlaces(CutSurface& surface, const FlatChart& chart, double bound)
{
  const ChartMesh& mesh = chart.mesh;
  const int n = static_cast<int>(mesh.triangles.size());
  // Regions of dense triangles, joined across chart vertices.
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v)
    {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  };
  for (int i = 0; i < n; ++i)
  {
    if (chart.map.density[i] > bound)
    {
      parent[root(mesh.triangles[i][0])] = root(mesh.triangles[i][1]);
      parent[root(mesh.triangles[i][1])] = root(mesh.triangles[i][2]);
    }
  }
  std::vector<int> densest(mesh.vertices.size(), -1);
  for (int i = 0; i < n; ++i)
  {
    if (chart.map.density[i] > bound)
    {
      int& d = densest[root(mesh.triangles[i][0])];
      if (d < 0 || chart.map.density[i] > chart.map.density[d])
      {
        d = i;
      }
    }
  }
  // Shortest paths to the boundary.
  std::vector<std::vector<std::pair<int, int>>> out(mesh.vertices.size()); // halfedges to other
                                                                           // vertices
  for (int i = 0; i < n; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int h = 3 * mesh.faces[i] + k;
      if (!surface.cut[h])
      {
        out[mesh.triangles[i][k]].push_back({ mesh.triangles[i][(k + 1) % 3], h });
      }
    }
  }
  std::vector<double> distance(mesh.vertices.size(), Infinity);
  std::vector<std::pair<int, int>> toward(mesh.vertices.size(), { -1, -1 });
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (int v : mesh.boundary)
  {
    distance[v] = 0;
    front.push({ 0., v });
  }
  while (!front.empty())
  {
    const auto [d, v] = front.top();
    front.pop();
    if (d > distance[v])
    {
      continue;
    }
    for (const auto& [w, h] : out[v])
    {
      const double step =
        (surface.points[mesh.vertices[w]] - surface.points[mesh.vertices[v]]).norm();
      if (d + step < distance[w])
      {
        distance[w] = d + step;
        toward[w] = { v, h };
        front.push({ d + step, w });
      }
    }
  }
  bool changed = false;
  for (int d : densest)
  {
    if (d < 0)
    {
      continue;
    }
    const Triangle& t = mesh.triangles[d];
    int v = *std::max_element(
      t.begin(), t.end(), [&](int a, int b) { return distance[a] < distance[b]; });
    while (toward[v].first >= 0 && !surface.cut[toward[v].second])
    {
      surface.setCut(toward[v].second, true);
      changed = true;
      v = toward[v].first;
    }
  }
  return changed;
}

/// Splits the longest boundary edge of a chart; returns the new faces with the faces that they were
/// part of.
std::vector<std::array<int, 2>> splitLongestBoundaryEdge(CutSurface& surface, const Faces& faces)
{
  int longest = -1;
  double length = -1;
  for (int f : faces)
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
  std::vector<std::array<int, 2>> added = { { surface.numberOfFaces(), longest / 3 } };
  if (surface.twin[longest] >= 0)
  {
    added.push_back({ surface.numberOfFaces() + 1, surface.twin[longest] / 3 });
  }
  surface.splitEdge(longest, 0.5);
  return added;
}

/// Farthest-point Voronoi regions of the whole surface, at least one a component, as many as asked
/// for.
void startWithVoronoi(CutSurface& surface, int numberOfCharts)
{
  const std::vector<Faces> components = chartFaces(surface);
  VoronoiRegions regions(surface);
  Faces all(surface.numberOfFaces());
  std::iota(all.begin(), all.end(), 0);
  int owners = 0;
  for (const Faces& component : components)
  {
    regions.addSeed(component.front(), owners);
    const int far = regions.farthest(component);
    regions.forget(component);
    regions.addSeed(far, owners++);
  }
  while (owners < std::min(numberOfCharts, surface.numberOfFaces()))
  {
    regions.addSeed(regions.farthest(all), owners++);
  }
  regions.removeSpikes(all);
  cutBetweenOwners(surface, regions, all, owners);
}

struct Candidate
{
  Faces faces;
  int cutRounds = 0; ///< how often cuts into the chart have been tried
  double previousRatio = Infinity;
};

/// Adds a face that a split made to the chart of its parent; a finished chart has to be flattened
/// again.
void adopt(int added, int parent, std::vector<Candidate>& pending, std::vector<FlatChart>& finished)
{
  for (Candidate& c : pending)
  {
    if (std::find(c.faces.begin(), c.faces.end(), parent) != c.faces.end())
    {
      c.faces.push_back(added);
      return;
    }
  }
  for (auto chart = finished.begin(); chart != finished.end(); ++chart)
  {
    Faces& faces = chart->mesh.faces;
    if (std::binary_search(faces.begin(), faces.end(), parent))
    {
      faces.push_back(added);
      pending.push_back({ std::move(faces) });
      finished.erase(chart);
      return;
    }
  }
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
  startWithVoronoi(surface, options.numberOfCharts);
  std::vector<Candidate> pending;
  for (Faces& faces : chartFaces(surface))
  {
    pending.push_back({ std::move(faces) });
  }
  std::size_t done = 0;
  while (!pending.empty())
  {
    if (!report(progress, static_cast<double>(done) / static_cast<double>(surface.numberOfFaces())))
    {
      return Status::aborted();
    }
    // Topology first: bisect until every chart is a disk.
    std::vector<Candidate> disks;
    for (std::size_t i = 0; i < pending.size(); ++i)
    {
      const ChartMesh mesh = extractChart(surface, pending[i].faces);
      if (mesh.isDisk())
      {
        disks.push_back(std::move(pending[i]));
        continue;
      }
      const Faces faces = std::move(pending[i].faces);
      for (Faces& part : bisect(surface, faces, -1))
      {
        pending.push_back({ std::move(part) });
      }
    }
    // A rectangle's corners need four boundary vertices; the neighbour across a split edge changes
    // too.
    for (std::size_t i = 0; i < disks.size(); ++i)
    {
      while (extractChart(surface, disks[i].faces).boundary.size() < 4)
      {
        for (const auto& [added, parent] : splitLongestBoundaryEdge(surface, disks[i].faces))
        {
          adopt(added, parent, disks, charts);
        }
      }
    }
    for (Candidate& c : disks)
    {
      splitChords(surface, c.faces);
    }
    std::vector<FlatChart> flat(disks.size());
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(disks.size()), 1, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType i = begin; i < end; ++i)
        {
          flat[i].mesh = extractChart(surface, disks[i].faces);
          flat[i].map = mapToRectangle(surface, flat[i].mesh, { options.square });
        }
      });
    std::vector<Candidate> next;
    for (std::size_t i = 0; i < disks.size(); ++i)
    {
      Candidate& c = disks[i];
      const ConformalMap& map = flat[i].map;
      if (map.valid && map.densityRatio <= options.maximumDensityRatio)
      {
        done += c.faces.size();
        charts.push_back(std::move(flat[i]));
        continue;
      }
      if (c.faces.size() <= 2)
      {
        return Status::error(
          "A chart of two triangles can't be flattened: the surface has triangles too thin "
          "for double precision; repair it first.");
      }
      const bool helping = c.cutRounds == 0 || map.densityRatio < 0.5 * c.previousRatio;
      if (map.valid && helping && c.cutRounds < 8 &&
        cutToDensePlaces(surface, flat[i], options.maximumDensityRatio))
      {
        next.push_back({ std::move(c.faces), c.cutRounds + 1, map.densityRatio });
        continue;
      }
      int densest = -1;
      if (map.valid)
      {
        densest = flat[i].mesh.faces[std::max_element(map.density.begin(), map.density.end()) -
          map.density.begin()];
      }
      for (Faces& part : bisect(surface, c.faces, densest))
      {
        next.push_back({ std::move(part) });
      }
    }
    pending = std::move(next);
  }
  return Status::success();
}
}
