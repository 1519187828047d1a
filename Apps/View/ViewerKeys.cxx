// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The keys.
#include "Viewer.h"

namespace stipple
{
bool Viewer::key(const KeyStroke& stroke)
{
  if (const std::shared_ptr<Page> page = this->Asked)
  {
    page->key(stroke);
    this->Window.touch(ViewerWindow::Overlay);
    return true;
  }
  if (this->Focus)
  {
    const bool taken = this->Focus->key(stroke);
    this->Window.touch(ViewerWindow::PanelPart);
    if (!this->Controls.points().hasFocus())
    {
      this->Focus = nullptr;
    }
    if (taken)
    {
      return true;
    }
  }
  if (stroke.control)
  {
    return this->commandKey(stroke);
  }
  const auto setTool = [this](Tool tool) {
    this->changeView([tool](ViewState& v) { v.tool = tool; });
    return true;
  };
  const std::string& key = stroke.symbol;
  if (key == "v" || key == "b" || key == "k" || key == "x")
  {
    return setTool(key == "v" ? Tool::Camera
        : key == "b"          ? Tool::Brush
        : key == "k"          ? Tool::Point
                              : Tool::Edge);
  }
  if (key == "h")
  {
    this->changeView([](ViewState& v) { v.help = !v.help; });
  }
  else if (key == "d")
  {
    this->changeView([](ViewState& v) {
      v.display = static_cast<Display>((static_cast<int>(v.display) + 1) % 4);
    });
  }
  else if (key == "l")
  {
    this->changeView([](ViewState& v) { v.features = !v.features; });
  }
  else if (key == "m")
  {
    this->changeView([](ViewState& v) { v.seams = !v.seams; });
  }
  else if (key == "w" || key == "s")
  {
    this->changeView([&key](ViewState& v) { v.wireframe = key == "w"; });
  }
  else if (key == "r")
  {
    this->fitCamera();
  }
  else if (key == "q" || key == "e")
  {
    this->askToQuit();
  }
  else if (key == "n")
  {
    this->Controls.points().focus();
    this->setFocus(&this->Controls.points());
    this->Window.touch(ViewerWindow::PanelPart);
  }
  else if (key == "Return" || key == "KP_Enter")
  {
    this->MeshWanted = !this->meshIsCurrent();
    this->MeshAt = Clock::now();
    this->Stopped = false;
  }
  else if (key == "Escape")
  {
    if (this->View.help)
    {
      this->changeView([](ViewState& v) { v.help = false; });
    }
    else if (this->Worker.busy() || this->MeshWanted)
    {
      this->Worker.cancel();
      this->MeshWanted = false;
      this->SaveWhenDone = false;
      this->Stopped = true;
      this->say("");
    }
  }
  else
  {
    return false;
  }
  return true;
}

bool Viewer::commandKey(const KeyStroke& stroke)
{
  if (stroke.symbol == "z" || stroke.symbol == "Z")
  {
    stroke.shift ? this->redo() : this->undo();
  }
  else if (stroke.symbol == "y")
  {
    this->redo();
  }
  else if (stroke.symbol == "q")
  {
    this->askToQuit();
  }
  else if (stroke.symbol == "s")
  {
    this->saveMesh();
  }
  else if (stroke.symbol == "p")
  {
    this->savePicture();
  }
  else if (stroke.symbol == "j")
  {
    this->saveSession();
  }
  else
  {
    return false;
  }
  return true;
}
}
