// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangles glued along halfedges. Unlike a halfedge mesh it may hold two edges between the same
// two vertices, or an edge from a vertex to itself: what stitching charts can yield before swaps
// resolve it.
#ifndef stipple_TriangleComplex_h
#define stipple_TriangleComplex_h

#include "StippleFiltersMeshingModule.h"
#include "TriangleSurface.h"

#include <functional>

namespace stipple
{
/// A piece of a constraint, between two neighbouring samples of a backbone.
using Label = ElementId<struct LabelElement>;

struct STIPPLEFILTERSMESHING_EXPORT TriangleComplex
{
  std::vector<Triangle> triangles;
  HalfedgeTwins twin;
  ElementArray<Halfedge, Label> label; ///< the constraint that it lies on; equal on both sides

  int numberOfFaces() const { return static_cast<int>(this->triangles.size()); }
  ElementRange<Face> faces() const { return { 0, this->numberOfFaces() }; }
  ElementRange<Halfedge> halfedges() const { return { 0, 3 * this->numberOfFaces() }; }
  Triangle& triangle(Face f) { return this->triangles[static_cast<std::size_t>(f.index())]; }
  const Triangle& triangle(Face f) const
  {
    return this->triangles[static_cast<std::size_t>(f.index())];
  }
  Vertex tail(Halfedge h) const { return Vertex(this->triangle(faceOf(h))[cornerOf(h)]); }
  Vertex head(Halfedge h) const { return this->tail(nextHalfedge(h)); }
  Vertex apex(Halfedge h) const { return this->tail(previousHalfedge(h)); }
  bool isBoundary(Halfedge h) const { return !this->twin[h].valid(); }
  void glue(Halfedge h, Halfedge g)
  {
    if (h.valid())
    {
      this->twin[h] = g;
    }
    if (g.valid())
    {
      this->twin[g] = h;
    }
  }
  /// Replaces the edge of h by the other diagonal of its two triangles. h becomes the new edge from
  /// apex(twin) to apex(h); the triangles keep their numbers.
  void flip(Halfedge h);
  /// The next outgoing halfedge of the same vertex, clockwise resp. counterclockwise; none past the
  /// boundary.
  Halfedge turnLeft(Halfedge h) const { return this->twin[previousHalfedge(h)]; }
  Halfedge turnRight(Halfedge h) const
  {
    return this->isBoundary(h) ? Halfedge() : nextHalfedge(this->twin[h]);
  }
  /// All outgoing halfedges of the tail of `outgoing`, counterclockwise; from the boundary on if
  /// there is one. Empty if the halfedges about the vertex form no star: see isSound().
  std::vector<Halfedge> star(Halfedge outgoing) const;
  /// Every halfedge's twin has it as its own twin, and runs the other way between the same
  /// vertices.
  bool isSound() const;
  /// Rates a triangle (three corners) that could fill a hole; larger is better.
  using Score = std::function<double(Vertex, Vertex, Vertex)>;
  /// Takes a vertex of valence two in its chain of constraints out of the chain and of the complex,
  /// and fills the hole; the chain then runs directly between its neighbours. `outgoing` holds a
  /// halfedge a vertex and is kept so. Where nothing lies between two chains, they become one edge:
  /// merged gets the pair of their labels. Where two edges run between the vertex and another,
  /// swaps separate them first. False, and the vertex stays, if no triangle would be left on either
  /// side, or no disk. Freed triangles have corners -1.
  bool removeFromChain(Vertex vertex, ElementArray<Vertex, Halfedge>& outgoing, const Score& score,
    std::vector<std::array<Label, 2>>& merged);
  /// Drops freed triangles.
  void compact();
};
}

#endif
