// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The maps on OpenGL: the face index map is drawn, the others are computed from it, several a pass.
#ifndef stipple_OpenGLMapPass_h
#define stipple_OpenGLMapPass_h

#include "MapRasterizer.h"

class vtkOpenGLRenderWindow;

namespace stipple
{
// In the window's context, which becomes current. Both follow MapRasterizer.h's rules.

/// The triangle of every pixel; every pixel gets one.
Status drawFaces(
  vtkOpenGLRenderWindow* window, const MapChart& chart, int width, int height, int* faces);

/// The maps from the faces.
Status drawMaps(vtkOpenGLRenderWindow* window, const MapChart& chart, int width, int height,
  const int* faces, const std::vector<MapRequest>& requests, const Progress& progress);
} // namespace stipple

#endif
