// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How far triangles and creases of the mesh lie from the surface's, and whether triangles face the
// way the surface does. Vertices on creases have no one normal, so that triangles between creases
// are judged by this.
#ifndef stipple_SurfaceProximity_h
#define stipple_SurfaceProximity_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

#include <memory>

namespace stipple
{
/// Distances from the surface, in units of its points.
struct SurfaceDistances
{
  double faces = 0;   ///< of the triangles' centroids and the edges' middles
  double creases = 0; ///< of a crease's points from the edge between its neighbours, or from that
                      ///< edge's triangles
};

class STIPPLEFILTERSOPTIMIZATION_EXPORT SurfaceProximity
{
public:
  /// Borrows the mesh. Its features stay, and may slide.
  explicit SurfaceProximity(const OptimizedMesh& mesh);
  ~SurfaceProximity();

  /// The largest distances of the whole mesh.
  SurfaceDistances largest() const;
  /// No distance of these triangles is larger, and they all face the way the surface does.
  bool isNear(const std::vector<Face>& faces, const SurfaceDistances& bound) const;

  /// Of a triangle's centroid, and of an edge's middle.
  double distanceOf(Face f) const;
  double distanceOf(Edge e) const;
  /// Of the edges that meet at a vertex and of its triangles.
  double distanceAbout(Vertex v) const;
  /// Zero for edges that are no features.
  double distanceOfCrease(Edge e) const;
  /// Whether a triangle faces the way the surface does: away from creases, at all of its vertices,
  /// else where the surface is nearest to the centroid: on a crease, on either side of it.
  bool facesOutwards(Face f) const;

private:
  struct Internals;
  struct Nearest;
  double agreement(Face f, const Nearest& below) const;
  Vec3 centroid(Face f) const;
  Vec3 middle(Edge e) const;

  std::unique_ptr<Internals> Surface;
  const OptimizedMesh& Mesh;
};

/// Keeps the mesh as near to the surface while vertices move one by one. Distances are measured
/// only where the vertices' steps since the last time may have used up what is left of the bound.
class STIPPLEFILTERSOPTIMIZATION_EXPORT ProximityGuard
{
public:
  /// Borrows both.
  ProximityGuard(
    const OptimizedMesh& mesh, const SurfaceProximity& proximity, const SurfaceDistances& bound);

  /// Whether a vertex, which has moved, may stay there; else it must be put back.
  bool allows(Vertex v);

private:
  const OptimizedMesh& Mesh;
  const SurfaceProximity& Proximity;
  const SurfaceDistances Bound;
  ElementArray<Vertex, Vec3> Position;       // of the vertices, when they were allowed last
  ElementArray<Vertex, double> LargestAbout; // no distance about a vertex is larger
};
}

#endif
