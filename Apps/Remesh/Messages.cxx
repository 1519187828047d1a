// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkObjectFactory.h"

namespace stipple
{
vtkStandardNewMacro(CollectingOutputWindow);

std::string sentenceOf(const std::string& vtkMessage)
{
  std::string text = vtkMessage;
  const bool located = text.compare(0, 7, "ERROR: ") == 0 || text.compare(0, 9, "Warning: ") == 0 ||
    text.compare(0, 17, "Generic Warning: ") == 0;
  const std::size_t firstLine = text.find('\n');
  if (located && firstLine != std::string::npos)
  {
    text.erase(0, firstLine + 1);
    const std::size_t address = text.find(" (0x");
    const std::size_t colon = text.find("): ");
    if (address != std::string::npos && colon != std::string::npos && address < colon &&
      text.find_first_of(" \n") == address)
    {
      text.erase(0, colon + 3);
    }
  }
  for (char& c : text)
  {
    c = c == '\n' || c == '\r' ? ' ' : c;
  }
  const std::size_t end = text.find_last_not_of(' ');
  return text.substr(0, end == std::string::npos ? 0 : end + 1);
}

vtkSmartPointer<CollectingOutputWindow> CollectingOutputWindow::install()
{
  auto window = vtkSmartPointer<CollectingOutputWindow>::New();
  vtkOutputWindow::SetInstance(window);
  return window;
}

void CollectingOutputWindow::DisplayText(const char* text)
{
  this->Warnings.push_back(sentenceOf(text ? text : ""));
}

void CollectingOutputWindow::DisplayErrorText(const char* text)
{
  this->Errors.push_back(sentenceOf(text ? text : ""));
}

void CollectingOutputWindow::DisplayWarningText(const char* text)
{
  this->Warnings.push_back(sentenceOf(text ? text : ""));
}

void CollectingOutputWindow::DisplayGenericWarningText(const char* text)
{
  this->Warnings.push_back(sentenceOf(text ? text : ""));
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
