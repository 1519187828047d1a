// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The steps of the surface's repair, each alone; and charts handed over as VTK data.
#include "ChartPartition.h"
#include "ChartWriter.h"
#include "DegenerateFaces.h"
#include "Shapes.h"
#include "SoupOrientation.h"
#include "ThinTriangles.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace stipple;

namespace
{
std::vector<int> numbers(std::size_t n)
{
  std::vector<int> result(n);
  std::iota(result.begin(), result.end(), 0);
  return result;
}
}

TEST(SoupOrientation, NeighboursAgreeAndNoPointIsSplitForIt)
{
  TriangleSurface s = shapes::torus(3, 1, 20, 12);
  for (std::size_t f = 0; f < s.triangles.size(); f += 3)
  {
    std::swap(s.triangles[f][0], s.triangles[f][1]);
  }
  std::vector<int> source = numbers(s.points.size());
  orientSoup(s.points, s.triangles, source);
  EXPECT_EQ(source.size(), s.points.size());
  s.connect();
  EXPECT_TRUE(s.topology().manifold);
  EXPECT_EQ(s.topology().boundaryLoops, 0);
  EXPECT_EQ(s.topology().euler, 0);
}

namespace
{
/// Of triangles that share points, oriented.
TriangleSurface oriented(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  TriangleSurface s;
  s.triangles = triangles;
  std::vector<int> source = numbers(points.size());
  orientSoup(points, s.triangles, source);
  for (const int p : source)
  {
    s.points.push_back(points[p]);
  }
  s.connect();
  return s;
}

/// The point at a place; as many as there are if there is none.
int pointAt(const TriangleSurface& s, const Vec3& place)
{
  const auto at = std::find_if(
    s.points.begin(), s.points.end(), [&](const Vec3& p) { return (p - place).norm() < 1e-9; });
  return static_cast<int>(at - s.points.begin());
}

/// One after the other, moved, with one point wherever several are.
void append(TriangleSurface& s, const TriangleSurface& more, const Vec3& shift)
{
  std::vector<int> id;
  for (const Vec3& p : more.points)
  {
    id.push_back(pointAt(s, p + shift));
    if (id.back() == static_cast<int>(s.points.size()))
    {
      s.points.push_back(Vec3(p + shift));
    }
  }
  for (const Triangle& t : more.triangles)
  {
    s.triangles.push_back({ id[t[0]], id[t[1]], id[t[2]] });
  }
}
}

TEST(SoupOrientation, PointsAreSplitWhereSheetsMeet)
{
  // Three triangles around one edge, all along it: each gets its own copy of it, but for the first.
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 },
    { -1, 0, 0 } };
  std::vector<Triangle> book = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } };
  std::vector<int> source = numbers(5);
  orientSoup(points, book, source);
  EXPECT_EQ(source.size(), 9U);
  EXPECT_EQ(std::count(source.begin(), source.end(), 0), 3);
  EXPECT_EQ(std::count(source.begin(), source.end(), 1), 3);
  // Two that meet in a point.
  std::vector<Triangle> tie = { { 0, 1, 2 }, { 2, 3, 4 } };
  source = numbers(5);
  orientSoup(points, tie, source);
  ASSERT_EQ(source.size(), 6U);
  EXPECT_EQ(source[5], 2);
}

TEST(SoupOrientation, BodiesThatMeetInEdgesStayClosed)
{
  const TriangleSurface cube = shapes::cube(3);
  for (const double degrees : { 0., 20., 140. })
  {
    TriangleSurface s = cube; // four around a pillar: all edges between two of them have four
                              // triangles
    append(s, cube, { 1, 1, 0 });
    append(s, cube, { 2, 0, 0 });
    append(s, cube, { 1, -1, 0 });
    const double turn = degrees / 180. * Pi;
    for (Vec3& p : s.points)
    {
      p = Vec3(std::cos(turn) * p[0] - std::sin(turn) * p[2], p[1],
        std::sin(turn) * p[0] + std::cos(turn) * p[2]);
    }
    const TriangleSurface found = oriented(s.points, s.triangles);
    EXPECT_TRUE(found.topology().manifold);
    EXPECT_EQ(found.topology().components, 4);
    EXPECT_EQ(found.topology().euler, 8);
    EXPECT_EQ(found.topology().boundaryLoops, 0);
  }
}

