// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Knots: regions whose triangles cover the surface more than once, all of them facing the right
// way. Moves of one vertex at a time do not undo them; placing all vertices anew does.
#ifndef stipple_LocalEmbedding_h
#define stipple_LocalEmbedding_h

#include "OptimizedMesh.h"

namespace stipple
{
/// The vertices of some triangles and of so many rings about them, and what is needed to take back
/// their embedding.
class LocalEmbedding
{
public:
  LocalEmbedding(OptimizedMesh& mesh, const std::vector<int>& faces, int rings);

  /// All triangles that it changes, ascending.
  const std::vector<int>& faces() const { return this->Faces; }

  /// Puts every vertex that is free on the surface to the middle of its neighbours (Tutte's
  /// embedding, on the surface: without folds where the region is nearly flat), starting over from
  /// the vertices around; then swaps and moves for good angles. False if the longest edge became
  /// much longer: vertices were drawn off a part of the surface, which a few large triangles then
  /// cut off.
  [[nodiscard]] bool embed();
  /// Back to what was there before.
  void undo();

private:
  void placeInwards();
  void relax();
  void improve();

  OptimizedMesh& Mesh;
  std::vector<int> Vertices; // that may move
  std::vector<int> Faces;
  std::vector<Footing> Before; // of Vertices
  std::vector<int> Swapped;    // edges, in order
};

/// Triangles that hang together at vertices, each group ascending.
std::vector<std::vector<int>> groupsOf(const OptimizedMesh& mesh, const std::vector<int>& faces);

/// Embeds the vertices about triangles, of as few rings as make isBetter(after, before) true of
/// what measure(faces) says of the triangles changed. Returns these; none if no number of rings
/// helps.
template <typename Measure, typename IsBetter>
std::vector<int> embedAbout(OptimizedMesh& mesh, const std::vector<int>& faces, int mostRings,
  const Measure& measure, const IsBetter& isBetter)
{
  for (int rings = 0; rings <= mostRings; ++rings)
  {
    LocalEmbedding embedding(mesh, faces, rings);
    const auto before = measure(embedding.faces());
    if (embedding.embed() && isBetter(measure(embedding.faces()), before))
    {
      return embedding.faces();
    }
    embedding.undo();
  }
  return {};
}

/// Embeds the vertices about triangles that are folded over, of as few rings as undo most of it.
/// Returns the number of groups of triangles where that helped.
int unfold(OptimizedMesh& mesh);
}

#endif
