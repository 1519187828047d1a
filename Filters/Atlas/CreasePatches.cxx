// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CreasePatches.h"

#include "AtlasConstants.h"
#include "ConformalMap.h"
#include "FaceSets.h"
#include "ShortestPaths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
/// The patches, the negligible ones joined to their neighbours.
class Patches
{
public:
  explicit Patches(const CutSurface& surface)
    : Surface(surface)
    , Sets(surface, [&](Halfedge h) { return !surface.isCrease(h); })
    , Joined(this->Sets.number)
    , Area(this->Sets.number, 0.)
    , LeastArea(this->Sets.number, 0.)
    , Curvature(this->Sets.number, 0.)
    , Rim(this->Sets.number)
    , Beside(this->Sets.number)
  {
    const FaceSets components(surface, [](Halfedge) { return true; });
    std::iota(this->Joined.begin(), this->Joined.end(), 0);
    std::vector<double> whole(components.number, 0.);
    std::vector<char> onRim(surface.points.size(), 0);
    for (const Face f : surface.faces())
    {
      const double area = surface.faceArea(f);
      this->Area[this->Sets.of[f]] += area;
      whole[components.of[f]] += area;
    }
    for (const Face f : surface.faces())
    {
      const int patch = this->Sets.of[f];
      this->LeastArea[patch] = NegligibleArea * whole[components.of[f]];
      for (const Halfedge h : halfedgesOf(f))
      {
        const int across = surface.isBoundary(h) ? patch : this->Sets.of[faceOf(surface.twin[h])];
        if (across != patch)
        {
          this->Beside[patch][across] += surface.edgeLength(h);
          this->Rim[patch].push_back(h);
          onRim[surface.tail(h).index()] = onRim[surface.head(h).index()] = 1;
        }
      }
    }
    std::vector<double> defect(surface.points.size(), 2 * Pi);
    std::vector<int> patchOf(surface.points.size(), -1);
    for (const Halfedge h : surface.halfedges())
    {
      const int v = surface.tail(h).index();
      const Vec3 a = surface.edge(h);
      const Vec3 b = -surface.edge(previousHalfedge(h));
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      defect[v] -= angle;
      patchOf[v] = this->Sets.of[faceOf(h)];
      if ((onRim[v] & 1) != 0)
      {
        this->Angle[{ v, patchOf[v] }] += angle;
      }
      onRim[v] |= surface.isBoundary(h) ? 2 : 0;
      onRim[surface.head(h).index()] |= surface.isBoundary(h) ? 2 : 0;
    }
    for (std::size_t v = 0; v < defect.size(); ++v)
    {
      if (!onRim[v] && patchOf[v] >= 0)
      {
        this->Curvature[patchOf[v]] += std::abs(defect[v]);
      }
    }
    this->joinNegligible();
  }

  int operator()(Face face) const { return this->find(this->Sets.of[face]); }

private:
  int find(int patch) const
  {
    while (this->Joined[patch] != patch)
    {
      patch = this->Joined[patch];
    }
    return patch;
  }

