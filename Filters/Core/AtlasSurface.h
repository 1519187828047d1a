// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The cut surface, put together again from its charts: one surface in space, one parameter plane a
// chart.
#ifndef stipple_AtlasSurface_h
#define stipple_AtlasSurface_h

#include "Progress.h"
#include "StippleFiltersCoreModule.h"
#include "TriangleSurface.h"

#include <vector>

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// Faces are numbered chart by chart: face chartBegin[c] + i is triangle i of chart c.
struct STIPPLEFILTERSCORE_EXPORT AtlasSurface : TriangleSurface // points by SurfacePointId
{
  std::vector<int> chartBegin;       ///< first face of every chart, and the number of faces
  std::vector<int> faceChart;        ///< chart of every face
  std::vector<Triangle> chartPoints; ///< per face, the chart's own point ids
  std::vector<Vec2> uv;              ///< per corner (= halfedge), the parameter of its tail
  std::vector<Vec2> extent;          ///< per chart, width and height of its rectangle
  std::vector<int> sourceCell;       ///< per face, the input cell that it lies in
  std::vector<vtkPolyData*> charts;  ///< the data sets themselves, borrowed

  int numberOfCharts() const { return static_cast<int>(this->extent.size()); }
  const Vec2& cornerUV(int face, int corner) const { return this->uv[3 * face + corner]; }
  Vec2 parameter(int face, const Vec3& bary) const
  {
    return bary[0] * this->cornerUV(face, 0) + bary[1] * this->cornerUV(face, 1) +
      bary[2] * this->cornerUV(face, 2);
  }
  /// A3D / A2D of a face, the area distortion of its chart's map.
  double areaDistortion(int face) const;
};

/// The data set of chart c, or null.
STIPPLEFILTERSCORE_EXPORT vtkPolyData* chartOf(
  vtkPartitionedDataSetCollection* charts, unsigned int c);

/// Welds the charts along their seams by SurfacePointId; says what is missing if they are not an
/// atlas.
STIPPLEFILTERSCORE_EXPORT Status readAtlas(
  vtkPartitionedDataSetCollection* charts, AtlasSurface& surface);
}

#endif
