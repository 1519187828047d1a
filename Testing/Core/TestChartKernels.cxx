// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What charts are made with, each alone and against closed forms: cells, paths, harmonic functions,
// rectangles, maps, and work that reports.
#include "ChartMesh.h"
#include "ConformalMap.h"
#include "HarmonicSystem.h"
#include "RectangleLayout.h"
#include "Shapes.h"
#include "ShortestPaths.h"
#include "VoronoiDiagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace stipple;

namespace
{
/// The rectangle from the origin to (width, height) on an nx by ny grid.
TriangleSurface rectangle(double width, double height, int nx, int ny)
{
  TriangleSurface s;
  for (int j = 0; j <= ny; ++j)
  {
    for (int i = 0; i <= nx; ++i)
    {
      s.points.emplace_back(width * i / nx, height * j / ny, 0);
    }
  }
  for (int j = 0; j < ny; ++j)
  {
    for (int i = 0; i < nx; ++i)
    {
      const int a = j * (nx + 1) + i;
      const int b = a + nx + 1;
      s.triangles.push_back({ a, a + 1, b + 1 });
      s.triangles.push_back({ a, b + 1, b });
    }
  }
  s.connect();
  return s;
}

std::vector<Face> allFaces(const TriangleSurface& s)
{
  std::vector<Face> faces;
  for (const Face f : s.faces())
  {
    faces.push_back(f);
  }
  return faces;
}

/// Inner points moved about, so that triangles have all kinds of shapes.
void disturb(TriangleSurface& s, const ChartMesh& chart, double amount)
{
  for (int v = 0; v < chart.numberOfVertices(); ++v)
  {
    if (!chart.onBoundary[v])
    {
      Vec3& p = s.points[chart.vertices[v]];
      p += amount * Vec3(std::sin(7. * v), std::cos(11. * v), 0);
    }
  }
}

/// Of a sphere, the triangles above its equator.
TriangleSurface halfSphere()
{
  TriangleSurface half = shapes::sphere(1, 4);
  half.triangles.erase(
    std::remove_if(half.triangles.begin(), half.triangles.end(),
      [&](const Triangle& t) {
        return half.points[t[0]].z() + half.points[t[1]].z() + half.points[t[2]].z() < 0;
      }),
    half.triangles.end());
  half.connect();
  return half;
}

/// The edge path with the given ends, cut.
void cutEdge(CutSurface& s, int p, int q)
{
  for (const Halfedge h : s.halfedges())
  {
    if (s.tail(h) == Vertex(p) && s.head(h) == Vertex(q))
    {
      s.setCut(h, true);
    }
  }
}
}

TEST(ChartMesh, KnowsDisksAnnuliAndSpheres)
{
  const CutSurface sphere = shapes::cutSurface(shapes::sphere(1, 2));
  const ChartMesh closed = extractChart(sphere, allFaces(sphere));
  EXPECT_EQ(closed.euler, 2);
  EXPECT_EQ(closed.boundaryLoops, 0);
  EXPECT_FALSE(closed.isDisk());

  TriangleSurface tube = shapes::cylinder(1, 2, 12, 3);
  tube.triangles.erase(std::remove_if(tube.triangles.begin(), tube.triangles.end(),
                         [](const Triangle& t) {
                           return std::any_of(t.begin(), t.end(), [](int p) { return p >= 48; });
                         }),
    tube.triangles.end());
  tube.connect();
  const CutSurface annulus = shapes::cutSurface(tube);
  const ChartMesh ring = extractChart(annulus, allFaces(annulus));
  EXPECT_EQ(ring.euler, 0);
  EXPECT_EQ(ring.boundaryLoops, 2);

  const CutSurface plane = shapes::cutSurface(rectangle(3, 2, 3, 2));
  const ChartMesh disk = extractChart(plane, allFaces(plane));
  EXPECT_TRUE(disk.isDisk());
  EXPECT_EQ(disk.numberOfVertices(), 12);
  ASSERT_EQ(disk.boundary.size(), 10U);
  double area = 0; // of the polygon that the boundary is: counterclockwise
  for (std::size_t i = 0; i < disk.boundary.size(); ++i)
  {
    const Vec3& a = plane.points[disk.vertices[disk.boundary[i]]];
    const Vec3& b = plane.points[disk.vertices[disk.boundary[(i + 1) % 10]]];
    area += 0.5 * cross2(a.head<2>(), b.head<2>());
  }
  EXPECT_NEAR(area, 6, 1e-12);
}

