// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// An indexed, oriented, manifold triangle surface with halfedge adjacency.
#ifndef stipple_TriangleSurface_h
#define stipple_TriangleSurface_h

#include "ElementIds.h"
#include "Geometry.h"
#include "StippleFiltersCoreModule.h"

#include <array>
#include <vector>

namespace stipple
{
using Triangle = std::array<int, 3>;

/// Halfedge k of a face runs from its corner k to corner k + 1, with the face on its left. All that
/// is known of how halfedges are numbered stands here; it holds for any list of triangles.
constexpr int nextCorner(int corner)
{
  return corner == 2 ? 0 : corner + 1;
}
constexpr int previousCorner(int corner)
{
  return corner == 0 ? 2 : corner - 1;
}
constexpr Halfedge halfedgeOf(Face face, int corner)
{
  return Halfedge(3 * face.index() + corner);
}
constexpr Face faceOf(Halfedge h)
{
  return Face(h.index() / 3);
}
constexpr int cornerOf(Halfedge h)
{
  return h.index() % 3;
}
constexpr Halfedge nextHalfedge(Halfedge h)
{
  return Halfedge(h.index() % 3 == 2 ? h.index() - 2 : h.index() + 1);
}
constexpr Halfedge previousHalfedge(Halfedge h)
{
  return Halfedge(h.index() % 3 == 0 ? h.index() + 2 : h.index() - 1);
}
constexpr ElementRange<Halfedge> halfedgesOf(Face face)
{
  return { 3 * face.index(), 3 * face.index() + 3 };
}

// The same for callers that still count with an int.
constexpr int nextHalfedge(int h)
{
  return nextHalfedge(Halfedge(h)).index();
}
constexpr int previousHalfedge(int h)
{
  return previousHalfedge(Halfedge(h)).index();
}

using HalfedgeTwins = ElementArray<Halfedge, Halfedge>;

/// A directed edge that more than one triangle has: it has no twin, and the surface is no manifold
/// there.
constexpr Halfedge NonManifoldTwin{ -2 };

/// Twin of every halfedge, none on a boundary. Halfedges are matched by their directed end points;
/// a directed edge that occurs twice (a non-manifold or mis-oriented surface) yields
/// NonManifoldTwin for all its halfedges.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT HalfedgeTwins halfedgeTwins(
  const std::vector<Triangle>& triangles);

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
  HalfedgeTwins twin; ///< call connect() after the triangles changed

  void connect() { this->twin = halfedgeTwins(this->triangles); }

  int numberOfVertices() const { return static_cast<int>(this->points.size()); }
  int numberOfFaces() const { return static_cast<int>(this->triangles.size()); }
  int numberOfHalfedges() const { return 3 * this->numberOfFaces(); }
  ElementRange<Vertex> vertices() const { return { 0, this->numberOfVertices() }; }
  ElementRange<Face> faces() const { return { 0, this->numberOfFaces() }; }
  ElementRange<Halfedge> halfedges() const { return { 0, this->numberOfHalfedges() }; }

  const Triangle& triangle(Face face) const { return this->triangles[face.index()]; }
  Vertex vertex(Face face, int corner) const { return Vertex(this->triangle(face)[corner]); }
  Vertex tail(Halfedge h) const { return this->vertex(faceOf(h), cornerOf(h)); }
  Vertex head(Halfedge h) const { return this->tail(nextHalfedge(h)); }
  bool isBoundary(Halfedge h) const { return !this->twin[h].valid(); }
  const Vec3& point(Vertex v) const { return this->points[v.index()]; }
  const Vec3& point(Face face, int corner) const { return this->point(this->vertex(face, corner)); }
  /// From tail to head.
  Vec3 edge(Halfedge h) const { return this->point(this->head(h)) - this->point(this->tail(h)); }
  double edgeLength(Halfedge h) const { return this->edge(h).norm(); }
  double faceArea(Face face) const
  {
    return triangleArea(this->point(face, 0), this->point(face, 1), this->point(face, 2));
  }
  /// Unit normal; zero for a degenerate triangle.
  Vec3 faceNormal(Face face) const;
  Vec3 position(Face face, const Vec3& bary) const
  {
    return bary[0] * this->point(face, 0) + bary[1] * this->point(face, 1) +
      bary[2] * this->point(face, 2);
  }
  double area() const;
  double boundingBoxDiagonal() const;
  /// One outgoing halfedge a vertex (the one with no predecessor across it on a boundary), none if
  /// unused.
  ElementArray<Vertex, Halfedge> vertexHalfedges() const;
  SurfaceTopology topology() const;

  // The same for callers that still count with an int.
  int tail(int h) const { return this->tail(Halfedge(h)).index(); }
  int head(int h) const { return this->head(Halfedge(h)).index(); }
  const Vec3& point(int face, int corner) const { return this->point(Face(face), corner); }
  double faceArea(int face) const { return this->faceArea(Face(face)); }
  Vec3 faceNormal(int face) const { return this->faceNormal(Face(face)); }
  Vec3 position(int face, const Vec3& bary) const { return this->position(Face(face), bary); }
};

/// The halfedge from vertex p to vertex q, or none; first is vertexHalfedges().
STIPPLEFILTERSCORE_EXPORT Halfedge findHalfedge(
  const TriangleSurface& surface, const ElementArray<Vertex, Halfedge>& first, Vertex p, Vertex q);
}

#endif
