// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityCuts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace stipple
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The densest triangle of every connected part of the chart that is denser than the bound; the
/// densest first.
std::vector<int> densestTriangles(const FlatChart& chart, double bound)
{
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
  std::vector<int> densest(mesh.vertices.size(), -1);
  for (int i = 0; i < n; ++i)
  {
    if (density[i] > bound)
    {
      int& d = densest[root(mesh.triangles[i][0])];
      if (d < 0 || density[i] > density[d])
      {
        d = i;
      }
    }
  }
  densest.erase(std::remove(densest.begin(), densest.end(), -1), densest.end());
  std::sort(densest.begin(), densest.end(),
    [&](int a, int b) { return density[a] > density[b] || (density[a] == density[b] && a < b); });
  return densest;
}

/// Shortest edge paths from every vertex of a chart to its boundary.
struct BoundaryDistance
{
  std::vector<double> distance;
  std::vector<int> end; // the path's end on the boundary
};

BoundaryDistance distanceToBoundary(const TriangleSurface& surface, const ChartMesh& mesh)
{
  std::vector<std::vector<int>> neighbours(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      neighbours[t[k]].push_back(t[(k + 1) % 3]);
      neighbours[t[(k + 1) % 3]].push_back(t[k]);
    }
  }
  BoundaryDistance paths = { std::vector<double>(mesh.vertices.size(), Infinity),
    std::vector<int>(mesh.vertices.size(), -1) };
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (int v : mesh.boundary)
  {
    paths.distance[v] = 0;
    paths.end[v] = v;
    front.push({ 0., v });
  }
  while (!front.empty())
  {
    const auto [d, v] = front.top();
    front.pop();
    if (d > paths.distance[v])
    {
      continue;
    }
    for (int w : neighbours[v])
    {
      const double there =
        d + (surface.points[mesh.vertices[w]] - surface.points[mesh.vertices[v]]).norm();
      if (there < paths.distance[w])
      {
        paths.distance[w] = there;
        paths.end[w] = paths.end[v];
        front.push({ there, w });
      }
    }
  }
  return paths;
}

/// A halfedge of the region that leaves a point.
int halfedgeFrom(const ChartRegions& regions, int region, int point)
{
  for (int f : regions.faces(region))
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (regions.surface().tail(h) == point)
      {
        return h;
      }
    }
  }
  return -1;
}

/// Cuts a region along straight lines of its conformal plane.
class StraightCuts
{
public:
  StraightCuts(ChartRegions& regions, const FlatChart& chart)
    : Regions(regions)
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

  /// From the tail of h, inside the region, towards a point of the plane as far as the next cut.
  /// False if the tail is on a cut itself.
  bool cut(int h, const Vec2& target)
  {
    if (this->numberOfCutsAround(h) > 0)
    {
      return false;
    }
    do
    {
      h = this->step(h, target);
    } while (h >= 0 && this->numberOfCutsAround(h) == 1);
    return true;
  }

private:
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
  CutSurface& Surface;
  std::vector<Vec2> UV; // by halfedge, of its tail
};
}

bool cutToDensePlaces(ChartRegions& regions, int region, const FlatChart& chart, double bound)
{
  const ChartMesh& mesh = chart.mesh;
  const BoundaryDistance paths = distanceToBoundary(regions.surface(), mesh);
  StraightCuts cuts(regions, chart);
  bool changed = false;
  for (int i : densestTriangles(chart, bound))
  {
    const Triangle& t = mesh.triangles[i];
    const int k = static_cast<int>(std::max_element(t.begin(), t.end(),
                                     [&](int a, int b) {
                                       return paths.distance[a] < paths.distance[b];
                                     }) -
      t.begin());
    const int h = halfedgeFrom(regions, region, mesh.vertices[t[k]]);
    changed = cuts.cut(h, chart.map.uv[paths.end[t[k]]]) || changed;
  }
  return changed;
}
}
