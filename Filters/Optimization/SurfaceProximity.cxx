// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceProximity.h"

#include "CellLocator.h"
#include "MeshRegion.h"
#include "SurfaceViews.h"
#include "Tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
struct SurfaceProximity::Nearest
{
  double distance;
  int face;
  Vec3 place;
};

struct SurfaceProximity::Internals
{
  explicit Internals(const AtlasSurface& surface)
    : Locator(surface.points, surface.triangles)
  {
  }
  Nearest nearest(const Vec3& p) const
  {
    const CellLocator::Place place = this->Locator.nearest(p);
    return { std::sqrt(place.squaredDistance), static_cast<int>(place.cell), place.position };
  }

  CellLocator Locator;
};

SurfaceProximity::SurfaceProximity(const OptimizedMesh& mesh)
  : Surface(std::make_unique<Internals>(mesh.atlas().surface()))
  , Mesh(mesh)
{
}

SurfaceProximity::~SurfaceProximity() = default;

Vec3 SurfaceProximity::centroid(Face f) const
{
  const auto [a, b, c] = this->Mesh.corners(f);
  return (this->Mesh.position(a) + this->Mesh.position(b) + this->Mesh.position(c)) / 3.;
}

Vec3 SurfaceProximity::middle(Edge e) const
{
  const Halfedge h = this->Mesh.halfedge(e);
  return 0.5 * (this->Mesh.position(this->Mesh.from(h)) + this->Mesh.position(this->Mesh.to(h)));
}

SurfaceDistances SurfaceProximity::largest() const
{
  SurfaceDistances result;
  for (const Face f : this->Mesh.faces())
  {
    result.faces = std::max(result.faces, this->distanceOf(f));
  }
  for (const Edge e : this->Mesh.edges())
  {
    result.faces = std::max(result.faces, this->distanceOf(e));
    result.creases = std::max(result.creases, this->distanceOfCrease(e));
  }
  return result;
}

bool SurfaceProximity::isNear(const std::vector<Face>& faces, const SurfaceDistances& bound) const
{
  std::vector<Edge> edges;
  for (const Face f : faces)
  {
    const Halfedge h = this->Mesh.halfedge(f);
    for (const Halfedge g : { h, this->Mesh.next(h), this->Mesh.previous(h) })
    {
      edges.push_back(this->Mesh.edge(g));
    }
  }
  makeUnique(edges);
  const auto isEdgeNear = [&](Edge e) { return this->distanceOf(e) <= bound.faces; };
  const auto isFaceNear = [&](Face f) {
    const Nearest below = this->Surface->nearest(this->centroid(f));
    return below.distance <= bound.faces &&
      this->agreement(f, below) >= Tuning::LeastAgreementBelow;
  };
  return std::all_of(edges.begin(), edges.end(),
           [&](Edge e) { return this->distanceOfCrease(e) <= bound.creases; }) &&
    std::all_of(faces.begin(), faces.end(), isFaceNear) &&
    std::all_of(edges.begin(), edges.end(), isEdgeNear);
}

double SurfaceProximity::distanceOf(Face f) const
{
  return this->Surface->nearest(this->centroid(f)).distance;
}

double SurfaceProximity::distanceOf(Edge e) const
{
  return this->Surface->nearest(this->middle(e)).distance;
}

double SurfaceProximity::distanceAbout(Vertex v) const
{
  double largest = 0;
  this->Mesh.forEachHalfedge(
    v, [&](Halfedge h) { largest = std::max(largest, this->distanceOf(this->Mesh.edge(h))); });
  this->Mesh.forEachFace(v, [&](Face f) { largest = std::max(largest, this->distanceOf(f)); });
  return largest;
}

