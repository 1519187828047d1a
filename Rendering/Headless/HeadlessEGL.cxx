// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// EGL without a surface. libEGL is opened at run time, so that machines without it can use OSMesa.
#include "HeadlessContext.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <vector>

#include <dlfcn.h>

namespace stipple
{
namespace
{
bool hasWord(const char* list, const char* word)
{
  const std::size_t length = std::strlen(word);
  for (const char* p = list; p && (p = std::strstr(p, word)); p += length)
  {
    if ((p == list || p[-1] == ' ') && (p[length] == ' ' || p[length] == '\0'))
    {
      return true;
    }
  }
  return false;
}

/// The entry points of libEGL, which stays loaded.
struct EGL
{
  decltype(&eglGetProcAddress) getProcAddress = nullptr;
  decltype(&eglGetDisplay) getDisplay = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglQueryString) queryString = nullptr;
  decltype(&eglBindAPI) bindAPI = nullptr;
  decltype(&eglChooseConfig) chooseConfig = nullptr;
  decltype(&eglCreateContext) createContext = nullptr;
  decltype(&eglDestroyContext) destroyContext = nullptr;
  decltype(&eglCreatePbufferSurface) createPbufferSurface = nullptr;
  decltype(&eglDestroySurface) destroySurface = nullptr;
  decltype(&eglMakeCurrent) makeCurrent = nullptr;
  decltype(&eglGetCurrentContext) getCurrentContext = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
  PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr;
  bool loaded = false;

  static const EGL& instance()
  {
    static const EGL egl;
    return egl;
  }