TEST(SoupOrientation, ASheetGoesOnBeneathWhatEndsOnIt)
{
  // Its lower edges are two of a cube's.
  TriangleSurface s = shapes::cube(2);
  const int n = static_cast<int>(s.points.size());
  const int a = pointAt(s, { 0, 0, 1 });
  const int b = pointAt(s, { 0.5, 0, 1 });
  const int c = pointAt(s, { 1, 0, 1 });
  ASSERT_LT(std::max({ a, b, c }), n);
  for (const int p : { a, b, c })
  {
    s.points.push_back(Vec3(s.points[p] + Vec3(0, -0.3, 0.4)));
  }
  for (const bool turned : { false, true })
  {
    TriangleSurface with = s;
    const std::vector<Triangle> sheet = { { a, b, n }, { b, n + 1, n }, { b, c, n + 1 },
      { c, n + 2, n + 1 } };
    for (const Triangle& t : sheet)
    {
      with.triangles.push_back(turned ? Triangle{ t[0], t[2], t[1] } : t);
    }
    const TriangleSurface found = oriented(with.points, with.triangles);
    EXPECT_TRUE(found.topology().manifold);
    EXPECT_EQ(found.topology().components, 2);
    EXPECT_EQ(found.topology().boundaryLoops, 1);
    EXPECT_EQ(found.topology().euler, 3);
  }
}

TEST(SoupOrientation, AnEdgeOfVeryManyTrianglesTakesNoMoreTimeThanTheseDo)
{
  // Tetrahedra around an edge, or every other one of their triangles there.
  const int n = 50000;
  for (const bool closed : { true, false })
  {
    std::vector<Vec3> points = { { 0, 0, 0 }, { 0, 0, 1 } };
    std::vector<Triangle> book;
    for (int i = 0; i < n; ++i)
    {
      const int p = static_cast<int>(points.size());
      for (const double angle : { 6. * i / n, 6. * (i + 0.5) / n })
      {
        points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
      }
      book.push_back({ 1, 0, p });
      book.push_back({ 0, 1, p + 1 });
      if (closed)
      {
        book.push_back({ 0, p + 1, p });
        book.push_back({ 1, p, p + 1 });
      }
    }
    const TriangleSurface found = oriented(points, book);
    EXPECT_TRUE(found.topology().manifold);
    EXPECT_EQ(found.topology().components, closed ? n : 2 * n);
    EXPECT_EQ(found.topology().boundaryLoops, closed ? 0 : 2 * n);
  }
}

TEST(SoupOrientation, TwoEdgesBetweenTheSamePointsArePartedAgain)
{
  // A sphere of two lunes with two edges from a to b, drawn as one: matched as on the sphere, both
  // would be between the same two points.
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0.4 }, { -1, 0, 0.6 },
    { 1, 0, 0.4 }, { 0, -1, 0.6 } };
  const std::vector<Triangle> lunes = { { 0, 1, 2 }, { 0, 2, 3 }, { 2, 1, 3 }, { 1, 0, 3 },
    { 1, 0, 4 }, { 0, 5, 4 }, { 5, 1, 4 }, { 0, 1, 5 } };
  const TriangleSurface found = oriented(points, lunes);
  EXPECT_TRUE(found.topology().manifold);
  EXPECT_EQ(found.topology().components, 2);
  EXPECT_EQ(found.topology().boundaryLoops, 0);
}

