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
struct SurfaceReach
{
  double faces = 0;   ///< of the triangles' centroids and the edges' middles
  double creases = 0; ///< from an edge along a crease to the crease's points between its ends
};

class STIPPLEFILTERSOPTIMIZATION_EXPORT SurfaceProximity
{
public:
  /// Borrows the mesh. Its features stay, and may slide.
  explicit SurfaceProximity(const OptimizedMesh& mesh);
  ~SurfaceProximity();

  /// The largest distances of the whole mesh.
  SurfaceReach largest() const;
  /// No distance of these triangles is larger, and they all face the way the surface does.
  bool isNear(const std::vector<int>& faces, const SurfaceReach& reach) const;

  /// Of the edges that meet at a vertex and of its triangles.
  double distanceAbout(int v) const;
  /// Zero for edges that are no features.
  double distanceOfCrease(int edge) const;
  /// Whether a triangle faces the way the surface does: away from creases, at all of its vertices,
  /// else where the surface is nearest to the centroid: on a crease, on either side of it.
  bool facesOutwards(int face) const;

private:
  struct Internals;
  struct Crease
  {
    int backbone = -1;
    int from = -1; ///< vertices; along the backbone
    int to = -1;
  };
  struct Nearest;
  double agreement(int face, const Nearest& below) const;
  Vec3 centroid(int face) const;
  Vec3 middle(int edge) const;

  std::unique_ptr<Internals> Surface;
  const OptimizedMesh& Mesh;
  std::vector<Crease> CreaseOf; // by edge
};

/// Keeps the mesh within reach of the surface while vertices move one by one. Distances are
/// measured only where the vertices' steps since the last time may have used up what is left of the
/// reach.
class STIPPLEFILTERSOPTIMIZATION_EXPORT SurfaceLeash
{
public:
  /// Borrows both.
  SurfaceLeash(
    const OptimizedMesh& mesh, const SurfaceProximity& proximity, const SurfaceReach& reach);

  /// Whether a vertex, which has moved, may stay there; else it must be put back.
  bool allows(int v);

private:
  const OptimizedMesh& Mesh;
  const SurfaceProximity& Proximity;
  const SurfaceReach Reach;
  std::vector<Vec3> Position;       // of the vertices, when they were allowed last
  std::vector<double> LargestAbout; // no distance about a vertex is larger
};
}

#endif
