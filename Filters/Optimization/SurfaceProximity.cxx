// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceProximity.h"

#include "PolyDataConversion.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
namespace
{
using HalfedgeHandle = OptimizedMesh::Halfedge;

/// Cosine between the normals of a triangle and of the surface below it: less, and it may be
/// flipped.
constexpr double LeastAgreement = 0.3;
/// And of the surface at the triangle's vertices: if all agree more and none lies on a crease,
/// there is no need to look below it.
constexpr double SafeAgreement = 0.7;
/// Barycentric coordinate below which a place is on an edge.
constexpr double OnEdge = 1e-4;
}

struct SurfaceProximity::Nearest
{
  double distance;
  int face;
  Vec3 place;
};

struct SurfaceProximity::Internals
{
  Nearest nearest(const Vec3& p) const
  {
    double on[3];
    vtkIdType face = -1;
    int sub = 0;
    double squared = 0;
    this->Locator->FindClosestPoint(p.data(), on, this->Cell, face, sub, squared);
    return { std::sqrt(squared), static_cast<int>(face), Vec3(on) };
  }

  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
};

SurfaceProximity::SurfaceProximity(const OptimizedMesh& mesh)
  : Surface(std::make_unique<Internals>())
  , Mesh(mesh)
  , CreaseOf(mesh.numberOfEdges())
{
  const AtlasSurface& surface = mesh.atlas().surface();
  this->Surface->Locator->SetDataSet(toPolyData(surface.points, surface.triangles));
  this->Surface->Locator->BuildLocator();

  const auto& chains = mesh.chains();
  for (std::size_t b = 0; b < chains.size(); ++b)
  {
    for (std::size_t i = 1; i < chains[b].size(); ++i)
    {
      const HalfedgeHandle h = mesh.graph().find_halfedge(
        OptimizedMesh::Vertex(chains[b][i - 1]), OptimizedMesh::Vertex(chains[b][i]));
      this->CreaseOf[mesh.graph().edge_handle(h).idx()] = { static_cast<int>(b), chains[b][i - 1],
        chains[b][i] };
    }
  }
}

SurfaceProximity::~SurfaceProximity() = default;

Vec3 SurfaceProximity::centroid(int face) const
{
  const auto t = this->Mesh.corners(face);
  return (this->Mesh.position(t[0]) + this->Mesh.position(t[1]) + this->Mesh.position(t[2])) / 3.;
}

Vec3 SurfaceProximity::middle(int edge) const
{
  const auto& graph = this->Mesh.graph();
  const HalfedgeHandle h = graph.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
  return 0.5 *
    (this->Mesh.position(graph.from_vertex_handle(h)) +
      this->Mesh.position(graph.to_vertex_handle(h)));
}

SurfaceReach SurfaceProximity::largest() const
{
  SurfaceReach result;
  for (int f = 0; f < this->Mesh.numberOfFaces(); ++f)
  {
    result.faces = std::max(result.faces, this->Surface->nearest(this->centroid(f)).distance);
  }
  for (int e = 0; e < this->Mesh.numberOfEdges(); ++e)
  {
    result.faces = std::max(result.faces, this->Surface->nearest(this->middle(e)).distance);
    result.creases = std::max(result.creases, this->distanceOfCrease(e));
  }
  return result;
}

bool SurfaceProximity::isNear(const std::vector<int>& faces, const SurfaceReach& reach) const
{
  const auto& graph = this->Mesh.graph();
  std::vector<int> edges;
  for (int f : faces)
  {
    HalfedgeHandle h = graph.halfedge_handle(OpenMesh::FaceHandle(f));
    for (int k = 0; k < 3; ++k, h = graph.next_halfedge_handle(h))
    {
      edges.push_back(graph.edge_handle(h).idx());
    }
  }
  makeUnique(edges);
  const auto isEdgeNear = [&](int e) {
    return this->Surface->nearest(this->middle(e)).distance <= reach.faces;
  };
  const auto isFaceNear = [&](int f) {
    const Nearest below = this->Surface->nearest(this->centroid(f));
    return below.distance <= reach.faces && this->agreement(f, below) >= LeastAgreement;
  };
  return std::all_of(edges.begin(), edges.end(),
           [&](int e) { return this->distanceOfCrease(e) <= reach.creases; }) &&
    std::all_of(faces.begin(), faces.end(), isFaceNear) &&
    std::all_of(edges.begin(), edges.end(), isEdgeNear);
}

double SurfaceProximity::distanceAbout(int v) const
{
  double largest = 0;
  this->Mesh.forEachHalfedge(v, [&](HalfedgeHandle h) {
    const int edge = this->Mesh.graph().edge_handle(h).idx();
    largest = std::max(largest, this->Surface->nearest(this->middle(edge)).distance);
  });
  this->Mesh.forEachFace(v, [&](int f) {
    largest = std::max(largest, this->Surface->nearest(this->centroid(f)).distance);
  });
  return largest;
}

