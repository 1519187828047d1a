// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CreasePatches.h"

#include "ConformalMap.h"
#include "ShortestPaths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace stipple
{
namespace
{
/// Sets of triangles that are connected across some edges, numbered by their first triangle.
template <typename IsOpen>
std::vector<int> connectedSets(const CutSurface& surface, const IsOpen& isOpen)
{
  std::vector<int> set(surface.triangles.size(), -1);
  std::vector<int> faces;
  int sets = 0;
  for (int start = 0; start < surface.numberOfFaces(); ++start)
  {
    if (set[start] >= 0)
    {
      continue;
    }
    set[start] = sets;
    faces = { start };
    while (!faces.empty())
    {
      const int f = faces.back();
      faces.pop_back();
      for (int h = 3 * f; h < 3 * f + 3; ++h)
      {
        const int g = surface.twin[h];
        if (g >= 0 && isOpen(h) && set[g / 3] < 0)
        {
          set[g / 3] = sets;
          faces.push_back(g / 3);
        }
      }
    }
    ++sets;
  }
  return set;
}

/// The patches, the negligible ones joined to their neighbours.
class Patches
{
public:
  explicit Patches(const CutSurface& surface)
    : OfFace(connectedSets(surface, [&](int h) { return !surface.sharp[h]; }))
  {
    const std::vector<int> component = connectedSets(surface, [](int) { return true; });
    const std::size_t n =
      this->OfFace.empty() ? 0 : *std::max_element(this->OfFace.begin(), this->OfFace.end()) + 1;
    this->Joined.resize(n);
    std::iota(this->Joined.begin(), this->Joined.end(), 0);
    this->Area.resize(n, 0.);
    this->LeastArea.resize(n, 0.);
    this->Beside.resize(n);
    std::vector<double> whole(n, 0.); // by component: there are not more of them than patches
    for (int f = 0; f < surface.numberOfFaces(); ++f)
    {
      const double area = surface.faceArea(f);
      this->Area[this->OfFace[f]] += area;
      whole[component[f]] += area;
    }
    for (int f = 0; f < surface.numberOfFaces(); ++f)
    {
      const int patch = this->OfFace[f];
      this->LeastArea[patch] = NegligibleArea * whole[component[f]];
      for (const Halfedge h : halfedgesOf(Face(f)))
      {
        const int across =
          surface.isBoundary(h) ? patch : this->OfFace[surface.twin[h].index() / 3];
        if (across != patch)
        {
          this->Beside[patch][across] += surface.edgeLength(h);
        }
      }
    }
    this->joinNegligible();
  }

  int operator()(int face) const { return this->find(this->OfFace[face]); }

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
      this->Joined[patch] = into;
      this->Area[into] += this->Area[patch];
      for (const auto& [neighbour, length] : this->Beside[patch])
      {
        this->Beside[into][neighbour] += length;
      }
    }
  }

  std::vector<int> OfFace;
  std::vector<int> Joined; // the patch it has gone to, or itself
  std::vector<double> Area;
  std::vector<double> LeastArea;
  std::vector<std::map<int, double>> Beside; // length of the common outline, by neighbour
};
}

void cutAlongCreases(CutSurface& surface)
{
  const Patches patch(surface);
  for (int h = 0; h < surface.numberOfHalfedges(); ++h)
  {
    if (!surface.isBoundary(h) && patch(surface.twin[h] / 3) != patch(h / 3))
    {
      surface.setCut(h, true);
    }
  }
}

bool isNearlyDevelopable(const TriangleSurface& surface, const ChartMesh& chart)
{
  constexpr double Pi = 3.14159265358979323846;
  constexpr double MostSquaredStretch = 2;
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
  return 2 * Pi + negative <= MostSquaredStretch * (2 * Pi - positive);
}

std::vector<int> joinLoops(ChartRegions& regions, int region)
{
  // It ends: a path from a loop to the nearest point of the others makes one of two.
  std::vector<int> opened;
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
    const std::vector<int> cuts = regions.cutAlong(mesh, toFirst.path(nearest));
    opened.insert(opened.end(), cuts.begin(), cuts.end());
    mesh = regions.mesh(region);
  }
  return opened;
}
}
