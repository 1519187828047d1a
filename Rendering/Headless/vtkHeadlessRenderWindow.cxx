// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleOpenGL.h"

#include "vtkHeadlessRenderWindow.h"

#include "HeadlessContext.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <memory>
#include <string>

#include <sys/mman.h>

namespace
{
/// Whether a limit (ulimit -v) leaves the address space that drivers need at least. Mesa and LLVM
/// end the program, or use a null pointer, where an allocation fails; with less than 120 MB they
/// did so at nearly every step.
bool hasRoomForDrivers()
{
  constexpr std::size_t Room = std::size_t(256) << 20;
  void* space = mmap(nullptr, Room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return space != MAP_FAILED && munmap(space, Room) == 0;
}
}

vtkStandardNewMacro(vtkHeadlessRenderWindow);

struct vtkHeadlessRenderWindow::Internals
{
  std::unique_ptr<stipple::HeadlessContext> Context;
  std::string RendererName;
};

vtkHeadlessRenderWindow::vtkHeadlessRenderWindow()
  : Internal(new Internals)
{
  this->FrameBlitMode = NoBlit; // there is nothing to blit to
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
  this->OpenGLSupportMessage = "No OpenGL context was asked for yet.";
}

vtkHeadlessRenderWindow::~vtkHeadlessRenderWindow()
{
  this->vtkHeadlessRenderWindow::Finalize();
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->SetRenderWindow(nullptr);
  }
  this->Internal.reset(); // the superclasses' destructors ask whether the context is current
}

void vtkHeadlessRenderWindow::SetPlatform(int platform)
{
  platform = std::clamp<int>(platform, AUTO, OSMESA);
  if (platform != this->Platform)
  {
    this->Finalize();
    this->Platform = platform;
    this->OpenGLSupportTested = false;
    this->Modified();
  }
}

bool vtkHeadlessRenderWindow::IsHardwareAvailable()
{
  return stipple::HeadlessContext::hasHardware();
}

bool vtkHeadlessRenderWindow::CreateContext()
{
  if (this->Internal->Context)
  {
    return true;
  }
  if (this->OpenGLSupportTested && !this->OpenGLSupportResult)
  {
    return false; // a process does not change its mind
  }
  this->OpenGLSupportTested = true;
  this->OpenGLSupportResult = 0;
  std::string reasonOSMesa;
  std::string reasonEGL;
  const bool room = hasRoomForDrivers();
  if (!room)
  {
    reasonOSMesa = "there is not enough memory for its drivers";
  }
  if (room && this->Platform != EGL)
  {
    this->Internal->Context = stipple::HeadlessContext::createOSMesa(reasonOSMesa);
  }
  if (room && !this->Internal->Context && this->Platform != OSMESA)
  {
    this->Internal->Context = stipple::HeadlessContext::createEGL(reasonEGL);
  }
  std::string reasons;
  for (const std::string* reason : { &reasonOSMesa, &reasonEGL })
  {
    if (!reason->empty())
    {
      reasons += (reasons.empty() ? "" : ", and ") + *reason;
    }
  }
  if (this->Internal->Context)
  {
    this->OpenGLInit();
    if (this->Initialized)
    {
      this->OpenGLSupportResult = 1;
      this->OpenGLSupportMessage = "OpenGL without a display works through " +
        std::string(this->Internal->Context->platform()) + ".";
    }
    else
    {
      reasons = "the functions of OpenGL 3.2 cannot be loaded";
      this->Internal->Context.reset();
    }
  }
  if (!this->Internal->Context)
  {
    this->OpenGLSupportMessage =
      "There is no OpenGL without a display in this program: " + reasons + ".";
  }
  this->ReadyForRendering = this->Internal->Context != nullptr;
  this->Mapped = this->ReadyForRendering;
  return this->ReadyForRendering;
}

const char* vtkHeadlessRenderWindow::GetPlatformName()
{
  return this->CreateContext() ? this->Internal->Context->platform() : "";
}

const char* vtkHeadlessRenderWindow::GetRendererName()
{
  return this->CreateContext() ? this->Internal->RendererName.c_str() : "";
}

