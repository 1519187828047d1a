// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The folds of a lion's mane are sharp to a scan's edges; at the scale of a mesh they are none, and
// hold no vertices where triangles would be poor. A part's creases do.
#include "LostFeatures.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"
#include "TestModels.h"

#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"

#include <gtest/gtest.h>

#include <utility>

using namespace stipple;

namespace
{
struct Outcome
{
  MeshQuality quality;
  vtkIdType lost = 0; ///< pieces of features
};

Outcome remesh(vtkPolyData* model, int points, double tolerance)
{
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(model);
  remesher->SetNumberOfPoints(points);
  remesher->GetOptimizer()->SetFeatureTolerance(tolerance);
  remesher->Update();
  EXPECT_EQ(remesher->GetOutput()->GetNumberOfPoints(), points);
  const vtkSmartPointer<vtkPolyData> lost = lostFeatures(remesher);
  return { measureQuality(fromPolyData(remesher->GetOutput())),
    lost ? lost->GetNumberOfLines() : 0 };
}
}

TEST(ScanCreases, AreGivenUpWherePoor)
{
  const vtkSmartPointer<vtkPolyData> lion = readModel("lion-head");
  for (const int points : { 4000, 5000 })
  {
    const Outcome outcome = remesh(lion, points, 1.);
    const Outcome kept = remesh(lion, points, 0.);
    EXPECT_GT(outcome.lost, kept.lost + 50) << points << " points";
    EXPECT_EQ(kept.lost, 0) << points << " points";
    EXPECT_LT(outcome.quality.percentBelow30, 0.1) << points << " points";
    EXPECT_GT(kept.quality.percentBelow30, 0.5) << points << " points";
    EXPECT_GT(outcome.quality.minimumAngle, 25.) << points << " points";
  }
}

TEST(ScanCreases, AreKeptOnParts)
{
  for (const char* part : { "fandisk", "blade", "anchor_dense" })
  {
    EXPECT_EQ(remesh(readModel(part), 5000, 1.).lost, 0) << part;
  }
}

// Each by itself is worth what it costs; a thin bone without those on both of its sides is
// lost: 2.5 % of the diagonal at 500 points.
TEST(ScanCreases, AreKeptWhereTheMeshWouldBeFar)
{
  for (const auto& [name, points] : { std::pair{ "femur", 500 }, std::pair{ "elephant", 500 } })
  {
    const vtkSmartPointer<vtkPolyData> model = readModel(name);
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(model);
    remesher->SetNumberOfPoints(points);
    remesher->Update();
    const MeshDistance distance =
      measureDistance(fromPolyData(remesher->GetOutput()), fromPolyData(model));
    EXPECT_LT(distance.hausdorffPercent, 1.4) << name;
  }
}
