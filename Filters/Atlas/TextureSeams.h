// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The seams of the input's texture: where its texture coordinates jump, though points were welded.
#ifndef stipple_TextureSeams_h
#define stipple_TextureSeams_h

#include "CutSurface.h"
#include "DensityCuts.h"
#include "SurfaceRepair.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;
class vtkDoubleArray;
class vtkPolyData;

namespace stipple
{
/// The texture coordinates that the input's cells have at their corners.
class STIPPLEFILTERSATLAS_EXPORT TextureSeams
{
public:
  /// Of the input's active texture coordinates, which need two components or more. Both arguments
  /// are kept.
  TextureSeams(vtkPolyData* input, const RepairedSurface& repaired);

  /// Keeps the edges of the repaired surface, before any is cut, across which coordinates jump, as
  /// borders of regions are kept.
  void mark(CutSurface& surface) const;

  /// The array CornerTextureCoordinates of every chart of the cut surface. Along edges coordinates
  /// are linear, and so they are over a face.
  std::vector<vtkSmartPointer<vtkDoubleArray>> corners(
    const CutSurface& surface, const std::vector<FlatChart>& charts) const;

private:
  Vec2 coordinates(int inputPoint) const;
  /// Of a cell at a point of the repaired surface: its corner's there, or from its plane.
  Vec2 at(int cell, int point) const;

  vtkSmartPointer<vtkPolyData> Input;
  const RepairedSurface& Repaired;
  vtkDataArray* Texture;
  double SamePlace; ///< distance that rounding may make
};
}

#endif
