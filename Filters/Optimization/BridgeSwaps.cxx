// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BridgeSwaps.h"

#include "ParallelFor.h"
#include "Relaxation.h"
#include "SurfaceProximity.h"
#include "Tuning.h"
#include "VertexStar.h"

#include <algorithm>
#include <array>
#include <vector>

namespace stipple
{
namespace
{
class Bridges
{
public:
  Bridges(MeshEdit& edit, double share, double tolerance)
    : Edit(edit)
    , Mesh(edit.mesh())
    , Spacing(edit.mesh())
    , Share(share)
    , Tolerance(tolerance)
  {
  }

  /// Edges that may be far away: as the ends are on the surface, only long ones are. Where their
  /// triangles lie nearly in one plane, the other edge would run by the same place.
  std::vector<Edge> candidates() const
  {
    ElementArray<Edge, char> mayBeFar(static_cast<std::size_t>(this->Mesh.edges().size()), 0);
    parallelFor(this->Mesh.edges(), [&](Edge e) {
      mayBeFar[e] = this->Mesh.isSwappable(e) && 0.5 * this->length(e) > this->bound(e) &&
          this->cosineAt(e) < Tuning::LeastBend
        ? 1
        : 0;
    });
    std::vector<Edge> result;
    for (const Edge e : this->Mesh.edges())
    {
      if (mayBeFar[e] != 0)
      {
        result.push_back(e);
      }
    }
    return result;
  }

  bool swap(const SurfaceProximity& surface, Edge e)
  {
    if (surface.distanceOf(e) <= this->bound(e))
    {
      return false;
    }
    const Vertex end = this->Mesh.from(this->Mesh.halfedge(e));
    const double distance = this->distance(surface, e);
    const double angle = this->angle(e);
    return this->Edit.attempt([&]() {
      if (!this->Edit.swap(e))
      {
        return false;
      }
      const double nearer = distance - this->distance(surface, e);
      const double wanted = this->Spacing.poorestAngle(end, this->Tolerance, nearer);
      const auto [left, right] = this->trianglesOf(e);
      return nearer > 0 && this->angle(e) >= std::min(angle, wanted) &&
        surface.facesOutwards(left) && surface.facesOutwards(right);
    });
  }

private:
  std::array<Face, 2> trianglesOf(Edge e) const
  {
    const Halfedge h = this->Mesh.halfedge(e);
    return { { this->Mesh.face(h), this->Mesh.face(this->Mesh.opposite(h)) } };
  }
  /// Between their normals.
  double cosineAt(Edge e) const
  {
    const auto [left, right] = this->trianglesOf(e);
    return this->Mesh.faceNormal(left).dot(this->Mesh.faceNormal(right));
  }
  double length(Edge e) const
  {
    const Halfedge h = this->Mesh.halfedge(e);
    return (this->Mesh.position(this->Mesh.to(h)) - this->Mesh.position(this->Mesh.from(h))).norm();
  }
  /// What is farther from the surface is far.
  double bound(Edge e) const
  {
    const Halfedge h = this->Mesh.halfedge(e);
    return 0.5 *
      (this->Spacing.farthest(this->Mesh.from(h), this->Share) +
        this->Spacing.farthest(this->Mesh.to(h), this->Share));
  }
  /// Of an edge and its triangles.
  double distance(const SurfaceProximity& surface, Edge e) const
  {
    const auto [left, right] = this->trianglesOf(e);
    return std::max({ surface.distanceOf(e), surface.distanceOf(left), surface.distanceOf(right) });
  }
  double angle(Edge e) const
  {
    const auto [left, right] = this->trianglesOf(e);
    return std::min(faceQuality(this->Mesh, left), faceQuality(this->Mesh, right));
  }

  MeshEdit& Edit;
  const OptimizedMesh& Mesh;
  const VertexSpacing Spacing;
  const double Share;
  const double Tolerance;
};
}

int swapBridges(MeshEdit& edit, double share, double tolerance)
{
  Bridges bridges(edit, share, tolerance);
  std::vector<Edge> edges = bridges.candidates();
  if (edges.empty())
  {
    return 0;
  }
  const SurfaceProximity surface(edit.mesh());
  int total = 0;
  for (int pass = 0; pass < Tuning::LooksAtFarPlaces; ++pass)
  {
    int swaps = 0;
    for (const Edge e : edges)
    {
      swaps += bridges.swap(surface, e) ? 1 : 0;
    }
    if (swaps == 0)
    {
      break;
    }
    total += swaps;
    edges = bridges.candidates(); // of triangles that changed, others may be far now
  }
  return total;
}
}
