// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityCuts.h"

#include "AtlasConstants.h"
#include "ShortestPaths.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The densest triangles of the connected parts of the chart that are denser than the bound: of the
/// largest parts, as many as hold all but a sliver of the area that is too dense. Largest first.
std::vector<int> densestTriangles(const FlatChart& chart, double bound)
{
  const ChartMesh& mesh = chart.mesh;
  const std::vector<double>& density = chart.map.density;
  boost::disjoint_sets_with_storage<> sets(mesh.vertices.size());
  const int n = static_cast<int>(mesh.triangles.size());
  for (int i = 0; i < n; ++i)
  {
    if (density[i] > bound)
    {
      sets.union_set(mesh.triangles[i][0], mesh.triangles[i][1]);
      sets.union_set(mesh.triangles[i][1], mesh.triangles[i][2]);
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
    const double area = chart.map.area[i];
    total += area;
    if (density[i] > bound)
    {
      dense += area;
      Part& part = parts[sets.find_set(mesh.triangles[i][0])];
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
    if (dense <= Constants::DenseSliver * total)
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
    , UV(regions.surface().numberOfHalfedges(), Vec2::Zero())
  {
    spread(chart.mesh, chart.map.uv, this->UV);
  }

  /// Cuts along a path from inside the chart to its boundary, or to the next cut, with as few
  /// straight lines as are not much longer than the path. False if the path starts on a cut.
  bool cut(const FlatChart& chart, const ShortestPaths& paths, const std::vector<int>& path)
  {
    Halfedge h = this->halfedgeFrom(chart.mesh.vertices[path.front()]);
    if (this->Surface.numberOfCutsAround(h) > 0)
    {
      return false;
    }
    std::size_t from = 0;
    // A line ends at a later vertex of the path than the one before, at the next one at the latest.
    while (h.valid() && from + 1 < path.size())
    {
      std::size_t to = path.size() - 1;
      while (to > from + 1 &&
        this->lineLength(h, chart.map.uv[path[to]]) >
          Constants::LongestCut * (paths.distance(path[from]) - paths.distance(path[to])))
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
  Halfedge halfedgeFrom(int point) const
  {
    for (const Face f : this->Regions.faces(this->Region))
    {
      for (const Halfedge h : halfedgesOf(f))
      {
        if (this->Surface.tail(h).index() == point)
        {
          return h;
        }
      }
    }
    return {};
  }

  /// Cuts from the tail of h straight to a vertex. Returns a halfedge from there, or none if it
  /// ran into another cut.
  Halfedge cutLine(Halfedge h, const Vec2& target, int point)
  {
    // A straight line crosses a triangle once, and each step crosses one; steps beyond that are
    // rounding's, in triangles next to without area.
    for (int left = this->Surface.numberOfFaces(); left > 0 && h.valid(); --left)
    {
      h = this->step(h, target);
      if (!h.valid() || this->Surface.numberOfCutsAround(h) != 1)
      {
        return {};
      }
      if (this->Surface.tail(h).index() == point)
      {
        return h;
      }
    }
    return {};
  }

  /// Length in space of the straight line of the plane from the tail of h to a target, as far as
  /// the next cut.
  double lineLength(Halfedge h, const Vec2& target) const
  {
    const Halfedge first = this->towards(h, target);
    const Vec2 start = this->UV[first];
    Vec3 last = this->Surface.point(this->Surface.tail(first));
    double length = 0;
    Halfedge e = nextHalfedge(first); // the edge that the line leaves the triangle by
    for (int left = this->Surface.numberOfFaces(); left > 0; --left) // it crosses each once
    {
      const Vec2& a = this->UV[e];
      const Vec2& b = this->UV[nextHalfedge(e)];
      const bool inside = orient2(a, b, target) >= 0;
      const double toA = orient2(start, a, target);
      const double toB = orient2(start, target, b);
      const double t = toA + toB > 0 ? std::clamp(toA / (toA + toB), 0., 1.) : 0.5;
      const Vec3 there = (1 - t) * this->Surface.point(this->Surface.tail(e)) +
        t * this->Surface.point(this->Surface.head(e));
      length += (there - last).norm();
      last = there;
      if (inside || this->Surface.cut[e])
      {
        return length;
      }
      const Halfedge across = this->Surface.twin[e]; // from b to a
      const Vec2& apex = this->UV[previousHalfedge(across)];
      e = orient2(start, target, apex) > 0 ? nextHalfedge(across) : previousHalfedge(across);
    }
    return Infinity;
  }

  /// The triangle around the tail of h that the line to the target runs through, as the halfedge
  /// with that tail.
  Halfedge towards(Halfedge h, const Vec2& target) const
  {
    Halfedge best;
    double bestMargin = -Infinity;
    Halfedge g = h;
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

  /// Cuts through one triangle; returns a halfedge from where the cut has got to, none if the
  /// line runs along a cut.
  Halfedge step(Halfedge h, const Vec2& target)
  {
    const Halfedge g = this->towards(h, target);
    const Vec2& p = this->UV[g];
    const Vec2& a = this->UV[nextHalfedge(g)];
    const Vec2& b = this->UV[previousHalfedge(g)];
    const double toA = orient2(p, a, target);
    const double toB = orient2(p, target, b);
    const double t = toA + toB > 0 ? toA / (toA + toB) : 0.;
    if (t < Constants::NearestToVertex || t > 1 - Constants::NearestToVertex)
    {
      const Halfedge along = t < Constants::NearestToVertex ? g : previousHalfedge(g);
      if (this->Surface.cut[along])
      {
        return {};
      }
      this->Regions.cutOpen(along);
      return t < Constants::NearestToVertex ? nextHalfedge(g) : along;
    }
    const Halfedge across = nextHalfedge(g);
    this->split(across, t);
    this->Regions.cutOpen(nextHalfedge(across));
    return nextHalfedge(across);
  }

  void split(Halfedge h, double t)
  {
    const Halfedge g = this->Surface.twin[h];
    const Face added(this->Surface.numberOfFaces());
    this->Regions.splitEdge(h, t);
    this->UV.resize(this->Surface.numberOfHalfedges(), Vec2::Zero());
    const auto follow = [&](Halfedge side, Face half, double there) {
      const Vec2 middle = (1 - there) * this->UV[side] + there * this->UV[nextHalfedge(side)];
      followSplit(this->UV, side, half, middle);
    };
    follow(h, added, t);
    if (g.valid())
    {
      follow(g, Face(added.index() + 1), 1 - t);
    }
  }

  ChartRegions& Regions;
  int Region;
  CutSurface& Surface;
  ElementArray<Halfedge, Vec2> UV; // of its tail
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
  for (int i : densestTriangles(chart, bound))
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
  if (!(toBoundary.distance(deepest) > Constants::DeepSleeve * around))
  {
    return false;
  }
  regions.cutAlong(mesh, toBoundary.path(deepest));
  return true;
}
}
