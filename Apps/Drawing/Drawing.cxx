// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// libStippleDrawing's one entry, as DrawingLibrary.h has it.
#include "DrawingLibrary.h"
#include "Picture.h"

#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"

namespace
{
std::string rendererName()
{
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(16, 16);
  const std::string renderer = window->GetRendererName();
  return renderer.empty() ? "" : renderer + " (" + window->GetPlatformName() + ")";
}
}

extern "C" __attribute__((visibility("default"))) const stipple::DrawingLibrary* stippleDrawing();

const stipple::DrawingLibrary* stippleDrawing()
{
  static const stipple::DrawingLibrary library = { stipple::writePicture, rendererName };
  return &library;
}
