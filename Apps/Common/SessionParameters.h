// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// From a session to the parameters of the filters.
#ifndef stipple_SessionParameters_h
#define stipple_SessionParameters_h

#include "Progress.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkControlMap;
class vtkGeometryRemesher;
class vtkImageData;
class vtkPolyData;

namespace stipple
{
struct Session;

/// Whether the session suits the mesh: its array is there, its edges name points that exist.
[[nodiscard]] Status checkSession(const Session& session, vtkPolyData* mesh);

/// All of a session but the importance's image. A parameter that does not change does not modify
/// its stage.
void applySession(const Session& session, vtkGeometryRemesher* remesher);

/// What of a session belongs to the control map, but the importance's image.
void applyControl(const Session& session, vtkControlMap* control);

/// Reads a picture (.png, .jpg, .vti, ...) to paste as an importance.
[[nodiscard]] Status readImage(const std::string& file, vtkSmartPointer<vtkImageData>& image);
}

#endif
