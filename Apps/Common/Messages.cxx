// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "MessageText.h"

#include "vtkCallbackCommand.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkObjectFactory.h"

namespace stipple
{
vtkStandardNewMacro(CollectingOutputWindow);

vtkSmartPointer<CollectingOutputWindow> CollectingOutputWindow::install()
{
  auto window = vtkSmartPointer<CollectingOutputWindow>::New();
  vtkOutputWindow::SetInstance(window);
  // VTK's executives also log to stderr by themselves.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  return window;
}

CollectingOutputWindow* CollectingOutputWindow::installed()
{
  return dynamic_cast<CollectingOutputWindow*>(vtkOutputWindow::GetInstance());
}

MessageWatch::MessageWatch()
{
  if (const auto* window = CollectingOutputWindow::installed())
  {
    this->Errors = window->errors().size();
    this->Warnings = window->warnings().size();
  }
}

std::string MessageWatch::firstError() const
{
  const auto* window = CollectingOutputWindow::installed();
  if (window && window->errors().size() > this->Errors)
  {
    return window->errors()[this->Errors];
  }
  for (std::size_t i = this->Warnings; window && i < window->warnings().size(); ++i)
  {
    if (window->warnings()[i].find("Error") != std::string::npos)
    {
      return window->warnings()[i];
    }
  }
  return {};
}

void CollectingOutputWindow::keep(std::vector<std::string>& list, const char* text)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  list.push_back(sentenceOf(text ? text : ""));
}

void CollectingOutputWindow::DisplayText(const char* text)
{
  this->keep(this->Warnings, text);
}

void CollectingOutputWindow::DisplayErrorText(const char* text)
{
  this->keep(this->Errors, text);
}

void CollectingOutputWindow::DisplayWarningText(const char* text)
{
  this->keep(this->Warnings, text);
}

void CollectingOutputWindow::DisplayGenericWarningText(const char* text)
{
  this->keep(this->Warnings, text);
}

ErrorCollector::ErrorCollector(vtkObject* object)
  : Object(object)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(&ErrorCollector::execute);
  this->Tag = object->AddObserver(vtkCommand::ErrorEvent, command);
}

ErrorCollector::~ErrorCollector()
{
  this->Object->RemoveObserver(this->Tag);
}

void ErrorCollector::execute(vtkObject*, unsigned long, void* self, void* message)
{
  auto* collector = static_cast<ErrorCollector*>(self);
  if (collector->First.empty() && message)
  {
    collector->First = sentenceOf(static_cast<const char*>(message));
  }
}
}
