// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK's own messages, collected instead of printed, so that a failure is one line.
#ifndef stipple_Messages_h
#define stipple_Messages_h

#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <mutex>
#include <string>
#include <vector>

class vtkObject;

namespace stipple
{
/// Takes the place of VTK's output window: nothing is printed, everything is kept. Any thread may
/// speak; what was said is read where no other thread speaks any more.
class CollectingOutputWindow : public vtkOutputWindow
{
public:
  static CollectingOutputWindow* New();
  vtkTypeMacro(CollectingOutputWindow, vtkOutputWindow);

  /// Makes a new one VTK's output window.
  static vtkSmartPointer<CollectingOutputWindow> install();
  /// The one that is VTK's output window, or null.
  static CollectingOutputWindow* installed();

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char*) override {}

  const std::vector<std::string>& errors() const { return this->Errors; }
  const std::vector<std::string>& warnings() const { return this->Warnings; }

private:
  void keep(std::vector<std::string>& list, const char* text);
  std::mutex Mutex;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};

/// Collects the errors of one object as long as it lives.
class ErrorCollector
{
public:
  explicit ErrorCollector(vtkObject* object);
  ~ErrorCollector();
  ErrorCollector(const ErrorCollector&) = delete;
  ErrorCollector& operator=(const ErrorCollector&) = delete;
  /// The first sentence, or nothing.
  const std::string& first() const { return this->First; }

private:
  static void execute(vtkObject* caller, unsigned long event, void* self, void* message);
  vtkSmartPointer<vtkObject> Object;
  unsigned long Tag;
  std::string First;
};

/// What objects out of reach say to the collecting output window from now on.
class MessageWatch
{
public:
  MessageWatch();
  /// The first error, or warning that speaks of one; or nothing.
  [[nodiscard]] std::string firstError() const;

private:
  std::size_t Errors = 0;
  std::size_t Warnings = 0;
};
}

#endif
