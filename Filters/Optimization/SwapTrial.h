// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Swaps that are good for nothing before the vertices about them have moved, and may be taken back.
#ifndef stipple_SwapTrial_h
#define stipple_SwapTrial_h

#include "OptimizedMesh.h"
#include "StippleFiltersOptimizationModule.h"

namespace stipple
{
/// Halfedges out of the four vertices of an edge's triangles, all in these triangles: the edge's
/// ends, then the others.
std::array<OptimizedMesh::Halfedge, 4> cornersAbout(const OptimizedMesh& mesh, int edge);

/// One after the other, without asking.
void swapAll(OptimizedMesh& mesh, const std::vector<int>& edges);
void swapBack(OptimizedMesh& mesh, const std::vector<int>& edges);

/// Where a vertex stands.
struct Stand
{
  Footing footing;
  double arcLength;
};
inline Stand standOf(const OptimizedMesh& mesh, int v)
{
  return { mesh.footing(v), mesh.arcLength(v) };
}

class STIPPLEFILTERSOPTIMIZATION_EXPORT SwapTrial
{
public:
  /// Borrows both. The edges are not swapped yet.
  SwapTrial(OptimizedMesh& mesh, const std::vector<int>& edges);

  /// Swaps the edges and moves vertices, on creases along them, until all triangles are as good as
  /// minimumAngle (radians), or as good as the worst of them was, and none is folded over. Returns
  /// whether that could be had.
  bool settle(double minimumAngle);
  /// Undoes what settle() did.
  void takeBack();

  /// The vertices that may move.
  const std::vector<int>& vertices() const { return this->Vertices; }
  /// Those that the swaps change edges of.
  const std::vector<int>& inner() const { return this->Inner; }
  /// All that swaps and moves change.
  const std::vector<int>& faces() const { return this->Faces; }

private:
  void putBack();
  double worstQuality() const;
  double worstBend() const;
  void slideToMiddle(int v);
  void spread();
  bool improve(double enough, double wanted);

  OptimizedMesh& Mesh;
  const std::vector<int>& Edges;
  std::vector<int> Vertices;
  std::vector<int> Inner;
  std::vector<int> Faces;
  std::vector<Stand> Before; // of Vertices
};
}

#endif