TEST(ChartMesh, DoublesTheVerticesOfACut)
{
  CutSurface s = shapes::cutSurface(rectangle(4, 4, 4, 4));
  // From the middle of the left side to the centre.
  cutEdge(s, 10, 11);
  cutEdge(s, 11, 12);
  const ChartMesh chart = extractChart(s, allFaces(s));
  EXPECT_TRUE(chart.isDisk());
  EXPECT_EQ(chart.numberOfVertices(), 25 + 2) << "the cut's end stays one vertex";
  EXPECT_EQ(chart.boundary.size(), 16U + 4U);
  for (int p = 0; p < 25; ++p)
  {
    EXPECT_EQ(
      std::count(chart.vertices.begin(), chart.vertices.end(), p), p == 10 || p == 11 ? 2 : 1)
      << p;
  }
  EXPECT_EQ(chartFaces(s).size(), 1U);
  cutEdge(s, 12, 13);
  cutEdge(s, 13, 14);
  const auto halves = chartFaces(s);
  ASSERT_EQ(halves.size(), 2U);
  EXPECT_EQ(halves[0].size(), halves[1].size());
}

TEST(VoronoiDiagram, CellsOfAGridAreNearestToTheirSites)
{
  CutSurface s = shapes::cutSurface(rectangle(20, 10, 40, 20));
  VoronoiDiagram diagram(s);
  const auto faceAt = [&](double x, double y) {
    Face best;
    double nearest = 1e300;
    for (const Face f : s.faces())
    {
      const double d = (s.position(f, Vec3::Constant(1. / 3)) - Vec3(x, y, 0)).norm();
      best = d < nearest ? f : best;
      nearest = std::min(nearest, d);
    }
    return best;
  };
  diagram.addSite(faceAt(5, 5), 0);
  for (const Face f : s.faces())
  {
    EXPECT_EQ(diagram.cell(f), 0);
  }
  const Vec3 far = s.position(diagram.farthest(allFaces(s)), Vec3::Constant(1. / 3));
  EXPECT_GT(far.x(), 19) << "the farthest triangle is at the other end";
  diagram.addSite(faceAt(15, 5), 1);
  int wrong = 0;
  for (const Face f : s.faces())
  {
    const double x = s.position(f, Vec3::Constant(1. / 3)).x();
    wrong += std::abs(x - 10) > 2.5 && diagram.cell(f) != (x > 10);
  }
  EXPECT_EQ(wrong, 0) << "the line halfway parts the cells, as far as paths over centroids tell";
  diagram.forget({ Face(3), Face(4) });
  EXPECT_EQ(diagram.cell(Face(3)), -1);
}

TEST(VoronoiDiagram, DoesNotGrowAcrossCutsAndHasNoSpikes)
{
  CutSurface s = shapes::cutSurface(rectangle(6, 6, 6, 6));
  for (int i = 0; i < 6; ++i)
  {
    cutEdge(s, 21 + i, 22 + i);
  }
  VoronoiDiagram diagram(s);
  diagram.addSite(Face(0), 0);
  int reached = 0;
  for (const Face f : s.faces())
  {
    reached += diagram.cell(f) == 0;
  }
  EXPECT_EQ(reached, s.numberOfFaces() / 2);

  CutSurface whole = shapes::cutSurface(shapes::sphere(1, 3));
  VoronoiDiagram cells(whole);
  cells.addSite(Face(0), 0);
  cells.addSite(cells.farthest(allFaces(whole)), 1);
  cells.removeSpikes(allFaces(whole));
  for (const Face f : whole.faces())
  {
    int other = 0;
    for (const Halfedge h : halfedgesOf(f))
    {
      other += cells.cell(faceOf(whole.twin[h])) != cells.cell(f);
    }
    EXPECT_LT(other, 2) << "triangle " << f.index() << " hangs on its cell by one edge";
  }
}

