// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A triangulation of a surface that knows lengths along it and no positions: edges are flipped
// without the surface noticing, until they are Delaunay.
#ifndef stipple_IntrinsicTriangulation_h
#define stipple_IntrinsicTriangulation_h

#include "ChartMesh.h"

#include <vector>

namespace stipple
{
/// Starts as a chart's own triangles. Edges of the boundary stay.
class STIPPLEFILTERSATLAS_EXPORT IntrinsicTriangulation
{
public:
  IntrinsicTriangulation(const TriangleSurface& surface, const ChartMesh& chart);

  /// Flips edges until the angles opposite each sum to pi at most, so that cotangent weights of
  /// inner edges are not negative and values obey the maximum principle (Bobenko and Springborn,
  /// A discrete Laplace-Beltrami operator for simplicial surfaces, 2007; Fisher, Springborn,
  /// Schroeder, Bobenko, An algorithm for the construction of intrinsic Delaunay triangulations,
  /// 2007). Returns the number of flips.
  int flipToDelaunay();

  /// Halfedges are numbered as those of surfaces are.
  ElementRange<Halfedge> halfedges() const
  {
    return { 0, static_cast<int>(3 * this->Triangles.size()) };
  }
  /// A vertex of the chart; an edge may come back to where it began.
  int tail(Halfedge h) const { return this->Triangles[faceOf(h).index()][cornerOf(h)]; }
  int head(Halfedge h) const { return this->tail(nextHalfedge(h)); }
  double length(Halfedge h) const { return this->Length[h]; }
  bool isBoundary(Halfedge h) const { return !this->Twin[h].valid(); }
  /// Of the angle opposite a halfedge, at most LargestCotangent in size: slivers stay finite.
  double cotangentOpposite(Halfedge h) const;
  static constexpr double LargestCotangent = 1e8;

private:
  bool isDelaunay(Halfedge h) const;
  void flip(Halfedge h);

  std::vector<Triangle> Triangles;
  ElementArray<Halfedge, double> Length;
  HalfedgeTwins Twin;
};
}

#endif
