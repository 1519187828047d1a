// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A part of a surface that is remeshed, while the rest comes out as it came in.
#ifndef stipple_SelectedPart_h
#define stipple_SelectedPart_h

#include "Progress.h"
#include "StippleFiltersRemesherModule.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkIdTypeArray;
class vtkPolyData;

namespace stipple
{
class STIPPLEFILTERSREMESHER_EXPORT SelectedPart
{
public:
  /// Takes apart a surface of polygons and strips: cells whose value in the cell array is not 0 are
  /// the part. Fails if there is no such array of one number a cell, or no such cell.
  Status split(vtkPolyData* input, const std::string& array);

  /// The part, over all of the input's points.
  vtkPolyData* part() const { return this->Part; }
  /// The edges that part and rest share: two components, ids of the part's points.
  vtkIdTypeArray* borderEdges() const { return this->BorderEdges; }
  /// Places of the input at the ends of these edges.
  int numberOfBorderPoints() const { return static_cast<int>(this->BorderPoints.size()); }

  /// The rest and, in place of the part, a mesh that has each of the border's edges: first the
  /// rest's points and cells in the input's order, points at the same place once, then those of the
  /// mesh. Arrays of the mesh come along; the rest has the values of the input's arrays of the same
  /// name, else -1 for integers, 0 for others. SourceCellId counts the input's cells. Lines over
  /// the mesh's points become lines over the result's. Fails if the border is not the mesh's,
  /// or the mesh so coarse there that it has an edge of the rest that cannot be swapped.
  Status join(vtkPolyData* mesh, vtkPolyData* lines, vtkPolyData* result) const;

private:
  /// CornerTextureCoordinates: the mesh's, and for the rest what its points have.
  void joinTexture(
    vtkPolyData* mesh, const std::vector<vtkIdType>& idOfMeshPoint, vtkPolyData* result) const;

  vtkSmartPointer<vtkPolyData> Input; // polygons, in the order of the input's cells
  vtkSmartPointer<vtkPolyData> Part;
  vtkSmartPointer<vtkIdTypeArray> BorderEdges;
  std::vector<vtkIdType> SourceCell; // of every polygon of Input, the input's cell
  std::vector<vtkIdType> PartCells;  // polygons
  std::vector<vtkIdType> RestCells;
  // Of every point, the first at its place, or apart by rounding alone where the part has one.
  std::vector<vtkIdType> FirstAt;
  std::vector<vtkIdType> BorderPoints; // the first of each place, ascending
};
}

#endif
