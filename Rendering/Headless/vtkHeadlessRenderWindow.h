// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeadlessRenderWindow
 * @brief   an OpenGL render window that needs no display
 *
 * Draws into memory, with DISPLAY unset and no X server, and is else an ordinary vtkRenderWindow:
 * add renderers, Render(), read it with vtkWindowToImageFilter. It also serves as a context for
 * computing (vtkGeometryMapRenderer): Initialize() or SupportsOpenGL() makes it ready.
 *
 * There are two ways to OpenGL without a display, chosen at run time by Platform:
 *
 * - EGL needs libEGL and a driver (Debian: libegl1), nothing of the program, and reaches graphics
 *   hardware.
 * - OSMesa is software, the same on every machine. All of the process' OpenGL calls have to go to
 * it: a program says so by linking the library libStippleOSMesa before all others (CMake:
 *   stipple_link_osmesa(target)); Python loads it with RTLD_GLOBAL before vtkmodules. Such a
 * process cannot open windows on an X display.
 *
 * AUTO takes OSMesa in a program that was linked for it, since that is what such a program asked
 * for and what its OpenGL calls reach for certain, else EGL; and if that fails, the other.
 *
 * If there is no context to be had, SupportsOpenGL() is 0, GetOpenGLSupportMessage() says why, and
 * Render() reports that as an error and draws nothing.
 *
 * @warning As for any use of VTK's rendering, the program has to initialize VTK::RenderingOpenGL2
 * (vtk_module_autoinit, or import vtkmodules.vtkRenderingOpenGL2), or it sees black.
 *
 * @sa vtkGeometryMapRenderer
 */

#ifndef vtkHeadlessRenderWindow_h
#define vtkHeadlessRenderWindow_h

#include "StippleRenderingHeadlessModule.h" // for export macro
#include "vtkGenericOpenGLRenderWindow.h"

#include <memory> // for std::unique_ptr

class STIPPLERENDERINGHEADLESS_EXPORT vtkHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkHeadlessRenderWindow* New();
  vtkTypeMacro(vtkHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PlatformType
  {
    AUTO = 0,
    EGL = 1,
    OSMESA = 2
  };

  ///@{
  /**
   * Where the OpenGL context comes from. A change takes effect at once: the context, if there is
   * one already, is given up. The default is AUTO.
   */
  void SetPlatform(int platform);
  vtkGetMacro(Platform, int);
  void SetPlatformToAuto() { this->SetPlatform(AUTO); }
  void SetPlatformToEGL() { this->SetPlatform(EGL); }
  void SetPlatformToOSMesa() { this->SetPlatform(OSMESA); }
  ///@}

  /**
   * The platform of the context, "EGL" or "OSMesa"; makes the context if there is none yet. Empty
   * if there is none to be had.
   */
  const char* GetPlatformName();

  /**
   * The name that OpenGL's renderer gives itself; makes the context if there is none yet. Empty if
   * there is none to be had.
   */
  const char* GetRendererName();

  /**
   * Whether EGL knows a graphics device that is no software renderer. Makes no context.
   */
  static bool IsHardwareAvailable();

  /**
   * Leaves the calling thread without a current context if this one is current in it. A context can
   * be current in one thread only, so a thread that is done lets it go for the next.
   */
  void ReleaseCurrent() override;

  ///@{
  /**
   * What vtkRenderWindow asks of a window.
   */
  void Initialize() override;
  void Finalize() override;
  void Start() override;
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override;
  void OpenGLInit() override;
  void OpenGLInitContext() override;
  const char* ReportCapabilities() override;
  int* GetScreenSize() VTK_SIZEHINT(2) override;
  void PushContext() override;
  void PopContext() override;
  ///@}

protected:
  vtkHeadlessRenderWindow();
  ~vtkHeadlessRenderWindow() override;

private:
  vtkHeadlessRenderWindow(const vtkHeadlessRenderWindow&) = delete;
  void operator=(const vtkHeadlessRenderWindow&) = delete;

  bool CreateContext();

  int Platform = AUTO;
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
