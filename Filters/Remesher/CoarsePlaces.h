// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a mesh's edges are too long for it to be sound or beautiful.
#ifndef stipple_CoarsePlaces_h
#define stipple_CoarsePlaces_h

#include "Atlas.h"
#include "Progress.h"
#include "StippleFiltersRemesherModule.h"
#include "TriangleIntersections.h"
#include "TriangleSurface.h"

#include <array>
#include <functional>
#include <vector>

class vtkDoubleArray;
class vtkPolyData;

namespace stipple
{
struct CoarsePlace
{
  Vec3 position;
  double edgeLength;         ///< the mean of the triangles' there
  bool isOverlap;            ///< the mesh passes through itself; else its triangle is just poor
  std::array<Face, 2> faces; ///< those that do so; twice the poor one
};

/// Smallest angle of a triangle, in degrees, that shorter edges are not asked for.
constexpr double SmallestGoodAngle = 15.;

/// Places where the mesh passes through itself and the surface does not (findOverlaps()): sheets
/// are closer together than edges are long. And triangles with smaller angles than
/// SmallestGoodAngle of which a vertex may go anywhere (isFree): the surface is bent more than they
/// can follow. What lies between features alone is as these are. Of no use if stopped.
[[nodiscard]] STIPPLEFILTERSREMESHER_EXPORT std::vector<CoarsePlace> coarsePlaces(
  const TriangleSurface& mesh, const std::vector<char>& isFree,
  const std::function<std::vector<Box>()>& known, const Stop& stop = {});

/// How many places there are where a mesh passes through itself, and how many others.
struct CoarsePlaceCount
{
  int overlaps = 0;
  int poor = 0;
  int triangles = 0; ///< at any of them

  /// What is wrong goes before what is ugly.
  bool operator<(const CoarsePlaceCount& o) const
  {
    return this->overlaps != o.overlaps ? this->overlaps < o.overlaps : this->poor < o.poor;
  }
};

/// These places of a mesh as rows for vtkControlMap::SetSizePlaces(), a share of the edges that are
/// there, added to others: where it passes through itself, and where it is poor. Either may be
/// null; all are counted.
[[nodiscard]] STIPPLEFILTERSREMESHER_EXPORT Status addSizePlaces(vtkPolyData* mesh,
  const Atlas& atlas, double share, const Progress& progress, vtkDoubleArray* overlapping,
  vtkDoubleArray* poor, CoarsePlaceCount& count);

/// The distance between a mesh and its surface, over the surface's diagonal; 0 if it does not show
/// (Tuning::VisibleDistance).
[[nodiscard]] STIPPLEFILTERSREMESHER_EXPORT Status visibleDistance(
  vtkPolyData* mesh, const Atlas& atlas, const Progress& progress, double& distance);
}

#endif
