// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a mesh would pass through itself, as the camel's tail, which is thinner than edges are long
// and would be turned inside out, edges are shorter.
#include "MeshOverlaps.h"
#include "PolyDataConversion.h"
#include "TestModels.h"

#include "vtkControlMap.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>

using namespace stipple;

namespace
{
std::function<std::vector<Box>()> placesOf(const TriangleSurface& s)
{
  return [&s] { return placesOfIntersections(s.points, s.triangles).value_or(std::vector<Box>()); };
}
}

TEST(Overlaps, ArePartedByShorterEdges)
{
  const vtkSmartPointer<vtkPolyData> model = readModel("camel");
  const TriangleSurface surface = fromPolyData(model);
  const auto overlapsOf = [&](vtkGeometryRemesher* remesher, int points) {
    remesher->SetNumberOfPoints(points);
    remesher->Update();
    EXPECT_EQ(remesher->GetOutput()->GetNumberOfPoints(), points);
    const std::size_t overlaps =
      findOverlaps(fromPolyData(remesher->GetOutput()), placesOf(surface)).size();
    EXPECT_EQ(remesher->GetNumberOfOverlaps(), static_cast<int>(overlaps)) << points << " points";
    return overlaps;
  };
  vtkNew<vtkGeometryRemesher> remesher;
  vtkNew<vtkGeometryRemesher> even; // no edges are shorter than others
  even->GetControlMap()->SetGrowth(0.);
  for (vtkGeometryRemesher* each : { remesher.Get(), even.Get() })
  {
    each->SetInputData(model);
  }
  std::size_t before = 0;
  bool hasPlaces = false;
  for (const int points : { 5000, 5300, 5700, 6100, 7000 })
  {
    before += overlapsOf(even, points);
    EXPECT_EQ(even->GetControlMap()->GetSizePlaces()->GetNumberOfTuples(), 0);
    EXPECT_EQ(overlapsOf(remesher, points), 0U) << points << " points";
    hasPlaces = hasPlaces || remesher->GetControlMap()->GetSizePlaces()->GetNumberOfTuples() > 0;
  }
  EXPECT_GT(before, 20U);
  EXPECT_TRUE(hasPlaces) << "the features' sizes alone do not do it";
  // What was asked for at one number is gone at the next.
  remesher->SetPresetToUniform();
  remesher->Update();
  EXPECT_EQ(remesher->GetControlMap()->GetSizePlaces()->GetNumberOfTuples(), 0);
}

TEST(Overlaps, ArePartedInPlace)
{
  std::size_t before = 0;
  vtkNew<vtkGeometryRemesher> remesher;
  const auto compare = [&](const char* name, std::initializer_list<int> numbers) {
    const vtkSmartPointer<vtkPolyData> model = readModel(name);
    const TriangleSurface surface = fromPolyData(model);
    remesher->SetInputData(model);
    for (const int points : numbers)
    {
      remesher->SetNumberOfPoints(points);
      remesher->Update();
      vtkRemeshOptimizer* optimizer = remesher->GetOptimizer();
      EXPECT_TRUE(optimizer->GetRefineFaults()) << "as sizes grow";
      const auto overlaps = [&](bool refines) {
        optimizer->SetRefineFaults(refines);
        optimizer->Update();
        EXPECT_EQ(optimizer->GetOutput()->GetNumberOfPoints(), points);
        return findOverlaps(fromPolyData(optimizer->GetOutput()), placesOf(surface)).size();
      };
      EXPECT_EQ(overlaps(true), 0U) << name << ", " << points << " points";
      before += overlaps(false);
    }
  };
  compare("camel", { 1500, 5000 });
  compare("femur", { 2000, 2700 });
  EXPECT_GT(before, 2U);
  remesher->SetNumberOfPoints(1500);
  remesher->GetControlMap()->SetGrowth(0.);
  remesher->Update();
  EXPECT_FALSE(remesher->GetOptimizer()->GetRefineFaults());
}