TEST(ShortestPaths, OfAGridRunAlongItsLines)
{
  const CutSurface s = shapes::cutSurface(rectangle(8, 6, 8, 6));
  const ChartMesh chart = extractChart(s, allFaces(s));
  ShortestPaths paths(s, chart);
  const int corner = static_cast<int>(
    std::find(chart.vertices.begin(), chart.vertices.end(), 0) - chart.vertices.begin());
  paths.addTargets({ corner });
  for (int v = 0; v < chart.numberOfVertices(); ++v)
  {
    // Squares have the diagonal from the lower left: it is a shortcut.
    const Vec3& p = s.points[chart.vertices[v]];
    const double both = std::min(p.x(), p.y());
    EXPECT_NEAR(paths.distance(v), std::sqrt(2.) * both + std::max(p.x(), p.y()) - both, 1e-12);
    const std::vector<int> path = paths.path(v);
    EXPECT_EQ(path.front(), v);
    EXPECT_EQ(path.back(), corner);
    double length = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      length += (s.points[chart.vertices[path[i]]] - s.points[chart.vertices[path[i + 1]]]).norm();
    }
    EXPECT_NEAR(length, paths.distance(v), 1e-12);
  }
  paths.addTargets(chart.boundary);
  const int middle = static_cast<int>(
    std::find(chart.vertices.begin(), chart.vertices.end(), 3 * 9 + 4) - chart.vertices.begin());
  EXPECT_NEAR(paths.distance(middle), 3, 1e-12) << "more targets bring it nearer";
}

