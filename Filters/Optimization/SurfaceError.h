// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How far the surface's points lie from the mesh, and moves and swaps that bring the mesh nearer.
#ifndef stipple_SurfaceError_h
#define stipple_SurfaceError_h

#include "CompressedRows.h"
#include "MeshEdit.h"
#include "StippleFiltersOptimizationModule.h"
#include "TriangleDistance.h"

namespace stipple
{
/// The points of the surface, each with the vertex of the mesh that is nearest along its edges.
class STIPPLEFILTERSOPTIMIZATION_EXPORT SurfaceError
{
public:
  /// Borrows the mesh. Vertices may move and edges be swapped, as long as they stay near.
  explicit SurfaceError(const OptimizedMesh& mesh);

  /// Squared distances of points to the triangles about the vertices that they are next to.
  struct Measure
  {
    double sum = 0;
    double largest = 0;
    int farthest = -1; ///< the point of the largest; -1 if all lie on the mesh
  };
  /// Of the points next to a vertex.
  Measure at(Vertex v) const;
  /// Of the points next to a vertex and its one-ring: all that moving the vertex can change.
  Measure about(Vertex v) const;
  /// The same, but looks no further once the bound's sum is reached or its largest exceeded.
  Measure aboutUpTo(Vertex v, const Measure& bound) const;

  /// The points next to a vertex, ascending.
  std::vector<int> pointsOf(Vertex v) const
  {
    const auto points = this->Points[v.index()];
    return { points.begin(), points.end() };
  }

private:
  /// at(), but looks no further once the sum, with what others had, reaches the bound's, or the
  /// largest exceeds it.
  Measure atUpTo(Vertex v, double sumOfOthers, const Measure& bound) const;

  const OptimizedMesh& Mesh;
  CompressedRows<int> Points; // by vertex
};

/// Moves vertices where the surface is farthest from the mesh: about the given share (0 to 1) of
/// all vertices, those with the farthest points beside them. Every move lowers the sum of squared
/// distances about the vertex and does not raise the largest, makes no triangle worse than
/// minimumAngle (radians), and keeps areas even. Where a tip stays cut off, edges
/// are swapped too. Returns the number of moves and swaps.
STIPPLEFILTERSOPTIMIZATION_EXPORT int reduceSurfaceError(
  MeshEdit& edit, double minimumAngle, double share);
}

#endif
