// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AcuteCorners.h"

#include "Relaxation.h"
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
struct LeavingCrease
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
std::optional<LeavingCrease> creaseFrom(const OptimizedMesh& mesh, Vertex corner, Vertex first)
{
  if (mesh.freedom(first) == Freedom::Backbone)
  {
    const int b = mesh.backbone(first);
    const OptimizedMesh::Chain& chain = mesh.chains()[b];
    const std::size_t n = chain.size();
    for (const bool fromEnd : { false, true })
    {
      if (chain[fromEnd ? n - 1 : 0].vertex == corner && chain[fromEnd ? n - 2 : 1].vertex == first)
      {
        return LeavingCrease{ mesh.atlas(), b, fromEnd };
      }
    }
  }
  return std::nullopt;
}

/// How far from a corner, in spacings, the first points on two creases may lie.
double farthest(const LeavingCrease& a, const LeavingCrease& b, double spacing)
{
  return std::min(Tuning::FarthestOpening,
    std::min(a.length(), b.length()) / spacing - Tuning::LeastBeyondOpening);
}

/// At what distance from the corner, in spacings, two creases have opened to an angle; 1 if they
/// have where their first points would be anyway, or nowhere near.
double distanceWhereOpen(
  const Vec3& corner, const LeavingCrease& a, const LeavingCrease& b, double spacing, double angle)
{
  const double most = farthest(a, b, spacing);
  for (double distance = 1.; distance <= most; distance += Tuning::StepOfOpening)
  {
    const double s = distance * spacing;
    if (cotangent(corner, a.at(s), b.at(s)) <= 1. / std::tan(angle))
    {
      return distance;
    }
  }
  return 1.;
}

/// Calls function(a, b, angle) with every two creases that leave a vertex side by side, and the
/// angle there between their first points.
template <typename Function>
void forEachPairOfCreases(const OptimizedMesh& mesh, Vertex v, const Function& function)
{
  mesh.forEachCorner(v, [&](Halfedge h) {
    const Halfedge g = mesh.previous(h);
    if (mesh.isCrease(mesh.edge(h)) && mesh.isCrease(mesh.edge(g)))
    {
      const auto a = creaseFrom(mesh, v, mesh.to(h));
      const auto b = creaseFrom(mesh, v, mesh.from(g));
      if (a && b)
      {
        const double cot =
          cotangent(mesh.position(v), mesh.position(mesh.to(h)), mesh.position(mesh.from(g)));
        function(*a, *b, std::atan2(1., cot));
      }
    }
  });
}
}

AcuteCorners::AcuteCorners(const OptimizedMesh& mesh, double angle)
  : Angle(angle)
{
  const VertexSpacing spacing(mesh);
  for (const Vertex v : mesh.vertices())
  {
    if (mesh.freedom(v) == Freedom::None)
    {
      bool found = false;
      forEachPairOfCreases(
        mesh, v, [&](const LeavingCrease&, const LeavingCrease&, double) { found = true; });
      if (found)
      {
        this->Corners.push_back({ v, spacing.at(v), angle });
      }
    }
  }
}

double AcuteCorners::growthAt(const OptimizedMesh& mesh, const Corner& corner) const
{
  const Vec3& p = mesh.position(corner.vertex);
  double distance = 1;
  forEachPairOfCreases(
    mesh, corner.vertex, [&](const LeavingCrease& a, const LeavingCrease& b, double) {
      if (const double d = distanceWhereOpen(p, a, b, corner.spacing, this->Angle); d > 1.)
      {
        // If they open to what was asked for, but not to what would make good what is lacking, as
        // far as they may.
        const double more = distanceWhereOpen(p, a, b, corner.spacing, corner.asked);
        distance = std::max(distance, more > 1. ? more : farthest(a, b, corner.spacing));
      }
    });
  return 1. + Tuning::ShareOfOpening * (distance - 1.);
}

SpacingRegions AcuteCorners::regions(const OptimizedMesh& mesh) const
{
  SpacingRegions regions;
  for (const Corner& corner : this->Corners)
  {
    if (const double growth = this->growthAt(mesh, corner); growth > 1.)
    {
      regions.add(mesh.atlas().surface(), Face(mesh.place(corner.vertex).face),
        { mesh.position(corner.vertex), corner.spacing, growth });
    }
  }
  return regions;
}

std::vector<char> AcuteCorners::closedCreases(const OptimizedMesh& mesh) const
{
  std::vector<char> result(mesh.chains().size(), 0);
  for (const Corner& corner : this->Corners)
  {
    if (this->growthAt(mesh, corner) > 1.)
    {
      continue;
    }
    forEachPairOfCreases(
      mesh, corner.vertex, [&](const LeavingCrease& a, const LeavingCrease& b, double angle) {
        if (angle < std::max(this->Angle, Tuning::SharpCorner))
        {
          result[a.backbone] = 1;
          result[b.backbone] = 1;
        }
      });
  }
  return result;
}

void AcuteCorners::correct(const OptimizedMesh& mesh)
{
  for (Corner& corner : this->Corners)
  {
    double lack = 0;
    forEachPairOfCreases(
      mesh, corner.vertex, [&](const LeavingCrease&, const LeavingCrease&, double angle) {
        lack = std::max(lack, this->Angle - angle);
      });
    corner.asked += lack;
  }
}
}
