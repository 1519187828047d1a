// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Stages run one by one, sound meshes made of them, and numbers of points that are searched.
#include "NumberSearches.h"
#include "PolyDataConversion.h"
#include "RemesherRun.h"
#include "StageRunner.h"
#include "SurfaceDeviation.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace stipple;

namespace
{
vtkSmartPointer<vtkPolyData> sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.);
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

/// Three corners on a line.
vtkSmartPointer<vtkPolyData> flatTriangle()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 3; ++i)
  {
    points->InsertNextPoint(i, 0., 0.);
  }
  vtkNew<vtkCellArray> triangle;
  triangle->InsertNextCell({ 0, 1, 2 });
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangle);
  return mesh;
}

/// Writes down what a run says.
struct Listener
{
  std::vector<double> fractions;
  std::vector<std::pair<char, int>> stages; ///< '(' or ')' and the stage
  int stopsAt = -1;                         ///< the stage with whose start it is stopped
  bool isStopped = false;

  RunCallbacks callbacks()
  {
    RunCallbacks result;
    result.tell = [this](double fraction) { this->fractions.push_back(fraction); };
    result.isStopped = [this] { return this->isStopped; };
    result.stageStarts = [this](int stage) {
      this->stages.emplace_back('(', stage);
      this->isStopped = this->isStopped || stage == this->stopsAt;
    };
    result.stageEnds = [this](int stage) { this->stages.emplace_back(')', stage); };
    return result;
  }
};

TEST(StageRunner, TellsWhenStagesStartAndEndAndWhatTheyTake)
{
  RemesherStages stages;
  Listener listener;
  StageRunner runner(stages, listener.callbacks());
  stages.Atlas->SetInputDataObject(0, sphere());
  runner.setProgressRange(0.5, 0.75);
  EXPECT_TRUE(runner.run(vtkGeometryRemesher::ATLAS).ok());
  const std::vector<std::pair<char, int>> once = { { '(', 0 }, { ')', 0 } };
  EXPECT_EQ(listener.stages, once);
  ASSERT_FALSE(listener.fractions.empty());
  EXPECT_TRUE(std::is_sorted(listener.fractions.begin(), listener.fractions.end()));
  EXPECT_GE(listener.fractions.front(), 0.5);
  const double ofAtlas = stages.progressOf(vtkGeometryRemesher::ATLAS)[1];
  EXPECT_DOUBLE_EQ(listener.fractions.back(), 0.5 + 0.25 * ofAtlas);

  const double seconds = runner.seconds(vtkGeometryRemesher::ATLAS);
  EXPECT_GT(seconds, 0.);
  EXPECT_TRUE(runner.run(vtkGeometryRemesher::ATLAS).ok());
  EXPECT_EQ(runner.seconds(vtkGeometryRemesher::ATLAS), seconds) << "it was up to date";
  runner.clearSeconds();
  EXPECT_EQ(runner.seconds(vtkGeometryRemesher::ATLAS), 0.);
}

TEST(StageRunner, HandsOnCodeAndSentence)
{
  RemesherStages stages;
  Listener listener;
  StageRunner runner(stages, listener.callbacks());
  vtkSmartPointer<vtkPolyData> mesh = sphere();
  const double x = mesh->GetPoint(7)[0];
  const double y = mesh->GetPoint(7)[1];
  const double z = mesh->GetPoint(7)[2];
  mesh->GetPoints()->SetPoint(7, std::numeric_limits<double>::quiet_NaN(), 0., 0.);
  stages.Atlas->SetInputDataObject(0, mesh);
  const Status bad = runner.run(vtkGeometryRemesher::ATLAS);
  EXPECT_EQ(bad.code(), StatusCode::BadInput);
  EXPECT_EQ(bad.message(),
    "Point 7 of the input has a coordinate that is not a finite number: remove or correct it.");

  // What was wrong is not said of the next run.
  mesh->GetPoints()->SetPoint(7, x, y, z);
  mesh->GetPoints()->Modified();
  mesh->Modified();
  EXPECT_TRUE(runner.run(vtkGeometryRemesher::ATLAS).ok());
}

