// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The numbers that the window shows of a mesh.
#ifndef stipple_MeshFigures_h
#define stipple_MeshFigures_h

#include "MeshQuality.h"

#include "vtkType.h"

#include <array>

class vtkPolyData;

namespace stipple
{
struct MeshFigures
{
  MeshQuality quality;
  std::array<double, 7> valences = {}; ///< inside: of valence 3 or less, 4, ..., 8, 9 or more
  std::array<double, 18> angles = {};  ///< the triangles' angles, 10 degrees a bar
  int lostFeatureEdges = 0;            ///< of the input, that the mesh has no room for
  vtkIdType cutEdges = 0;              ///< of the input, of more than two triangles
  vtkIdType quads = 0;                 ///< two of the triangles each
};

[[nodiscard]] MeshFigures measureFigures(vtkPolyData* mesh);
}

#endif
