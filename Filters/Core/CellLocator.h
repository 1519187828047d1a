// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells by place, at any scale.
#ifndef stipple_CellLocator_h
#define stipple_CellLocator_h

#include "Geometry.h"
#include "StippleFiltersCoreModule.h"
#include "TriangleSurface.h"

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace stipple
{
/// vtkStaticCellLocator on a copy of the cells that is some hundred units long. VTK takes what is
/// shorter than a thousandth of a unit for a point: a model of 32,000 triangles that was measured
/// in metres, and is a millimetre long, was sorted into bins in 16 s for .005, and each question
/// took 1.6 ms for 10 us. The copy's scale is a power of two, so that nothing is rounded.
class STIPPLEFILTERSCORE_EXPORT CellLocator
{
public:
  struct Place
  {
    vtkIdType cell = -1; ///< -1 if there is none
    Vec3 position = Vec3::Zero();
    double squaredDistance = 0;
  };

  explicit CellLocator(vtkPolyData* cells);
  CellLocator(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  ~CellLocator();
  CellLocator(const CellLocator&) = delete;
  CellLocator& operator=(const CellLocator&) = delete;

  /// The place on the cells nearest to one. By one thread at a time, as all.
  [[nodiscard]] Place nearest(const Vec3& position) const;

  /// Where the way from one place to another meets a cell first, t (from 0 to 1) of it away.
  [[nodiscard]] Place firstHit(const Vec3& from, const Vec3& to, double& t) const;

private:
  struct Internals;
  const std::unique_ptr<Internals> Inside;
};
}

#endif
