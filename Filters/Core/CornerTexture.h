// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Texture coordinates of the corners of cells: what jumps across the seams of a texture, where a
// mesh has one point only.
#ifndef stipple_CornerTexture_h
#define stipple_CornerTexture_h

#include "Geometry.h"
#include "StippleFiltersCoreModule.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataArray;
class vtkDoubleArray;
class vtkPolyData;

namespace stipple
{
/// The cell array with the coordinates of a cell's first corner, second corner, and so on, as many
/// as the largest cell has.
constexpr const char* CornerTextureName = "CornerTextureCoordinates";

/// That array of a surface without lines and strips, or null. Coordinates have two components.
STIPPLEFILTERSCORE_EXPORT vtkDataArray* cornerTexture(vtkPolyData* surface);
STIPPLEFILTERSCORE_EXPORT vtkSmartPointer<vtkDoubleArray> newCornerTexture(
  vtkIdType cells, int corners = 3);

/// Of corner k of a cell; only pairs that are there may be asked for.
STIPPLEFILTERSCORE_EXPORT Vec2 textureOfCorner(vtkDataArray* corners, vtkIdType cell, vtkIdType k);
STIPPLEFILTERSCORE_EXPORT void setTextureOfCorner(
  vtkDataArray* corners, vtkIdType cell, vtkIdType k, const Vec2& coordinates);

/// The surface as VTK draws it: points are there once for each of the texture coordinates that the
/// corners around them have, the first with its id, the others behind all points, with the same
/// values in all other arrays. The coordinates become the active ones of points, under the name
/// that those have, and their cell array goes. A surface without it is handed back as it is.
STIPPLEFILTERSCORE_EXPORT vtkSmartPointer<vtkPolyData> splitTextureSeams(vtkPolyData* surface);
}

#endif
