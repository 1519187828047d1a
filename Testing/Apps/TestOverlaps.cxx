// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a mesh would pass through itself, as the camel's tail, which is thinner than edges are long
// and would be turned inside out, edges are shorter.
#include "MeshOverlaps.h"
#include "PolyDataConversion.h"
#include "TestModels.h"

#include "vtkCellArray.h"
#include "vtkControlMap.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>

using namespace stipple;

namespace
{
std::function<std::vector<Box>()> placesOf(const TriangleSurface& s)
{
  return [&s] { return placesOfIntersections(s.points, s.triangles).value_or(std::vector<Box>()); };
}

/// A round plate, 300 wide and 4 thick, with a head in it, 12 wide, and .4 of air about the head.
vtkSmartPointer<vtkPolyData> plateWithHead()
{
  constexpr std::array<std::array<double, 2>, 8> Profile = { { { { 0., 0. } }, { { 150., 0. } },
    { { 150., 4. } }, { { 6.4, 4. } }, { { 6.4, 1. } }, { { 6., 1. } }, { { 6., 4. } },
    { { 0., 4. } } } };
  constexpr int Sides = 64;
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  for (const auto& [radius, height] : Profile)
  {
    for (int i = 0; i < Sides; ++i)
    {
      const double angle = 2. * Pi * i / Sides;
      points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (int ring = 0; ring + 1 < static_cast<int>(Profile.size()); ++ring)
  {
    for (int i = 0; i < Sides; ++i)
    {
      const vtkIdType below = ring * Sides;
      const vtkIdType next = below + (i + 1) % Sides;
      polygons->InsertNextCell({ below + i, next, next + Sides, below + i + Sides });
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}
}

// Of what few points tell apart, the mesh of the samples says where more are needed.
TEST(Overlaps, OfAHeadInItsHoleArePartedByFewPoints)
{
  const vtkSmartPointer<vtkPolyData> model = plateWithHead();
  const TriangleSurface surface = fromPolyData(model);
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(model);
  for (const int points : { 900, 1000 })
  {
    remesher->SetNumberOfPoints(points);
    remesher->Update();
    ASSERT_EQ(remesher->GetOutput()->GetNumberOfPoints(), points);
    EXPECT_EQ(remesher->GetNumberOfOverlaps(), 0) << points << " points";
    EXPECT_EQ(findOverlaps(fromPolyData(remesher->GetOutput()), placesOf(surface)).size(), 0U);
    EXPECT_GT(remesher->GetControlMap()->GetSizePlaces()->GetNumberOfTuples(), 0);
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
  for (const int points : { 5000, 5450, 5700, 6350, 7000 })
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
  compare("camel", { 1500, 5300 });
  compare("femur", { 2300, 3300 });
  EXPECT_GT(before, 2U);
  remesher->SetNumberOfPoints(1500);
  remesher->GetControlMap()->SetGrowth(0.);
  remesher->Update();
  EXPECT_FALSE(remesher->GetOptimizer()->GetRefineFaults());
}
