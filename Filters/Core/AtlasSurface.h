// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The cut surface, put together again from its charts: one surface in space, one parameter plane a
// chart.
#ifndef stipple_AtlasSurface_h
#define stipple_AtlasSurface_h

#include "FlatFaceCells.h"
#include "Progress.h"
#include "StippleFiltersCoreModule.h"
#include "TriangleSurface.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// Faces are numbered chart by chart.
struct STIPPLEFILTERSCORE_EXPORT AtlasSurface : TriangleSurface // points by SurfacePointId
{
  std::vector<int> chartBegin;              ///< first face of every chart, and the number of faces
  ElementArray<Face, Chart> faceChart;      ///< chart of every face
  ElementArray<Face, Triangle> chartPoints; ///< per face, the chart's own point ids
  ElementArray<Halfedge, Vec2> uv;          ///< per corner, the parameter of its halfedge's tail
  ElementArray<Chart, Vec2> extent;         ///< per chart, width and height of its rectangle
  ElementArray<Face, int> sourceCell; ///< per face, the input cell that it lies in, or one on the
                                      ///< flat face that it lies in
  FlatFaceCells flatFaces;
  std::vector<vtkSmartPointer<vtkPolyData>> charts; ///< the data sets themselves

  int numberOfCharts() const { return static_cast<int>(this->extent.size()); }
  using TriangleSurface::faces;
  ElementRange<Face> faces(Chart c) const
  {
    return { this->chartBegin[c.index()], this->chartBegin[c.index() + 1] };
  }
  /// A chart's own number of a face, its cell id there.
  int chartCell(Face face) const
  {
    return face.index() - this->chartBegin[this->faceChart[face].index()];
  }
  /// The chart's own id of the point that a halfedge leaves.
  int chartPoint(Halfedge h) const { return this->chartPoints[faceOf(h)][cornerOf(h)]; }
  const Vec2& cornerUV(Face face, int corner) const { return this->uv[halfedgeOf(face, corner)]; }
  Vec2 parameter(Face face, const Vec3& bary) const
  {
    return bary[0] * this->cornerUV(face, 0) + bary[1] * this->cornerUV(face, 1) +
      bary[2] * this->cornerUV(face, 2);
  }
  /// A3D / A2D of a face, the area distortion of its chart's map.
  double areaDistortion(Face face) const;

  // The same for callers that still count with an int.
  const Vec2& cornerUV(int face, int corner) const { return this->cornerUV(Face(face), corner); }
  Vec2 parameter(int face, const Vec3& bary) const { return this->parameter(Face(face), bary); }
  double areaDistortion(int face) const { return this->areaDistortion(Face(face)); }
};

/// The data set of chart c, or null.
STIPPLEFILTERSCORE_EXPORT vtkPolyData* chartOf(
  vtkPartitionedDataSetCollection* charts, unsigned int c);

/// Welds the charts along their seams by SurfacePointId; says what is wrong if they are no atlas.
/// Stages do not call this: Atlas::read() keeps what it makes.
STIPPLEFILTERSCORE_EXPORT Status readAtlas(
  vtkPartitionedDataSetCollection* charts, AtlasSurface& surface, const Stop& stop = {});
}

#endif
