// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What is asked of data that a user's own filters may have touched, before its ids become indices.
#ifndef stipple_UserArrays_h
#define stipple_UserArrays_h

#include "Geometry.h"
#include "Progress.h"
#include "StippleFiltersCoreModule.h"

#include "vtkType.h"

#include <cmath>
#include <string>

class vtkCellArray;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkFieldData;

namespace stipple
{
/// Vertices and triangles of a surface: the halfedges, three a triangle, are numbered with an int.
constexpr int MaximumNumberOfElements = 715827882;

/// A value as an index below size; -1 if it is none: negative, too large, a fraction, NaN.
inline int indexBelow(double value, int size)
{
  return value >= 0 && value < size && value == std::floor(value) ? static_cast<int>(value) : -1;
}

/// VTK's 64-bit number of elements as an int. what names them in the error: "points of chart 3".
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT Status checkedCount(
  vtkIdType number, const std::string& what, int& count);

/// The named array, which has as many components and tuples as it must. owner and remedy are for
/// the error: "Chart 3", "pass output port 0 of vtkConformalAtlas".
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT Status findArray(vtkFieldData* data, const char* name,
  int components, vtkIdType tuples, const std::string& owner, const std::string& remedy,
  vtkDataArray*& array);

/// "The SurfacePointId of point 7 of chart 3 is -2, which is none of the 100 that there are."
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT Status badId(
  vtkDataArray* array, vtkIdType tuple, const std::string& element, int size);

/// Every cell's ids are those of points.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT Status checkCells(
  vtkCellArray* cells, vtkIdType numberOfPoints, const std::string& owner);

/// Every array has a tuple for each of the elements ("points", "cells").
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT Status checkAttributes(
  vtkDataSetAttributes* data, vtkIdType elements, const char* what, const std::string& owner);

/// Numbers that sum to one, none of them negative, but for rounding.
inline bool isBarycentric(const Vec3& b)
{
  constexpr double Rounding = 1e-3; // also of floats
  return b.allFinite() && b.minCoeff() >= -Rounding && std::abs(b.sum() - 1.) <= Rounding;
}
}

#endif
