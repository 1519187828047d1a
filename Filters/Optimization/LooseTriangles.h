// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A mesh's triangles and creases without halfedges: to be collapsed, split and led anew.
#ifndef stipple_LooseTriangles_h
#define stipple_LooseTriangles_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace stipple
{
using VertexPair = std::pair<Vertex, Vertex>;

inline VertexPair pairOf(Vertex a, Vertex b)
{
  return { std::min(a, b), std::max(a, b) };
}

inline bool has(const Triangle& t, Vertex v)
{
  return std::find(t.begin(), t.end(), v.index()) != t.end();
}

/// The third corner of a triangle.
inline Vertex apexOf(const Triangle& t, Vertex a, Vertex b)
{
  return Vertex(t[0] + t[1] + t[2] - a.index() - b.index());
}

inline Triangle replaced(Triangle t, Vertex v, Vertex by)
{
  std::replace(t.begin(), t.end(), v.index(), by.index());
  return t;
}

/// The mesh's triangles and chains, to be changed in ways that MeshEdit has not.
class STIPPLEFILTERSOPTIMIZATION_EXPORT LooseTriangles
{
public:
  using Chain = OptimizedMesh::Chain;

  explicit LooseTriangles(const OptimizedMesh& mesh);

  /// Those that were there at first come first; those that are gone have no corners.
  const std::vector<Triangle>& triangles() const { return this->Triangles; }
  const Triangle& triangle(int t) const { return this->Triangles[t]; }
  bool isGone(int t) const { return this->Triangles[t][0] < 0; }
  /// The triangles whose corners have changed since this was called last.
  std::vector<int> takeChanges() { return std::exchange(this->Changed, {}); }
  const std::vector<Chain>& chains() const { return this->Chains; }
  const std::vector<int>& about(Vertex v) const { return this->About[v]; }
  const std::vector<int>& chainsOf(Vertex v) const { return this->ChainsOf[v]; }
  bool isCrease(Vertex a, Vertex b) const { return this->Creases.count(pairOf(a, b)) > 0; }
  /// What is to be kept of an edge.
  Keep keep(Vertex a, Vertex b) const;

  /// The vertices that edges join to one, ascending.
  std::vector<Vertex> ring(Vertex v) const;
  /// The triangles of an edge.
  std::vector<int> beside(Vertex a, Vertex b) const;
  /// The triangles over a triangle's edges.
  std::vector<int> neighbours(int t) const;
  int numberOfCreases(Vertex v) const;
  /// Whether lines that must stay do, and regions stay apart, when v has gone to u: v may lie
  /// inside a border that leads to u. A triangle that goes may have one more edge on the border, as
  /// the tip of a tooth has; a region that has only that triangle stays.
  bool keepsLines(Vertex v, Vertex u) const;
  bool isOnBoundary(Vertex v) const;

  /// Whether a manifold of the same topology is left when v has gone to u: the link condition (Dey,
  /// Edelsbrunner, Guha and Nekhayev 1999).
  bool mayCollapse(Vertex v, Vertex u) const;
  /// Moves v to u. Creases go with it.
  void collapse(Vertex v, Vertex u);

  /// Swaps the crease (p, q) between two triangles for the edge between their other corners, v and
  /// another one, and leads its chains over v. On a boundary, the triangle goes.
  void bend(Vertex p, Vertex q, Vertex v);

  /// Vertices that edges join to both ends of an edge without a triangle between the three: while
  /// there are any, it may not be collapsed.
  std::vector<Vertex> obstacles(Vertex v, Vertex u) const;

  /// A place on one of the chains that an edge is part of.
  struct OnChain
  {
    int chain;
    std::size_t next; ///< place of the chain's vertex behind it
    double arcLength;
  };
  /// The places on an edge of creases at a share of the way from a to b, one a chain.
  std::vector<OnChain> onChains(Vertex a, Vertex b, double share) const;
  /// The edge of a chain that runs over an arc length, and the share of the way from its first
  /// vertex to its second at which that is.
  struct EdgeOfChain
  {
    VertexPair ends; ///< in the chain's direction; not valid if no edge does
    double share = 0;
  };
  EdgeOfChain edgeAt(int chain, double arcLength) const;
  /// Creases that ran along an edge run over another vertex now, at these places.
  void lead(Vertex a, Vertex b, const std::vector<OnChain>& places, Vertex over);
  /// Puts a vertex, which is in no triangle, on an edge of creases at these places.
  void splitCrease(Vertex a, Vertex b, const std::vector<OnChain>& places, Vertex middle);

  /// Swaps an edge between two triangles, no crease, for the one between their other corners.
  void swap(Vertex p, Vertex q);

  /// Puts a vertex, which is in no triangle, in the middle of some that are a disk without inner
  /// vertices, whose rim has these edges, counterclockwise; or on its boundary, where the rim has
  /// all edges but one.
  void fan(const std::vector<int>& disk, const std::vector<std::array<int, 2>>& rim, Vertex middle);

  /// Puts a vertex, which is in no triangle, on an edge between two.
  void split(Vertex a, Vertex b, Vertex middle);

private:
  void put(int t, const Triangle& corners);
  void insert(const std::vector<OnChain>& places, Vertex v);
  static void replaceIn(Chain& chain, Vertex v, Vertex u);

  const OptimizedMesh& Mesh;
  std::vector<Triangle> Triangles;
  std::vector<int> Changed; // since takeChanges()
  std::vector<Chain> Chains;
  ElementArray<Vertex, std::vector<int>> About;    // of its triangles
  ElementArray<Vertex, std::vector<int>> ChainsOf; // of a vertex; some of them more than once
  std::map<VertexPair, Keep> Creases;
};
}

#endif