void vtkHeadlessRenderWindow::Initialize()
{
  if (!this->CreateContext())
  {
    vtkErrorMacro(<< this->OpenGLSupportMessage);
  }
}

void vtkHeadlessRenderWindow::Finalize()
{
  if (this->Internal && this->Internal->Context)
  {
    this->Internal->Context->makeCurrent();
    this->ReleaseGraphicsResources(this);
    this->Internal->Context.reset();
    this->Internal->RendererName.clear();
    this->OpenGLSupportTested = false;
    this->Initialized = false;
    this->Mapped = 0;
  }
}

void vtkHeadlessRenderWindow::OpenGLInit()
{
  // Not the superclass' version, which saves the state of a context that somebody else owns.
  this->vtkOpenGLRenderWindow::OpenGLInit(); // NOLINT(bugprone-parent-virtual-call)
}

void vtkHeadlessRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized || !this->Internal->Context)
  {
    return;
  }
#ifdef GLAD_GL
  this->SetOpenGLSymbolLoader(
    [](void* context, const char* name) {
      return static_cast<stipple::HeadlessContext*>(context)->procedure(name);
    },
    this->Internal->Context.get());
  this->vtkOpenGLRenderWindow::OpenGLInitContext();
#else
  // GLEW loads OpenGL's entry points and then complains about GLX, which there is none of.
  const GLenum result = glewInit();
  const bool loaded = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY ||
    result == GLEW_ERROR_GLX_VERSION_11_ONLY;
  this->GlewInitValid = loaded && (GLEW_VERSION_3_2 != 0) && glCreateShader != nullptr;
  this->Initialized = this->GlewInitValid;
#endif
  if (!this->Initialized)
  {
    return; // CreateContext() reports it
  }
  const GLubyte* name = glGetString(GL_RENDERER);
  this->Internal->RendererName = name ? reinterpret_cast<const char*>(name) : "";
  GLfloat range[2] = { 1.f, 1.f };
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

void vtkHeadlessRenderWindow::Start()
{
  if (this->CreateContext())
  {
    this->vtkOpenGLRenderWindow::Start();
  }
}

void vtkHeadlessRenderWindow::Render()
{
  this->Initialize();
  if (this->ReadyForRendering)
  {
    // Not the superclass' version, for the reason in OpenGLInit().
    this->vtkOpenGLRenderWindow::Render(); // NOLINT(bugprone-parent-virtual-call)
  }
}

void vtkHeadlessRenderWindow::MakeCurrent()
{
  if (this->Internal && this->Internal->Context && !this->Internal->Context->makeCurrent())
  {
    vtkErrorMacro(<< "The " << this->Internal->Context->platform()
                  << " context cannot be made current: another thread holds it.");
  }
}

void vtkHeadlessRenderWindow::ReleaseCurrent()
{
  if (this->Internal->Context)
  {
    this->Internal->Context->release();
  }
}

bool vtkHeadlessRenderWindow::IsCurrent()
{
  return this->Internal && this->Internal->Context && this->Internal->Context->isCurrent();
}

void vtkHeadlessRenderWindow::PushContext()
{
  this->MakeCurrent();
}

void vtkHeadlessRenderWindow::PopContext() {}

int vtkHeadlessRenderWindow::SupportsOpenGL()
{
  return this->CreateContext() ? 1 : 0;
}

vtkTypeBool vtkHeadlessRenderWindow::IsDirect()
{
  return this->CreateContext() ? 1 : 0;
}

const char* vtkHeadlessRenderWindow::ReportCapabilities()
{
  return this->CreateContext() ? this->Superclass::ReportCapabilities()
                               : this->OpenGLSupportMessage.c_str();
}

int* vtkHeadlessRenderWindow::GetScreenSize()
{
  return this->ScreenSize;
}

void vtkHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Platform: " << this->Platform << "\n";
  os << indent << "PlatformName: "
     << (this->Internal->Context ? this->Internal->Context->platform() : "(none yet)") << "\n";
  os << indent << "RendererName: " << this->Internal->RendererName << "\n";
}
