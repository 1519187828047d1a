// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Versions.h"

#include "DrawingLibrary.h"

#include "vtkVersion.h"

#include <CGAL/version.h>

#define STIPPLE_STRING(x) #x
#define STIPPLE_STRING_OF(x) STIPPLE_STRING(x)

namespace stipple
{
std::string versionText()
{
  const DrawingLibrary* drawing = nullptr;
  const std::string renderer = loadDrawing(drawing).ok() ? drawing->rendererName() : "";
  return "stipple " STIPPLE_VERSION "\nVTK " + std::string(vtkVersion::GetVTKVersion()) +
    "\nCGAL " STIPPLE_STRING_OF(CGAL_VERSION) "\nOpenGL renderer: " +
    (renderer.empty() ? "none" : renderer) + "\n";
}
}
