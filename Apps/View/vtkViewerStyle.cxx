// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewerStyle.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"

#include <cctype>

vtkStandardNewMacro(vtkViewerStyle);

stipple::Pointer vtkViewerStyle::PointerNow(bool secondary)
{
  const int* place = this->Interactor->GetEventPosition();
  stipple::Pointer pointer;
  pointer.x = static_cast<float>(place[0]);
  pointer.y = static_cast<float>(place[1]);
  pointer.shift = this->Interactor->GetShiftKey() != 0;
  pointer.control = this->Interactor->GetControlKey() != 0;
  pointer.secondary = secondary;
  return pointer;
}

// The focus that VTK's style takes when a button goes down would keep events from all others: the
// window would not be drawn until the button is up.
void vtkViewerStyle::OnLeftButtonDown()
{
  this->Captured = this->Handler->press(this->PointerNow(false));
  if (!this->Captured)
  {
    this->Superclass::OnLeftButtonDown();
    this->ReleaseFocus();
  }
}

void vtkViewerStyle::OnMiddleButtonDown()
{
  this->Superclass::OnMiddleButtonDown();
  this->ReleaseFocus();
}

void vtkViewerStyle::OnLeftButtonUp()
{
  if (this->Captured)
  {
    this->Captured = false;
    this->Handler->release(this->PointerNow(false));
    return;
  }
  this->Superclass::OnLeftButtonUp();
}

void vtkViewerStyle::OnRightButtonDown()
{
  if (!this->Handler->press(this->PointerNow(true)))
  {
    this->Superclass::OnRightButtonDown();
    this->ReleaseFocus();
  }
}

void vtkViewerStyle::OnRightButtonUp()
{
  this->Superclass::OnRightButtonUp();
}

void vtkViewerStyle::OnMouseMove()
{
  if (this->Captured)
  {
    this->Handler->drag(this->PointerNow(false));
    return;
  }
  if (this->State == VTKIS_NONE)
  {
    this->Handler->hover(this->PointerNow(false));
  }
  this->Superclass::OnMouseMove();
}

void vtkViewerStyle::OnMouseWheelForward()
{
  this->Handler->wheel(this->PointerNow(false), 1);
}

void vtkViewerStyle::OnMouseWheelBackward()
{
  this->Handler->wheel(this->PointerNow(false), -1);
}

void vtkViewerStyle::OnKeyPress()
{
  stipple::KeyStroke stroke;
  const char* symbol = this->Interactor->GetKeySym();
  stroke.symbol = symbol ? symbol : "";
  const char letter = this->Interactor->GetKeyCode();
  stroke.letter = std::isprint(static_cast<unsigned char>(letter)) ? letter : '\0';
  stroke.shift = this->Interactor->GetShiftKey() != 0;
  stroke.control = this->Interactor->GetControlKey() != 0;
  this->KeyTaken = this->Handler->key(stroke);
}

void vtkViewerStyle::OnChar()
{
  // A key press comes as two events, this one second.
  const char letter = this->Interactor->GetKeyCode();
  if (!this->KeyTaken && (letter == 'f' || letter == 'F'))
  {
    this->Superclass::OnChar();
  }
}
