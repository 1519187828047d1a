// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What no mesh that is handed out may have.
#include "MeshCheck.h"

#include <gtest/gtest.h>

using namespace stipple;

namespace
{
/// A square of n x n cells, bent up by height(x, y).
template <typename F>
TriangleSurface sheet(int n, const F& height)
{
  TriangleSurface s;
  for (int y = 0; y <= n; ++y)
  {
    for (int x = 0; x <= n; ++x)
    {
      const Vec2 p(static_cast<double>(x) / n, static_cast<double>(y) / n);
      s.points.emplace_back(p.x(), p.y(), height(p));
    }
  }
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      const int a = y * (n + 1) + x;
      s.triangles.push_back({ a, a + 1, a + n + 2 });
      s.triangles.push_back({ a, a + n + 2, a + n + 1 });
    }
  }
  s.connect();
  return s;
}

double flat(const Vec2&)
{
  return 0.;
}

struct MeshCheck : testing::Test
{
  TriangleSurface surface = sheet(40, flat);
  TriangleSurface mesh = sheet(10, flat);

  Status check()
  {
    this->mesh.connect();
    return checkMesh(this->mesh, this->surface, this->surface.topology(), {});
  }
  void expectFault(const char* word)
  {
    const Status status = this->check();
    EXPECT_EQ(status.code(), StatusCode::TooFewPoints);
    EXPECT_NE(status.message().find(word), std::string::npos) << status.message();
  }
};
}

TEST_F(MeshCheck, PassesWhatIsSound)
{
  EXPECT_TRUE(this->check().ok()) << this->check().message();
}

TEST_F(MeshCheck, TakesNothingForNothingOnly)
{
  this->mesh = TriangleSurface();
  EXPECT_FALSE(this->check().ok());
  this->surface = TriangleSurface();
  this->surface.connect();
  EXPECT_TRUE(this->check().ok());
}

TEST_F(MeshCheck, FindsAPointWithoutATriangle)
{
  this->mesh.points.emplace_back(0.5, 0.5, 0.);
  this->expectFault("without a triangle");
}

TEST_F(MeshCheck, FindsATriangleTooMany)
{
  this->mesh.triangles.push_back(this->mesh.triangles.front());
  this->expectFault("not manifold");
}

TEST_F(MeshCheck, FindsATurnedTriangle)
{
  std::swap(this->mesh.triangles[77][0], this->mesh.triangles[77][1]);
  this->expectFault("not manifold");
}

TEST_F(MeshCheck, FindsAHole)
{
  this->mesh.triangles.erase(this->mesh.triangles.begin() + 77);
  this->expectFault("topology");
}

TEST_F(MeshCheck, FindsATriangleWithoutAnArea)
{
  // A corner of the sheet onto the diagonal of its neighbours.
  this->mesh.points[10] = 0.5 * (this->mesh.points[9] + this->mesh.points[21]);
  this->expectFault("without an area");
}

TEST_F(MeshCheck, FindsAPlaceThatNoSampleReached)
{
  // A needle's tip lies 2.2 and 1.8 edges above a mesh that has none of it; the edges of equal
  // triangles are about 0.107 long, and its own are 0.141.
  const auto needle = [](double height) {
    return [height](const Vec2& p) { return (p - Vec2(0.5, 0.5)).norm() < 0.1 ? height : 0.; };
  };
  this->surface = sheet(40, needle(0.34));
  this->expectFault("apart");
  this->surface = sheet(40, needle(0.2));
  EXPECT_TRUE(this->check().ok()) << this->check().message();
}

TEST_F(MeshCheck, FindsATriangleOffTheSurface)
{
  this->mesh.points[60].z() = 1.;
  this->expectFault("apart");
  this->mesh.points[60].z() = 0.3;
  EXPECT_TRUE(this->check().ok()) << "its triangles' centroids are one edge off";
}

TEST_F(MeshCheck, StopsWhenAsked)
{
  EXPECT_TRUE(checkMesh(this->mesh, this->surface, this->surface.topology(), [](double) {
    return false;
  }).isAbort());
}
