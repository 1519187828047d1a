// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewRun.h"

#include "Application.h"
#include "Benchmark.h"
#include "Display.h"
#include "OutputFiles.h"
#include "RecentFiles.h"
#include "Script.h"
#include "ViewOptions.h"

#include "vtkInteractorEventRecorder.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkVersion.h"

#include <array>

namespace stipple
{
namespace
{
Status useWindow(const Arguments& line, Application& application)
{
  const OptionValues& o = line.options;
  const bool steps = o.has("play") || o.has("shot"); // the program ends after them
  // Nobody is kept waiting for a small file by a page that says so.
  constexpr std::chrono::milliseconds Patience(300);
  constexpr std::chrono::hours Forever(1000);
  const bool named = o.has("model") || o.has("session");
  const bool waits = steps || o.has("benchmark") || !named;
  if (Status status = application.open(o, waits ? Forever : Patience); !status.ok())
  {
    return status;
  }
  if (o.has("benchmark"))
  {
    return runBenchmark(application.viewer(), o.text("benchmark"));
  }
  if (steps)
  {
    application.hideTimes();
  }
  else
  {
    application.rememberFiles();
    for (const char* name : { "model", "session" })
    {
      if (o.has(name))
      {
        addRecentFile(o.text(name));
      }
    }
  }
  if (!named)
  {
    application.viewer().showStart();
  }
  for (const auto& [name, file] : line.inOrder)
  {
    Status status = Status::success();
    if (name == "play")
    {
      status = playEvents(application, file);
    }
    else if (name == "shot")
    {
      application.settle();
      status = application.viewer().writePicture(file);
    }
    if (!status.ok())
    {
      return status;
    }
  }
  if (!steps)
  {
    vtkNew<vtkInteractorEventRecorder> recorder;
    if (o.has("record"))
    {
      recorder->SetInteractor(application.interactor());
      recorder->SetFileName(o.text("record").c_str());
      recorder->On();
      recorder->Record();
    }
    const Status status = application.run();
    recorder->Stop();
    return status;
  }
  return Status::success();
}
}

Status runViewer(const Arguments& line)
{
  const OptionValues& o = line.options;
  Status status = Status::success();
  for (const char* name : { "record", "benchmark" })
  {
    if (status.ok() && o.has(name))
    {
      status = OutputFiles::check(o.text(name));
    }
  }
  if (status.ok())
  {
    status = checkDisplay();
  }
  if (!status.ok())
  {
    return status;
  }
  std::array<int, 2> size = defaultWindowSize();
  if (o.has("size"))
  {
    const std::vector<double>& wanted = o.list("size");
    size = { { static_cast<int>(wanted[0]), static_cast<int>(wanted[1]) } };
  }
  Application application(size[0], size[1]);
  return useWindow(line, application);
}

std::string viewVersionText()
{
  std::string text =
    "stipple-view " STIPPLE_VERSION "\nVTK " + std::string(vtkVersion::GetVTKVersion()) + "\n";
  if (!checkDisplay().ok())
  {
    return text + "OpenGL: no display\n";
  }
  vtkNew<vtkRenderWindow> window;
  window->SetSize(16, 16);
  window->SetShowWindow(false);
  window->Render();
  const std::string capabilities = window->ReportCapabilities();
  const std::string key = "OpenGL renderer string:  ";
  const std::size_t begin = capabilities.find(key);
  return text + "OpenGL: " +
    (begin == std::string::npos ? "unknown"
                                : capabilities.substr(begin + key.size(),
                                    capabilities.find('\n', begin) - begin - key.size())) +
    "\n";
}
}
