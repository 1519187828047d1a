// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FarPlaces.h"

#include "FaceSets.h"
#include "LooseMesh.h"
#include "MeshQuality.h"
#include "ParallelFor.h"
#include "Relaxation.h"
#include "SurfaceError.h"
#include "Tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace stipple
{
namespace
{
class Insertion : public LooseMesh
{
public:
  Insertion(const OptimizedMesh& mesh, double tolerance)
    : LooseMesh(mesh, tolerance)
    , IsWhole(this->Now.triangles().size(), 1)
  {
  }

  /// Puts a vertex at a place, in a disk of triangles about the nearest one, or about the edge of
  /// the crease that it lies on. The disk grows from there, by the neighbour that leaves the
  /// largest smallest angle, as long as there is one.
  void reach(const FarPlace& place)
  {
    const LooseTriangles::EdgeOfChain edge = place.backbone < 0
      ? LooseTriangles::EdgeOfChain()
      : this->Now.edgeAt(place.backbone, place.arcLength);
    const auto [a, b] = edge.ends;
    const std::vector<int> beside =
      a.valid() && a != b ? this->Now.beside(a, b) : std::vector<int>();
    const bool isOnCrease = !beside.empty();
    const std::vector<int> disk = isOnCrease ? beside : std::vector<int>{ place.face.index() };
    if (std::any_of(disk.begin(), disk.end(), [&](int t) { return !this->isToUse(t); }) ||
      (isOnCrease && this->Now.keep(a, b) == Keep::Edges))
    {
      return;
    }
    Cavity now = this->cavityOf(disk, isOnCrease ? pairOf(a, b) : VertexPair(), place.position);
    Cavity best = now;
    while (now.disk.size() < Tuning::LargestCavity && this->grow(now, place.position))
    {
      if (now.angle > best.angle)
      {
        best = now;
      }
    }
    const Vertex corner(this->Now.triangle(best.disk.front())[0]);
    if (best.angle < this->Spacing.poorestAngle(corner, this->Tolerance, place.distance))
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
    const Vertex v = this->takeSpare(this->Mesh.pointAt(place.place), false);
    std::vector<std::array<int, 2>> rim;
    for (const RimEdge& e : best.rim)
    {
      rim.push_back(e.ends);
    }
    for (const int t : best.disk)
    {
      this->IsWhole[t] = 0;
    }
    this->Fixed.push_back(v);
    this->Now.fan(best.disk, rim, v);
    if (isOnCrease)
    {
      this->Now.lead(a, b, this->Now.onChains(a, b, edge.share), v);
      this->OnBackbones.push_back({ v, place.backbone, place.arcLength });
    }
    else
    {
      this->Placed.push_back(v);
    }
    ++this->NumberOfSwaps;
  }

private:
  struct RimEdge
  {
    std::array<int, 2> ends;
    Vec3 normal; ///< of the disk's triangle there
  };
  /// Triangles to be replaced by a fan, and how good that is.
  struct Cavity
  {
    std::vector<int> disk;
    std::vector<RimEdge> rim;
    double angle = -1; ///< the smallest; below 0 if one is turned over
  };

  bool isToUse(int t) const
  {
    return t < static_cast<int>(this->IsWhole.size()) && this->IsWhole[t] != 0 &&
      !this->Now.isGone(t);
  }
  /// Of one triangle, or those of an edge, which is inside it then, or on the boundary.
  Cavity cavityOf(const std::vector<int>& disk, const VertexPair& edge, const Vec3& tip) const
  {
    Cavity cavity;
    cavity.disk = disk;
    for (const int t : disk)
    {
      const Triangle& c = this->Now.triangle(t);
      int first = 0; // its edge behind that edge
      while (edge.first.valid() && pairOf(Vertex(c[(first + 2) % 3]), Vertex(c[first])) != edge)
      {
        ++first;
      }
      for (int k = first; k < first + (edge.first.valid() ? 2 : 3); ++k)
      {
        cavity.rim.push_back({ { { c[k % 3], c[(k + 1) % 3] } }, this->normal(c) });
      }
    }
    cavity.angle = this->angleOfFan(cavity, tip);
    return cavity;
  }
  /// The smallest angle of a fan's triangles; -1 if one turns its back on the surface at the rim,
  /// or where that is creases, on the disk there.
  double angleOfFan(const Cavity& cavity, const Vec3& tip) const
  {
    double least = 10;
    for (const auto& [ends, normal] : cavity.rim)
    {
      const auto [a, b] = ends;
      const Vec3 n = (this->position(a) - tip).cross(this->position(b) - tip);
      Vec3 surface = Vec3::Zero();
      for (const int u : { a, b })
      {
        surface += this->IsFree[Vertex(u)] != 0 ? this->Place[Vertex(u)].normal : Vec3::Zero();
      }
      surface = surface == Vec3::Zero() ? normal : surface;
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
      const Vertex a(cavity.rim[k].ends[0]);
      const Vertex b(cavity.rim[k].ends[1]);
      const std::vector<int> pair = this->Now.beside(a, b);
      if (pair.size() != 2 || this->Now.isCrease(a, b))
      {
        continue;
      }
      const bool isFirst =
        std::find(cavity.disk.begin(), cavity.disk.end(), pair[0]) == cavity.disk.end();
      const int other = pair[isFirst ? 0 : 1];
      const Triangle& added = this->Now.triangle(other);
      const Vertex d = apexOf(added, a, b);
      const bool closes = std::any_of(cavity.rim.begin(), cavity.rim.end(),
        [&](const RimEdge& e) { return e.ends[0] == d.index() || e.ends[1] == d.index(); });
      if (!this->isToUse(other) || closes)
      {
        continue;
      }
      Cavity with = cavity;
      with.disk.push_back(other);
      with.rim[k] = { { { a.index(), d.index() } }, this->normal(added) };
      with.rim.insert(with.rim.begin() + static_cast<std::ptrdiff_t>(k) + 1,
        { { { d.index(), b.index() } }, this->normal(added) });
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

  std::vector<char> IsWhole; // by triangle, of those that were there at first
};

/// Where the surface is looked at.
class Lookout
{
public:
  Lookout(const OptimizedMesh& mesh, const SurfaceError& error, double share)
    : Mesh(mesh)
    , Error(error)
    , Spacing(mesh)
    , Share(share)
    , SpacingAt(mesh.atlas().surface().points.size(), this->Spacing.atUnitDensity())
  {
    for (const Vertex v : mesh.vertices())
    {
      for (const int p : this->Error.pointsOf(v))
      {
        this->SpacingAt[p] = this->Spacing.at(v);
      }
    }
  }

  std::vector<FarPlace> places() const
  {
    std::vector<FarPlace> result;
    this->addPoints(result);
    this->addCreases(result);
    this->addInsides(result);
    return result;
  }
  /// What is farther from a triangle of the mesh is far.
  double bound(Face face) const
  {
    double sum = 0;
    for (const Vertex v : this->Mesh.corners(face))
    {
      sum += this->Spacing.farthest(v, this->Share);
    }
    return sum / 3.;
  }

private:
  void add(std::vector<FarPlace>& places, const SurfacePlace& place, int backbone = -1,
    double arcLength = 0.) const
  {
    FarPlace there;
    there.place = place;
    there.position = this->Mesh.atlas().surface().position(Face(place.face), place.bary);
    there.backbone = backbone;
    there.arcLength = arcLength;
    places.push_back(there);
  }
  /// Points on no crease that may be far: distances to the triangles about one vertex are too large
  /// at most.
  void addPoints(std::vector<FarPlace>& places) const
  {
    const Atlas& atlas = this->Mesh.atlas();
    std::vector<char> isOnCrease(atlas.surface().points.size(), 0);
    for (std::size_t b = 0; b < atlas.graph().backbones.size(); ++b)
    {
      const bool isCrease = this->Mesh.isCreaseBackbone(static_cast<int>(b));
      for (const int p : atlas.graph().backbones[b].points)
      {
        isOnCrease[p] = isOnCrease[p] != 0 || isCrease ? 1 : 0;
      }
    }
    ElementArray<Vertex, char> mayBeFar(static_cast<std::size_t>(this->Mesh.vertices().size()), 0);
    parallelFor(this->Mesh.vertices(), [&](Vertex v) {
      const double bound = this->Spacing.farthest(v, this->Share);
      mayBeFar[v] = this->Error.at(v).largest > bound * bound ? 1 : 0;
    });
    for (const Vertex v : this->Mesh.vertices())
    {
      for (const int p : mayBeFar[v] != 0 ? this->Error.pointsOf(v) : std::vector<int>())
      {
        if (isOnCrease[p] == 0)
        {
          this->add(places, atlas.placeOfPoint(p));
        }
      }
    }
  }
  void addCreases(std::vector<FarPlace>& places) const
  {
    const Atlas& atlas = this->Mesh.atlas();
    for (std::size_t b = 0; b < atlas.graph().backbones.size(); ++b)
    {
      const Backbone& backbone = atlas.graph().backbones[b];
      const BackboneTrace& trace = atlas.traces()[b];
      if (!this->Mesh.isCreaseBackbone(static_cast<int>(b)))
      {
        continue;
      }
      for (int i = 0; i < backbone.numberOfSegments(); ++i)
      {
        const double from = trace.arcLength[i];
        const double to = trace.arcLength[i + 1];
        const int steps = static_cast<int>(
          std::ceil(std::max(1., (to - from) / this->SpacingAt[backbone.points[i]])));
        for (int k = 0; k < steps; ++k)
        {
          const double there = from + (to - from) * k / steps;
          this->add(
            places, atlas.placeOfBackbone(static_cast<int>(b), there), static_cast<int>(b), there);
        }
      }
    }
  }
  /// Rows along the longest edge of each triangle that is larger than the mesh's.
  void addInsides(std::vector<FarPlace>& places) const
  {
    const AtlasSurface& surface = this->Mesh.atlas().surface();
    for (const Face f : surface.faces())
    {
      const Triangle& t = surface.triangle(f);
      const auto length = [&](int k) {
        return (surface.points[t[(k + 1) % 3]] - surface.points[t[k]]).norm();
      };
      int longest = 0;
      for (int k = 1; k < 3; ++k)
      {
        longest = length(k) > length(longest) ? k : longest;
      }
      const double step =
        std::min({ this->SpacingAt[t[0]], this->SpacingAt[t[1]], this->SpacingAt[t[2]] });
      if (length(longest) <= step)
      {
        continue;
      }
      const double height = 2. *
        triangleArea(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]) /
        length(longest);
      const int rows = static_cast<int>(std::ceil(height / step));
      for (int j = 0; j < rows; ++j)
      {
        const double up = (j + 0.5) / rows;
        const int steps = static_cast<int>(std::ceil((1. - up) * length(longest) / step));
        for (int i = 0; i < steps; ++i)
        {
          Vec3 bary;
          bary[(longest + 2) % 3] = up;
          bary[(longest + 1) % 3] = (1. - up) * (i + 0.5) / steps;
          bary[longest] = 1. - up - bary[(longest + 1) % 3];
          this->add(places, { f.index(), bary });
        }
      }
    }
  }

  const OptimizedMesh& Mesh;
  const SurfaceError& Error;
  const VertexSpacing Spacing;
  const double Share;
  std::vector<double> SpacingAt; // by point of the surface
};

/// Tells places the triangles next to them, and how far these are: those of the mesh of their own
/// component, however near another one comes. Within `enough`, any of them.
Status findNearest(
  const OptimizedMesh& mesh, double enough, const Progress& progress, std::vector<FarPlace>& places)
{
  if (places.empty())
  {
    return Status::success();
  }
  const FaceSets components(mesh.atlas().surface(), [](Halfedge) { return true; });
  const auto n = static_cast<std::size_t>(components.number);
  std::vector<std::vector<Face>> faces(n);
  for (const Face f : mesh.faces())
  {
    faces[components.of[Face(mesh.place(mesh.corners(f)[0]).face)]].push_back(f);
  }
  std::vector<std::vector<std::size_t>> placesOf(n);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    placesOf[components.of[Face(places[i].place.face)]].push_back(i);
  }
  const std::vector<Triangle> triangles = mesh.triangles();
  TriangleSurface own; // a component's triangles
  for (const Vertex v : mesh.vertices())
  {
    own.points.push_back(mesh.position(v));
  }
  for (std::size_t c = 0; c < n; ++c)
  {
    if (placesOf[c].empty() || faces[c].empty())
    {
      continue;
    }
    own.triangles.clear();
    for (const Face f : faces[c])
    {
      own.triangles.push_back(triangles[static_cast<std::size_t>(f.index())]);
    }
    std::vector<Vec3> positions;
    for (const std::size_t i : placesOf[c])
    {
      positions.push_back(places[i].position);
    }
    std::vector<NearestTriangle::Hit> nearest;
    if (Status status = nearestPlaces(positions, own, progress, nearest, enough); !status.ok())
    {
      return status;
    }
    for (std::size_t k = 0; k < nearest.size(); ++k)
    {
      FarPlace& place = places[placesOf[c][k]];
      place.face = faces[c][static_cast<std::size_t>(nearest[k].face)];
      place.distance = std::sqrt(nearest[k].squaredDistance);
    }
  }
  return Status::success();
}
}

Status farPlaces(
  const OptimizedMesh& mesh, double share, const Progress& progress, std::vector<FarPlace>& places)
{
  const SurfaceError error(mesh);
  if (!report(progress, 0.))
  {
    return Status::aborted();
  }
  const Lookout lookout(mesh, error, share);
  if (!report(progress, 0.))
  {
    return Status::aborted();
  }
  places = lookout.places();
  double least = std::numeric_limits<double>::infinity(); // of what is far
  for (const Face f : mesh.faces())
  {
    least = std::min(least, lookout.bound(f));
  }
  if (Status status = findNearest(mesh, least, progress, places); !status.ok())
  {
    return status;
  }
  places.erase(
    std::remove_if(places.begin(), places.end(),
      [&](const FarPlace& p) { return !p.face.valid() || p.distance <= lookout.bound(p.face); }),
    places.end());
  std::stable_sort(places.begin(), places.end(),
    [](const FarPlace& a, const FarPlace& b) { return a.distance > b.distance; });
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
