// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Application.h"

#include "Display.h"
#include "RecentFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <thread>

namespace stipple
{
namespace
{
constexpr int TickMilliseconds = 10;
}

Application::Application(const Document& document, int width, int height)
  : Window(width, height)
{
  this->Interactor->SetRenderWindow(this->Window.window());
  // VTK's style asks for a frame after every event; a turn draws one for all of them.
  this->Interactor->EnableRenderOff();
  this->Now = std::make_unique<Viewer>(this->Window, this->Interactor, document);
}

Application::~Application() = default;

void Application::open()
{
  this->Now->open();
  this->Interactor->Initialize();
  setLeastSize(this->Window.window(), LeastWidth, LeastHeight);
  this->Now->resize(); // a window manager may have given another size
  vtkNew<vtkCallbackCommand> timer;
  timer->SetClientData(this);
  timer->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<Application*>(self)->turn(); });
  this->Interactor->AddObserver(vtkCommand::TimerEvent, timer);
  this->Interactor->CreateRepeatingTimer(TickMilliseconds);
}

void Application::run()
{
  this->Interactor->Start();
}

void Application::turn()
{
  this->Now->tick();
  if (const std::string file = this->Now->takeWantedFile(); !file.empty())
  {
    this->read(file);
  }
}

void Application::read(const std::string& file)
{
  Document document;
  if (const Status status = readDocument(file, document); !status.ok())
  {
    this->Now->complain(status.message());
    return;
  }
  this->Now.reset();
  this->Window.clear();
  this->Now = std::make_unique<Viewer>(this->Window, this->Interactor, document);
  this->Now->open();
  if (this->TimesHidden)
  {
    this->Now->hideTimes();
  }
  if (this->Remembers)
  {
    addRecentFile(file);
  }
}

void Application::settle()
{
  // No turn comes after the question: a mesh that it took would be drawn, but not smoothly.
  while (!this->Now->atRest())
  {
    this->turn();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void Application::hideTimes()
{
  this->TimesHidden = true;
  this->Now->hideTimes();
}
}
