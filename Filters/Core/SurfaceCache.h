// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the mesher and the optimiser derive from charts and feature graph alone: kept as long as
// these do not change, so that a slider that moves samples does not pay for it again.
#ifndef stipple_SurfaceCache_h
#define stipple_SurfaceCache_h

#include "ChartGraph.h"
#include "StippleFiltersCoreModule.h"
#include "SurfaceWalk.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>

class vtkDataObject;

namespace stipple
{
class STIPPLEFILTERSCORE_EXPORT SurfaceCache
{
public:
  /// Reads both inputs unless they are those of the last time, unmodified.
  Status update(vtkPartitionedDataSetCollection* charts, vtkPolyData* featureGraph);

  const AtlasSurface& surface() const { return this->Surface; }
  const FeatureGraph& graph() const { return this->Graph; }
  const std::vector<BackboneTrace>& traces() const { return this->Traces; }
  /// Sharp edges are its walls.
  const SurfaceWalk& walk() const { return *this->Walk; }
  /// Normal of a face averaged with those about it on the same side of creases; unit length, or
  /// zero.
  const Vec3& smoothNormal(int face) const { return this->SmoothNormal[face]; }
  /// The neighbours of point p along edges are neighbours()[neighbourBegin()[p]] to
  /// neighbours()[neighbourBegin()[p + 1] - 1].
  const std::vector<int>& neighbourBegin() const { return this->NeighbourBegin; }
  const std::vector<int>& neighbours() const { return this->Neighbours; }
  /// The place at an arc length of a backbone, seen from the first side that it has.
  SurfacePlace placeOfBackbone(int backbone, double arcLength) const;
  /// A point that a triangle uses, as a place.
  SurfacePlace placeOfPoint(int p) const;
  const SurfaceTopology& topology() const { return this->Topology; }
  /// Counts the times that the inputs were read.
  int generation() const { return this->Generation; }

private:
  void smoothNormals(const std::vector<char>& wall);
  void findNeighbours();

  using Key = std::vector<std::pair<vtkSmartPointer<vtkDataObject>, vtkMTimeType>>;
  Key KeyOfContents;
  AtlasSurface Surface;
  FeatureGraph Graph;
  std::vector<BackboneTrace> Traces;
  std::unique_ptr<SurfaceWalk> Walk;
  std::vector<Vec3> SmoothNormal;
  std::vector<int> NeighbourBegin;
  std::vector<int> Neighbours;
  std::vector<int> Outgoing; // a halfedge a point
  SurfaceTopology Topology;
  int Generation = 0;
};
}

#endif