  /// Each patch is looked at once, the smallest first.
  void joinNegligible()
  {
    std::vector<int> order(this->Joined.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
      order.begin(), order.end(), [&](int a, int b) { return this->Area[a] < this->Area[b]; });
    for (const int patch : order)
    {
      if (this->find(patch) != patch || this->Area[patch] >= this->LeastArea[patch])
      {
        continue;
      }
      std::map<int, double> shared; // length of outline by neighbour, as patches are now
      for (const auto& [neighbour, length] : this->Beside[patch])
      {
        shared[this->find(neighbour)] += length;
      }
      shared.erase(patch);
      const auto most = std::max_element(shared.begin(), shared.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; });
      if (most == shared.end())
      {
        continue;
      }
      const int into = most->first;
      if (this->closesSleeve(patch, into, most->second))
      {
        continue;
      }
      this->Joined[patch] = into;
      this->Area[into] += this->Area[patch];
      this->Rim[into].insert(
        this->Rim[into].end(), this->Rim[patch].begin(), this->Rim[patch].end());
      for (const auto& [neighbour, length] : this->Beside[patch])
      {
        this->Beside[into][neighbour] += length;
      }
    }
  }

  /// Whether a patch is the end of another one, which is a sleeve, can be unrolled, and is deeper
  /// than any map (cutDeepSleeve()). Along the end of a tube the tube does not
  /// turn; around a hole in a plane the plane does, by -2 pi.
  bool closesSleeve(int patch, int into, double length) const
  {
    if (this->Curvature[into] > Constants::MostCurvatureOfSleeve ||
      this->Area[into] <= Constants::DeepSleeve * length * length)
    {
      return false;
    }
    double turn = 0;
    for (const Halfedge h : this->Rim[patch])
    {
      const int across = this->find(this->Sets.of[faceOf(this->Surface.twin[h])]);
      if (across == patch)
      {
        continue; // inside what has been joined
      }
      if (across != into)
      {
        return false;
      }
      const int v = this->Surface.tail(h).index();
      turn += Pi;
      for (auto at = this->Angle.lower_bound({ v, 0 });
           at != this->Angle.end() && at->first.first == v; ++at)
      {
        turn -= this->find(at->first.second) == into ? at->second : 0.;
      }
    }
    return turn > -Pi;
  }

  const CutSurface& Surface;
  FaceSets Sets;
  std::vector<int> Joined; // the patch it has gone to, or itself
  std::vector<double> Area;
  std::vector<double> LeastArea;
  std::vector<double> Curvature;               // total of its inner points
  std::vector<std::vector<Halfedge>> Rim;      // what is not inside it, or was not
  std::map<std::pair<int, int>, double> Angle; // by point on a rim and patch
  std::vector<std::map<int, double>> Beside;   // length of the common outline, by neighbour
};
}

void cutAlongCreases(CutSurface& surface)
{
  if (std::none_of(surface.sharp.begin(), surface.sharp.end(),
        [](char mark) { return mark != 0 && mark != CutSurface::Rounded; }))
  {
    return; // no crease: nothing to find out
  }
  const Patches patch(surface);
  for (const Halfedge h : surface.halfedges())
  {
    if (!surface.isBoundary(h) && patch(faceOf(surface.twin[h])) != patch(faceOf(h)))
    {
      surface.setCut(h, true);
    }
  }
}

bool isNearlyDevelopable(const TriangleSurface& surface, const ChartMesh& chart)
{
  std::vector<double> defect(chart.vertices.size(), 2 * Pi);
  for (const Triangle& t : chart.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& p = surface.points[chart.vertices[t[k]]];
      const Vec3 a = surface.points[chart.vertices[t[nextCorner(k)]]] - p;
      const Vec3 b = surface.points[chart.vertices[t[previousCorner(k)]]] - p;
      defect[t[k]] -= std::atan2(a.cross(b).norm(), a.dot(b));
    }
  }
  double positive = 0;
  double negative = 0;
  for (std::size_t v = 0; v < defect.size(); ++v)
  {
    if (!chart.onBoundary[v])
    {
      (defect[v] > 0 ? positive : negative) += std::abs(defect[v]);
    }
  }
  return 2 * Pi + negative <= Constants::MostSquaredStretch * (2 * Pi - positive);
}

std::vector<Halfedge> joinLoops(ChartRegions& regions, int region)
{
  // It ends: a path from a loop to the nearest point of the others makes one of two.
  std::vector<Halfedge> opened;
  ChartMesh mesh = regions.mesh(region);
  while (mesh.boundaryLoops > 1 && !regions.isStopped())
  {
    ShortestPaths toFirst(regions.surface(), mesh);
    toFirst.addTargets(mesh.boundary, regions.stop());
    std::vector<char> isFirst(mesh.vertices.size(), 0);
    for (const int v : mesh.boundary)
    {
      isFirst[v] = 1;
    }
    int nearest = -1;
    for (int v = 0; v < mesh.numberOfVertices(); ++v)
    {
      if (mesh.onBoundary[v] && !isFirst[v] &&
        (nearest < 0 || toFirst.distance(v) < toFirst.distance(nearest)))
      {
        nearest = v;
      }
    }
    const std::vector<Halfedge> cuts = regions.cutAlong(mesh, toFirst.path(nearest));
    opened.insert(opened.end(), cuts.begin(), cuts.end());
    mesh = regions.mesh(region);
  }
  return opened;
}
}
