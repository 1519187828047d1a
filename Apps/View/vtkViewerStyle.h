// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkViewerStyle
 * @brief   the trackball camera, after the window's controls and tools had their say
 *
 * Of VTK's own keys only f (fly to what is under the pointer) is left: the others (stereo, the box
 * of a picked actor, wireframe in one view, exit at once) would break the window, or are the
 * handler's.
 */
#ifndef vtkViewerStyle_h
#define vtkViewerStyle_h

#include "Control.h"

#include "vtkInteractorStyleTrackballCamera.h"

namespace stipple
{
/// Who is asked first. True: the event is not for the camera.
class PointerHandler
{
public:
  virtual ~PointerHandler() = default;
  virtual bool press(const Pointer& pointer) = 0;
  virtual void drag(const Pointer& pointer) = 0; ///< only after press() took it
  virtual void release(const Pointer& pointer) = 0;
  virtual void hover(const Pointer& pointer) = 0;
  /// Notches of the wheel, away from the user positive.
  virtual void wheel(const Pointer& pointer, int notches) = 0;
  virtual bool key(const KeyStroke& stroke) = 0;
};
}

class vtkViewerStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static vtkViewerStyle* New();
  vtkTypeMacro(vtkViewerStyle, vtkInteractorStyleTrackballCamera);

  /// Not kept alive.
  void SetHandler(stipple::PointerHandler* handler) { this->Handler = handler; }

  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMouseMove() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnKeyPress() override;
  void OnChar() override;
  /// Does nothing: where a timer runs, VTK repeats the last motion at each of its events while a
  /// button is down. The window's timer is there to draw.
  void OnTimer() override {}

protected:
  vtkViewerStyle() = default;
  ~vtkViewerStyle() override = default;

private:
  vtkViewerStyle(const vtkViewerStyle&) = delete;
  void operator=(const vtkViewerStyle&) = delete;

  stipple::Pointer PointerNow(bool secondary);

  stipple::PointerHandler* Handler = nullptr;
  bool Captured = false; ///< the handler has the button that is down
  bool KeyTaken = false; ///< the handler has the key that is down
};

#endif