  /// Devices that are no software renderers.
  std::vector<EGLDeviceEXT> hardware() const
  {
    std::vector<EGLDeviceEXT> devices;
    EGLint n = 0;
    if (!this->loaded || !this->queryDevices || !this->queryDeviceString ||
      !this->queryDevices(0, nullptr, &n) || n <= 0)
    {
      return devices;
    }
    std::vector<EGLDeviceEXT> all(n);
    this->queryDevices(n, all.data(), &n);
    for (EGLint k = 0; k < n; ++k)
    {
      const char* extensions = this->queryDeviceString(all[k], EGL_EXTENSIONS);
      if (!hasWord(extensions, "EGL_MESA_device_software") &&
        (hasWord(extensions, "EGL_EXT_device_drm") || hasWord(extensions, "EGL_NV_device_cuda")))
      {
        devices.push_back(all[k]);
      }
    }
    return devices;
  }

private:
  EGL()
  {
    void* library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
    if (!library)
    {
      return;
    }
    const auto look = [&](const char* name, auto& function) {
      function = reinterpret_cast<std::decay_t<decltype(function)>>(dlsym(library, name));
      return function != nullptr;
    };
    this->loaded = look("eglGetProcAddress", this->getProcAddress) &&
      look("eglGetDisplay", this->getDisplay) && look("eglInitialize", this->initialize) &&
      look("eglQueryString", this->queryString) && look("eglBindAPI", this->bindAPI) &&
      look("eglChooseConfig", this->chooseConfig) &&
      look("eglCreateContext", this->createContext) &&
      look("eglDestroyContext", this->destroyContext) &&
      look("eglCreatePbufferSurface", this->createPbufferSurface) &&
      look("eglDestroySurface", this->destroySurface) &&
      look("eglMakeCurrent", this->makeCurrent) &&
      look("eglGetCurrentContext", this->getCurrentContext);
    if (!this->loaded)
    {
      return;
    }
    // Without a display, this asks for the extensions of the client library.
    const char* extensions = this->queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto extension = [&](const char* name, const char* procedure, auto& function) {
      if (hasWord(extensions, name))
      {
        function =
          reinterpret_cast<std::decay_t<decltype(function)>>(this->getProcAddress(procedure));
      }
    };
    extension("EGL_EXT_platform_base", "eglGetPlatformDisplayEXT", this->getPlatformDisplay);
    for (const char* name : { "EGL_EXT_device_base", "EGL_EXT_device_enumeration" })
    {
      extension(name, "eglQueryDevicesEXT", this->queryDevices);
    }
    for (const char* name : { "EGL_EXT_device_base", "EGL_EXT_device_query" })
    {
      extension(name, "eglQueryDeviceStringEXT", this->queryDeviceString);
    }
  }
};

class EGLHeadlessContext : public HeadlessContext
{
public:
  EGLHeadlessContext(EGLDisplay display, EGLContext context, EGLSurface surface)
    : Display(display)
    , Handle(context)
    , Surface(surface)
  {
  }
  ~EGLHeadlessContext() override
  {
    const EGL& egl = EGL::instance();
    this->release();
    egl.destroyContext(this->Display, this->Handle);
    if (this->Surface != EGL_NO_SURFACE)
    {
      egl.destroySurface(this->Display, this->Surface);
    }
  }
  const char* platform() const override { return "EGL"; }
  Procedure procedure(const char* name) const override
  {
    return EGL::instance().getProcAddress(name);
  }
  bool bind() override
  {
    const EGL& egl = EGL::instance();
    return egl.makeCurrent(this->Display, this->Surface, this->Surface, this->Handle);
  }
  bool isBound() const override
  {
    const EGL& egl = EGL::instance();
    return egl.bindAPI(EGL_OPENGL_API) && egl.getCurrentContext() == this->Handle;
  }
  void unbind() override
  {
    if (this->isBound())
    {
      EGL::instance().makeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
  }

private:
  EGLDisplay Display; // shared by the process and never terminated
  EGLContext Handle;
  EGLSurface Surface;
};

std::unique_ptr<HeadlessContext> createOn(EGLDisplay display)
{
  const EGL& egl = EGL::instance();
  EGLint major = 0;
  EGLint minor = 0;
  if (display == EGL_NO_DISPLAY || !egl.initialize(display, &major, &minor) ||
    !egl.bindAPI(EGL_OPENGL_API))
  {
    return nullptr;
  }
  const char* extensions = egl.queryString(display, EGL_EXTENSIONS);
  const bool surfaceless = hasWord(extensions, "EGL_KHR_surfaceless_context");
  const EGLint wanted[] = { EGL_SURFACE_TYPE, surfaceless ? 0 : EGL_PBUFFER_BIT,
    EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (!egl.chooseConfig(display, wanted, &config, 1, &configs) || configs < 1)
  {
    return nullptr;
  }
  const EGLint version[] = { EGL_CONTEXT_MAJOR_VERSION_KHR, 3, EGL_CONTEXT_MINOR_VERSION_KHR, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR, EGL_NONE };
  const EGLContext handle = egl.createContext(display, config, EGL_NO_CONTEXT, version);
  if (handle == EGL_NO_CONTEXT)
  {
    return nullptr;
  }
  EGLSurface surface = EGL_NO_SURFACE;
  if (!surfaceless)
  {
    const EGLint size[] = { EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE };
    surface = egl.createPbufferSurface(display, config, size);
  }
  auto context = std::make_unique<EGLHeadlessContext>(display, handle, surface);
  return context->makeCurrent() ? std::move(context) : nullptr;
}

/// Whether the process' OpenGL calls reach the current EGL context; they do not where another
/// library (OSMesa) took over OpenGL's entry points and the driver does not share its dispatch.
bool callsArrive()
{
#if __has_include("vtk_glad.h")
  return true; // VTK calls what HeadlessContext::procedure() finds
#else
  constexpr unsigned int rendererName = 0x1F01; // GL_RENDERER
  using GetString = const unsigned char* (*)(unsigned int);
  const auto own = reinterpret_cast<GetString>(EGL::instance().getProcAddress("glGetString"));
  const auto linked = reinterpret_cast<GetString>(dlsym(RTLD_DEFAULT, "glGetString"));
  if (!own || !linked)
  {
    return false;
  }
  const unsigned char* a = own(rendererName);
  const unsigned char* b = linked(rendererName);
  return a && b &&
    std::strcmp(reinterpret_cast<const char*>(a), reinterpret_cast<const char*>(b)) == 0;
#endif
}
} // namespace

std::unique_ptr<HeadlessContext> HeadlessContext::createEGL(std::string& reason)
{
  const EGL& egl = EGL::instance();
  if (!egl.loaded)
  {
    reason = "libEGL.so.1 cannot be loaded";
    return nullptr;
  }
  // Hardware first, then Mesa without any window system, then whatever the system calls default.
  std::unique_ptr<HeadlessContext> context;
  for (EGLDeviceEXT device : egl.hardware())
  {
    if (!context && egl.getPlatformDisplay)
    {
      context = createOn(egl.getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
    }
  }
  if (!context && egl.getPlatformDisplay &&
    hasWord(egl.queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless"))
  {
    context =
      createOn(egl.getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  if (!context)
  {
    context = createOn(egl.getDisplay(EGL_DEFAULT_DISPLAY));
  }
  if (!context)
  {
    reason = "EGL makes no OpenGL 3.2 core context";
    return nullptr;
  }
  if (!callsArrive())
  {
    reason = "EGL's context is out of reach, as another library took over OpenGL in this program";
    return nullptr;
  }
  return context;
}

bool HeadlessContext::hasHardware()
{
  return !EGL::instance().hardware().empty();
}
} // namespace stipple