double SurfaceProximity::distanceOfCrease(Edge e) const
{
  if (!this->Mesh.isCrease(e))
  {
    return 0.;
  }
  const Crease& crease = this->Mesh.crease(e);
  const AtlasSurface& surface = this->Mesh.atlas().surface();
  const std::vector<int>& point = this->Mesh.atlas().graph().backbones[crease.backbone].points;
  const BackboneTrace& trace = this->Mesh.atlas().traces()[crease.backbone];
  const double begin = this->Mesh.arcLength(crease.from);
  double end = this->Mesh.arcLength(crease.to);
  if (end <= begin) // over the seam of a closed one
  {
    end += trace.length();
  }
  const Vec3& a = this->Mesh.position(crease.from.vertex);
  const Vec3& b = this->Mesh.position(crease.to.vertex);
  const auto distance = [&](const Vec3& p) {
    double least = distanceToSegment(p, a, b);
    for (int side = 0; side < 2; ++side)
    {
      const Halfedge h = this->Mesh.halfedge(e, side);
      if (!this->Mesh.isBoundary(h))
      {
        const Vec3& c = this->Mesh.position(this->Mesh.apex(h));
        const Vec3 bary = barycentricInSpace(p, a, b, c);
        least = bary.allFinite() && bary.minCoeff() >= 0.
          ? std::min(least, (bary[0] * a + bary[1] * b + bary[2] * c - p).norm())
          : least;
      }
    }
    return least;
  };
  double largest = 0;
  // A closed one's last arc length is that of its first point.
  const int n = static_cast<int>(trace.arcLength.size());
  for (const double lap : { 0., trace.length() })
  {
    const auto first =
      std::upper_bound(trace.arcLength.begin(), trace.arcLength.end(), begin - lap);
    for (auto i = static_cast<int>(first - trace.arcLength.begin());
         i < n && trace.arcLength[i] + lap < end; ++i)
    {
      largest =
        std::max(largest, distance(surface.points[point[i % static_cast<int>(point.size())]]));
    }
  }
  return largest;
}

/// The least cosine between the normals of a triangle and of the surface's triangles that meet at
/// the place nearest to its centroid. On a crease there are several, and a triangle that leans out
/// over it faces away from one of them.
double SurfaceProximity::agreement(Face f, const Nearest& below) const
{
  const AtlasSurface& surface = this->Mesh.atlas().surface();
  const Vec3 n = this->Mesh.faceNormal(f);
  const Vec3 bary = barycentricInSpace(below.place, surface.point(below.face, 0),
    surface.point(below.face, 1), surface.point(below.face, 2));
  double least = 1;
  for (const SurfacePlace& view :
    viewsOf(surface, { below.face, clampedBarycentric(bary) }, Tuning::OnEdge))
  {
    least = std::min(least, n.dot(this->Mesh.surfaceWalk().normal(view.face)));
  }
  return least;
}

bool SurfaceProximity::facesOutwards(Face f) const
{
  const Vec3 n = this->Mesh.faceNormal(f);
  const auto t = this->Mesh.corners(f);
  if (std::all_of(t.begin(), t.end(), [&](Vertex v) {
        return this->Mesh.isFree(v) && n.dot(this->Mesh.normal(v)) > Tuning::SafeAgreement;
      }))
  {
    return true;
  }
  return this->agreement(f, this->Surface->nearest(this->centroid(f))) >=
    Tuning::LeastAgreementBelow;
}

ProximityGuard::ProximityGuard(
  const OptimizedMesh& mesh, const SurfaceProximity& proximity, const SurfaceDistances& bound)
  : Mesh(mesh)
  , Proximity(proximity)
  , Bound(bound)
  , LargestAbout(
      static_cast<std::size_t>(mesh.vertices().size()), std::numeric_limits<double>::infinity())
{
  for (const Vertex v : mesh.vertices())
  {
    this->Position.push_back(mesh.position(v));
  }
}

bool ProximityGuard::allows(Vertex v)
{
  bool isNear = true;
  this->Mesh.forEachHalfedge(v, [&](Halfedge h) {
    isNear = isNear && this->Proximity.distanceOfCrease(this->Mesh.edge(h)) <= this->Bound.creases;
  });
  const double step = (this->Mesh.position(v) - this->Position[v]).norm();
  double largest = this->LargestAbout[v] + step;
  if (isNear && largest > this->Bound.faces)
  {
    largest = this->Proximity.distanceAbout(v);
    isNear = largest <= this->Bound.faces;
  }
  this->Mesh.forEachFace(v, [&](Face f) { isNear = isNear && this->Proximity.facesOutwards(f); });
  if (!isNear)
  {
    return false;
  }
  this->LargestAbout[v] = largest;
  this->Position[v] = this->Mesh.position(v);
  this->Mesh.forEachNeighbour(v, [&](Vertex u) { this->LargestAbout[u] += step; });
  return true;
}
}
