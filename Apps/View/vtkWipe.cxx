// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWipe.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <cmath>

vtkStandardNewMacro(vtkWipe);

int vtkWipe::RenderOpaqueGeometry(vtkViewport* viewport)
{
  constexpr unsigned int ColorAndDepth = 0x4000 | 0x0100; // of OpenGL's glClear
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (this->Share <= 0 || !window)
  {
    return 0;
  }
  int width;
  int height;
  int x;
  int y;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  const int left = static_cast<int>(std::lround(this->Share * static_cast<float>(width)));
  vtkOpenGLState* state = window->GetState();
  const double* color = renderer->GetBackground();
  state->vtkglScissor(x + left, y, width - left, height); // until the next renderer's camera
  state->vtkglClearColor(
    static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]), 0);
  state->vtkglClearDepth(1);
  state->vtkglClear(ColorAndDepth);
  return 1;
}
