// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLGeometryMapBackend
 * @brief   draws the maps of vtkGeometryMapRenderer on OpenGL 3.2
 *
 * Overrides vtkGeometryMapBackend in VTK's object factory. The library registers it when it is
 * loaded, whoever loads it: a program that links it, dlopen(), LD_PRELOAD, Python's import. A
 * linker may drop a library that a program calls nothing of (--as-needed), and takes nothing
 * unasked from a static one: vtk_module_autoinit(TARGETS program MODULES
 * Stipple::RenderingGeometryMaps) makes sure in both cases.
 *
 * @sa vtkGeometryMapRenderer vtkHeadlessRenderWindow
 */
#ifndef vtkOpenGLGeometryMapBackend_h
#define vtkOpenGLGeometryMapBackend_h

#include "StippleRenderingGeometryMapsModule.h" // for export macro
#include "vtkGeometryMapBackend.h"

#include <memory> // for std::unique_ptr

class STIPPLERENDERINGGEOMETRYMAPS_EXPORT vtkOpenGLGeometryMapBackend : public vtkGeometryMapBackend
{
public:
  static vtkOpenGLGeometryMapBackend* New();
  vtkTypeMacro(vtkOpenGLGeometryMapBackend, vtkGeometryMapBackend);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  void SetWindow(vtkWindow* window) override;
  bool IsPreferred() override;
  stipple::Status Initialize() override;
  std::string GetName() override;
  stipple::Status DrawFaces(
    const stipple::MapChart& chart, int width, int height, int* faces) override;
  stipple::Status DrawMaps(const stipple::MapChart& chart, int width, int height, const int* faces,
    const std::vector<stipple::MapRequest>& requests,
    const std::function<bool(double)>& progress) override;
  void Finish() override;
#endif

protected:
  vtkOpenGLGeometryMapBackend();
  ~vtkOpenGLGeometryMapBackend() override;

private:
  vtkOpenGLGeometryMapBackend(const vtkOpenGLGeometryMapBackend&) = delete;
  void operator=(const vtkOpenGLGeometryMapBackend&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
