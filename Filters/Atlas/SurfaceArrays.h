// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The input's point and cell arrays on the surface that is cut into charts.
#ifndef stipple_SurfaceArrays_h
#define stipple_SurfaceArrays_h

#include "CutSurface.h"
#include "SurfaceRepair.h"

#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;
class vtkPolyData;

namespace stipple
{
/// The arrays with names that none of Stipple's stages uses; an input that is itself an output of
/// Stipple has all of those.
std::vector<vtkAbstractArray*> usersArrays(vtkDataSetAttributes* data);
bool isReservedArrayName(const char* name);

/// Original points and how much each weighs in a point that was inserted between them.
using PointWeights = std::vector<std::pair<int, double>>;
/// Of every inserted point; those inserted on inserted edges, too.
std::vector<PointWeights> weightsOfInserted(const CutSurface& surface);

vtkSmartPointer<vtkAbstractArray> emptyLike(vtkAbstractArray* array);

/// The input's point arrays at all points of the cut surface: on edges floating-point numbers are
/// interpolated, others come from the original point that weighs most.
std::vector<vtkSmartPointer<vtkAbstractArray>> pointArrays(
  vtkPolyData* input, const RepairedSurface& repaired, const CutSurface& surface);

/// Tells where a flipped edge leaves all arrays as they are.
class ArraysOverEdges
{
public:
  /// The surface may be flipped afterwards, but not split.
  ArraysOverEdges(vtkPolyData* input, const RepairedSurface& repaired, const CutSurface& surface);

  /// Whether the cell arrays are the same on both sides of an edge, and the point arrays the same
  /// at s along it and at t from the corner over it to the corner over its twin.
  bool allowFlip(Halfedge h, double s, double t) const;

private:
  struct Continuous
  {
    vtkSmartPointer<vtkAbstractArray> array;
    double tolerance;
  };

  const CutSurface& Surface;
  std::vector<vtkAbstractArray*> Cells;
  std::vector<Continuous> Numbers;
  std::vector<vtkSmartPointer<vtkAbstractArray>> Labels; // at points
};
}

#endif
