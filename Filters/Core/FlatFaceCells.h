// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The input's cells on flat faces that charts triangulate anew: so that it is still known exactly
// in which cell a place lies.
#ifndef stipple_FlatFaceCells_h
#define stipple_FlatFaceCells_h

#include "CellLocator.h"
#include "Geometry.h"
#include "Progress.h"
#include "StippleFiltersCoreModule.h"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkFieldData;

namespace stipple
{
/// A triangle of an atlas lies in its `SourceCellId`, or, if that cell is on one of these faces,
/// somewhere on the face. Charts carry the faces that they have triangles of as field arrays:
/// `FlatFaceOffsets` (where the cells of each face begin, and their number), `FlatFaceCells` (ids
/// in the input) and `FlatFaceCorners` (three points a cell).
class STIPPLEFILTERSCORE_EXPORT FlatFaceCells
{
public:
  /// A triangle of a cell of the input; a polygon has several.
  struct Piece
  {
    int cell;
    std::array<Vec3, 3> corners;
  };

  bool empty() const { return this->Faces.empty(); }
  int size() const { return static_cast<int>(this->Faces.size()); }
  void add(std::vector<Piece> face);
  /// The face that a cell is on, -1 if none.
  int faceOf(int cell) const;
  const std::vector<Piece>& pieces(int face) const { return this->Faces[face]; }

  /// Adds the arrays for the faces that some cells are on, if there are any.
  void write(const std::set<int>& cells, vtkFieldData* data) const;
  /// Adds the faces of a chart that are not known yet; says what is wrong with its arrays.
  Status read(vtkFieldData* data, const std::string& owner);

private:
  std::vector<std::vector<Piece>> Faces;
  std::map<int, int> FaceOf; // of a cell
};

/// Finds cells by place.
class STIPPLEFILTERSCORE_EXPORT FlatFaceLocator
{
public:
  explicit FlatFaceLocator(const FlatFaceCells& faces)
    : Faces(faces)
  {
  }
  /// The cell nearest to a place, of those on the face that a cell is on; that cell if on none.
  int cellAt(int cell, const Vec3& place);

private:
  const FlatFaceCells& Faces;
  std::map<int, std::unique_ptr<CellLocator>> Locators; // by face, when asked for
};
}

#endif
