// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of the mesh that pass through each other, where two sheets of the surface are closer
// than the mesh is fine; moves and swaps that part them.
#ifndef stipple_SelfIntersections_h
#define stipple_SelfIntersections_h

#include "BoxGrid.h"
#include "LocalEmbedding.h"
#include "MeshEdit.h"
#include "StippleFiltersOptimizationModule.h"

#include <memory>
#include <optional>

namespace stipple
{
/// Finds intersecting triangles of a mesh while vertices move and edges are swapped.
class STIPPLEFILTERSOPTIMIZATION_EXPORT SelfIntersections
{
public:
  /// Borrows the mesh.
  explicit SelfIntersections(const OptimizedMesh& mesh);
  ~SelfIntersections();

  /// Pairs of intersecting triangles of which one at least is among `faces`, as the mesh is now.
  /// The others must be where they were when update() last saw them.
  int count(const std::vector<Face>& faces) const;
  /// Takes note of where triangles are now.
  void update(const std::vector<Face>& faces);
  /// Triangles that intersect others, as last updated, ascending; the same for any number of
  /// threads.
  std::vector<Face> faces() const;
  /// Of triangles, as they were at first.
  double meanSize() const;
  /// Whether a triangle, as last updated, is nearer to one of the boxes than the mean size of
  /// triangles.
  bool isNear(Face face, BoxGrid& boxes) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Now;
};

/// What is known of a mesh's overlaps from what was done about them before.
struct KnownOverlaps
{
  /// Where the surface passes through itself, once asked.
  std::optional<BoxGrid> ofSurface;
  FailedEmbeddings folds;  ///< that unfold() could not undo
  FailedEmbeddings layers; ///< that could not be parted
  /// What resolveSelfIntersections() has left, unless the mesh has changed since.
  std::optional<int> left;
};

/// Triangles that intersect others where the surface does not pass through itself. What they are is
/// as last updated.
STIPPLEFILTERSOPTIMIZATION_EXPORT std::vector<Face> overlapsOf(
  const OptimizedMesh& mesh, const SelfIntersections& intersections, KnownOverlaps& known);

/// Moves vertices and swaps edges of intersecting triangles, always such that fewer pairs
/// intersect and no triangle gets worse than Tuning::PartingAngle unless it was; what is left is
/// embedded anew. What is where the surface passes through itself is left as it is, and so is a
/// mesh that passes through itself elsewhere in more than 250 and 2 % of its triangles. Returns the
/// number of triangles that still intersect others elsewhere.
STIPPLEFILTERSOPTIMIZATION_EXPORT int resolveSelfIntersections(
  MeshEdit& edit, int maximumNumberOfPasses, KnownOverlaps& known);
}

#endif
