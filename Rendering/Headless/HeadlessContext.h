// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// An OpenGL 3.2 core context without a window; everything is drawn into framebuffer objects.
#ifndef stipple_HeadlessContext_h
#define stipple_HeadlessContext_h

#include <memory>
#include <string>

namespace stipple
{
class HeadlessContext
{
public:
  virtual ~HeadlessContext() = default;
  virtual const char* platform() const = 0;
  /// In the calling thread.
  virtual bool makeCurrent() = 0;
  virtual bool isCurrent() const = 0;
  /// Leaves the calling thread without a context, if this one is current in it.
  virtual void release() = 0;

  /// Null, with the reason, if this process cannot have one. The context is current on return.
  static std::unique_ptr<HeadlessContext> createEGL(std::string& reason);
  static std::unique_ptr<HeadlessContext> createOSMesa(std::string& reason);

  /// Whether EGL knows a graphics device that is no software renderer. Makes no context.
  static bool hasHardware();
};
}

#endif
