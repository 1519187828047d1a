// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityCuts.h"

#include "ShortestPaths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stipple
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The densest triangles of the connected parts of the chart that are denser than the bound: of the
/// largest parts, as many as hold all but a sliver of the area that is too dense. Largest first.
std::vector<int> densestTriangles(
  const TriangleSurface& surface, const FlatChart& chart, double bound)
{
  constexpr double sliver = 5e-4; // of the chart's area; the bound leaves 1e-3 out of account
  const ChartMesh& mesh = chart.mesh;
  const std::vector<double>& density = chart.map.density;
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
  const int n = static_cast<int>(mesh.triangles.size());
  for (int i = 0; i < n; ++i)
  {
    if (density[i] > bound)
    {
      parent[root(mesh.triangles[i][0])] = root(mesh.triangles[i][1]);
      parent[root(mesh.triangles[i][1])] = root(mesh.triangles[i][2]);
    }
  }
  struct Part
  {
    double area = 0;
    int densest = -1;
  };
  std::vector<Part> parts(mesh.vertices.size());
  double total = 0;
  double dense = 0;
  for (int i = 0; i < n; ++i)
  {
    const double area = surface.faceArea(mesh.faces[i]);
    total += area;
    if (density[i] > bound)
    {
      dense += area;
      Part& part = parts[root(mesh.triangles[i][0])];
      part.area += area;
      if (part.densest < 0 || density[i] > density[part.densest])
      {
        part.densest = i;
      }
    }
  }
  parts.erase(
    std::remove_if(parts.begin(), parts.end(), [](const Part& part) { return part.densest < 0; }),
    parts.end());
  std::stable_sort(
    parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.area > b.area; });
  std::vector<int> densest;
  for (const Part& part : parts)
  {
    if (dense <= sliver * total)
    {
      break;
    }
    densest.push_back(part.densest);
    dense -= part.area;
  }
  return densest;
}

/// Cuts a region along straight lines of its conformal plane, which are smooth on the surface.
class StraightCuts
{
public:
  StraightCuts(ChartRegions& regions, int region, const FlatChart& chart)
    : Regions(regions)
    , Region(region)
    , Surface(regions.surface())
    , UV(3 * regions.surface().triangles.size(), Vec2::Zero())
  {
    for (std::size_t i = 0; i < chart.mesh.faces.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->UV[3 * chart.mesh.faces[i] + k] = chart.map.uv[chart.mesh.triangles[i][k]];
      }
    }
  }

  /// Cuts along a path from inside the chart to its boundary, or to the next cut, with as few
  /// straight lines as are not much longer than the path. False if the path starts on a cut.
  bool cut(const FlatChart& chart, const ShortestPaths& paths, const std::vector<int>& path)
  {
    int h = this->halfedgeFrom(chart.mesh.vertices[path.front()]);
    if (this->numberOfCutsAround(h) > 0)
    {
      return false;
    }
    constexpr double longest = 1.1; // times the path
    std::size_t from = 0;
    // A line ends at a later vertex of the path than the one before, at the next one at the latest.
    while (h >= 0 && from + 1 < path.size())
    {
      std::size_t to = path.size() - 1;
      while (to > from + 1 &&
        this->lineLength(h, chart.map.uv[path[to]]) >
          longest * (paths.distance(path[from]) - paths.distance(path[to])))
      {
        to = from + (to - from) / 2;
      }
      h = this->cutLine(h, chart.map.uv[path[to]], chart.mesh.vertices[path[to]]);
      from = to;
    }
    return true;
  }

