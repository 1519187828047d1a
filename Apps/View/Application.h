// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The one window of the program, and what is open in it.
#ifndef stipple_Application_h
#define stipple_Application_h

#include "DocumentReader.h"
#include "Viewer.h"

namespace stipple
{
class Application
{
public:
  /// A window of so many pixels, not open yet.
  Application(int width, int height);
  ~Application();
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;

  /// Opens the window with what options name, read beside it if that takes longer than so.
  [[nodiscard]] Status open(const OptionValues& options, std::chrono::milliseconds patience);
  /// Handles events until the window is closed. An error: what was to be opened first cannot be.
  [[nodiscard]] Status run();
  /// One turn of the loop; a file that was asked for is opened after it.
  void turn();
  /// Turns until what is read beside the window is open.
  void finishReading();
  /// Turns until all is at rest.
  void settle();

  /// Another one once a file was opened.
  Viewer& viewer() { return *this->Now; }
  vtkRenderWindowInteractor* interactor() { return this->Interactor; }
  /// Leaves out what differs from run to run, for pictures that are compared.
  void hideTimes();
  /// Files that are opened are offered again by the next run.
  void rememberFiles() { this->Remembers = true; }

private:
  void openWindow();
  void show(const Document& document);
  void takeDocument();

  DocumentReader Reader; ///< first: the window need not wait for what it still reads
  ViewerWindow Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  std::unique_ptr<Viewer> Now;
  bool ReadsFirst = false; ///< what the command line names
  Session Agreed;          ///< that may be left for what is read
  Status First = Status::success();
  bool TimesHidden = false;
  bool Remembers = false;
};
}

#endif
