// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where blocks meet: a graph of curves on the surface, and the samples on it. Every rank makes the
// same of the same edges.
#ifndef stipple_BlockBorders_h
#define stipple_BlockBorders_h

#include "Geometry.h"
#include "Progress.h"
#include "StippleFiltersParallelModule.h"

#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <vector>

class vtkPolyData;

namespace stipple
{
/// An edge that one of a block's triangles has and no other, in the direction of that triangle.
struct OpenEdge
{
  std::array<long long, 2> point = { { -1, -1 } }; ///< ids of its tail and head
  std::array<std::array<double, 3>, 2> x = {};
  std::array<double, 2> density = { { 1, 1 } }; ///< wanted there, up to one factor
  int block = -1;
  int isCrease = 0;   ///< the edge is sharp, or parts regions
  int hasFeature = 0; ///< an edge within the block that is a feature ends at the tail
};

/// A vertex of the mesh that blocks share: (1 - t) a + t b on the edge from point a to point b of
/// the surface, a < b; or point a if b is -1.
struct BorderSample
{
  long long a = -1;
  long long b = -1;
  double t = 0;
  Vec3 position = Vec3::Zero();
  std::vector<int> blocks; ///< that have it, ascending
  bool isHeld = false;     ///< on a crease, or where one ends: it stays where it is
};

/// Between two blocks, from node to node.
struct BorderCurve
{
  std::array<int, 2> blocks = { { -1, -1 } }; ///< ascending
  std::vector<int> samples; ///< from one to the next a mesh has an edge; the first one again if
                            ///< closed
  bool isCrease = false;
};

struct BlockBorders
{
  std::vector<BorderSample> samples;
  std::vector<BorderCurve> curves;
  /// Of an edge, from its point of the smaller id, the samples inside.
  std::map<std::array<long long, 2>, std::vector<int>> onEdge;
  std::map<long long, int> atPoint;
  /// Edges of one block alone, where the surface ends: as they are directed.
  std::vector<std::array<long long, 2>> boundary;
};

/// Matches open edges of all blocks and samples the curves so that neighbours are as far apart, in
/// a straight line, as equilateral triangles of the density have long edges: l = sqrt(2 / (sqrt(3)
/// rho)) for rho = scale times the density. Distances are straight ones because borders go to and
/// fro with the triangles' edges. Curves end where three blocks meet, and at features and
/// boundaries. An error names an edge of more than two triangles, or of two that are oriented
/// differently.
[[nodiscard]] STIPPLEFILTERSPARALLEL_EXPORT Status sampleBorders(
  std::vector<OpenEdge> edges, double scale, BlockBorders& borders);

/// The curves as polylines from sample to sample, with the cell array `BlockIds` of two blocks
/// each.
STIPPLEFILTERSPARALLEL_EXPORT vtkSmartPointer<vtkPolyData> toPolyData(const BlockBorders& borders);
}

#endif