TEST(HarmonicSystem, LinearFunctionsAreReproduced)
{
  TriangleSurface shape = rectangle(5, 3, 15, 9);
  CutSurface s = shapes::cutSurface(shape);
  const ChartMesh chart = extractChart(s, allFaces(s));
  disturb(s, chart, 0.08);
  HarmonicSystem system(s, chart, chart.onBoundary);
  ASSERT_TRUE(system.factorize());
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix values = Matrix::Zero(chart.numberOfVertices(), 2);
  Matrix wanted = values;
  for (int v = 0; v < chart.numberOfVertices(); ++v)
  {
    const Vec3& p = s.points[chart.vertices[v]];
    wanted.row(v) << 2 * p.x() - p.y() + 1, p.x() + 3 * p.y();
    if (chart.onBoundary[v])
    {
      values.row(v) = wanted.row(v);
    }
  }
  system.solve(values);
  EXPECT_LT((values - wanted).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(HarmonicSystem, ValuesKeepToTheMaximumPrincipleAndFreeBoundariesAreNatural)
{
  // Given on the left and right sides only: the function is x over the width, whatever the shape of
  // the triangles, as its derivative across the other sides is zero.
  CutSurface s = shapes::cutSurface(rectangle(4, 1, 16, 4));
  const ChartMesh chart = extractChart(s, allFaces(s));
  disturb(s, chart, 0.05);
  std::vector<char> given(chart.vertices.size(), 0);
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix values = Matrix::Zero(chart.numberOfVertices(), 1);
  for (int v = 0; v < chart.numberOfVertices(); ++v)
  {
    const double x = s.points[chart.vertices[v]].x();
    given[v] = x == 0 || x == 4;
    values(v, 0) = x == 4;
  }
  HarmonicSystem system(s, chart, given);
  for (const bool positive : { false, true })
  {
    ASSERT_TRUE(
      system.factorize(positive ? std::vector<char>(given.size(), 1) : std::vector<char>()));
    Matrix solution = values;
    system.solve(solution);
    EXPECT_GE(solution.minCoeff(), 0);
    EXPECT_LE(solution.maxCoeff(), 1);
    for (int v = 0; v < chart.numberOfVertices() && !positive; ++v)
    {
      EXPECT_NEAR(solution(v, 0), s.points[chart.vertices[v]].x() / 4, 1e-11);
    }
  }
}

TEST(HarmonicSystem, UniformValuesAreTheMeansOfTheirNeighbours)
{
  CutSurface s = shapes::cutSurface(rectangle(400, 1, 6, 4)); // slivers
  const ChartMesh chart = extractChart(s, allFaces(s));
  HarmonicSystem system(s, chart, chart.onBoundary);
  ASSERT_TRUE(system.factorizeUniform());
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix values = Matrix::Zero(chart.numberOfVertices(), 1);
  for (std::size_t i = 0; i < chart.boundary.size(); ++i)
  {
    values(chart.boundary[i], 0) = std::cos(3. * static_cast<double>(i));
  }
  system.solve(values);
  std::vector<double> sum(chart.vertices.size(), 0.);
  std::vector<int> count(chart.vertices.size(), 0);
  for (const Triangle& t : chart.triangles) // of inner vertices, each neighbour comes twice
  {
    for (int k = 0; k < 3; ++k)
    {
      sum[t[k]] += values(t[(k + 1) % 3], 0) + values(t[(k + 2) % 3], 0);
      count[t[k]] += 2;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
  {
    if (!chart.onBoundary[v])
    {
      EXPECT_NEAR(values(static_cast<Eigen::Index>(v), 0), sum[v] / count[v], 1e-12);
    }
  }
}

TEST(RectangleLayout, BordersMayHaveFewVertices)
{
  // Three: two corners are at one of them. Less bound nothing in a plane.
  const CutSurface s = shapes::cutSurface(rectangle(1, 1, 1, 1));
  ChartMesh chart = extractChart(s, { Face(0) });
  for (const std::size_t n : { 3, 2, 1 })
  {
    chart.boundary.resize(n);
    const RectangleLayout layout(s, chart);
    for (const RectanglePlacement& placement : layout.placements(false))
    {
      std::vector<Vec2> uv(chart.vertices.size(), Vec2::Constant(-1));
      layout.place(placement, uv);
      double widest = 0;
      for (std::size_t i = 0; i < n; ++i)
      {
        const Vec2& p = uv[chart.boundary[i]];
        EXPECT_TRUE(p.minCoeff() >= 0 && (placement.extent - p).minCoeff() >= 0) << n;
        widest = std::max(widest, (p - uv[chart.boundary[0]]).norm());
      }
      EXPECT_EQ(widest > 0, n == 3);
    }
  }
}

TEST(RectangleLayout, CornersAreThoseOfARectangle)
{
  for (const double length : { 1., 3., 300. })
  {
    const CutSurface s = shapes::cutSurface(rectangle(length, 1, 12, 6));
    const ChartMesh chart = extractChart(s, allFaces(s));
    const RectangleLayout layout(s, chart);
    const auto squares = layout.placements(true);
    EXPECT_TRUE(std::all_of(squares.begin(), squares.end(),
      [](const RectanglePlacement& p) { return p.extent == Vec2(1, 1); }));
    double least = 1e300; // how far the best of the layouts is from the rectangle itself
    for (const RectanglePlacement& placement : layout.placements(false))
    {
      EXPECT_EQ(placement.extent.maxCoeff(), 1);
      std::vector<Vec2> uv(chart.vertices.size(), Vec2::Constant(-1));
      layout.place(placement, uv);
      double off = 0;
      for (int v : chart.boundary)
      {
        const Vec2& p = uv[v];
        const Vec2& e = placement.extent;
        EXPECT_TRUE(p.x() == 0 || p.y() == 0 || p.x() == e.x() || p.y() == e.y());
        EXPECT_TRUE(p.minCoeff() >= 0 && p.x() <= e.x() && p.y() <= e.y());
        const Vec3& x = s.points[chart.vertices[v]];
        // Turned by any quarter of a turn.
        off = std::max(off,
          std::min({ (p.cwiseQuotient(e) - Vec2(x.x() / length, x.y())).norm(),
            (p.cwiseQuotient(e) - Vec2(1 - x.x() / length, 1 - x.y())).norm(),
            (p.cwiseQuotient(e) - Vec2(x.y(), 1 - x.x() / length)).norm(),
            (p.cwiseQuotient(e) - Vec2(1 - x.y(), x.x() / length)).norm() }));
      }
      least = std::min(least, off);
    }
    EXPECT_LT(least, 1e-9) << length;
  }
}

TEST(ConformalMap, OfARectangleIsTheIdentityUpToScale)
{
  CutSurface s = shapes::cutSurface(rectangle(6, 3, 24, 12));
  const ChartMesh chart = extractChart(s, allFaces(s));
  disturb(s, chart, 0.04);
  ConformalMap map = mapToRectangle(s, chart, {});
  EXPECT_TRUE(map.valid);
  EXPECT_FALSE(map.fallback);
  EXPECT_NEAR(map.extent.minCoeff(), 0.5, 1e-9);
  EXPECT_NEAR(map.densityRatio, 1, 1e-6) << "nowhere denser than elsewhere";
  for (const Triangle& t : chart.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vec3 edge = s.points[chart.vertices[t[(k + 1) % 3]]] - s.points[chart.vertices[t[k]]];
      EXPECT_NEAR((map.uv[t[(k + 1) % 3]] - map.uv[t[k]]).norm(), edge.norm() / 6, 1e-9);
    }
  }
  map.uv[chart.triangles[40][0]] += Vec2(2, 0);
  measureMap(s, chart, map);
  EXPECT_FALSE(map.valid) << "a flipped triangle is seen";
  EXPECT_FALSE(mapToRectangle(s, chart, {}, [] { return true; }).valid) << "stopped";
}

TEST(ConformalMap, OfALongChartIsAsLong)
{
  // A flat ellipse bent into a half ring has no corners: short sides lie at its ends.
  for (const double length : { 30., 60., 100. })
  {
    TriangleSurface strip = halfSphere();
    for (Vec3& p : strip.points)
    {
      const double angle = 0.5 * Pi * p.x();
      const double radius = length / Pi - 0.5 * p.y();
      p = Vec3(radius * std::sin(angle), radius * std::cos(angle), 0);
    }
    const CutSurface s = shapes::cutSurface(strip);
    const ChartMesh chart = extractChart(s, allFaces(s));
    const ConformalMap map = mapToRectangle(s, chart, {});
    EXPECT_TRUE(map.valid) << length;
    EXPECT_LT(map.extent.minCoeff(), 2. / length) << "as slender as the chart";
    EXPECT_GT(map.extent.minCoeff(), 0.5 / length);
    EXPECT_LT(map.densityRatio, 100) << length << ", the bound of an atlas";
  }
}

TEST(ConformalMap, ByMeansIsValidForNeedles)
{
  for (const double width : { 1., 1e-3, 1e-6, 1e-9 })
  {
    TriangleSurface half = halfSphere();
    for (Vec3& p : half.points)
    {
      p.x() *= width;
    }
    const CutSurface s = shapes::cutSurface(half);
    const ChartMesh chart = extractChart(s, allFaces(s));
    const ConformalMap map = mapByMeans(s, chart);
    EXPECT_TRUE(map.valid) << width;
    EXPECT_TRUE(map.fallback);
    EXPECT_EQ(map.extent, Vec2(1, 1));
    for (const Vec2& p : map.uv)
    {
      EXPECT_TRUE(p.minCoeff() >= 0 && p.maxCoeff() <= 1);
    }
  }
}

TEST(ConformalMap, IsHarmonicInsideACurvedChart)
{
  const TriangleSurface half = halfSphere();
  const CutSurface s = shapes::cutSurface(half);
  const ChartMesh chart = extractChart(s, allFaces(s));
  ASSERT_TRUE(chart.isDisk());
  const ConformalMap map = mapToRectangle(s, chart, { true });
  ASSERT_TRUE(map.valid);
  EXPECT_EQ(map.extent, Vec2(1, 1));
  EXPECT_GT(map.densityRatio, 1.2) << "a curved chart is denser here than there";
  std::vector<Vec2> laplacian(chart.vertices.size(), Vec2::Zero());
  std::vector<double> size(chart.vertices.size(), 0.);
  for (const Triangle& t : chart.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      const int c = t[(k + 2) % 3];
      const double w = cotangent(
        s.points[chart.vertices[c]], s.points[chart.vertices[a]], s.points[chart.vertices[b]]);
      laplacian[a] += w * (map.uv[b] - map.uv[a]);
      laplacian[b] += w * (map.uv[a] - map.uv[b]);
      size[a] += (map.uv[b] - map.uv[a]).norm();
    }
  }
  for (int v = 0; v < chart.numberOfVertices(); ++v)
  {
    EXPECT_LT(chart.onBoundary[v] ? 0. : laplacian[v].norm(), 1e-9 * size[v]);
  }
}
