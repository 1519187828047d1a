// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmark.h"

#include "OutputFiles.h"
#include "TextNumbers.h"
#include "Viewer.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <thread>

namespace stipple
{
namespace
{
constexpr int PreviewFrames = 60;

struct Frame
{
  double seconds = 0;
  double processor = 0; ///< seconds of all threads; tells more than the clock on a busy machine
};

class Times
{
public:
  void add(const Frame& frame)
  {
    this->Milliseconds.push_back(1e3 * frame.seconds);
    this->Processor.push_back(1e3 * frame.processor);
  }

  std::string json()
  {
    const std::size_t n = this->Milliseconds.size();
    const auto at = [n](std::vector<double>& times, double share) {
      std::sort(times.begin(), times.end());
      return n == 0
        ? std::string("null")
        : shortestText(
            std::round(10 * times[static_cast<std::size_t>(share * static_cast<double>(n - 1))]) /
            10);
    };
    return "{ \"frames\": " + std::to_string(n) + ", \"median\": " + at(this->Milliseconds, .5) +
      ", \"p95\": " + at(this->Milliseconds, .95) + ", \"longest\": " + at(this->Milliseconds, 1) +
      ", \"processor_median\": " + at(this->Processor, .5) + " }";
  }

private:
  std::vector<double> Milliseconds;
  std::vector<double> Processor;
};

/// From a changed session to the picture of its samples: of the first, or of those that stay.
Frame timePreview(Viewer& viewer, bool (Viewer::*isDone)())
{
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  while (!(viewer.*isDone)())
  {
    viewer.tick();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  viewer.window().window()->WaitForCompletion();
  return { std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
    static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC };
}

/// A turn of the loop, its picture included.
Frame timeFrame(Viewer& viewer)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  viewer.tick();
  viewer.window().window()->WaitForCompletion();
  return { std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
    static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC };
}
}

Status runBenchmark(Viewer& viewer, const std::string& file)
{
  viewer.settle();
  viewer.edit([](Session& s) { s.set("importance", "total"); }, true);
  viewer.settle();

  Times preview[2];
  Times rested[2];
  Times sampling[2];
  for (const int smooth : { 0, 1 })
  {
    viewer.edit([smooth](Session& s) { s.set("gradation", smooth); }, true);
    viewer.settle();
    for (int i = 0; i < PreviewFrames; ++i)
    {
      const double gamma = 0.1 + 1.4 * i / PreviewFrames;
      viewer.edit([gamma](Session& s) { s.set("gamma", gamma); }, false);
      preview[smooth].add(timePreview(viewer, &Viewer::previewIsShown));
      sampling[smooth].add({ viewer.previewSeconds(), 0 });
      if (i % 3 == 0)
      {
        viewer.edit([gamma](Session& s) { s.set("gamma", gamma + 0.01); }, false);
        rested[smooth].add(timePreview(viewer, &Viewer::previewIsCurrent));
      }
    }
  }

  // The slider of the gradation itself moves: frames, not previews.
  Times gradation;
  for (int i = 0; i < PreviewFrames; ++i)
  {
    viewer.edit([i](Session& s) { s.set("gradation", 0.05 * i); }, false);
    gradation.add(timeFrame(viewer));
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
  }
  viewer.edit([](Session& s) { s.set("gradation", 0); }, true);
  viewer.settle();

  // The slider rests: the mesh is computed while the camera turns.
  Times camera;
  viewer.edit([](Session& s) { s.set("gamma", 0.7); }, true);
  const Session wanted = viewer.session();
  viewer.tick();
  while (viewer.busy())
  {
    viewer.window().renderer(ViewerWindow::Before)->GetActiveCamera()->Azimuth(2);
    viewer.window().touch(ViewerWindow::Views);
    camera.add(timeFrame(viewer));
  }
  viewer.settle();

  Times idle;
  for (int i = 0; i < PreviewFrames; ++i)
  {
    viewer.window().renderer(ViewerWindow::Before)->GetActiveCamera()->Azimuth(2);
    viewer.window().touch(ViewerWindow::Views);
    idle.add(timeFrame(viewer));
  }
  const int* size = viewer.window().window()->GetSize();
  OutputFiles files;
  std::ofstream stream(files.aside(file));
  stream << "{\n  \"window\": [" << size[0] << ", " << size[1]
         << "],\n  \"points\": " << wanted.integer("points")
         << ",\n  \"preview_ms\": " << preview[0].json()
         << ",\n  \"preview_at_rest_ms\": " << rested[0].json()
         << ",\n  \"preview_sampling_ms\": " << sampling[0].json()
         << ",\n  \"preview_with_gradation_ms\": " << preview[1].json()
         << ",\n  \"preview_with_gradation_at_rest_ms\": " << rested[1].json()
         << ",\n  \"preview_with_gradation_sampling_ms\": " << sampling[1].json()
         << ",\n  \"frame_while_gradation_moves_ms\": " << gradation.json()
         << ",\n  \"camera_while_meshing_ms\": " << camera.json()
         << ",\n  \"camera_ms\": " << idle.json() << "\n}\n";
  stream.close();
  return stream ? files.commit() : Status::error("cannot write '" + file + "'");
}
}
