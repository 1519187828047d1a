// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the window says that it does.
#include "Activity.h"

#include <gtest/gtest.h>

namespace stipple
{
namespace
{
using Mesh = Activity::Mesh;

Activity of(Mesh mesh)
{
  Activity activity;
  activity.mesh = mesh;
  activity.meshFile = "mesh.ply";
  activity.meshPath = "/work/mesh.ply";
  activity.meshProblem = "It failed.";
  return activity;
}

bool says(const Activity& activity, const std::string& words)
{
  return activity.sentence().find(words) != std::string::npos;
}
}

TEST(Activity, HeaderBarAndSentenceAgree)
{
  for (const Mesh mesh : { Mesh::Current, Mesh::Waiting, Mesh::Charts, Mesh::Making, Mesh::Asks,
         Mesh::Stopped, Mesh::Failed })
  {
    const Activity a = of(mesh);
    EXPECT_EQ(a.note().empty(), mesh == Mesh::Current);
    EXPECT_EQ(a.note() == "updating ...", a.works());
    EXPECT_EQ(says(a, "Esc stops it"), a.showsBar());
    EXPECT_EQ(says(a, "Stopped"), mesh == Mesh::Stopped);
    EXPECT_EQ(a.alarms(), mesh == Mesh::Failed);
    EXPECT_FALSE(a.showsBar() && !a.works());
  }
}

TEST(Activity, ManyPointsAreAskedAbout)
{
  Activity a = of(Mesh::Asks);
  a.points = 837462;
  EXPECT_EQ(a.sentence(), "Edges so short take some 840,000 points. Return makes the mesh.");
  EXPECT_FALSE(a.alarms());
  EXPECT_EQ(a.note(), "not up to date");
  a.byLevels = true;
  a.savesMesh = true;
  EXPECT_EQ(a.sentence(),
    "So many levels make some 840,000 points. Return makes the mesh and writes mesh.ply.");
  a.byLevels = false;
  a.points = 1.4e18;
  EXPECT_EQ(a.sentence(), "Edges so short take some 1.4e+18 points: there can be 10,000,000.");
}

TEST(Activity, TellsTheNumberThatIsTried)
{
  Activity a = of(Mesh::Making);
  EXPECT_EQ(a.sentence(), "Meshing; Esc stops it.");
  const Activity before = a;
  a.tried = 3412;
  EXPECT_NE(a, before);
  EXPECT_EQ(a.sentence(), "Trying 3,412 points for the distance; Esc stops it.");
  a.tried = 0;
  a.byLevels = true;
  a.points = 31970;
  EXPECT_EQ(a.sentence(), "Meshing some 32,000 points; Esc stops it.");
}

TEST(Activity, TellsWhatWillBeWritten)
{
  Activity a = of(Mesh::Making);
  a.savesMesh = true;
  EXPECT_TRUE(says(a, "mesh.ply will be written"));
  EXPECT_TRUE(says(a, "/work/mesh.ply")) << "with its folder";
  a.mesh = Mesh::Stopped;
  EXPECT_EQ(a.sentence(), "Stopped. Return makes the mesh and writes mesh.ply.");
}

TEST(Activity, ProblemsComeFirst)
{
  Activity a = of(Mesh::Making);
  a.savesMesh = true;
  a.sampling = true;
  a.sampleProblem = "Too few points.";
  EXPECT_EQ(a.sentence(), "Too few points.");
  EXPECT_TRUE(a.alarms());
  a.mesh = Mesh::Failed;
  EXPECT_EQ(a.sentence(), "It failed.");
}

TEST(Activity, NoSamplesAreAwaitedWhereNothingRuns)
{
  EXPECT_EQ(of(Mesh::Charts).sampleNote(), "sampling ...") << "they follow the charts";
  Activity a = of(Mesh::Stopped);
  EXPECT_EQ(a.sampleNote(), "no samples");
  a.samples = true;
  EXPECT_EQ(a.sampleNote(), "sampling ...");
  a.sampleProblem = "Too few points.";
  EXPECT_EQ(a.sampleNote(), "no samples");
}

TEST(Activity, SamplesThatTakeLongAreTold)
{
  Activity a = of(Mesh::Current);
  EXPECT_EQ(a.sentence(), "");
  a.sampling = true;
  EXPECT_EQ(a.sentence(), "Sampling ...");
}
}
