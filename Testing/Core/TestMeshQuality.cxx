// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshQuality.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace stipple;

namespace
{
TriangleSurface makeSurface(std::vector<Vec3> points, std::vector<Triangle> triangles)
{
  TriangleSurface s;
  s.points = std::move(points);
  s.triangles = std::move(triangles);
  return s;
}

const std::vector<Vec3> TetrahedronPoints = { { 1, 1, 1 }, { -1, -1, 1 }, { -1, 1, -1 },
  { 1, -1, -1 } };
const std::vector<Triangle> TetrahedronTriangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 },
  { 1, 2, 3 } };
}

TEST(MeshQuality, RegularTetrahedron)
{
  const MeshQuality q = measureQuality(makeSurface(TetrahedronPoints, TetrahedronTriangles));
  EXPECT_EQ(q.numberOfPoints, 4);
  EXPECT_EQ(q.numberOfTriangles, 4);
  EXPECT_EQ(q.components, 1);
  EXPECT_EQ(q.boundaryLoops, 0);
  EXPECT_EQ(q.boundaryEdges, 0);
  EXPECT_EQ(q.euler, 2);
  EXPECT_EQ(q.genus, 0.);
  EXPECT_EQ(q.nonManifoldEdges + q.nonManifoldVertices + q.misorientedEdges + q.degenerate, 0);
  EXPECT_NEAR(q.minimumQ, 1., 1e-12);
  EXPECT_NEAR(q.averageQ, 1., 1e-12);
  EXPECT_NEAR(q.minimumAngle, 60., 1e-9);
  EXPECT_NEAR(q.maximumAngle, 60., 1e-9);
  EXPECT_NEAR(q.area, 8. * std::sqrt(3.), 1e-12);
  EXPECT_NEAR(q.areaVariation, 0., 1e-6);
  EXPECT_NEAR(q.edgeVariation, 0., 1e-6);
}

TEST(MeshQuality, GridHasRightTrianglesAndOneBoundary)
{
  const MeshQuality q = measureQuality(shapes::grid(10));
  EXPECT_EQ(q.boundaryEdges, 40);
  EXPECT_EQ(q.boundaryLoops, 1);
  EXPECT_EQ(q.euler, 1);
  EXPECT_EQ(q.genus, 0.);
  EXPECT_NEAR(q.minimumAngle, 45., 1e-9);
  EXPECT_NEAR(q.averageMinimumAngle, 45., 1e-9);
  EXPECT_NEAR(q.maximumAngle, 90., 1e-9);
  EXPECT_EQ(q.percentBelow30, 0.);
  EXPECT_EQ(q.percentValence6, 100.);
  EXPECT_EQ(q.percentValence567, 100.);
  EXPECT_NEAR(q.area, 1., 1e-12);
}

TEST(MeshQuality, CountsWhatIsWrong)
{
  // Two tetrahedra that share one point, and a point that nothing uses.
  auto points = TetrahedronPoints;
  auto triangles = TetrahedronTriangles;
  points.insert(points.end(), { { 5, 1, 1 }, { 5, 2, 1 }, { 5, 1, 2 }, { 9, 9, 9 } });
  triangles.insert(triangles.end(), { { 0, 4, 5 }, { 0, 5, 6 }, { 0, 6, 4 }, { 4, 6, 5 } });
  MeshQuality q = measureQuality(makeSurface(points, triangles));
  EXPECT_EQ(q.isolatedPoints, 1);
  EXPECT_EQ(q.nonManifoldVertices, 1);
  EXPECT_EQ(q.nonManifoldEdges, 0);
  EXPECT_EQ(q.misorientedEdges, 0);
  EXPECT_EQ(q.components, 1);
  EXPECT_EQ(q.euler, 3);

  // A fin of three triangles; the third runs along edge (0, 1) like the first.
  q =
    measureQuality(makeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } },
      { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }));
  EXPECT_EQ(q.nonManifoldEdges, 1);
  EXPECT_EQ(q.misorientedEdges, 1);
  EXPECT_EQ(q.nonManifoldVertices, 0);

  // A sliver without area: its three points lie on a line.
  q = measureQuality(makeSurface(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 1, 3 } }));
  EXPECT_EQ(q.degenerate, 1);
  EXPECT_NEAR(q.minimumQ, 0., 1e-12);
  EXPECT_EQ(q.percentBelow30, 50.);
}

TEST(MeshQuality, EmptyMesh)
{
  const MeshQuality q = measureQuality({});
  EXPECT_EQ(q.numberOfPoints, 0);
  EXPECT_EQ(q.components, 0);
  EXPECT_EQ(measureDistance({}, shapes::grid(2)).hausdorffPercent, 0.);
}

TEST(MeshDistance, ParallelGrids)
{
  // Two unit squares 0.1 apart: the diagonal of the reference is sqrt 2.
  const MeshDistance d = measureDistance(shapes::grid(7, 0.1), shapes::grid(10), 2000);
  EXPECT_NEAR(d.hausdorffPercent, 10. / std::sqrt(2.), 1e-9);
  EXPECT_NEAR(d.rmsPercent, 10. / std::sqrt(2.), 1e-9);
  EXPECT_NEAR(d.areaRatio, 1., 1e-12);
  EXPECT_TRUE(d.sameTopology);
}

TEST(MeshDistance, IsTheSamePercentageOfTinySurfaces)
{
  const auto scaled = [](TriangleSurface surface, int power) {
    for (Vec3& p : surface.points)
    {
      p *= std::ldexp(1., power);
    }
    return surface;
  };
  const MeshDistance d = measureDistance(shapes::grid(7, 0.1), shapes::grid(10), 2000);
  for (const int power : { -40, -30, -11, 30 })
  {
    const MeshDistance other =
      measureDistance(scaled(shapes::grid(7, 0.1), power), scaled(shapes::grid(10), power), 2000);
    EXPECT_NEAR(other.hausdorffPercent, d.hausdorffPercent, 1e-9 * d.hausdorffPercent);
    EXPECT_NEAR(other.rmsPercent, d.rmsPercent, 1e-9 * d.rmsPercent);
    EXPECT_NEAR(other.ofPoint[3], std::ldexp(d.ofPoint[3], power), 1e-9 * other.ofPoint[3]);
  }
}

TEST(MeshDistance, SeesWhatIsMissingOnEitherSide)
{
  TriangleSurface half = shapes::grid(10);
  half.triangles.resize(100); // the rows below y = 0.5
  const MeshDistance d = measureDistance(half, shapes::grid(10), 2000);
  EXPECT_NEAR(d.hausdorffPercent, 50. / std::sqrt(2.), 1e-9);
  EXPECT_NEAR(
    measureDistance(shapes::grid(10), half, 2000).hausdorffPercent, 50. / std::sqrt(1.25), 1e-9);
  EXPECT_NEAR(d.areaRatio, 0.5, 1e-12);
  EXPECT_TRUE(d.sameTopology);
  half.triangles.erase(half.triangles.begin() + 33);
  EXPECT_FALSE(measureDistance(half, shapes::grid(10), 2000).sameTopology);
}
