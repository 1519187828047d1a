// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The maps on OpenGL: the face index map is drawn, the others are computed from it, several a pass.
#ifndef stipple_OpenGLMapPass_h
#define stipple_OpenGLMapPass_h

#include "MapBackend.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkHeadlessRenderWindow;
class vtkOpenGLRenderWindow;

namespace stipple
{
class OpenGLMapBackend : public MapBackend
{
public:
  /// In the context of a window that the caller keeps.
  explicit OpenGLMapBackend(vtkOpenGLRenderWindow* window);
  /// In a headless context of its own.
  OpenGLMapBackend();
  ~OpenGLMapBackend() override;

  /// Makes the context ready, or says why there is none.
  Status initialize() override;
  /// Whether a CPU runs the shaders; after initialize().
  bool isSoftware() const;

  std::string name() const override { return this->Name; }
  Status faces(const MapChart& chart, int width, int height, int* faces) override;
  Status maps(const MapChart& chart, int width, int height, const int* faces,
    const std::vector<MapRequest>& requests, const Progress& progress) override;
  void finish() override;

private:
  Status checkSize(int width, int height) const;

  vtkSmartPointer<vtkHeadlessRenderWindow> Own;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::string Name;
  std::string RendererName;
};
} // namespace stipple

#endif