TEST(StageRunner, IsDeafOnceItIsGone)
{
  RemesherStages stages;
  stages.Atlas->SetInputDataObject(0, sphere());
  Listener listener;
  {
    StageRunner runner(stages, listener.callbacks());
  }
  stages.Atlas->Update();
  EXPECT_TRUE(listener.fractions.empty());
}

TEST(RemesherRun, MakesWhatIsAskedForOrSaysWhatCanBe)
{
  Listener listener;
  RemesherRun run(listener.callbacks());
  run.begin(vtkGeometryRemesher::TRIANGLES);
  ASSERT_TRUE(run.takeInput(sphere(), "").ok());
  ASSERT_TRUE(run.remesh(150).ok());
  EXPECT_EQ(run.mesh()->GetNumberOfPoints(), 150);
  EXPECT_EQ(run.numberOfPoints(), 150);
  EXPECT_EQ(run.numberOfGivenPoints(), 0);
  EXPECT_EQ(run.numberTried(), 0);
  EXPECT_EQ(listener.stages.back(), std::make_pair(')', int(vtkGeometryRemesher::OPTIMISATION)));

  const Status few = run.remesh(2);
  ASSERT_EQ(few.code(), StatusCode::TooFewPoints);
  const int least = run.leastNumberOfPoints();
  ASSERT_GT(least, 2);
  EXPECT_NE(few.message().find(std::to_string(least)), std::string::npos) << few.message();
  EXPECT_TRUE(run.remesh(least).ok());
  EXPECT_EQ(run.mesh()->GetNumberOfPoints(), least);

  // A search takes what there is, in half of what is left of the time.
  run.runner().setProgressRange(0., 0.);
  EXPECT_TRUE(run.tryNumber(2).ok());
  EXPECT_EQ(run.numberTried(), 2);
  EXPECT_EQ(run.numberOfPoints(), least);
  EXPECT_DOUBLE_EQ(run.runner().progressEnd(), 0.5);
  EXPECT_TRUE(run.tryNumber(60).ok());
  EXPECT_DOUBLE_EQ(run.runner().progressEnd(), 0.75);
  run.end();
  EXPECT_EQ(run.numberTried(), 0);
}

TEST(RemesherRun, MakesNothingOfNothing)
{
  for (const int pattern : { vtkGeometryRemesher::TRIANGLES, vtkGeometryRemesher::QUADS,
         vtkGeometryRemesher::SEMIREGULAR })
  {
    Listener listener;
    RemesherRun run(listener.callbacks());
    run.begin(pattern);
    ASSERT_TRUE(run.takeInput(flatTriangle(), "").ok());
    const Status status = run.remesh(100);
    EXPECT_TRUE(status.ok()) << status.message();
    EXPECT_EQ(run.mesh()->GetNumberOfCells(), 0) << pattern;
  }
}

TEST(RemesherRun, StopsWithAnyStageAndGoesOnFromThere)
{
  for (int stage = 0; stage < RemesherStages::NumberOfStages; ++stage)
  {
    Listener listener;
    RemesherRun run(listener.callbacks());
    run.begin(vtkGeometryRemesher::TRIANGLES);
    ASSERT_TRUE(run.takeInput(sphere(), "").ok());
    listener.stopsAt = stage;
    EXPECT_TRUE(run.remesh(100).isAbort()) << stage;
    EXPECT_EQ(listener.stages.back(), std::make_pair('(', stage)) << "it was not gone through";
    listener.stopsAt = -1;
    listener.isStopped = false;
    EXPECT_TRUE(run.remesh(100).ok()) << stage;
    EXPECT_EQ(run.mesh()->GetNumberOfPoints(), 100);
  }
}

