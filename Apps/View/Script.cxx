// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Script.h"

#include "Application.h"

#include "vtkInteractorEventRecorder.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"

#include <array>
#include <fstream>

namespace stipple
{
namespace
{
/// Events of the recording machine's window and clock are not played.
bool isInput(const std::string& line)
{
  static const std::array<const char*, 13> names = { { "MouseMoveEvent", "LeftButtonPressEvent",
    "LeftButtonReleaseEvent", "MiddleButtonPressEvent", "MiddleButtonReleaseEvent",
    "RightButtonPressEvent", "RightButtonReleaseEvent", "MouseWheelForwardEvent",
    "MouseWheelBackwardEvent", "KeyPressEvent", "KeyReleaseEvent", "CharEvent",
    "LeftButtonDoubleClickEvent" } };
  for (const std::string name : names)
  {
    if (line.compare(0, name.size() + 1, name + " ") == 0)
    {
      return true;
    }
  }
  return false;
}
}

Status playEvents(Application& application, const std::string& file)
{
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line) || line.compare(0, 15, "# StreamVersion") != 0)
  {
    return Status::error("cannot read the recording '" + file + "'");
  }
  const std::string header = line;
  application.settle();
  while (std::getline(stream, line))
  {
    if (!isInput(line))
    {
      continue;
    }
    vtkNew<vtkInteractorEventRecorder> player;
    player->SetInteractor(application.interactor());
    player->ReadFromInputStringOn();
    player->SetInputString((header + "\n" + line + "\n").c_str());
    player->Play();
    application.turn();
    application.finishReading(); // as whoever was recorded did
  }
  application.settle();
  return Status::success();
}
}
