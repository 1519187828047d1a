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
struct STIPPLEFILTERSMESHING_EXPORT TriangleComplex
{
  std::vector<Triangle> triangles;
  HalfedgeTwins twin;     ///< by halfedge, -1 on the boundary
  std::vector<int> label; ///< by halfedge, the constraint that it lies on, or -1; equal on both
                          ///< sides

  int numberOfHalfedges() const { return 3 * static_cast<int>(this->triangles.size()); }
  int tail(int h) const { return this->triangles[h / 3][h % 3]; }
  int head(int h) const { return this->tail(nextHalfedge(h)); }
  int apex(int h) const { return this->tail(previousHalfedge(h)); }
  void glue(int h, int g)
  {
    if (h >= 0)
    {
      this->twin[h] = g;
    }
    if (g >= 0)
    {
      this->twin[g] = h;
    }
  }
  /// Replaces the edge of h by the other diagonal of its two triangles. h becomes the new edge from
  /// apex(twin) to apex(h); the triangles keep their numbers.
  void flip(int h);
  /// The next outgoing halfedge of the same vertex, clockwise resp. counterclockwise; -1 past the
  /// boundary.
  int turnLeft(int h) const { return this->twin[previousHalfedge(h)]; }
  int turnRight(int h) const { return this->twin[h] < 0 ? -1 : nextHalfedge(this->twin[h]); }
  /// All outgoing halfedges of the tail of `outgoing`, counterclockwise; from the boundary on if
  /// there is one. Empty if the halfedges about the vertex form no star: see isSound().
  std::vector<int> star(int outgoing) const;
  /// Every halfedge's twin has it as its own twin, and runs the other way between the same
  /// vertices.
  bool isSound() const;
  /// Rates a triangle (three corners) that could fill a hole; larger is better.
  using Score = std::function<double(int, int, int)>;
  /// Takes a vertex of valence two in its chain of constraints out of the chain and of the complex,
  /// and fills the hole; the chain then runs directly between its neighbours. `outgoing` holds a
  /// halfedge a vertex and is kept so. Where nothing lies between two chains, they become one edge:
  /// merged gets the pair of their labels. Where two edges run between the vertex and another,
  /// swaps separate them first. False, and the vertex stays, if no triangle would be left on either
  /// side, or no disk. Freed triangles have corners -1.
  bool removeFromChain(int vertex, std::vector<int>& outgoing, const Score& score,
    std::vector<std::array<int, 2>>& merged);
  /// Drops freed triangles.
  void compact();
};
}

#endif
