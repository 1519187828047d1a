// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AcuteCorners.h"

#include "Tuning.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace stipple
{
namespace
{
/// A crease, as it leaves a corner.
struct Crease
{
  const Atlas& atlas;
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
std::optional<Crease> creaseFrom(const OptimizedMesh& mesh, Vertex corner, Vertex first)
{
  if (mesh.freedom(first) == Freedom::Backbone)
  {
    const int b = mesh.backbone(first);
    const std::vector<Vertex>& chain = mesh.chains()[b];
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
  const double room = std::min(a.length(), b.length()) / spacing - Tuning::LeastBeyondOpening;
  for (double distance = 1.; distance <= std::min(Tuning::FarthestOpening, room);
       distance += Tuning::StepOfOpening)
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
  for (const Face f : mesh.faces())
  {
    const auto [a, b, c] = mesh.corners(f);
    total += mesh.faceArea(f) * (mesh.density(a) + mesh.density(b) + mesh.density(c)) / 3.;
  }
  return std::sqrt(2. / std::sqrt(3.) * total / mesh.vertices().size());
}
}

CoarseRegions findAcuteCorners(const OptimizedMesh& mesh, double angle)
{
  CoarseRegions regions;
  const double unit = spacingAtUnitDensity(mesh);
  for (const Vertex v : mesh.vertices())
  {
    if (mesh.freedom(v) != Freedom::None)
    {
      continue;
    }
    const double spacing = unit / std::sqrt(mesh.density(v));
    double distance = 1;
    mesh.forEachCorner(v, [&](Halfedge h) {
      const Halfedge g = mesh.previous(h);
      if (!mesh.isCrease(mesh.edge(h)) || !mesh.isCrease(mesh.edge(g)))
      {
        return;
      }
      const auto a = creaseFrom(mesh, v, mesh.to(h));
      const auto b = creaseFrom(mesh, v, mesh.from(g));
      if (a && b)
      {
        distance = std::max(distance, distanceWhereOpen(mesh.position(v), *a, *b, spacing, angle));
      }
    });
    if (distance > 1.)
    {
      regions.add(mesh.atlas().surface(), Face(mesh.place(v).face),
        { mesh.position(v), spacing, 1. + Tuning::ShareOfOpening * (distance - 1.) });
    }
  }
  return regions;
}
}
