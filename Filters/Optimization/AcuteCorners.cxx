// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AcuteCorners.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace stipple
{
namespace
{
/// In spacings: how far out the first points may go, and what must be left of a crease beyond.
constexpr double Farthest = 3.4;
constexpr double LeastBeyond = 2.;
constexpr double Step = 0.05;
/// The triangle is better with its two points at unequal distances: spacing need not grow by all of
/// the way. Found by trial.
constexpr double ShareOfWay = 0.75;

/// A crease, as it leaves a corner.
struct Crease
{
  const SurfaceCache& atlas;
  int backbone;
  bool fromEnd;

  double length() const { return this->atlas.traces()[this->backbone].length(); }
  Vec3 at(double distance) const
  {
    const SurfacePlace place = this->atlas.placeOfBackbone(
      this->backbone, this->fromEnd ? this->length() - distance : distance);
    return this->atlas.surface().position(place.face, place.bary);
  }
};

/// The one that leaves a corner towards a vertex, if it ends there.
std::optional<Crease> creaseFrom(const OptimizedMesh& mesh, int corner, int first)
{
  if (mesh.freedom(first) == Freedom::Backbone)
  {
    const int b = mesh.backbone(first);
    const std::vector<int>& chain = mesh.chains()[b];
    const std::size_t n = chain.size();
    for (const bool fromEnd : { false, true })
    {
      if (chain[fromEnd ? n - 1 : 0] == corner && chain[fromEnd ? n - 2 : 1] == first)
      {
        return Crease{ mesh.atlas(), b, fromEnd };
      }
    }
  }
  return std::nullopt;
}

/// At what distance from the corner, in spacings, two creases have opened to an angle; 1 if they
/// have where their first points would be anyway, or nowhere near.
double distanceWhereOpen(
  const Vec3& corner, const Crease& a, const Crease& b, double spacing, double angle)
{
  const double room = std::min(a.length(), b.length()) / spacing - LeastBeyond;
  for (double distance = 1.; distance <= std::min(Farthest, room); distance += Step)
  {
    const double s = distance * spacing;
    if (cotangent(corner, a.at(s), b.at(s)) <= 1. / std::tan(angle))
    {
      return distance;
    }
  }
  return 1.;
}

/// Edge length of a lattice that has as many vertices as the mesh at a density of 1.
double spacingAtUnitDensity(const OptimizedMesh& mesh)
{
  double total = 0;
  for (int f = 0; f < mesh.numberOfFaces(); ++f)
  {
    const auto t = mesh.corners(f);
    total += triangleArea(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])) *
      (mesh.density(t[0]) + mesh.density(t[1]) + mesh.density(t[2])) / 3.;
  }
  return std::sqrt(2. / std::sqrt(3.) * total / mesh.numberOfVertices());
}
}

CoarseRegions findAcuteCorners(const OptimizedMesh& mesh, double angle)
{
  CoarseRegions regions;
  const auto& graph = mesh.graph();
  const double unit = spacingAtUnitDensity(mesh);
  for (int v = 0; v < mesh.numberOfVertices(); ++v)
  {
    if (mesh.freedom(v) != Freedom::None)
    {
      continue;
    }
    const double spacing = unit / std::sqrt(mesh.density(v));
    double distance = 1;
    mesh.forEachHalfedge(v, [&](OptimizedMesh::Halfedge h) {
      const auto g = graph.prev_halfedge_handle(h);
      if (graph.is_boundary(h) || !mesh.isFeature(graph.edge_handle(h).idx()) ||
        !mesh.isFeature(graph.edge_handle(g).idx()))
      {
        return;
      }
      const auto a = creaseFrom(mesh, v, graph.to_vertex_handle(h).idx());
      const auto b = creaseFrom(mesh, v, graph.from_vertex_handle(g).idx());
      if (a && b)
      {
        distance = std::max(distance, distanceWhereOpen(mesh.position(v), *a, *b, spacing, angle));
      }
    });
    if (distance > 1.)
    {
      regions.add(mesh.atlas().surface(), mesh.place(v).face,
        { mesh.position(v), spacing, 1. + ShareOfWay * (distance - 1.) });
    }
  }
  return regions;
}
}
