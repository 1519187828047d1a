// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The mesh's thread: it comes to rest whatever was asked for and taken back.
#include "MeshWorker.h"
#include "SphereAtlas.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

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
  MeshWorker worker(sphere(32));
  Session session = withPoints(100);
  session.set("max_deviation", 1.);
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
  EXPECT_EQ(tried.count(static_cast<int>(mesh->mesh->GetNumberOfPoints())), 1);
  EXPECT_GE(tried.size(), 3) << "none yet, and more than one";
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
