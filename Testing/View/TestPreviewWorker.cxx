// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The preview's thread: the latest session wins, and nobody waits for the others.
#include "PreviewWorker.h"
#include "SphereAtlas.h"

#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

namespace stipple
{
namespace
{
std::vector<std::unique_ptr<PreviewResult>> waitForAll(PreviewWorker& worker)
{
  std::vector<std::unique_ptr<PreviewResult>> results;
  while (!worker.idle())
  {
    if (auto result = worker.take())
    {
      results.push_back(std::move(result));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return results;
}

std::unique_ptr<PreviewResult> wait(PreviewWorker& worker)
{
  auto results = waitForAll(worker);
  return results.empty() ? nullptr : std::move(results.back());
}

std::vector<float> valuesOf(vtkPartitionedDataSetCollection* controls)
{
  std::vector<float> values;
  for (unsigned int c = 0; c < controls->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* image = vtkImageData::SafeDownCast(controls->GetPartitionAsDataObject(c, 0));
    auto* control = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("Control"));
    values.insert(
      values.end(), control->GetPointer(0), control->GetPointer(0) + control->GetNumberOfValues());
  }
  return values;
}
}

TEST(PreviewWorker, SamplesExactly)
{
  PreviewWorker worker(8);
  worker.setAtlas(sphereAtlas(24));
  EXPECT_TRUE(worker.idle());
  worker.start(withPoints(321));
  EXPECT_FALSE(worker.idle()) << "its result has not been taken";
  const auto result = wait(worker);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->problem, "");
  EXPECT_EQ(result->numberOfSamples, 321);
  EXPECT_EQ(result->histogram.size(), 8U);
  EXPECT_EQ(worker.waiting(), 0.);
}

TEST(PreviewWorker, PaintsDensitiesWhereTheyAreAskedFor)
{
  PreviewWorker worker(8);
  worker.setAtlas(sphereAtlas(24));
  worker.start(withPoints(321));
  auto result = wait(worker);
  ASSERT_TRUE(result && result->dots);
  EXPECT_TRUE(result->density.empty());
  worker.setDensityWanted(true);
  worker.start(withPoints(321));
  result = wait(worker);
  ASSERT_TRUE(result && result->dots);
  EXPECT_EQ(result->density.size(), result->dots->numbers.size());
}

TEST(PreviewWorker, TheLatestWins)
{
  PreviewWorker worker(8);
  worker.setAtlas(sphereAtlas(24));
  constexpr int Asked = 100;
  for (int i = 0; i < Asked; ++i)
  {
    worker.start(withPoints(400 + i));
  }
  const auto result = wait(worker);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->numberOfSamples, 400 + Asked - 1);
}

TEST(PreviewWorker, SamplesThatAreGivenComeOnTop)
{
  SamplingInput atlas = sphereAtlas(24);
  atlas.given = 21;
  PreviewWorker worker(8);
  worker.setAtlas(atlas);
  worker.start(withPoints(300));
  EXPECT_EQ(wait(worker)->numberOfSamples, 321);
}

TEST(PreviewWorker, WhatIsGivenUpIsNotHandedOver)
{
  PreviewWorker worker(8);
  worker.setAtlas(sphereAtlas(24));
  int givenUp = 0;
  for (int i = 0; i < 20; ++i) // one or the other may be done before
  {
    worker.start(withPoints(2000 + i));
    worker.cancel();
    givenUp += wait(worker) ? 0 : 1;
  }
  EXPECT_GT(givenUp, 0);
  worker.start(withPoints(300));
  EXPECT_EQ(wait(worker)->numberOfSamples, 300) << "and goes on";
}

TEST(PreviewWorker, TellsWhyThereAreNoSamples)
{
  PreviewWorker worker(8);
  worker.setAtlas(sphereAtlas(24));
  worker.start(withPoints(1));
  const auto result = wait(worker);
  ASSERT_TRUE(result);
  EXPECT_NE(result->problem, "");
  EXPECT_EQ(result->numberOfSamples, 0);
  EXPECT_FALSE(result->dots);
  worker.start(withPoints(300));
  EXPECT_EQ(wait(worker)->problem, "") << "and goes on";
}

