// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Swaps in a row that give a vertex on a crease two neighbours on one side.
#ifndef stipple_RibSearch_h
#define stipple_RibSearch_h

#include "MeshEdit.h"
#include "SurfaceProximity.h"

#include <cstdint>
#include <unordered_map>

namespace stipple
{
/// What the search for the swaps of one side may spend, and what the mesh must keep.
struct RibDemand
{
  int sequences;          ///< of swaps that are looked at
  int trials;             ///< of them, those after which vertices are moved
  double minimumAngle;    ///< radians; of triangles, unless they had smaller ones
  SurfaceDistances bound; ///< from the surface
};

/// Looks for swaps that mend one side of a vertex: best first, by what they cost and how many they
/// are. What was found in vain is kept for lesser demands, for as long as nothing changes there.
class RibSearch
{
public:
  /// Borrows both. The budget is of sequences, and of what moves cost in sequences.
  RibSearch(MeshEdit& edit, const SurfaceProximity& proximity, int budget);

  /// The side to the left of a halfedge along a crease, about the vertex that it leaves. Returns
  /// whether it was mended. Once the budget is spent, it is not.
  bool mend(Halfedge h, const RibDemand& demand);

  /// The vertices about all swaps that were made, some more than once.
  const std::vector<Vertex>& moved() const { return this->Moved; }

private:
  /// Swaps in a row: those of another sequence, and one more.
  struct Sequence
  {
    int base = -1;
    Edge edge;
    int length = 0;
    int change = 0;            ///< of the cost
    std::uint64_t outcome = 0; ///< the same for sequences that lead to the same edges
  };
  /// A search that was in vain.
  struct Attempt
  {
    int time = 0;
    RibDemand demand;
    std::vector<Vertex> vertices; ///< about which it has swapped
    std::vector<std::vector<Edge>> candidates;
  };

  bool hasChanged(const Attempt& attempt) const;
  bool search(Halfedge h, const RibDemand& demand);
  std::vector<Edge> edgesOf(const std::vector<Sequence>& sequences, int index) const;
  void note(Edge e, Attempt& attempt);
  bool isWall(Halfedge h) const { return !this->Mesh.isSwappable(this->Mesh.edge(h)); }
  Halfedge beginOfSide(Halfedge h) const;
  void addEdges(Halfedge h, bool opposite, std::vector<Edge>& edges) const;
  void addHelpfulSwaps(Halfedge h, std::vector<Edge>& edges) const;
  void addSwapsAfter(const std::vector<Edge>& sequence, std::vector<Edge>& edges) const;
  bool swapAndSettle(const std::vector<Edge>& edges, const RibDemand& demand);

  MeshEdit& Edit;
  const OptimizedMesh& Mesh;
  const SurfaceProximity& Proximity;
  int Budget;
  int Time = 0;                         // swaps that were made
  ElementArray<Vertex, int> LastChange; // of a vertex or its edges
  int Searches = 0;
  ElementArray<Vertex, int> Seen; // the last search that came by a vertex
  std::vector<Vertex> Moved;
  std::unordered_map<Halfedge, Attempt> Memory; // by the halfedge that a side begins with
};
}

#endif