TEST(ThinTriangles, AreRemovedAndOthersKept)
{
  TriangleSurface s = shapes::saddle(6);
  const TriangleSurface good = s;
  std::vector<int> cells = numbers(s.triangles.size());
  EXPECT_EQ(removeThinTriangles(s, cells), 0);
  EXPECT_EQ(s.triangles, good.triangles);

  // A point on an edge belongs to one side only, and a cap without height fills the slit.
  const Triangle t = s.triangles[20];
  const int m = static_cast<int>(s.points.size());
  s.points.push_back(Vec3(0.5 * (s.points[t[0]] + s.points[t[1]])));
  s.triangles[20] = { t[0], m, t[2] };
  s.triangles.push_back({ m, t[1], t[2] });
  s.triangles.push_back({ t[0], t[1], m });
  s.connect();
  ASSERT_TRUE(s.topology() == good.topology());
  cells = numbers(s.triangles.size());
  EXPECT_EQ(removeThinTriangles(s, cells), 1);
  EXPECT_EQ(cells.size(), s.triangles.size());
  EXPECT_TRUE(s.topology() == good.topology());
  EXPECT_NEAR(s.area(), good.area(), 0.05 * good.area());
  for (int f = 0; f < s.numberOfFaces(); ++f)
  {
    EXPECT_GT(s.faceArea(f), 1e-4);
  }
}

TEST(DegenerateFaces, GoAndTellWhereWhatIsLeftCameFrom)
{
  TriangleSurface s = shapes::cube(4); // coordinates without rounding
  const double area = s.area();
  const Triangle t = s.triangles[5];
  const int m = static_cast<int>(s.points.size());
  s.points.push_back(Vec3(0.5 * (s.points[t[0]] + s.points[t[1]])));
  s.triangles[5] = { t[0], m, t[2] };
  s.triangles.push_back({ m, t[1], t[2] });
  s.triangles.push_back({ t[0], t[1], m });
  const std::vector<Vec3> before = s.points;
  std::vector<int> points = numbers(s.points.size());
  std::vector<int> cells = numbers(s.triangles.size());
  EXPECT_TRUE(removeDegenerateFaces(s, points, cells));
  s.connect();
  EXPECT_EQ(s.topology().euler, 2);
  EXPECT_TRUE(s.topology().manifold);
  EXPECT_NEAR(s.area(), area, 1e-12);
  ASSERT_EQ(cells.size(), s.triangles.size());
  ASSERT_EQ(points.size(), s.points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    EXPECT_EQ(s.points[p], before[points[p]]);
  }
  for (int f = 0; f < s.numberOfFaces(); ++f)
  {
    EXPECT_GT(s.faceArea(f), 1e-6);
  }
}

namespace
{
/// A sphere of radius two in three charts or more, with its height at every point.
struct Charts
{
  vtkSmartPointer<vtkPolyData> input = shapes::toPolyData(shapes::sphere(2, 3));
  RepairedSurface repaired;
  CutSurface surface;
  std::vector<FlatChart> flat;
  vtkNew<vtkPartitionedDataSetCollection> output;

  Charts()
  {
    vtkNew<vtkDoubleArray> height;
    height->SetName("Height");
    for (vtkIdType p = 0; p < this->input->GetNumberOfPoints(); ++p)
    {
      height->InsertNextValue(this->input->GetPoint(p)[2]);
    }
    this->input->GetPointData()->AddArray(height);
    EXPECT_TRUE(repairSurface(this->input, this->repaired).ok());
    this->surface = CutSurface(this->repaired.surface, this->repaired.sourceCell);
    ChartPartitionOptions options;
    options.numberOfCharts = 3;
    EXPECT_TRUE(partitionSurface(this->surface, options, this->flat, {}).ok());
  }
  Status write(const Progress& progress = {})
  {
    return writeCharts(this->input, this->repaired, this->surface, this->flat,
      computeCurvature(this->repaired.surface), {}, this->output, progress);
  }
};
}

