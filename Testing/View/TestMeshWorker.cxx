// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The mesh's thread: it comes to rest whatever was asked for and taken back.
#include "MeshWorker.h"
#include "SphereAtlas.h"

#include "vtkCallbackCommand.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <thread>

namespace stipple
{
namespace
{
bool restsWithin(std::chrono::seconds time, MeshWorker& worker)
{
  const auto end = std::chrono::steady_clock::now() + time;
  while (!worker.idle())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    const auto atlas = worker.takeAtlas();
    const auto mesh = worker.takeMesh();
    const std::string error = worker.takeError();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}
}

TEST(MeshWorker, RestsAfterSessionsThatWereTakenBack)
{
  MeshWorker worker(sphere(16));
  const Session session = withPoints(100);
  for (int i = 0; i < 20; ++i)
  {
    // Mostly before the thread has woken.
    worker.start(session);
    i % 2 == 0 ? worker.relax() : worker.cancel();
    ASSERT_TRUE(restsWithin(std::chrono::seconds(60), worker)) << i;
  }
  worker.start(session);
  std::unique_ptr<MeshResult> mesh;
  while (!worker.idle())
  {
    const auto atlas = worker.takeAtlas();
    if (auto done = worker.takeMesh())
    {
      mesh = std::move(done);
    }
    ASSERT_TRUE(worker.takeError().empty());
  }
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->mesh->GetNumberOfPoints(), 100);
}

TEST(MeshWorker, TellsTheNumbersThatAreTriedForADistance)
{
  Session session = withPoints(100);
  session.set("max_deviation", 1.);
  // What the filter tells its observers, in time whatever else the machine does.
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(sphere(32));
  remesher->GetMapRenderer()->SetBackendToCPU();
  applyOptions(session, remesher);
  std::set<int> told;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&told);
  observer->SetCallback([](vtkObject* caller, unsigned long, void* set, void*) {
    static_cast<std::set<int>*>(set)->insert(
      static_cast<vtkGeometryRemesher*>(caller)->GetNumberOfPointsTried());
  });
  remesher->AddObserver(vtkGeometryRemesher::StageStartEvent, observer);
  remesher->Update();
  EXPECT_EQ(remesher->GetNumberOfPointsTried(), 0);
  EXPECT_GE(told.size(), 2) << "more than one";
  EXPECT_EQ(told.count(0), 0);

  MeshWorker worker(sphere(32));
  worker.start(session);
  std::set<int> tried;
  std::unique_ptr<MeshResult> mesh;
  while (!worker.idle())
  {
    tried.insert(worker.tried());
    const auto atlas = worker.takeAtlas();
    if (auto done = worker.takeMesh())
    {
      mesh = std::move(done);
    }
    ASSERT_TRUE(worker.takeError().empty());
  }
  ASSERT_TRUE(mesh);
  EXPECT_EQ(told.count(static_cast<int>(mesh->mesh->GetNumberOfPoints())), 1);
  EXPECT_GE(tried.size(), 2) << "none yet, and some";
  told.insert(0); // before the first
  EXPECT_TRUE(std::includes(told.begin(), told.end(), tried.begin(), tried.end()));
  EXPECT_EQ(worker.tried(), 0);
  // The number does not stay from one session to the next.
  worker.start(withPoints(100));
  while (!worker.idle())
  {
    const auto done = worker.takeMesh();
    EXPECT_EQ(worker.tried(), 0);
  }
}
}