private:
  /// A halfedge of the region that leaves a point.
  int halfedgeFrom(int point) const
  {
    for (int f : this->Regions.faces(this->Region))
    {
      for (int h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (this->Surface.tail(h) == point)
        {
          return h;
        }
      }
    }
    return -1;
  }

  /// Cuts from the tail of h straight to a vertex. Returns a halfedge from there, or -1 if it ran
  /// into another cut.
  int cutLine(int h, const Vec2& target, int point)
  {
    // A straight line crosses a triangle once, and each step crosses one; steps beyond that are
    // rounding's, in triangles next to without area.
    for (int left = this->Surface.numberOfFaces(); left > 0 && h >= 0; --left)
    {
      h = this->step(h, target);
      if (h < 0 || this->numberOfCutsAround(h) != 1)
      {
        return -1;
      }
      if (this->Surface.tail(h) == point)
      {
        return h;
      }
    }
    return -1;
  }

  /// Length in space of the straight line of the plane from the tail of h to a target, as far as
  /// the next cut.
  double lineLength(int h, const Vec2& target) const
  {
    const int first = this->towards(h, target);
    const Vec2 start = this->UV[first];
    Vec3 last = this->Surface.points[this->Surface.tail(first)];
    double length = 0;
    int e = nextHalfedge(first); // the edge that the line leaves the triangle by
    for (int left = this->Surface.numberOfFaces(); left > 0; --left) // it crosses each once
    {
      const Vec2& a = this->UV[e];
      const Vec2& b = this->UV[nextHalfedge(e)];
      const bool inside = orient2(a, b, target) >= 0;
      const double toA = orient2(start, a, target);
      const double toB = orient2(start, target, b);
      const double t = toA + toB > 0 ? std::clamp(toA / (toA + toB), 0., 1.) : 0.5;
      const Vec3 there = (1 - t) * this->Surface.points[this->Surface.tail(e)] +
        t * this->Surface.points[this->Surface.head(e)];
      length += (there - last).norm();
      last = there;
      if (inside || this->Surface.cut[e])
      {
        return length;
      }
      const int across = this->Surface.twin[e]; // from b to a
      const Vec2& apex = this->UV[previousHalfedge(across)];
      e = orient2(start, target, apex) > 0 ? nextHalfedge(across) : previousHalfedge(across);
    }
    return Infinity;
  }

  /// Cuts around the tail of h.
  int numberOfCutsAround(int h) const
  {
    int cuts = 0;
    int g = h;
    do
    {
      cuts += this->Surface.cut[g];
      if (this->Surface.twin[g] < 0)
      {
        return cuts + 1;
      }
      g = nextHalfedge(this->Surface.twin[g]);
    } while (g != h);
    return cuts;
  }

  /// The triangle around the tail of h that the line to the target runs through, as the halfedge
  /// with that tail.
  int towards(int h, const Vec2& target) const
  {
    int best = -1;
    double bestMargin = -Infinity;
    int g = h;
    do
    {
      const Vec2 a = this->UV[nextHalfedge(g)] - this->UV[g];
      const Vec2 b = this->UV[previousHalfedge(g)] - this->UV[g];
      const Vec2 d = target - this->UV[g];
      const double margin = std::min(cross2(a, d) / a.norm(), cross2(d, b) / b.norm());
      if (margin > bestMargin)
      {
        best = g;
        bestMargin = margin;
      }
      g = nextHalfedge(this->Surface.twin[g]);
    } while (g != h);
    return best;
  }

  /// Cuts through one triangle; returns a halfedge from where the cut has got to, -1 if the line
  /// runs along a cut.
  int step(int h, const Vec2& target)
  {
    constexpr double nearest = 0.05; // of an edge's length: closer to a vertex the cut goes there
    const int g = this->towards(h, target);
    const Vec2& p = this->UV[g];
    const Vec2& a = this->UV[nextHalfedge(g)];
    const Vec2& b = this->UV[previousHalfedge(g)];
    const double toA = orient2(p, a, target);
    const double toB = orient2(p, target, b);
    const double t = toA + toB > 0 ? toA / (toA + toB) : 0.;
    if (t < nearest || t > 1 - nearest)
    {
      const int along = t < nearest ? g : previousHalfedge(g);
      if (this->Surface.cut[along])
      {
        return -1;
      }
      this->Regions.cutOpen(along);
      return t < nearest ? nextHalfedge(g) : along;
    }
    const int across = nextHalfedge(g);
    this->split(across, t);
    this->Regions.cutOpen(nextHalfedge(across));
    return nextHalfedge(across);
  }

  void split(int h, double t)
  {
    const int g = this->Surface.twin[h];
    int added = 3 * this->Surface.numberOfFaces();
    this->Regions.splitEdge(h, t);
    this->UV.resize(3 * this->Surface.triangles.size(), Vec2::Zero());
    for (int side : { h, g })
    {
      if (side < 0)
      {
        continue;
      }
      const double there = side == h ? t : 1 - t;
      const Vec2 tail = this->UV[side];
      const Vec2 head = this->UV[nextHalfedge(side)];
      const Vec2 middle = (1 - there) * tail + there * head;
      this->UV[added] = middle;
      this->UV[added + 1] = head;
      this->UV[added + 2] = this->UV[previousHalfedge(side)];
      this->UV[nextHalfedge(side)] = middle;
      added += 3;
    }
  }

  ChartRegions& Regions;
  int Region;
  CutSurface& Surface;
  std::vector<Vec2> UV; // by halfedge, of its tail
};
}

bool cutToDensePlaces(ChartRegions& regions, int region, const FlatChart& chart, double bound)
{
  const ChartMesh& mesh = chart.mesh;
  ShortestPaths toBoundary(regions.surface(), mesh);
  toBoundary.addTargets(mesh.boundary, regions.stop());
  // A place that is nearer to a new cut than to the boundary waits: another time a cut from there
  // will join that one, rather than run beside it.
  ShortestPaths toCuts = toBoundary;
  StraightCuts cuts(regions, region, chart);
  bool changed = false;
  for (int i : densestTriangles(regions.surface(), chart, bound))
  {
    if (regions.isStopped())
    {
      break;
    }
    const Triangle& t = mesh.triangles[i];
    const int tip = *std::max_element(t.begin(), t.end(),
      [&](int a, int b) { return toBoundary.distance(a) < toBoundary.distance(b); });
    const std::vector<int> path = toBoundary.path(tip);
    if (toCuts.distance(tip) == toBoundary.distance(tip) && cuts.cut(chart, toBoundary, path))
    {
      toCuts.addTargets(path, regions.stop());
      changed = true;
    }
  }
  return changed;
}

bool cutDeepSleeve(ChartRegions& regions, const FlatChart& chart)
{
  // Its deepest triangles would be as small as double precision's last digit: e^(-2 pi 6) is 4e-17.
  constexpr double Deep = 6; // boundary lengths
  const CutSurface& surface = regions.surface();
  const ChartMesh& mesh = chart.mesh;
  ShortestPaths toBoundary(surface, mesh);
  toBoundary.addTargets(mesh.boundary, regions.stop());
  double around = 0;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const int next = mesh.boundary[(i + 1) % mesh.boundary.size()];
    around +=
      (surface.points[mesh.vertices[next]] - surface.points[mesh.vertices[mesh.boundary[i]]])
        .norm();
  }
  int deepest = 0;
  for (int v = 1; v < mesh.numberOfVertices(); ++v)
  {
    deepest = toBoundary.distance(v) > toBoundary.distance(deepest) ? v : deepest;
  }
  if (!(toBoundary.distance(deepest) > Deep * around))
  {
    return false;
  }
  regions.cutAlong(mesh, toBoundary.path(deepest));
  return true;
}
}
