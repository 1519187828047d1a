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

#include <filesystem>

namespace stipple
{
namespace
{
constexpr int DefaultPoints = 5000;

Status makeSession(const ViewOptions& o, Session& session)
{
  // Something to see when gamma is moved.
  session.set("importance", "total");
  session.set("gamma", 0.5);
  if (!o.session.empty())
  {
    if (Status status = readSession(o.session, session); !status.ok())
    {
      return status;
    }
  }
  if (!o.input.empty())
  {
    session.set("model", o.input);
  }
  if (session.text("model").empty())
  {
    return Status::error("the session '" + o.session + "' names no model: say which FILE");
  }
  const int points = o.points > 0 ? o.points : session.integer("points");
  session.set("points", points > 0 ? points : DefaultPoints);
  return Status::success();
}

ViewerFiles filesOf(const ViewOptions& o, const Session& session)
{
  const std::string stem = std::filesystem::path(session.text("model")).stem().string();
  ViewerFiles files;
  files.mesh = o.output.empty() ? stem + "-remeshed.ply" : o.output;
  files.picture = o.picture.empty() ? stem + "-view.png" : o.picture;
  files.session = o.saveSession.empty() ? stem + "-session.json" : o.saveSession;
  return files;
}

Status perform(const ViewOptions::Step& step, Viewer& viewer)
{
  if (step.kind == ViewOptions::Step::Kind::Play)
  {
    return playEvents(viewer, step.file);
  }
  viewer.settle();
  return viewer.writePicture(step.file);
}

Status useWindow(const ViewOptions& o, Viewer& viewer)
{
  viewer.open();
  if (!o.benchmark.empty())
  {
    return runBenchmark(viewer, o.benchmark);
  }
  if (!o.steps.empty())
  {
    viewer.hideTimes();
  }
  for (const ViewOptions::Step& step : o.steps)
  {
    if (Status status = perform(step, viewer); !status.ok())
    {
      return status;
    }
  }
  if (o.steps.empty())
  {
    vtkNew<vtkInteractorEventRecorder> recorder;
    if (!o.record.empty())
    {
      recorder->SetInteractor(viewer.interactor());
      recorder->SetFileName(o.record.c_str());
      recorder->On();
      recorder->Record();
    }
    viewer.run();
    recorder->Stop();
  }
  return Status::success();
}
}

Status runViewer(const ViewOptions& o)
{
  Session session;
  Status status = makeSession(o, session);
  for (const std::string& file : { o.record, o.benchmark })
  {
    if (status.ok() && !file.empty())
    {
      status = OutputFiles::check(file);
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
  Viewer viewer(input, image, session, filesOf(o, session), o.width, o.height);
  return useWindow(o, viewer);
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
