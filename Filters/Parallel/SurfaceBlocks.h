// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The blocks of a surface, each with all that remeshing it needs, on the rank that it is dealt to.
#ifndef stipple_SurfaceBlocks_h
#define stipple_SurfaceBlocks_h

#include "Geometry.h"
#include "RankMessages.h"
#include "TriangleSurface.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>

class vtkPolyData;

namespace stipple
{
/// Where a rank's part of the surface comes from: pieces, which are asked for in their order, and
/// more than once. Pieces of all ranks, rank by rank, are the surface.
struct SurfacePieces
{
  int count = 0;
  std::function<Status(int, vtkSmartPointer<vtkPolyData>&)> read;
};

/// A block's triangles and, behind them, those of other blocks about it: all that touch its box,
/// made larger by some edges of the mesh to be.
/// Points are in the order of their ids, triangles of each kind in that of theirs, so that nothing
/// depends on who had them before.
struct SurfaceBlock
{
  int number = 0;                    ///< of the block, from 0
  vtkSmartPointer<vtkPolyData> data; ///< the triangles, with the arrays that all pieces have
  std::string file;    ///< where it is when nobody works on it; empty: in memory all the time
  int numberOfOwn = 0; ///< triangles of the block itself
  std::vector<long long> pointId;    ///< of the whole surface, by point
  std::vector<long long> triangleId; ///< of the whole surface
  std::vector<int> owner;            ///< the block that a triangle is of
  std::vector<long long> cellId;     ///< the input's cell that a triangle is of, by triangle
};

/// What blocks a rank has, and what is known of the whole surface.
struct SurfaceBlocks
{
  int count = 0;                   ///< of the whole surface; those without a triangle, too
  std::vector<SurfaceBlock> own;   ///< ascending, without empty ones
  long long numberOfTriangles = 0; ///< of the whole surface
  bool isInFiles = false;          ///< nobody works on more than one at a time
  double area = 0;                 ///< of the whole surface
  double diagonal = 0;             ///< of its bounding box
  /// Blocks are dealt in a row: the rank of one.
  int rankOf(int block, int ranks) const
  {
    return static_cast<int>(static_cast<long long>(block) * ranks / std::max(1, this->count));
  }
};

/// Cuts a surface into blocks of at most so many triangles (but for triangles whose centres have
/// the same coordinate), and moves them to their ranks. Points at the same place are one, or where
/// every piece has global ids, those of the same global id; a point's id is the least number that
/// any copy of it has when the points of all pieces are counted in a row, or the global id.
/// With a folder blocks are kept in files there, named after the rank, and of the surface there is
/// in memory what is proportional to the number of its points and triangles (some 30 bytes a
/// triangle) and a piece or a block at a time. Boxes are made larger by three edges of equilateral
/// triangles that `points` points make of the surface.
[[nodiscard]] STIPPLEFILTERSPARALLEL_EXPORT Status makeBlocks(const SurfacePieces& pieces,
  long long trianglesPerBlock, long long points, const std::string& folder,
  const RankMessages& ranks, SurfaceBlocks& blocks);

/// Gives triangles, by their ids, to other blocks, which must know them.
STIPPLEFILTERSPARALLEL_EXPORT void moveTriangles(
  const std::map<long long, int>& newOwner, SurfaceBlocks& blocks);

/// The length of edges of equilateral triangles that so many points make of an area:
/// sqrt(2 area / (sqrt(3) points)), as a closed surface has two triangles a point.
inline double edgeLengthOf(double area, double points)
{
  return points > 0 ? std::sqrt(2. * area / (std::sqrt(3.) * points)) : 0.;
}
}

#endif
