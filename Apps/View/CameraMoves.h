// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How the camera of both views moves.
#ifndef stipple_CameraMoves_h
#define stipple_CameraMoves_h

#include "Geometry.h"

#include "vtkType.h"

#include <array>

class vtkCamera;
class vtkPolyData;
class vtkRenderer;

namespace stipple
{
/// The point under a window's pixel in the plane that the camera looks at.
[[nodiscard]] Vec3 focalPlaneAt(vtkRenderer* renderer, double x, double y);

/// Where it stands, what it looks at, what is up.
[[nodiscard]] std::array<double, 9> placeOf(vtkCamera* camera);

/// Looks at a cell of a mesh, so near that it is a tenth of the view, from the side that it faces,
/// or from outside if that is inside of a solid, as in a fold; aslant where the mesh is in the way.
void lookAt(vtkCamera* camera, vtkPolyData* mesh, vtkIdType cell, bool isSolid);

/// The same at a place of a surface, at something of that size, from a side.
void lookAt(
  vtkCamera* camera, vtkPolyData* surface, const Vec3& place, double size, const Vec3& from);

/// Makes everything larger by a factor; the center stays where it is on the screen.
void zoomAbout(vtkCamera* camera, const Vec3& center, double factor);
}

#endif