TEST(PreviewWorker, ADraftIsFollowedByWhatStays)
{
  // So thin that edges along its rim must be shorter than elsewhere.
  vtkNew<vtkCubeSource> plate;
  plate->SetZLength(0.05);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plate->GetOutputPort());
  vtkNew<vtkCleanPolyData> closed;
  closed->SetInputConnection(triangles->GetOutputPort());
  closed->Update();
  const SamplingInput atlas = atlasOf(closed->GetOutput());
  Session session = withPoints(321);
  session.set("importance", std::string("uniform"));
  Preview preview;
  preview.setAtlas(atlas);
  ASSERT_TRUE(preview.update(session, PreviewStage::Draft).ok());
  EXPECT_EQ(preview.samples()->GetNumberOfPoints(), 321);
  const std::vector<float> draft = valuesOf(preview.controls());
  ASSERT_TRUE(preview.update(session).ok());
  const std::vector<float> last = valuesOf(preview.controls());
  EXPECT_NE(draft, last);

  PreviewWorker worker(8, 0.);
  worker.setAtlas(atlas);
  worker.start(withPoints(300)); // how long it takes is not known yet
  EXPECT_EQ(waitForAll(worker).size(), 1U);
  worker.start(session);
  const auto results = waitForAll(worker);
  ASSERT_FALSE(results.empty());
  EXPECT_EQ(valuesOf(results.back()->controls), last);
  if (results.size() > 1) // else this thread slept too long to see it
  {
    EXPECT_EQ(valuesOf(results.front()->controls), draft);
    EXPECT_EQ(results.front()->numberOfSamples, 321);
  }
}

TEST(PreviewWorker, ASessionAfterADraftIsWaitedForFromItsOwnBeginning)
{
  PreviewWorker worker(8, 0.);
  worker.setAtlas(sphereAtlas(24));
  worker.start(withPoints(300)); // how long it takes is not known yet
  wait(worker);
  int seen = 0;
  for (int i = 0; i < 20; ++i)
  {
    worker.start(withPoints(400 + i));
    std::unique_ptr<PreviewResult> first;
    while (!first)
    {
      first = worker.take();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const bool works = worker.waiting() > 0; // on what stays: it has been drawn up to 20 ms
    const auto before = std::chrono::steady_clock::now();
    worker.start(withPoints(300 + i));
    const double waiting = worker.waiting();
    const double since =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    seen += works ? 1 : 0;
    EXPECT_LE(waiting, since);
    wait(worker);
  }
  EXPECT_GT(seen, 0);
}

TEST(PreviewWorker, SamplesOfOtherChartsAreNotHandedOver)
{
  const SamplingInput coarse = sphereAtlas(12);
  const SamplingInput fine = sphereAtlas(32);
  PreviewWorker worker(8);
  worker.setAtlas(coarse);
  worker.start(withPoints(300));
  worker.setAtlas(fine);
  worker.start(withPoints(301));
  const auto result = wait(worker);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->numberOfSamples, 301);
}

namespace
{
/// The distance of each to the nearest other one, over its mean: the standard deviation.
double unevenness(vtkPolyData* samples)
{
  const vtkIdType n = samples->GetNumberOfPoints();
  std::vector<double> nearest;
  double mean = 0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    double best = 1e30;
    for (vtkIdType j = 0; j < n; ++j)
    {
      const double d = (Vec3(samples->GetPoint(i)) - Vec3(samples->GetPoint(j))).norm();
      best = j != i && d < best ? d : best;
    }
    nearest.push_back(best);
    mean += best / static_cast<double>(n);
  }
  double sum = 0;
  for (const double d : nearest)
  {
    sum += (d - mean) * (d - mean) / static_cast<double>(n);
  }
  return std::sqrt(sum) / mean;
}
}

TEST(SampleRelaxation, DotsAreSpread)
{
  const SamplingInput atlas = sphereAtlas(48);
  const SampleRelaxation relaxation(atlas.charts, atlas.graph);
  Preview preview;
  preview.setAtlas(atlas);
  Session session = withPoints(1500);
  session.set("importance", std::string("uniform"));
  ASSERT_TRUE(preview.update(session).ok());
  vtkPolyData* samples = preview.samples();
  const auto relaxed = relaxation.relax(samples);
  ASSERT_TRUE(relaxed);
  vtkPolyData* dots = relaxed->samples;
  ASSERT_EQ(dots->GetNumberOfPoints(), 1500);
  EXPECT_LT(unevenness(dots), 0.6 * unevenness(samples));
  for (vtkIdType i = 0; i < 1500; ++i)
  {
    const Vec3 dot(dots->GetPoint(i));
    EXPECT_NEAR(dot.norm(), 0.5, 0.004) << "on the sphere";
    EXPECT_LT((dot - Vec3(samples->GetPoint(i))).norm(), 0.05) << "near where it was";
  }
}

TEST(PreviewWorker, EndsWhileItWorks)
{
  const SamplingInput atlas = sphereAtlas(64);
  PreviewWorker worker(8);
  worker.setAtlas(atlas);
  Session session = withPoints(2000);
  session.set("gradation", 0.05);
  worker.start(session);
}
}
