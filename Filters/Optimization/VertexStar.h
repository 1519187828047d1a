// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How good triangles are, and how good those about a vertex would be with the vertex elsewhere.
#ifndef stipple_VertexStar_h
#define stipple_VertexStar_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// Smallest angle of a triangle (radians) if it is sound; below zero if it is folded over, the
/// lower the farther; -2, as low as that goes, if it has no area.
STIPPLEFILTERSOPTIMIZATION_EXPORT double triangleQuality(
  const OptimizedMesh& mesh, const TriangleCorners& corners);
STIPPLEFILTERSOPTIMIZATION_EXPORT double faceQuality(const OptimizedMesh& mesh, Face f);
/// The least of some triangles; 10 of none.
STIPPLEFILTERSOPTIMIZATION_EXPORT double worstQuality(
  const OptimizedMesh& mesh, const std::vector<Face>& faces);

/// The worst quality of the triangles about a vertex; if some are folded, the sum of theirs.
STIPPLEFILTERSOPTIMIZATION_EXPORT double starQuality(const OptimizedMesh& mesh, Vertex v);

/// The triangles about a vertex, copied: as long as the vertices around it and its edges stay, they
/// are asked for many places of the vertex without changing the mesh. (A vertex on a crease must
/// have been put there.)
class STIPPLEFILTERSOPTIMIZATION_EXPORT VertexStar
{
public:
  VertexStar(const OptimizedMesh& mesh, Vertex v);

  /// starQuality() with the vertex there.
  double quality(const SurfacePoint& there) const;
  /// quality(there) > bound, without looking on once that is out of the question. A place of
  /// another vertex of the star never does: a folded triangle can be undone by moves, one without
  /// an edge can't.
  bool exceeds(const SurfacePoint& there, double bound) const;

private:
  template <typename Visit>
  void forEachQuality(const SurfacePoint& there, const Visit& visit) const;
  /// What of quality() is below zero.
  double folds(const SurfacePoint& there) const;
  struct Triangle
  {
    Vec3 q;
    Vec3 r;
    Vec3 normalQ; ///< zero on a crease, where the surface has no one normal
    Vec3 normalR;
    int normals; ///< of q and r, those that are not on a crease
    TriangleCorners corners;
  };
  /// OptimizedMesh's, if all three vertices are on creases; else 1.
  double normalAgreementOnCreases(const Triangle& t, const SurfacePoint& there) const;

  const OptimizedMesh& Mesh;
  Vertex V;
  std::vector<Triangle> Triangles; // (v, q, r)
  bool HasNormal = false;          // v is not on a crease
  mutable std::size_t First = 0;   // the triangle that failed last is likely to fail again
  // The last bound, for many places are held against one.
  mutable double Bound = 0;
  mutable double SineOfBound = 0;
  mutable double CosineOfBound = 1;
};
}

#endif
