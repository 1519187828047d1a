// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Application.h"

#include "Display.h"
#include "RecentFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <filesystem>
#include <thread>

namespace stipple
{
namespace
{
constexpr int TickMilliseconds = 10;
}

Application::Application(int width, int height)
  : Window(width, height)
{
  this->Interactor->SetRenderWindow(this->Window.window());
  // VTK's style asks for a frame after every event; a turn draws one for all of them.
  this->Interactor->EnableRenderOff();
}

Application::~Application() = default;

Status Application::open(const OptionValues& options, std::chrono::milliseconds patience)
{
  const std::string name = options.text(options.has("session") ? "session" : "model");
  this->Reader.start(name, [options](Document& d) { return readDocument(options, d); });
  const auto read = this->Reader.take(patience);
  if (read && read->status.ok())
  {
    this->show(read->document);
    this->openWindow();
    return read->status;
  }
  const bool stays = options.has("stay");
  if (read && !stays)
  {
    return read->status;
  }
  Document example;
  const Status status = readDocument(OptionValues(), example);
  this->ReadsFirst = !stays;
  this->show(example);
  this->openWindow();
  this->Now->showStart(read ? read->status.message() : "");
  this->Now->setReading(read ? "" : name);
  return status;
}

void Application::openWindow()
{
  this->Interactor->Initialize();
  setLeastSize(this->Window.window(), LeastWidth, LeastHeight);
  setTitle(this->Window.window(), this->Window.window()->GetWindowName());
  this->Now->resize(); // a window manager may have given another size
  vtkNew<vtkCallbackCommand> timer;
  timer->SetClientData(this);
  timer->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<Application*>(self)->turn(); });
  this->Interactor->AddObserver(vtkCommand::TimerEvent, timer);
  this->Interactor->CreateRepeatingTimer(TickMilliseconds);
}

void Application::show(const Document& document)
{
  this->Now.reset();
  this->Window.clear();
  this->Now = std::make_unique<Viewer>(this->Window, this->Interactor, document);
  this->Now->open();
  if (this->TimesHidden)
  {
    this->Now->hideTimes();
  }
}

Status Application::run()
{
  if (this->First.ok())
  {
    this->Interactor->Start();
  }
  return this->First;
}

void Application::turn()
{
  this->Now->tick();
  if (const std::string file = this->Now->takeWantedFile(); !file.empty())
  {
    this->Agreed = this->Now->session();
    this->Reader.start(file, [file](Document& d) { return readDocument(file, d); });
    this->Now->setReading(file);
  }
  if (const std::string file = this->Now->takeWrittenSession(); !file.empty() && this->Remembers)
  {
    addRecentFile(file);
  }
  if (this->Now->takeGivenUp())
  {
    this->Reader.giveUp();
    this->ReadsFirst = false;
    this->Now->setReading("");
  }
  this->takeDocument();
}

void Application::takeDocument()
{
  if (this->Now->asks()) // what is typed there is not to go to another window
  {
    return;
  }
  const auto read = this->Reader.take(std::chrono::milliseconds(0));
  if (!read)
  {
    return;
  }
  this->Now->setReading("");
  const bool first = std::exchange(this->ReadsFirst, false);
  if (!read->status.ok() && first)
  {
    this->First = read->status;
    this->Interactor->TerminateApp();
    return;
  }
  if (!read->status.ok())
  {
    this->Now->complain(read->status.message());
    return;
  }
  if (this->Now->session() != this->Agreed && this->Now->hasUnsavedWork())
  {
    this->Now->askToOpen(read->name); // painted meanwhile
    return;
  }
  this->show(read->document);
  if (this->Remembers && !first)
  {
    addRecentFile(read->name);
  }
}

void Application::finishReading()
{
  while (this->Reader.busy() && !this->Now->asks())
  {
    this->turn();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void Application::settle()
{
  // No turn comes after the question: a mesh that it took would be drawn, but not smoothly.
  while ((this->Reader.busy() && !this->Now->asks()) || !this->Now->atRest())
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
