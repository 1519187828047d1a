// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Curves given as points on the surface.
#include "FeatureCurves.h"
#include "FeatureGraphBuilder.h"
#include "Shapes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace stipple;

namespace
{
vtkSmartPointer<vtkPolyData> polyline(const std::vector<Vec3>& line)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(line.size()));
  for (const Vec3& p : line)
  {
    lines->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}

double length(const CutSurface& s, const Backbone& b)
{
  double sum = 0;
  for (int i = 0; i < b.numberOfSegments(); ++i)
  {
    sum += (s.points[b.segmentEnd(i)] - s.points[b.points[i]]).norm();
  }
  return sum;
}

bool isVertex(const CutSurface& s, const Vec3& x)
{
  return std::any_of(
    s.points.begin(), s.points.end(), [&](const Vec3& p) { return (p - x).norm() < 1e-9; });
}
}

TEST(FeatureCurves, StraightLineOnTheCube)
{
  CutSurface s = shapes::cutSurface(shapes::cube(4));
  const double area = s.area();
  const double z = s.points.front().z(); // a face of the cube
  std::vector<Vec3> line = { { 0.111, 0.222, z }, { 0.777, 0.555, z }, { 0.1, 0.85, z } };
  ASSERT_TRUE(insertFeatureCurves(s, polyline(line), {}).ok());
  EXPECT_EQ(s.twin, halfedgeTwins(s.triangles));
  EXPECT_NEAR(s.area(), area, 1e-12);
  EXPECT_TRUE(s.topology().manifold);
  for (const Vec3& p : line)
  {
    EXPECT_TRUE(isVertex(s, p));
  }
  const FeatureGraph graph = buildFeatureGraph(s, 60);
  ASSERT_EQ(graph.backbones.size(), 2U) << "the turn in the middle is a corner";
  EXPECT_NEAR(length(s, graph.backbones[0]) + length(s, graph.backbones[1]),
    (line[1] - line[0]).norm() + (line[2] - line[1]).norm(), 1e-9);
}

TEST(FeatureCurves, ClosedCircleOnTheSphere)
{
  CutSurface s = shapes::cutSurface(shapes::sphere(1, 4));
  std::vector<Vec3> circle;
  const int n = 24;
  const double z = 0.37;
  for (int i = 0; i <= n; ++i)
  {
    const double a = 2 * Pi * (i % n) / n;
    circle.emplace_back(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z);
  }
  ASSERT_TRUE(insertFeatureCurves(s, polyline(circle), {}).ok());
  EXPECT_EQ(s.topology().euler, 2);
  const FeatureGraph graph = buildFeatureGraph(s, 60);
  ASSERT_EQ(graph.backbones.size(), 1U);
  EXPECT_TRUE(graph.backbones[0].closed);
  EXPECT_NEAR(length(s, graph.backbones[0]), 2 * Pi * std::sqrt(1 - z * z), 0.02);
}

TEST(FeatureCurves, CurvesCross)
{
  CutSurface s = shapes::cutSurface(shapes::saddle(7));
  for (const auto& [from, to] : { std::pair(Vec3(-.9, -.91, 0), Vec3(.93, .88, 0)),
         std::pair(Vec3(-.88, .9, 0), Vec3(.9, -.86, 0)) })
  {
    std::vector<Vec3> line;
    for (int i = 0; i <= 10; ++i)
    {
      Vec3 p = from + (to - from) * i / 10.;
      p.z() = p.x() * p.y();
      line.push_back(p);
    }
    ASSERT_TRUE(insertFeatureCurves(s, polyline(line), {}).ok());
  }
  EXPECT_EQ(s.twin, halfedgeTwins(s.triangles));
  const FeatureGraph graph = buildFeatureGraph(s, 60);
  EXPECT_EQ(std::count_if(graph.backbones.begin(), graph.backbones.end(),
              [](const Backbone& b) { return b.type == BackboneType::Sharp; }),
    4)
    << "two lines that cross have four arms";
}

TEST(FeatureCurves, OneThatCannotBeFollowedIsAnError)
{
  TriangleSurface spheres = shapes::sphere(1, 3);
  const TriangleSurface other = shapes::sphere(1, 3);
  const int n = static_cast<int>(spheres.points.size());
  for (const Vec3& p : other.points)
  {
    spheres.points.emplace_back(p + Vec3(5, 0, 0));
  }
  for (const Triangle& t : other.triangles)
  {
    spheres.triangles.push_back({ t[0] + n, t[1] + n, t[2] + n });
  }
  spheres.connect();
  CutSurface s = shapes::cutSurface(spheres);
  const Status status = insertFeatureCurves(s, polyline({ { 0, 0, 1 }, { 5, 0, 1 } }), {});
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message().find("closer"), std::string::npos) << status.message();
  EXPECT_FALSE(insertFeatureCurves(s, polyline({ { 0, 0, std::nan("") }, { 0, 0, 1 } }), {}).ok());
}

TEST(FeatureCurves, CanBeStopped)
{
  CutSurface s = shapes::cutSurface(shapes::sphere(1, 3));
  EXPECT_TRUE(insertFeatureCurves(s, polyline({ { 0, 0, 1 }, { 0, 1, 0 } }), [](double) {
    return false;
  }).isAbort());
}
