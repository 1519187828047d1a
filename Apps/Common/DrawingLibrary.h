// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What needs OpenGL, in a library of its own that is loaded when something asks for it: loading
// OpenGL, OSMesa and VTK's rendering takes as long as remeshing a small part.
#ifndef stipple_DrawingLibrary_h
#define stipple_DrawingLibrary_h

#include "Progress.h"

#include <string>

namespace stipple
{
struct PictureContent;
enum class PicturePanel;

/// The functions of libStippleDrawing. While it is loaded, vtkGeometryMapRenderer draws on OpenGL.
struct DrawingLibrary
{
  Status (*writePicture)(const PictureContent& content, PicturePanel panel, const std::string& now,
    const std::string& file);    ///< see Picture.h
  std::string (*rendererName)(); ///< of OpenGL without a display, and whose; empty if there is none
};

/// Loads it once. An error says why it cannot be loaded.
[[nodiscard]] Status loadDrawing(const DrawingLibrary*& library);

/// Loads it where maps are, or may be, drawn on OpenGL: `backend` is the option's word. An error
/// where they must be.
[[nodiscard]] Status loadDrawingForMaps(const std::string& backend);
}

#endif