double SurfaceProximity::distanceOfCrease(int edge) const
{
  const Crease& crease = this->CreaseOf[edge];
  if (crease.backbone < 0)
  {
    return 0.;
  }
  const AtlasSurface& surface = this->Mesh.atlas().surface();
  const std::vector<int>& point = this->Mesh.atlas().graph().backbones[crease.backbone].points;
  const BackboneTrace& trace = this->Mesh.atlas().traces()[crease.backbone];
  // Nodes at a backbone's ends lie on several, and have no arc length.
  const bool startsAtNode = this->Mesh.backbone(crease.from) != crease.backbone;
  const bool endsAtNode = this->Mesh.backbone(crease.to) != crease.backbone;
  const double begin = startsAtNode ? 0. : this->Mesh.arcLength(crease.from);
  double end = endsAtNode ? trace.length() : this->Mesh.arcLength(crease.to);
  if (end <= begin) // over the seam of a closed one
  {
    end += trace.length();
  }
  const Vec3& a = this->Mesh.position(crease.from);
  const Vec3 along = this->Mesh.position(crease.to) - a;
  const double square = along.squaredNorm();
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
      const Vec3 d = surface.points[point[i % static_cast<int>(point.size())]] - a;
      const double t = square > 0 ? std::clamp(d.dot(along) / square, 0., 1.) : 0.;
      largest = std::max(largest, (d - t * along).norm());
    }
  }
  return largest;
}

/// The least cosine between the normals of a triangle and of the surface's triangles that meet at
/// the place nearest to its centroid. On a crease there are several, and a triangle that leans out
/// over it faces away from one of them.
double SurfaceProximity::agreement(int face, const Nearest& below) const
{
  const AtlasSurface& surface = this->Mesh.atlas().surface();
  const Vec3 n = this->Mesh.faceNormal(face);
  double least = 1;
  const auto lookAt = [&](int f) {
    least = std::min(least, n.dot(this->Mesh.atlas().walk().normal(f)));
  };
  lookAt(below.face);
  const double area = surface.faceArea(below.face);
  const auto isOn = [&](int h) {
    return triangleArea(surface.points[surface.tail(h)], surface.points[surface.head(h)],
             below.place) <= OnEdge * area;
  };
  for (int k = 0; k < 3; ++k)
  {
    const int h = 3 * below.face + k;
    const int before = previousHalfedge(h);
    if (!isOn(h))
    {
      continue;
    }
    if (surface.twin[h] >= 0)
    {
      lookAt(surface.twin[h] / 3);
    }
    if (isOn(before))
    {
      // At a point: both ways about it, for it may lie on a boundary.
      for (int g = surface.twin[h]; g >= 0 && g / 3 != below.face;
           g = surface.twin[nextHalfedge(g)])
      {
        lookAt(g / 3);
      }
      for (int g = surface.twin[before]; g >= 0 && g / 3 != below.face;
           g = surface.twin[previousHalfedge(g)])
      {
        lookAt(g / 3);
      }
    }
  }
  return least;
}

bool SurfaceProximity::facesOutwards(int face) const
{
  const Vec3 n = this->Mesh.faceNormal(face);
  const auto t = this->Mesh.corners(face);
  if (std::all_of(t.begin(), t.end(), [&](int v) {
        return this->Mesh.freedom(v) == Freedom::Surface &&
          n.dot(this->Mesh.normal(v)) > SafeAgreement;
      }))
  {
    return true;
  }
  return this->agreement(face, this->Surface->nearest(this->centroid(face))) >= LeastAgreement;
}

SurfaceLeash::SurfaceLeash(
  const OptimizedMesh& mesh, const SurfaceProximity& proximity, const SurfaceReach& reach)
  : Mesh(mesh)
  , Proximity(proximity)
  , Reach(reach)
  , LargestAbout(mesh.numberOfVertices(), std::numeric_limits<double>::infinity())
{
  this->Position.reserve(mesh.numberOfVertices());
  for (int v = 0; v < mesh.numberOfVertices(); ++v)
  {
    this->Position.push_back(mesh.position(v));
  }
}

bool SurfaceLeash::allows(int v)
{
  const auto& graph = this->Mesh.graph();
  bool isNear = true;
  this->Mesh.forEachHalfedge(v, [&](HalfedgeHandle h) {
    isNear =
      isNear && this->Proximity.distanceOfCrease(graph.edge_handle(h).idx()) <= this->Reach.creases;
  });
  const double step = (this->Mesh.position(v) - this->Position[v]).norm();
  double largest = this->LargestAbout[v] + step;
  if (isNear && largest > this->Reach.faces)
  {
    largest = this->Proximity.distanceAbout(v);
    isNear = largest <= this->Reach.faces;
  }
  this->Mesh.forEachFace(v, [&](int f) { isNear = isNear && this->Proximity.facesOutwards(f); });
  if (!isNear)
  {
    return false;
  }
  this->LargestAbout[v] = largest;
  this->Position[v] = this->Mesh.position(v);
  this->Mesh.forEachNeighbour(v, [&](int u) { this->LargestAbout[u] += step; });
  return true;
}
}
