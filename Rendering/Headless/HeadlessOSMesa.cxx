// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// OSMesa: Mesa's software renderer with its own OpenGL entry points. It can draw for VTK only in a
// process whose OpenGL calls all go to it, which is what libStippleOSMesa arranges for a program
// that links it first. This file asks the process how it is arranged, and never loads OSMesa
// itself.
#include "HeadlessContext.h"

#include <array>

#include <dlfcn.h>

namespace stipple
{
namespace
{
// From GL/osmesa.h, which distributions with Mesa 25.1 or later have no more.
constexpr int osmesaFormat = 0x22;
constexpr int osmesaRGBA = 0x1908;
constexpr int osmesaDepthBits = 0x30;
constexpr int osmesaProfile = 0x33;
constexpr int osmesaCoreProfile = 0x34;
constexpr int osmesaMajorVersion = 0x36;
constexpr int osmesaMinorVersion = 0x37;
constexpr unsigned int unsignedByte = 0x1401;

using Context = struct osmesa_context*;
using Procedure = HeadlessContext::Procedure;

struct OSMesa
{
  Context (*createContextAttribs)(const int*, Context) = nullptr;
  void (*destroyContext)(Context) = nullptr;
  unsigned char (*makeCurrent)(Context, void*, unsigned int, int, int) = nullptr;
  Context (*getCurrentContext)() = nullptr;
  Procedure (*getProcAddress)(const char*) = nullptr;

  template <typename Function>
  static bool look(const char* name, Function& function)
  {
    function = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
    return function != nullptr;
  }

  bool load(std::string& reason)
  {
    if (!look("OSMesaCreateContextAttribs", this->createContextAttribs) ||
      !look("OSMesaDestroyContext", this->destroyContext) ||
      !look("OSMesaMakeCurrent", this->makeCurrent) ||
      !look("OSMesaGetCurrentContext", this->getCurrentContext) ||
      !look("OSMesaGetProcAddress", this->getProcAddress))
    {
      reason = "this program does not link OSMesa (libStippleOSMesa)";
      return false;
    }
    // The process' own entry points have to be OSMesa's: those that libraries link, and those that
    // GLEW looks up.
    Procedure (*lookUp)(const unsigned char*) = nullptr;
    Dl_info clear{};
    Dl_info osmesa{};
    void* glClear = dlsym(RTLD_DEFAULT, "glClear");
    const char* name = "glCreateShader";
    if (!look("glXGetProcAddressARB", lookUp) || !glClear || !dladdr(glClear, &clear) ||
      !dladdr(reinterpret_cast<void*>(this->makeCurrent), &osmesa) ||
      clear.dli_fbase != osmesa.dli_fbase ||
      lookUp(reinterpret_cast<const unsigned char*>(name)) != this->getProcAddress(name))
    {
      reason = "OSMesa is in this program, but not before the system's OpenGL (link "
               "libStippleOSMesa first)";
      return false;
    }
    return true;
  }
};

class OSMesaHeadlessContext : public HeadlessContext
{
public:
  OSMesaHeadlessContext(const OSMesa& library, Context context)
    : Library(library)
    , Handle(context)
  {
  }
  ~OSMesaHeadlessContext() override
  {
    this->release();
    this->Library.destroyContext(this->Handle);
  }
  const char* platform() const override { return "OSMesa"; }
  Procedure procedure(const char* name) const override
  {
    return this->Library.getProcAddress(name);
  }
  bool bind() override
  {
    return this->Library.makeCurrent(this->Handle, this->Buffer.data(), unsignedByte, side, side) !=
      0;
  }
  bool isBound() const override { return this->Library.getCurrentContext() == this->Handle; }
  void unbind() override
  {
    if (this->isBound())
    {
      this->Library.makeCurrent(nullptr, nullptr, unsignedByte, 0, 0);
    }
  }

private:
  static constexpr int side = 16; // OSMesa wants a default framebuffer; nothing is drawn into it
  OSMesa Library;
  Context Handle;
  std::array<unsigned char, 4 * side * side> Buffer{};
};
} // namespace

std::unique_ptr<HeadlessContext> HeadlessContext::createOSMesa(std::string& reason)
{
  OSMesa library;
  if (!library.load(reason))
  {
    return nullptr;
  }
  const int attributes[] = { osmesaFormat, osmesaRGBA, osmesaDepthBits, 24, osmesaProfile,
    osmesaCoreProfile, osmesaMajorVersion, 3, osmesaMinorVersion, 2, 0 };
  const Context handle = library.createContextAttribs(attributes, nullptr);
  if (!handle)
  {
    reason = "OSMesa makes no OpenGL 3.2 core context";
    return nullptr;
  }
  auto context = std::make_unique<OSMesaHeadlessContext>(library, handle);
  if (!context->makeCurrent())
  {
    reason = "OSMesa's context cannot be made current";
    return nullptr;
  }
  return context;
}
} // namespace stipple
