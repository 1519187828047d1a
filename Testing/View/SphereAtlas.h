// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A small closed surface with its charts and maps.
#ifndef SphereAtlas_h
#define SphereAtlas_h

#include "MeshWorker.h"

#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <chrono>
#include <memory>
#include <thread>

namespace stipple
{
inline Session withPoints(int points)
{
  Session session;
  session.set("points", points);
  session.set("importance", "total");
  return session;
}

inline vtkSmartPointer<vtkPolyData> sphere(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  vtkNew<vtkCleanPolyData> closed;
  closed->SetInputConnection(source->GetOutputPort());
  closed->Update();
  return closed->GetOutput();
}

inline SamplingInput atlasOf(vtkPolyData* surface)
{
  MeshWorker worker(surface);
  worker.start(withPoints(500));
  std::unique_ptr<AtlasResult> atlas;
  while (!(atlas = worker.takeAtlas()))
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return atlas->sampling;
}

inline SamplingInput sphereAtlas(int resolution)
{
  return atlasOf(sphere(resolution));
}
}

#endif
