// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleOpenGL.h"

#include "vtkOpenGLGeometryMapBackend.h"

#include "OpenGLMapPass.h"

#include "vtkAutoInit.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

// Registers the override when the library is loaded; see the class' documentation.
VTK_MODULE_INIT(StippleRenderingGeometryMaps);

vtkStandardNewMacro(vtkOpenGLGeometryMapBackend);

struct vtkOpenGLGeometryMapBackend::Internals
{
  bool IsGiven = false;                         ///< the window is the caller's
  vtkSmartPointer<vtkHeadlessRenderWindow> Own; ///< made when first needed
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::string Name;
  std::string RendererName;

  /// A CPU runs the shaders.
  bool isSoftware() const
  {
    for (const char* name : { "llvmpipe", "softpipe", "swrast", "SWR", "Software" })
    {
      if (this->RendererName.find(name) != std::string::npos)
      {
        return true;
      }
    }
    return false;
  }
};

vtkOpenGLGeometryMapBackend::vtkOpenGLGeometryMapBackend()
  : Internal(new Internals)
{
}

vtkOpenGLGeometryMapBackend::~vtkOpenGLGeometryMapBackend() = default;

void vtkOpenGLGeometryMapBackend::SetWindow(vtkWindow* window)
{
  *this->Internal = {};
  this->Internal->IsGiven = window != nullptr;
  this->Internal->Window = vtkOpenGLRenderWindow::SafeDownCast(window);
}

/// A context that is at hand anyway, or hardware; software OpenGL is slower than the CPU's back
/// end.
bool vtkOpenGLGeometryMapBackend::IsPreferred()
{
  return this->Internal->IsGiven ||
    (vtkHeadlessRenderWindow::IsHardwareAvailable() && this->Initialize().ok() &&
      !this->Internal->isSoftware());
}

stipple::Status vtkOpenGLGeometryMapBackend::Initialize()
{
  using stipple::Status;
  Internals& self = *this->Internal;
  if (!self.IsGiven && !self.Own)
  {
    self.Own = vtkSmartPointer<vtkHeadlessRenderWindow>::New();
    self.Own->SetSize(16, 16);
    self.Window = self.Own;
  }
  if (!self.Window)
  {
    return Status::error("The RenderWindow is no OpenGL window: use the CPU back end.");
  }
  auto* headless = vtkHeadlessRenderWindow::SafeDownCast(self.Window);
  if (headless && !headless->SupportsOpenGL())
  {
    return Status::error(headless->GetOpenGLSupportMessage());
  }
  self.Window->Initialize();
  self.Window->MakeCurrent();
  int major = 0;
  int minor = 0;
  self.Window->GetOpenGLVersion(major, minor);
  if (!self.Window->IsCurrent() || 10 * major + minor < 32)
  {
    return Status::error(
      "The RenderWindow has no OpenGL 3.2 context yet: render it first, or use the CPU back end.");
  }
  if (self.Name.empty())
  {
    const GLubyte* renderer = glGetString(GL_RENDERER);
    self.RendererName = renderer ? reinterpret_cast<const char*>(renderer) : "unknown";
    std::string platform = self.Window->GetClassName();
    if (headless)
    {
      platform = headless->GetPlatformName();
    }
    else if (platform == "vtkXOpenGLRenderWindow")
    {
      platform = "GLX";
    }
    self.Name = "OpenGL: " + self.RendererName + " through " + platform;
  }
  return Status::success();
}

std::string vtkOpenGLGeometryMapBackend::GetName()
{
  return this->Internal->Name;
}

stipple::Status vtkOpenGLGeometryMapBackend::DrawFaces(
  const stipple::MapChart& chart, int width, int height, int* faces)
{
  return stipple::drawFaces(this->Internal->Window, chart, width, height, faces);
}

stipple::Status vtkOpenGLGeometryMapBackend::DrawMaps(const stipple::MapChart& chart, int width,
  int height, const int* faces, const std::vector<stipple::MapRequest>& requests,
  const stipple::Progress& progress)
{
  return stipple::drawMaps(this->Internal->Window, chart, width, height, faces, requests, progress);
}

void vtkOpenGLGeometryMapBackend::Finish()
{
  if (this->Internal->Own)
  {
    this->Internal->Own->ReleaseCurrent();
  }
}

void vtkOpenGLGeometryMapBackend::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Window: " << this->Internal->Window.GetPointer() << "\n";
  os << indent << "Name: " << this->Internal->Name << "\n";
}