TEST(ChartWriter, HandsOverPlacesParametersAndArrays)
{
  Charts charts;
  ASSERT_TRUE(charts.write().ok());
  ASSERT_EQ(charts.output->GetNumberOfPartitionedDataSets(), charts.flat.size());
  double area = 0;
  for (unsigned int c = 0; c < charts.output->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* chart =
      vtkPolyData::SafeDownCast(charts.output->GetPartitionedDataSet(c)->GetPartition(0));
    ASSERT_NE(chart, nullptr);
    vtkDataArray* height = chart->GetPointData()->GetArray("Height");
    vtkDataArray* gaussian = chart->GetPointData()->GetArray("GaussianCurvature");
    vtkDataArray* id = chart->GetPointData()->GetArray("SurfacePointId");
    vtkDataArray* uv = chart->GetPointData()->GetTCoords();
    ASSERT_TRUE(height && gaussian && id && uv);
    for (vtkIdType p = 0; p < chart->GetNumberOfPoints(); ++p)
    {
      const Vec3 x(chart->GetPoint(p));
      EXPECT_NEAR(height->GetComponent(p, 0), x.z(), 1e-6) << "interpolated on edges";
      EXPECT_NEAR(gaussian->GetComponent(p, 0), 0.25, 0.03);
      EXPECT_LT((charts.surface.points[static_cast<int>(id->GetComponent(p, 0))] - x).norm(), 1e-6);
    }
    vtkDataArray* distortion = chart->GetCellData()->GetArray("AreaDistortion");
    ASSERT_NE(distortion, nullptr);
    for (vtkIdType f = 0; f < chart->GetNumberOfCells(); ++f)
    {
      const Triangle& t = charts.flat[c].mesh.triangles[f];
      const auto at = [&](int k) {
        return Vec2(uv->GetComponent(t[k], 0), uv->GetComponent(t[k], 1));
      };
      area += distortion->GetComponent(f, 0) * 0.5 * orient2(at(0), at(1), at(2));
    }
    EXPECT_EQ(chart->GetFieldData()->GetArray("ChartExtent")->GetRange(-1)[1],
      charts.flat[c].map.extent.norm());
  }
  EXPECT_NEAR(area, charts.surface.area(), 1e-9 * area) << "A3D / A2D times A2D";
  EXPECT_TRUE(charts.write([](double) { return false; }).isAbort());
}

TEST(ChartWriter, ConstraintsLieInTheTrianglesThatTheyName)
{
  const Charts charts;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 40; ++i)
  {
    points->InsertNextPoint(3 * std::cos(i), 3 * std::sin(i), 0.1 * i - 2);
  }
  std::vector<ConstraintPoint> found;
  ASSERT_TRUE(locateConstraints(charts.surface, charts.flat, points, found).ok());
  constrainPoints(charts.surface, charts.flat, { 5, 77 }, found);
  ASSERT_EQ(found.size(), 42U);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const ConstraintPoint& c = found[i];
    const Face face = charts.flat[c.chart].mesh.faces[c.chartCell];
    EXPECT_LT((charts.surface.position(face, c.bary) - c.position).norm(), 1e-6);
    if (i < 40)
    {
      const Vec3 x(points->GetPoint(static_cast<vtkIdType>(i)));
      EXPECT_LT((x.normalized() - c.position.normalized()).norm(), 0.1)
        << "the nearest place of a sphere lies straight below";
    }
  }
  EXPECT_EQ(
    found[40].position + found[41].position, charts.surface.points[5] + charts.surface.points[77]);
  points->SetPoint(3, std::nan(""), 0, 0);
  EXPECT_FALSE(locateConstraints(charts.surface, charts.flat, points, found).ok());

  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  const Vec2 middle = 0.5 * charts.flat[1].map.extent;
  places->InsertNextTuple3(1, middle.x(), middle.y());
  found.clear();
  ASSERT_TRUE(locateChartConstraints(charts.surface, charts.flat, places, found).ok());
  ASSERT_EQ(found.size(), 1U);
  const Triangle& t = charts.flat[1].mesh.triangles[found[0].chartCell];
  const std::vector<Vec2>& uv = charts.flat[1].map.uv;
  const Vec2 there =
    found[0].bary[0] * uv[t[0]] + found[0].bary[1] * uv[t[1]] + found[0].bary[2] * uv[t[2]];
  EXPECT_LT((there - middle).norm(), 1e-12);
}
