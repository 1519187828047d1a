// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a mesh's edges are too long: a flat fan whose middle goes towards its rim.
#include "CoarsePlaces.h"
#include "OptimizerMeshes.h"
#include "PolyDataConversion.h"
#include "Shapes.h"
#include "Tuning.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace stipple;

namespace
{
constexpr int Rim = 6;

/// A regular hexagon about a vertex, the last one, at this place.
TriangleSurface fan(const Vec3& middle)
{
  TriangleSurface mesh;
  for (int i = 0; i < Rim; ++i)
  {
    mesh.points.emplace_back(std::cos(i * Pi / 3), std::sin(i * Pi / 3), 0);
    mesh.triangles.push_back({ i, (i + 1) % Rim, Rim });
  }
  mesh.points.push_back(middle);
  mesh.connect();
  return mesh;
}

const std::vector<char> Inside = { 0, 0, 0, 0, 0, 0, 1 };
const std::vector<char> Nothing(Rim + 1, 0);
}

TEST(CoarsePlaces, AreTrianglesWithSmallAngles)
{
  const TriangleSurface good = fan(Vec3::Zero());
  EXPECT_TRUE(coarsePlaces(good, Inside, shapes::intersectionsOf(good)).empty());
  // The triangle on the first edge gets an angle of 13 degrees.
  const Vec3 rim = 0.5 * (good.points[0] + good.points[1]);
  const Vec3 middle = rim - 0.5 * std::tan(13. * Pi / 180) * rim.normalized();
  const TriangleSurface flat = fan(middle);
  const std::vector<CoarsePlace> places = coarsePlaces(flat, Inside, shapes::intersectionsOf(good));
  ASSERT_EQ(places.size(), 1U);
  EXPECT_LT((places[0].position - (good.points[0] + good.points[1] + middle) / 3.).norm(), 1e-12);
  EXPECT_NEAR(places[0].edgeLength, (1. + 1. / std::cos(13. * Pi / 180)) / 3., 1e-12);
  EXPECT_TRUE(coarsePlaces(flat, Nothing, shapes::intersectionsOf(good)).empty())
    << "all corners on features";
  const Vec3 better = rim - 0.5 * std::tan(16. * Pi / 180) * rim.normalized();
  EXPECT_TRUE(coarsePlaces(fan(better), Inside, shapes::intersectionsOf(good)).empty());
}

TEST(CoarsePlaces, AreWhereTheMeshPassesThroughItself)
{
  // A second fan, whose middle comes through the first one.
  const auto both = [](double height) {
    TriangleSurface mesh = fan(Vec3::Zero());
    const TriangleSurface other = fan(Vec3(0, 0, height));
    for (const Vec3& p : other.points)
    {
      mesh.points.push_back(p + Vec3(0.1, 0.05, 0.3));
    }
    for (Triangle t : other.triangles)
    {
      for (int& p : t)
      {
        p += Rim + 1;
      }
      mesh.triangles.push_back(t);
    }
    mesh.connect();
    return mesh;
  };
  const TriangleSurface apart = both(0.);
  const TriangleSurface through = both(-0.35);
  const std::vector<char> none(apart.points.size(), 0);
  EXPECT_TRUE(coarsePlaces(apart, none, shapes::intersectionsOf(apart)).empty());
  const std::vector<CoarsePlace> places =
    coarsePlaces(through, none, shapes::intersectionsOf(apart));
  EXPECT_FALSE(places.empty());
  for (const CoarsePlace& place : places)
  {
    EXPECT_NEAR(place.edgeLength, 1., 0.15);
    EXPECT_LT(place.position.norm(), 1.);
  }
  EXPECT_TRUE(coarsePlaces(through, none, shapes::intersectionsOf(through)).empty())
    << "the surface does so, too";
}

TEST(CoarsePlaces, AreRowsOfSizes)
{
  const auto t = meshes::patch(4);
  const TriangleSurface mesh = fan(Vec3::Zero());
  const vtkSmartPointer<vtkPolyData> data = toPolyData(mesh.points, mesh.triangles);
  vtkNew<vtkDoubleArray> rows;
  rows->SetNumberOfComponents(4);
  CoarsePlaceCount count;
  ASSERT_TRUE(addSizePlaces(data, *t->atlas, 0.5, {}, rows, nullptr, count).ok());
  EXPECT_EQ(count.overlaps, 0);
  EXPECT_EQ(count.poor, 0);
  TriangleSurface two = mesh; // a triangle through the middle of one
  for (const Vec3& p : { Vec3(0.5, 0.2, -1), Vec3(0.5, 0.2, 1), Vec3(0.5, 0.4, 1) })
  {
    two.points.push_back(p);
  }
  two.triangles.push_back({ Rim + 1, Rim + 2, Rim + 3 });
  two.connect();
  const vtkSmartPointer<vtkPolyData> through = toPolyData(two.points, two.triangles);
  ASSERT_TRUE(addSizePlaces(through, *t->atlas, 0.5, {}, rows, nullptr, count).ok());
  EXPECT_GE(count.overlaps, 1);
  EXPECT_EQ(count.poor, 0) << "no vertex is said to be free";
  EXPECT_EQ(count.triangles, count.overlaps + 1) << "and the one that passes through them";
  ASSERT_EQ(rows->GetNumberOfTuples(), count.overlaps);
  const std::vector<CoarsePlace> places =
    coarsePlaces(two, std::vector<char>(two.points.size(), 0), [] { return std::vector<Box>(); });
  ASSERT_EQ(places.size(), static_cast<std::size_t>(count.overlaps));
  EXPECT_DOUBLE_EQ(rows->GetComponent(0, 3), 0.5 * places[0].edgeLength);
  const vtkIdType before = rows->GetNumberOfTuples();
  ASSERT_TRUE(addSizePlaces(through, *t->atlas, 0.5, {}, nullptr, rows, count).ok());
  EXPECT_GE(count.overlaps, 1) << "they are counted";
  EXPECT_EQ(rows->GetNumberOfTuples(), before) << "but are not what is asked for";
  EXPECT_FALSE(addSizePlaces(
    data, *t->atlas, 0.5, [](double) { return false; }, rows, nullptr, count)
                 .ok());
}

TEST(CoarsePlaces, CountWhatIsWrongFirst)
{
  EXPECT_TRUE((CoarsePlaceCount{ 0, 9 }) < (CoarsePlaceCount{ 1, 0 }));
  EXPECT_TRUE((CoarsePlaceCount{ 1, 0 }) < (CoarsePlaceCount{ 1, 1 }));
  EXPECT_FALSE((CoarsePlaceCount{ 1, 1 }) < (CoarsePlaceCount{ 1, 1 }));
}

TEST(CoarsePlaces, DistancesCountIfTheyShow)
{
  const auto t = meshes::patch(4);
  const double visible = Tuning::VisibleDistance;
  for (const double share : { 0.5, 0.9, 1.2, 3. })
  {
    TriangleSurface mesh;
    for (const Vertex v : t->mesh.vertices())
    {
      mesh.points.push_back(t->mesh.position(v) + Vec3(0, 0, share * visible * std::sqrt(2.)));
    }
    mesh.triangles = t->mesh.triangles();
    mesh.connect();
    double distance = -1;
    ASSERT_TRUE(
      visibleDistance(toPolyData(mesh.points, mesh.triangles), *t->atlas, {}, distance).ok());
    EXPECT_NEAR(
      distance, share < 1. ? 0. : share * visible, 0.01 * visible * share + 0.1 * visible);
  }
}
