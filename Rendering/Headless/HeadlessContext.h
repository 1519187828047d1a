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

  /// One of OpenGL's functions by its name; null if there is none. The context is current.
  using Procedure = void (*)();
  virtual Procedure procedure(const char* name) const = 0;

  // Of the calling thread. EGL and OSMesa do not know of each other, and each may take for current
  // what the other replaced; so the last one to be made current is noted here.
  bool makeCurrent()
  {
    if (this->isCurrent())
    {
      return true;
    }
    this->unbind();
    HeadlessContext::last() = this;
    return this->bind();
  }
  bool isCurrent() const { return HeadlessContext::last() == this && this->isBound(); }
  /// Leaves the thread without a context, if this one is current.
  void release()
  {
    if (HeadlessContext::last() == this)
    {
      this->unbind();
      HeadlessContext::last() = nullptr;
    }
  }

  /// Null, with the reason, if this process cannot have one. The context is current on return.
  static std::unique_ptr<HeadlessContext> createEGL(std::string& reason);
  static std::unique_ptr<HeadlessContext> createOSMesa(std::string& reason);

  /// Whether EGL knows a graphics device that is no software renderer. Makes no context.
  static bool hasHardware();

protected:
  virtual bool bind() = 0;
  virtual bool isBound() const = 0;
  virtual void unbind() = 0; ///< if it is bound

private:
  static const HeadlessContext*& last()
  {
    static thread_local const HeadlessContext* context = nullptr; // to compare, not to follow
    return context;
  }
};
} // namespace stipple

#endif
