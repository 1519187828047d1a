// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A part of the mesh that goes over borders of blocks, with the surface under it, as ranks hand it
// to one another.
#ifndef stipple_MeshPatch_h
#define stipple_MeshPatch_h

#include "BlockRemeshing.h"
#include "MeshOptimizer.h"

namespace stipple
{
/// What one block has of a patch.
struct PatchPart
{
  int block = -1;
  // The mesh.
  std::vector<long long> id;
  std::vector<Vec3> position;
  std::vector<char> isMovable;
  std::vector<char> movesLater; ///< in a patch of another color
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<int, 2>> lines; ///< edges that stay
  // The surface.
  std::vector<long long> surfaceId;
  std::vector<Vec3> surfacePosition;
  std::vector<double> density;
  std::vector<std::array<int, 3>> surfaceTriangles;
  std::vector<std::array<int, 2>> source; ///< block and triangle of each
  std::vector<std::array<int, 2>> creases;

  /// Appends itself, and a number for the reader.
  void write(long long number, Bytes& bytes) const;
  void read(const Bytes& bytes, std::size_t& at, long long& number);
};

/// What became of it.
struct HealedPatch
{
  long long patch = -1;
  std::vector<long long> id;
  std::vector<Vec3> position;
  std::vector<char> isMovable;
  std::vector<char> movesLater;
  std::vector<BlockPlace> place;
  std::vector<std::array<int, 3>> triangles;
  std::vector<BlockPlace> trianglePlace; ///< the block is to have the triangle

  void write(long long number, Bytes& bytes) const;
  void read(const Bytes& bytes, std::size_t& at, long long& number);
};

/// Puts the parts of a patch together and optimises what is movable in it. Parts have all triangles
/// about points that are movable and about their neighbours; only those that have a movable point
/// are in the result.
[[nodiscard]] STIPPLEFILTERSPARALLEL_EXPORT Status optimizePatch(
  const std::vector<PatchPart>& parts, const OptimizerOptions& options, HealedPatch& healed);
}

#endif
