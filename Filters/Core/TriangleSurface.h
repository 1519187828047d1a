// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// An indexed, oriented, manifold triangle surface with halfedge adjacency.
#ifndef stipple_TriangleSurface_h
#define stipple_TriangleSurface_h

#include "Geometry.h"
#include "StippleFiltersCoreModule.h"

#include <array>
#include <vector>

namespace stipple
{
using Triangle = std::array<int, 3>;

/// Halfedge 3 f + k runs from corner k of triangle f to corner k + 1, with f on its left.
inline int nextHalfedge(int h)
{
  return h % 3 == 2 ? h - 2 : h + 1;
}
inline int previousHalfedge(int h)
{
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// Twin of every halfedge, -1 on a boundary. Halfedges are matched by their directed end points; a
/// directed edge that occurs twice (a non-manifold or mis-oriented surface) yields -2 for all its
/// halfedges.
STIPPLEFILTERSCORE_EXPORT std::vector<int> halfedgeTwins(const std::vector<Triangle>& triangles);

struct SurfaceTopology
{
  int components = 0;
  int boundaryLoops = 0;
  int euler = 0; ///< V - E + F over the vertices that triangles use
  bool manifold = false;
  bool operator==(const SurfaceTopology& o) const
  {
    return components == o.components && boundaryLoops == o.boundaryLoops && euler == o.euler &&
      manifold == o.manifold;
  }
};

struct STIPPLEFILTERSCORE_EXPORT TriangleSurface
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<int> twin; ///< by halfedge; call connect() after the triangles changed

  void connect() { this->twin = halfedgeTwins(this->triangles); }

  int numberOfFaces() const { return static_cast<int>(this->triangles.size()); }
  int tail(int h) const { return this->triangles[h / 3][h % 3]; }
  int head(int h) const { return this->tail(nextHalfedge(h)); }
  const Vec3& point(int face, int corner) const
  {
    return this->points[this->triangles[face][corner]];
  }
  double faceArea(int face) const
  {
    return triangleArea(this->point(face, 0), this->point(face, 1), this->point(face, 2));
  }
  /// Unit normal; zero for a degenerate triangle.
  Vec3 faceNormal(int face) const;
  Vec3 position(int face, const Vec3& bary) const
  {
    return bary[0] * this->point(face, 0) + bary[1] * this->point(face, 1) +
      bary[2] * this->point(face, 2);
  }
  double area() const;
  double boundingBoxDiagonal() const;
  /// One outgoing halfedge a vertex (the one with no predecessor across it on a boundary), -1 if
  /// unused.
  std::vector<int> vertexHalfedges() const;
  SurfaceTopology topology() const;
};

/// The halfedge from point p to point q, or -1; first is vertexHalfedges().
STIPPLEFILTERSCORE_EXPORT int findHalfedge(
  const TriangleSurface& surface, const std::vector<int>& first, int p, int q);
}

#endif