TEST(RemesherRun, RefusesWhatItCannotUse)
{
  Listener listener;
  RemesherRun run(listener.callbacks());
  run.begin(vtkGeometryRemesher::QUADS);
  EXPECT_EQ(run.takeInput(sphere(), "Part").code(), StatusCode::BadInput) << "a part in quads";
  run.begin(vtkGeometryRemesher::TRIANGLES);
  EXPECT_EQ(run.takeInput(sphere(), "Part").code(), StatusCode::BadInput) << "no such array";
  vtkSmartPointer<vtkPolyData> mesh = sphere();
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("Length");
  lengths->SetNumberOfTuples(mesh->GetNumberOfPoints());
  lengths->Fill(0.);
  mesh->GetPointData()->AddArray(lengths);
  EXPECT_TRUE(run.takeInput(mesh, "").ok());
  run.stages().ControlMap->SetSizeArrayName("Length");
  EXPECT_EQ(run.takeInput(mesh, "").code(), StatusCode::BadInput) << "no edge is 0 long";
}

TEST(NumberSearches, EdgesAreAsLongAsAskedFor)
{
  for (const double length : { 0.2, 0.35 })
  {
    Listener listener;
    RemesherRun run(listener.callbacks());
    run.stages().ControlMap->SetEdgeLength(length);
    run.begin(vtkGeometryRemesher::TRIANGLES);
    ASSERT_TRUE(run.takeInput(sphere(), "").ok());
    double median = 0.;
    ASSERT_TRUE(remeshToEdgeLength(run, 0, median).ok());
    EXPECT_NEAR(median, length, 0.05 * length);
    EXPECT_GT(run.mesh()->GetNumberOfPoints(), 0);
  }
}

TEST(NumberSearches, DeviationsAreHeldByAboutAsFewPointsAsDo)
{
  const TriangleSurface reference = fromPolyData(sphere());
  const double largest = 0.02;
  Listener listener;
  RemesherRun run(listener.callbacks());
  run.begin(vtkGeometryRemesher::TRIANGLES);
  ASSERT_TRUE(run.takeInput(sphere(), "").ok());
  double reached = 0.;
  ASSERT_TRUE(remeshWithinDeviation(run, reference, largest, reached).ok());
  DeviationBounds bounds;
  ASSERT_TRUE(
    surfaceDeviation(fromPolyData(run.mesh()), reference, 1e-3 * largest, {}, bounds).ok());
  EXPECT_LE(bounds.lower, largest);
  EXPECT_LE(0.01 * reached * reference.boundingBoxDiagonal(), largest);
  EXPECT_GE(0.01 * reached * reference.boundingBoxDiagonal(), bounds.lower);
  const int found = run.numberOfPoints();
  // A third of these do not: deviations of a sphere fall with one over their number.
  ASSERT_TRUE(run.remesh(found / 3).ok());
  ASSERT_TRUE(
    surfaceDeviation(fromPolyData(run.mesh()), reference, 1e-3 * largest, {}, bounds).ok());
  EXPECT_GT(bounds.lower, largest);

  // Edges that may not be shorter than this have no such mesh.
  run.stages().ControlMap->SetSizeMinimum(0.8);
  run.begin(vtkGeometryRemesher::TRIANGLES);
  ASSERT_TRUE(run.takeInput(sphere(), "").ok());
  const Status status = remeshWithinDeviation(run, reference, largest, reached);
  EXPECT_EQ(status.code(), StatusCode::BadInput);
  EXPECT_NE(status.message().find("or shorter edges"), std::string::npos) << status.message();
}

TEST(NumberSearches, EndAtOnceWithoutASurface)
{
  Listener listener;
  RemesherRun run(listener.callbacks());
  run.stages().ControlMap->SetEdgeLength(0.5);
  run.begin(vtkGeometryRemesher::TRIANGLES);
  ASSERT_TRUE(run.takeInput(flatTriangle(), "").ok());
  double result = 0.;
  EXPECT_TRUE(remeshToEdgeLength(run, 0, result).ok());
  EXPECT_EQ(run.mesh()->GetNumberOfCells(), 0);
  run.stages().ControlMap->SetEdgeLength(0.);
  run.begin(vtkGeometryRemesher::TRIANGLES);
  EXPECT_TRUE(remeshWithinDeviation(run, fromPolyData(flatTriangle()), 0.1, result).ok());
  EXPECT_EQ(run.mesh()->GetNumberOfCells(), 0);
}
}
