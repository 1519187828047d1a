// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// From a soup of polygons as found in files to an oriented manifold surface, every repair counted.
#ifndef stipple_SurfaceRepair_h
#define stipple_SurfaceRepair_h

#include "Progress.h"
#include "StippleFiltersAtlasModule.h"
#include "TriangleSurface.h"

class vtkPolyData;

namespace stipple
{
struct RepairCounts
{
  int weldedPoints = 0; ///< points merged into another one at the very same place, or on open
                        ///< edges that rounding alone keeps apart (two units in the last place of
                        ///< single precision, of the surface's size); those that triangles close a
                        ///< fan around stay
  int unusedPoints = 0; ///< points that no triangle uses
  int degenerateTriangles = 0; ///< triangles without area but for rounding, removed
  int duplicateTriangles = 0;  ///< second and further copies of a triangle
  int reorientedTriangles = 0; ///< triangles turned around to agree with their neighbours
  int splitEdges = 0;          ///< edges of more than two triangles
  int splitVertices = 0; ///< copies made of points where sheets met in a point or a non-manifold
                         ///< edge
};

struct RepairedSurface
{
  TriangleSurface surface;       ///< manifold, oriented, connected; all points used
  std::vector<int> sourcePoint;  ///< input point of every point
  std::vector<int> sourceCell;   ///< input cell of every triangle
  std::vector<int> pointOfInput; ///< a point for every input point, -1 if it was dropped
  std::vector<Halfedge> joints;  ///< edges where other sheets of the input meet the surface
  RepairCounts counts;
};

/// Welds, triangulates, orients and splits the non-manifold; drops triangles without area, and
/// those that rounding alone keeps from it. An error names the first point that is NaN or infinite,
/// or tells that the surface is too large or too small for the maps' single precision.
STIPPLEFILTERSATLAS_EXPORT Status repairSurface(
  vtkPolyData* input, RepairedSurface& repaired, const Progress& progress = {});
}

#endif
