// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FarPlaces.h"

#include "LooseMesh.h"
#include "MeshQuality.h"
#include "ParallelFor.h"
#include "Relaxation.h"
#include "SurfaceError.h"
#include "Tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stipple
{
namespace
{
/// Points of the surface on creases and boundaries.
std::vector<char> pointsOnCreases(const Atlas& atlas)
{
  std::vector<char> isOn(atlas.surface().points.size(), 0);
  for (const Backbone& b : atlas.graph().backbones)
  {
    for (const int p : b.points)
    {
      isOn[p] = isOn[p] != 0 || b.type != BackboneType::Seam ? 1 : 0;
    }
  }
  return isOn;
}

class Insertion : public LooseMesh
{
public:
  Insertion(const OptimizedMesh& mesh, double tolerance)
    : LooseMesh(mesh)
    , Tolerance(tolerance)
    , IsWhole(this->Now.triangles().size(), 1)
  {
  }

  /// Puts a vertex at a place, in a disk of triangles about the nearest one. The disk grows from
  /// there, by the neighbour that leaves the largest smallest angle, as long as there is one.
  void reach(const FarPlace& place)
  {
    const SurfacePoint there = this->Mesh.pointAt(this->Mesh.atlas().placeOfPoint(place.point));
    if (!this->isToUse(place.face.index()))
    {
      return;
    }
    Cavity now = this->cavityOf(place.face.index(), there.position);
    Cavity best = now;
    while (now.disk.size() < Tuning::LargestCavity && this->grow(now, there.position))
    {
      if (now.angle > best.angle)
      {
        best = now;
      }
    }
    const Vertex corner(this->Now.triangle(place.face.index())[0]);
    const double lack = place.distance / (this->Tolerance * this->spacingAt(corner));
    if (best.angle < std::max(Tuning::HopelessAngle, (1. - lack) * Tuning::PoorFeatureAngle))
    {
      return;
    }
    const auto triangles = [&]() {
      std::vector<Triangle> result;
      for (const int t : best.disk)
      {
        result.push_back(this->Now.triangle(t));
      }
      return result;
    };
    const std::vector<Triangle> before = triangles();
    if (!this->hasSpare() || triangles() != before)
    {
      return;
    }
    const Vertex v = this->takeSpare(there, false);
    this->Placed.push_back(v);
    this->Fixed.push_back(v);
    for (const int t : best.disk)
    {
      this->IsWhole[t] = 0;
    }
    this->Now.fan(best.disk, best.rim, v);
    ++this->NumberOfSwaps;
  }

private:
  /// Triangles to be replaced by a fan, and how good that is.
  struct Cavity
  {
    std::vector<int> disk;
    std::vector<std::array<int, 2>> rim;
    double angle = -1; ///< the smallest; below 0 if one is turned over
  };

  bool isToUse(int t) const
  {
    return t < static_cast<int>(this->IsWhole.size()) && this->IsWhole[t] != 0 &&
      !this->Now.isGone(t);
  }
  Cavity cavityOf(int t, const Vec3& tip) const
  {
    const Triangle& c = this->Now.triangle(t);
    Cavity cavity;
    cavity.disk = { t };
    cavity.rim = { { { c[0], c[1] } }, { { c[1], c[2] } }, { { c[2], c[0] } } };
    cavity.angle = this->angleOfFan(cavity, tip);
    return cavity;
  }
  /// The smallest angle of a fan's triangles; -1 if one turns its back on the surface at the rim,
  /// or where that is creases, on the disk.
  double angleOfFan(const Cavity& cavity, const Vec3& tip) const
  {
    double least = 10;
    Vec3 ofDisk = Vec3::Zero();
    for (const int t : cavity.disk)
    {
      ofDisk += this->normal(this->Now.triangle(t));
    }
    for (const auto& [a, b] : cavity.rim)
    {
      const Vec3 n = (this->position(a) - tip).cross(this->position(b) - tip);
      Vec3 surface = Vec3::Zero();
      for (const int u : { a, b })
      {
        surface += this->IsFree[Vertex(u)] != 0 ? this->Place[Vertex(u)].normal : Vec3::Zero();
      }
      surface = surface == Vec3::Zero() ? ofDisk : surface;
      if (!(n.dot(surface) > Tuning::LeastAgreement * n.norm() * surface.norm()))
      {
        return -1;
      }
      least = std::min(least, angleOf({ { tip, this->position(a), this->position(b) } }));
    }
    return least;
  }
  /// Adds the best neighbour; false if there is none.
  bool grow(Cavity& cavity, const Vec3& tip) const
  {
    Cavity best;
    best.angle = -2;
    for (std::size_t k = 0; k < cavity.rim.size(); ++k)
    {
      const Vertex a(cavity.rim[k][0]);
      const Vertex b(cavity.rim[k][1]);
      const std::vector<int> pair = this->Now.beside(a, b);
      if (pair.size() != 2 || this->Now.isCrease(a, b))
      {
        continue;
      }
      const bool isFirst =
        std::find(cavity.disk.begin(), cavity.disk.end(), pair[0]) == cavity.disk.end();
      const int other = pair[isFirst ? 0 : 1];
      const Vertex d = apexOf(this->Now.triangle(other), a, b);
      const bool closes = std::any_of(
        cavity.rim.begin(), cavity.rim.end(), [&](const auto& e) { return e[0] == d.index(); });
      if (!this->isToUse(other) || closes)
      {
        continue;
      }
      Cavity with = cavity;
      with.disk.push_back(other);
      with.rim[k] = { { a.index(), d.index() } };
      with.rim.insert(
        with.rim.begin() + static_cast<std::ptrdiff_t>(k) + 1, { { d.index(), b.index() } });
      with.angle = this->angleOfFan(with, tip);
      if (with.angle > best.angle)
      {
        best = std::move(with);
      }
    }
    if (best.disk.empty())
    {
      return false;
    }
    cavity = std::move(best);
    return true;
  }

  const double Tolerance;
  std::vector<char> IsWhole; // by triangle, of those that were there at first
};
}

Status farPlaces(
  const OptimizedMesh& mesh, double share, const Progress& progress, std::vector<FarPlace>& places)
{
  places.clear();
  const SurfaceError error(mesh);
  const double spacing = spacingAtUnitDensity(mesh);
  const auto boundAt = [&](Vertex v) { return share * spacing / std::sqrt(mesh.density(v)); };
  // Distances to the triangles about one vertex are too large at most.
  ElementArray<Vertex, char> mayBeFar(static_cast<std::size_t>(mesh.vertices().size()), 0);
  parallelFor(mesh.vertices(),
    [&](Vertex v) { mayBeFar[v] = error.at(v).largest > boundAt(v) * boundAt(v) ? 1 : 0; });
  const std::vector<char> isOnCrease = pointsOnCreases(mesh.atlas());
  std::vector<int> points;
  std::vector<double> bounds;
  for (const Vertex v : mesh.vertices())
  {
    for (const int p : mayBeFar[v] != 0 ? error.pointsOf(v) : std::vector<int>())
    {
      if (isOnCrease[p] == 0)
      {
        points.push_back(p);
        bounds.push_back(boundAt(v));
      }
    }
  }
  if (points.empty())
  {
    return Status::success();
  }
  TriangleSurface whole;
  for (const Vertex v : mesh.vertices())
  {
    whole.points.push_back(mesh.position(v));
  }
  whole.triangles = mesh.triangles();
  std::vector<Vec3> positions;
  std::transform(points.begin(), points.end(), std::back_inserter(positions),
    [&](int p) { return mesh.atlas().surface().points[p]; });
  std::vector<NearestPlace> nearest;
  if (Status status = nearestPlaces(positions, whole, progress, nearest); !status.ok())
  {
    return status;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double distance = std::sqrt(nearest[i].squaredDistance);
    if (distance > bounds[i])
    {
      places.push_back({ points[i], Face(nearest[i].face), distance });
    }
  }
  std::sort(places.begin(), places.end(), [](const FarPlace& a, const FarPlace& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.point < b.point;
  });
  return Status::success();
}

Status reachPlaces(OptimizedMesh& mesh, const std::vector<FarPlace>& places, double tolerance)
{
  Insertion insertion(mesh, tolerance);
  for (const FarPlace& place : places)
  {
    insertion.reach(place);
  }
  OptimizedMesh::Change change = insertion.finish();
  return change.swaps == 0 ? Status::success() : mesh.rebuild(std::move(change));
}
}
