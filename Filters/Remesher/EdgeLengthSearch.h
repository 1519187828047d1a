// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How many points a mesh needs for its edges to be as long as asked for.
#ifndef stipple_EdgeLengthSearch_h
#define stipple_EdgeLengthSearch_h

#include "StippleFiltersRemesherModule.h"
#include "TriangleSurface.h"

namespace stipple
{
/// Of all edges of a mesh, borders too; 0 without triangles.
[[nodiscard]] STIPPLEFILTERSREMESHER_EXPORT double medianEdgeLength(const TriangleSurface& mesh);

/// The number that follows from the area is right where the surface is smooth and wide; where
/// features ask for points, where sheets are thin and where triangles cut across what is bent,
/// edges are shorter than that. Here the mesh is measured and the number corrected: lengths fall
/// with the root of the number, and as told by two meshes from then on.
class STIPPLEFILTERSREMESHER_EXPORT EdgeLengthSearch
{
public:
  /// The share of what is wanted by which the median may be off.
  static constexpr double Tolerance = 0.05;

  /// For edges of the length `wanted`, above 0.
  explicit EdgeLengthSearch(double wanted);

  /// The number of points to try next; 0 if the search is over.
  int next() const { return this->Next; }
  /// A mesh that was asked for `asked` points has `got` (more if there is none of so few) and
  /// edges of this median length.
  void add(int asked, int got, double median);

  /// The number of points of the mesh whose edges are nearest to what is wanted, on a logarithmic
  /// scale; 0 without a mesh.
  int found() const { return this->Best.points; }

private:
  struct Trial
  {
    int points = 0;
    double error = 0; ///< logarithm of the median over the wanted length
  };

  const double Wanted;
  int Next = 0;
  int Trials = 0;
  Trial Last;
  Trial Best;
};
}

#endif
