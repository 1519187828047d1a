// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Any models: a first remesh next to CGAL's isotropic_remeshing to as many points, timed in turns,
// and how far both are from the model. Both keep freed memory, as the program does.
//   StippleBenchmarkCorpus POINTS FILE...
// CGAL 5.5 crashes on some files: give those to a process of their own.
#include "CgalRemeshing.h"
#include "FreedMemory.h"
#include "MeshFile.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"

#include "vtkGeometryRemesher.h"
#include "vtkObject.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{
constexpr int Turns = 3;

double secondsOf(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0. : values[values.size() / 2];
}

double rmsOf(const stipple::TriangleSurface& mesh, const stipple::TriangleSurface& model)
{
  return stipple::measureDistance(mesh, model).rmsPercent;
}

struct Ratios
{
  std::vector<double> time;
  std::vector<double> rms;
};

void compare(const std::string& file, int points, Ratios& ratios)
{
  const std::string name = file.substr(file.find_last_of('/') + 1);
  vtkSmartPointer<vtkPolyData> model;
  if (const stipple::Status status = stipple::readMesh(file, model); !status.ok())
  {
    std::printf("%-32.32s %s\n", name.c_str(), status.message().c_str());
    return;
  }
  vtkSmartPointer<vtkGeometryRemesher> remesher;
  std::vector<double> ours;
  std::vector<double> theirs;
  const benchmarks::CgalRemeshing cgal(model, points);
  for (int turn = 0; turn < Turns; ++turn)
  {
    ours.push_back(secondsOf([&] {
      remesher = vtkSmartPointer<vtkGeometryRemesher>::New();
      remesher->SetInputData(model);
      remesher->SetNumberOfPoints(points);
      remesher->Update();
    }));
    theirs.push_back(secondsOf([&] { cgal.run(); }));
  }
  if (remesher->GetErrorCode() != 0)
  {
    std::printf("%-32.32s %8.3f s: refused\n", name.c_str(), median(ours));
    return;
  }
  const stipple::TriangleSurface surface = stipple::fromPolyData(model);
  const stipple::TriangleSurface other = cgal.surface();
  const double rms = rmsOf(stipple::fromPolyData(remesher->GetOutput()), surface);
  const double otherRms = rmsOf(other, surface);
  ratios.time.push_back(median(ours) / median(theirs));
  ratios.rms.push_back(otherRms > 0 ? rms / otherRms : 1.);
  std::printf("%-32.32s %8.3f %8.3f %6.2f   %8.4f %8.4f %6.2f   %7zu  ", name.c_str(), median(ours),
    median(theirs), ratios.time.back(), rms, otherRms, ratios.rms.back(), other.points.size());
  for (int stage = vtkGeometryRemesher::ATLAS; stage <= vtkGeometryRemesher::OPTIMISATION; ++stage)
  {
    std::printf(" %.3f", remesher->GetStageSeconds(stage));
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print(const char* what, const std::vector<double>& ratios)
{
  if (!ratios.empty())
  {
    std::printf("%s: median %.2f, largest %.2f of %zu\n", what, median(ratios),
      *std::max_element(ratios.begin(), ratios.end()), ratios.size());
  }
}
}

int main(int argc, char** argv)
{
  const int points = argc > 2 ? std::atoi(argv[1]) : 0;
  if (points <= 0)
  {
    std::fprintf(stderr, "usage: %s POINTS FILE...\n", argv[0]);
    return 2;
  }
  stipple::keepFreedMemory();
  vtkObject::GlobalWarningDisplayOff(); // of models that are refused
  std::printf("%-32s %8s %8s %6s   %8s %8s %6s   %7s   stages\n", "model", "s", "CGAL", "ratio",
    "RMS %", "CGAL", "ratio", "points");
  Ratios ratios;
  for (int i = 2; i < argc; ++i)
  {
    compare(argv[i], points, ratios);
  }
  print("time", ratios.time);
  print("RMS", ratios.rms);
  return 0;
}
