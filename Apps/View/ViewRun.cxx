// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewRun.h"

#include "Benchmark.h"
#include "Display.h"
#include "MeshFile.h"
#include "OutputFiles.h"
#include "Script.h"
#include "Session.h"
#include "ViewOptions.h"
#include "Viewer.h"

#include "vtkImageData.h"
#include "vtkInteractorEventRecorder.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkVersion.h"

#include <array>
#include <filesystem>

namespace stipple
{
namespace
{
constexpr int DefaultPoints = 5000;

Status makeSession(const OptionValues& o, Session& session)
{
  // Something to see when gamma is moved.
  session.set("importance", "total");
  session.set("gamma", 0.5);
  if (o.has("session"))
  {
    if (Status status = readSession(o.text("session"), session); !status.ok())
    {
      return status;
    }
  }
  if (o.has("model"))
  {
    session.set("model", o.text("model"));
  }
  if (session.text("model").empty())
  {
    return Status::error("the session '" + o.text("session") + "' names no model: say which FILE");
  }
  const int points = o.has("points") ? o.integer("points") : session.integer("points");
  session.set("points", points > 0 ? points : DefaultPoints);
  return Status::success();
}

ViewerFiles filesOf(const OptionValues& o, const Session& session)
{
  const std::string stem = std::filesystem::path(session.text("model")).stem().string();
  ViewerFiles files;
  files.mesh = o.has("output") ? o.text("output") : stem + "-remeshed.ply";
  files.picture = o.has("picture") ? o.text("picture") : stem + "-view.png";
  files.session = o.has("save_session") ? o.text("save_session") : stem + "-session.json";
  return files;
}

Status useWindow(const Arguments& line, Viewer& viewer)
{
  const OptionValues& o = line.options;
  viewer.open();
  if (o.has("benchmark"))
  {
    return runBenchmark(viewer, o.text("benchmark"));
  }
  const bool steps = o.has("play") || o.has("shot"); // the program ends after them
  if (steps)
  {
    viewer.hideTimes();
  }
  for (const auto& [name, file] : line.inOrder)
  {
    Status status = Status::success();
    if (name == "play")
    {
      status = playEvents(viewer, file);
    }
    else if (name == "shot")
    {
      viewer.settle();
      status = viewer.writePicture(file);
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
      recorder->SetInteractor(viewer.interactor());
      recorder->SetFileName(o.text("record").c_str());
      recorder->On();
      recorder->Record();
    }
    viewer.run();
    recorder->Stop();
  }
  return Status::success();
}
}

Status runViewer(const Arguments& line)
{
  const OptionValues& o = line.options;
  Session session;
  Status status = makeSession(o, session);
  for (const char* name : { "record", "benchmark" })
  {
    if (status.ok() && o.has(name))
    {
      status = OutputFiles::check(o.text(name));
    }
  }
  vtkSmartPointer<vtkPolyData> input;
  if (status.ok())
  {
    status = readMesh(session.text("model"), input);
  }
  if (status.ok())
  {
    status = checkSession(session, input);
  }
  vtkSmartPointer<vtkImageData> image;
  if (status.ok() && !session.text("importance_image").empty())
  {
    status = readImage(session.text("importance_image"), image);
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
  Viewer viewer(input, image, session, filesOf(o, session), size[0], size[1]);
  return useWindow(line, viewer);
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
