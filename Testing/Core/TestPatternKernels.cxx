// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Quads on lattices of the charts' planes, and base meshes split 1 to 4.
#include "MeshCreation.h"
#include "OptimizerMeshes.h"
#include "QuadPattern.h"
#include "SemiRegularSubdivision.h"
#include "VertexStar.h"

#include <set>

using namespace stipple;

namespace
{
/// A flat rectangle as one chart with its sides in its parameters.
std::unique_ptr<meshes::TestMesh> rectangle(const Vec2& extent, int n = 8)
{
  return meshes::openChart(
    [=](int i, int j) { return Vec3(extent.x() * i / n, extent.y() * j / n, 0); }, n, extent);
}

Vec3 positionOf(const Atlas& atlas, const Sample& s)
{
  return atlas.surface().position(s.face, s.bary);
}

std::vector<std::vector<int>> chainsOf(const meshes::TestMesh& t)
{
  return backboneChains(t.atlas->graph(), t.samples);
}

/// V - E + F of polygons, each edge of which is met once from either side at most.
int eulerNumber(const std::vector<std::vector<int>>& polygons)
{
  std::set<std::pair<int, int>> halfedges;
  std::set<std::pair<int, int>> edges;
  std::set<int> vertices;
  for (const auto& p : polygons)
  {
    for (std::size_t k = 0; k < p.size(); ++k)
    {
      const int a = p[k];
      const int b = p[(k + 1) % p.size()];
      EXPECT_TRUE(halfedges.insert({ a, b }).second) << "oriented alike, and manifold";
      edges.insert(std::minmax(a, b));
      vertices.insert(a);
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
    static_cast<int>(polygons.size());
}
}

TEST(QuadPattern, OneOpenChartIsAGrid)
{
  const auto t = rectangle(Vec2(1, 1));
  t->read();
  QuadMesh mesh;
  ASSERT_TRUE(meshWithQuads(*t->atlas, std::vector<Sample>(27), mesh, {}).ok());
  ASSERT_EQ(mesh.samples.size(), 25U) << "squares are worth two points";
  ASSERT_EQ(mesh.polygons.size(), 16U);
  EXPECT_EQ(mesh.polygons[0], (std::vector<int>{ 0, 1, 6, 5 }));
  EXPECT_EQ(eulerNumber(mesh.polygons), 1);
  for (int j = 0; j < 5; ++j)
  {
    for (int i = 0; i < 5; ++i)
    {
      const Sample& s = mesh.samples[5 * j + i];
      const Vec3 p(0.25 * i, 0.25 * j, 0);
      EXPECT_LT((positionOf(*t->atlas, s) - p).norm(), 1e-12);
      const int sides = (i % 4 == 0) + (j % 4 == 0);
      ASSERT_EQ(s.kind,
        sides == 2     ? SampleKind::Corner
          : sides == 1 ? SampleKind::Backbone
                       : SampleKind::Interior);
      if (sides == 2)
      {
        EXPECT_LT((t->atlas->surface().points[s.surfacePoint] - p).norm(), 1e-15);
      }
      else if (sides == 1)
      {
        const SurfacePlace place = t->atlas->placeOfBackbone(s.backbone, s.arcLength);
        EXPECT_LT((t->atlas->surface().position(place.face, place.bary) - p).norm(), 1e-12);
      }
    }
  }
}

TEST(QuadPattern, CellsAreAsSquareAsTheChartAllows)
{
  const auto square = rectangle(Vec2(1, 1));
  square->read();
  QuadMesh all;
  ASSERT_TRUE(meshWithQuads(*square->atlas, std::vector<Sample>(24), all, {}).ok());
  EXPECT_EQ(all.samples.size(), 24U) << "4 by 6, not 4 by 5: few points are left out";
  const auto wide = rectangle(Vec2(1, 0.25));
  wide->read();
  QuadMesh mesh;
  ASSERT_TRUE(meshWithQuads(*wide->atlas, std::vector<Sample>(85), mesh, {}).ok());
  ASSERT_EQ(mesh.samples.size(), 85U) << "17 by 5";
  for (const auto& q : mesh.polygons)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Vec3 side = positionOf(*wide->atlas, mesh.samples[q[(k + 1) % 4]]) -
        positionOf(*wide->atlas, mesh.samples[q[k]]);
      EXPECT_NEAR(side.norm(), 1. / 16, 1e-12);
    }
  }
  const Status status = meshWithQuads(*wide->atlas, std::vector<Sample>(3), mesh, {});
  EXPECT_EQ(status.code(), StatusCode::TooFewPoints);
  EXPECT_EQ(status.leastNumberOfPoints(), 4);
  ASSERT_TRUE(meshWithQuads(*wide->atlas, std::vector<Sample>(4), mesh, {}).ok());
  EXPECT_EQ(mesh.polygons.size(), 1U);
}

TEST(QuadPattern, AGridsCornerOnASmoothOutlineIsTwoTriangles)
{
  // The conformal map z^2 opens a corner of the square to a straight angle.
  const auto t = meshes::openChart(
    [](int i, int j) { return Vec3(i * i - j * j, 2. * i * j, 0); }, 32, Vec2(1, 1));
  t->read();
  QuadMesh mesh;
  ASSERT_TRUE(meshWithQuads(*t->atlas, std::vector<Sample>(81), mesh, {}).ok());
  ASSERT_EQ(mesh.samples.size(), 81U);
  EXPECT_EQ(eulerNumber(mesh.polygons), 1);
  ASSERT_EQ(mesh.polygons.size(), 65U) << "one of 64 cells is cut";
  EXPECT_EQ(mesh.polygons[0], (std::vector<int>{ 0, 1, 10 })) << "through the corner";
  EXPECT_EQ(mesh.polygons[1], (std::vector<int>{ 0, 10, 9 }));
}

TEST(QuadPattern, AShearedGridIsNone)
{
  const auto t =
    meshes::openChart([](int i, int j) { return Vec3(i + 1.5 * j, j, 0); }, 16, Vec2(1, 1));
  t->read();
  const std::vector<Sample> samples =
    synthetic::sample(t->atlas->surface(), t->atlas->graph(), t->atlas->traces(), 300);
  QuadMesh mesh;
  ASSERT_TRUE(meshWithQuads(*t->atlas, samples, mesh, {}).ok());
  EXPECT_EQ(mesh.samples.size(), samples.size()) << "exactly";
  EXPECT_EQ(eulerNumber(mesh.polygons), 1);
  for (const auto& polygon : mesh.polygons)
  {
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
      const Vec3 at = positionOf(*t->atlas, mesh.samples[polygon[k]]);
      const Vec3 next = positionOf(*t->atlas, mesh.samples[polygon[(k + 1) % polygon.size()]]) - at;
      const Vec3 last =
        positionOf(*t->atlas, mesh.samples[polygon[(k + polygon.size() - 1) % polygon.size()]]) -
        at;
      EXPECT_GT(std::atan2(next.cross(last).norm(), next.dot(last)), 25 * Pi / 180);
    }
  }
}

/// So many samples; and whether those inside have another one beside them.
class QuadLattices : public testing::TestWithParam<std::pair<int, bool>>
{
};

TEST_P(QuadLattices, FillChartsWithTheFarthestSamples)
{
  meshes::TestMesh t;
  synthetic::bumpyGrid(t.builder, 2, 12);
  t.read();
  t.samples =
    synthetic::sample(t.atlas->surface(), t.atlas->graph(), t.atlas->traces(), GetParam().first);
  for (std::size_t i = 0, n = t.samples.size(); i < n; ++i)
  {
    if (GetParam().second && t.samples[i].kind == SampleKind::Interior)
    {
      Sample twin = t.samples[i];
      twin.bary = 0.99 * twin.bary + Vec3::Constant(0.01 / 3);
      t.samples.push_back(twin);
    }
  }
  const AtlasSurface& surface = t.atlas->surface();
  const auto constraint = std::find_if(t.samples.begin(), t.samples.end(), [&](const Sample& s) {
    const Vec2 p = surface.parameter(s.face, s.bary);
    return s.kind == SampleKind::Interior && (p - Vec2(0.5, 0.5)).norm() < 0.2;
  });
  ASSERT_NE(constraint, t.samples.end());
  constraint->kind = SampleKind::Constraint;
  LatticeSamples mesh;
  ASSERT_TRUE(placeOnLattices(*t.atlas, t.samples, mesh, {}).ok());
  ASSERT_EQ(mesh.samples.size(), t.samples.size());

  const auto keyOf = [](const Sample& s) {
    return std::make_tuple(s.face, s.bary[0], s.bary[1], s.bary[2]);
  };
  std::set<std::tuple<int, double, double, double>> given;
  std::size_t fixed = 0;
  for (const Sample& s : t.samples)
  {
    given.insert(keyOf(s));
    if (s.kind != SampleKind::Interior)
    {
      EXPECT_EQ(keyOf(mesh.samples[fixed]), keyOf(s)) << "what must stay comes first";
      EXPECT_EQ(mesh.samples[fixed].kind, s.kind);
      ++fixed;
    }
  }
  const auto parameter = [&](const Sample& s) { return surface.parameter(s.face, s.bary); };
  // The cells of a chart are equal squares along its axes, half a side clear of what is fixed.
  std::vector<double> side(4, 0.);
  std::vector<int> quads(4, 0);
  for (const auto& q : mesh.cells)
  {
    if (*std::min_element(q.begin(), q.end()) >= 0)
    {
      const int c = surface.faceChart[mesh.samples[q[0]].face];
      const double a = (parameter(mesh.samples[q[1]]) - parameter(mesh.samples[q[0]])).norm();
      side[c] = quads[c]++ == 0 ? a : side[c];
      for (std::size_t k = 0; k < 4; ++k)
      {
        const Sample& s = mesh.samples[q[k]];
        const Vec2 next = parameter(mesh.samples[q[(k + 1) % 4]]) - parameter(s);
        EXPECT_NEAR(next.norm(), side[c], 1e-9);
        EXPECT_NEAR(next[(k + 1) % 2], 0., 1e-9);
        EXPECT_GE(q[k], static_cast<int>(fixed)) << "nodes, not what is fixed";
        EXPECT_EQ(given.count(keyOf(s)), 0U);
        if (surface.faceChart[constraint->face] == c)
        {
          EXPECT_GT((parameter(s) - parameter(*constraint)).norm(), 0.5 * side[c] - 1e-9);
        }
        EXPECT_GT(std::min({ parameter(s).x(), parameter(s).y(), 1. - parameter(s).x(),
                    1. - parameter(s).y() }),
          0.5 * side[c] - 1e-9);
      }
    }
  }
  for (int c = 0; c < 4; ++c)
  {
    EXPECT_GT(quads[c], 30);
    // Of a chart's samples those that were taken are the farthest from all others, in turn.
    std::vector<Vec2> present;
    double least = 1e300;
    const auto distanceTo = [&present](const Vec2& p) {
      double nearest = 1e300;
      for (const Vec2& q : present)
      {
        nearest = std::min(nearest, (q - p).norm());
      }
      return nearest;
    };
    if (surface.faceChart[constraint->face] == c)
    {
      present.push_back(parameter(*constraint));
    }
    std::set<std::tuple<int, double, double, double>> taken;
    for (std::size_t i = fixed; i < mesh.samples.size(); ++i)
    {
      const Sample& s = mesh.samples[i];
      if (surface.faceChart[s.face] == c)
      {
        if (given.count(keyOf(s)) > 0)
        {
          taken.insert(keyOf(s));
          least = std::min(least, distanceTo(parameter(s)));
        }
        present.push_back(parameter(s));
      }
    }
    for (const Sample& s : t.samples)
    {
      if (s.kind == SampleKind::Interior && surface.faceChart[s.face] == c &&
        taken.count(keyOf(s)) == 0)
      {
        EXPECT_LE(distanceTo(parameter(s)), least + 1e-12);
      }
    }
  }
  EXPECT_TRUE(placeOnLattices(*t.atlas, t.samples, mesh, [](double) { return false; }).isAbort());
}

TEST(QuadPattern, TrianglesBetweenSquaresAreOptimised)
{
  meshes::TestMesh t;
  synthetic::bumpyGrid(t.builder, 2, 12);
  t.read();
  const Atlas& atlas = *t.atlas;
  t.samples = synthetic::sample(atlas.surface(), atlas.graph(), atlas.traces(), 500);
  const auto constraint = std::find_if(t.samples.begin(), t.samples.end(),
    [](const Sample& s) { return s.kind == SampleKind::Interior; });
  constraint->kind = SampleKind::Constraint;
  LatticeSamples placed;
  ASSERT_TRUE(placeOnLattices(atlas, t.samples, placed, {}).ok());
  QuadMesh mesh;
  ASSERT_TRUE(meshWithQuads(atlas, t.samples, mesh, {}).ok());
  ASSERT_EQ(mesh.samples.size(), t.samples.size());
  EXPECT_EQ(eulerNumber(mesh.polygons), 1);
  std::vector<char> isOfQuad(mesh.samples.size(), 0);
  double smallest = Pi;
  for (const auto& polygon : mesh.polygons)
  {
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
      const Vec3 at = positionOf(atlas, mesh.samples[polygon[k]]);
      const Vec3 a = positionOf(atlas, mesh.samples[polygon[(k + 1) % polygon.size()]]) - at;
      const Vec3 b =
        positionOf(atlas, mesh.samples[polygon[(k + polygon.size() - 1) % polygon.size()]]) - at;
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      smallest = std::min(smallest, angle);
      if (polygon.size() == 4)
      {
        EXPECT_NEAR(angle, Pi / 2, Pi / 4 + 1e-9);
        isOfQuad[polygon[k]] = 1;
      }
    }
  }
  EXPECT_GT(smallest, 20 * Pi / 180);
  EXPECT_GT(std::count(isOfQuad.begin(), isOfQuad.end(), 1), 150);
  int moved = 0;
  for (std::size_t i = 0; i < mesh.samples.size(); ++i)
  {
    const SampleKind kind = placed.samples[i].kind;
    const double away =
      (positionOf(atlas, mesh.samples[i]) - positionOf(atlas, placed.samples[i])).norm();
    if (isOfQuad[i] != 0 || kind == SampleKind::Constraint)
    {
      EXPECT_LT(away, 1e-9) << i;
    }
    moved += away > 1e-9 ? 1 : 0;
  }
  EXPECT_GT(moved, 30);
  ASSERT_EQ(mesh.chains.size(), atlas.graph().backbones.size());
  for (std::size_t b = 0; b < mesh.chains.size(); ++b)
  {
    EXPECT_EQ(mesh.chains[b].empty(), atlas.graph().backbones[b].type == BackboneType::Seam) << b;
  }
  EXPECT_TRUE(meshWithQuads(atlas, t.samples, mesh, [](double) { return false; }).isAbort());
}

INSTANTIATE_TEST_SUITE_P(
  Samples, QuadLattices, testing::Values(std::pair(500, false), std::pair(350, true)));

TEST(SemiRegular, TrianglesAreSplitInFourAtTheMiddles)
{
  const auto t = meshes::patch(3);
  SubdividedMesh mesh;
  ASSERT_TRUE(
    subdivideSemiRegularly(*t->atlas, t->samples, t->triangles, chainsOf(*t), 2, 0, mesh, {}).ok());
  // 3 x 3 squares become 12 x 12.
  ASSERT_EQ(mesh.samples.size(), 13U * 13U);
  ASSERT_EQ(mesh.triangles.size(), 2U * 12U * 12U);
  ASSERT_EQ(mesh.level.size(), mesh.samples.size());
  ASSERT_EQ(mesh.parents.size(), mesh.samples.size());
  std::array<int, 3> atLevel = { { 0, 0, 0 } };
  for (std::size_t v = 0; v < mesh.samples.size(); ++v)
  {
    const auto [a, b] = mesh.parents[v];
    ++atLevel[mesh.level[v]];
    const Vec3 p = positionOf(*t->atlas, mesh.samples[v]);
    if (mesh.level[v] == 0)
    {
      EXPECT_EQ(a, -1);
      EXPECT_EQ(b, -1);
      EXPECT_EQ(p, positionOf(*t->atlas, t->samples[v])) << "the base mesh comes first, as it was";
      continue;
    }
    EXPECT_LT(a, b);
    EXPECT_EQ(std::max(mesh.level[a], mesh.level[b]), mesh.level[v] - 1);
    EXPECT_LT(
      (p - 0.5 * (positionOf(*t->atlas, mesh.samples[a]) + positionOf(*t->atlas, mesh.samples[b])))
        .norm(),
      1e-12);
    const double inside = std::min({ p.x(), p.y(), 1. - p.x(), 1. - p.y() });
    EXPECT_EQ(mesh.samples[v].kind, inside < 1e-12 ? SampleKind::Backbone : SampleKind::Interior);
  }
  EXPECT_EQ(atLevel, (std::array<int, 3>{ { 16, 33, 120 } })) << "a vertex an edge, each time";
  std::vector<double> area(t->triangles.size(), 0.);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    const auto& [a, b, c] = mesh.triangles[f];
    const Vec3 p = positionOf(*t->atlas, mesh.samples[a]);
    const Vec3 twice = (positionOf(*t->atlas, mesh.samples[b]) - p)
                         .cross(positionOf(*t->atlas, mesh.samples[c]) - p);
    EXPECT_NEAR(twice.z(), 1. / 144, 1e-12) << "oriented like its parent";
    ASSERT_LT(mesh.baseTriangle[f], static_cast<int>(area.size()));
    area[mesh.baseTriangle[f]] += 0.5 * twice.z();
  }
  for (const double a : area)
  {
    EXPECT_NEAR(a, 1. / 18, 1e-12) << "children fill their base triangle";
  }
}

TEST(SemiRegular, NoLevelsAreTheBaseMesh)
{
  const auto t = meshes::patch(2);
  SubdividedMesh mesh;
  ASSERT_TRUE(
    subdivideSemiRegularly(*t->atlas, t->samples, t->triangles, chainsOf(*t), 0, 5, mesh, {}).ok());
  EXPECT_EQ(mesh.triangles, t->triangles);
  EXPECT_EQ(mesh.samples.size(), t->samples.size());
  EXPECT_EQ(mesh.baseTriangle[5], 5);
}

TEST(SemiRegular, MiddlesOnAClosedCreaseAreMeasuredAlongIt)
{
  // A flat square with a closed crease inside; corners of which are nothing special.
  const auto t = rectangle(Vec2(1, 1), 16);
  std::vector<Vec3> loop;
  for (const auto& [i0, j0, i1, j1] :
    { std::array<int, 4>{ 4, 4, 12, 4 }, { 12, 4, 12, 12 }, { 12, 12, 4, 12 }, { 4, 12, 4, 4 } })
  {
    const auto side =
      synthetic::run([](int i, int j) { return Vec3(i / 16., j / 16., 0); }, i0, j0, i1, j1);
    loop.insert(loop.end(), side.begin(), side.end() - 1);
  }
  t->builder.addBackbone(BackboneType::Sharp, loop, true);
  t->read();
  t->samples = synthetic::sample(t->atlas->surface(), t->atlas->graph(), t->atlas->traces(), 150);
  ASSERT_TRUE(createMesh(*t->atlas, t->samples, t->triangles, {}).ok());
  SubdividedMesh mesh;
  ASSERT_TRUE(
    subdivideSemiRegularly(*t->atlas, t->samples, t->triangles, chainsOf(*t), 1, 0, mesh, {}).ok());
  const double length = t->atlas->traces()[4].length();
  EXPECT_NEAR(length, 2., 1e-12);
  int middles = 0;
  int before = 0;
  for (std::size_t v = 0; v < mesh.samples.size(); ++v)
  {
    const Sample& s = mesh.samples[v];
    if (s.backbone != 4)
    {
      continue;
    }
    before += mesh.level[v] == 0;
    if (mesh.level[v] == 1)
    {
      ++middles;
      EXPECT_GE(s.arcLength, 0.);
      EXPECT_LT(s.arcLength, length);
      const auto along = [&](int parent) {
        const double d = std::abs(mesh.samples[parent].arcLength - s.arcLength);
        return std::min(d, length - d);
      };
      EXPECT_NEAR(along(mesh.parents[v][0]), along(mesh.parents[v][1]), 1e-12);
      EXPECT_LT(along(mesh.parents[v][0]), 0.1) << "not on the far side of the loop";
      const Vec3 p = positionOf(*t->atlas, s) - Vec3(0.5, 0.5, 0);
      EXPECT_NEAR(p.lpNorm<Eigen::Infinity>(), 0.25, 1e-12) << "on it";
    }
  }
  EXPECT_GT(before, 10);
  EXPECT_EQ(middles, before) << "a closed curve has as many edges as vertices";
}

TEST(SemiRegular, LevelsAreRelaxedOnTheSurface)
{
  const auto t = meshes::cube(60, true);
  const auto subdivide = [&](int rounds, SubdividedMesh& mesh) {
    return subdivideSemiRegularly(
      *t->atlas, t->samples, t->triangles, chainsOf(*t), 2, rounds, mesh, {});
  };
  SubdividedMesh still;
  SubdividedMesh relaxed;
  ASSERT_TRUE(subdivide(0, still).ok());
  ASSERT_TRUE(subdivide(10, relaxed).ok());
  EXPECT_EQ(still.triangles.size(), 16U * t->triangles.size());
  const auto rotated = [](std::vector<Triangle> triangles) {
    for (Triangle& x : triangles)
    {
      std::rotate(x.begin(), std::min_element(x.begin(), x.end()), x.end());
    }
    return triangles;
  };
  EXPECT_EQ(rotated(relaxed.triangles), rotated(still.triangles)) << "no edge is swapped";
  const auto smallestAngle = [&](const SubdividedMesh& mesh) {
    OptimizedMesh read;
    EXPECT_TRUE(read.build(*t->atlas, t->density, mesh.samples, mesh.triangles).ok());
    double smallest = 10;
    for (const Face f : read.faces())
    {
      smallest = std::min(smallest, faceQuality(read, f));
    }
    return smallest;
  };
  EXPECT_GT(smallestAngle(relaxed), smallestAngle(still) + 0.08);
  int asked = 0;
  SubdividedMesh stopped;
  EXPECT_TRUE(subdivideSemiRegularly(
    *t->atlas, t->samples, t->triangles, chainsOf(*t), 3, 0, stopped, [&](double) {
      return ++asked < 2;
    }).isAbort());
  EXPECT_EQ(stopped.triangles.size(), 4U * t->triangles.size()) << "after one level";
  asked = 0;
  double told = 0;
  EXPECT_TRUE(subdivideSemiRegularly(
    *t->atlas, t->samples, t->triangles, chainsOf(*t), 3, 10, stopped, [&](double done) {
      EXPECT_GE(done, told);
      told = done;
      return ++asked < 6;
    }).isAbort());
  EXPECT_EQ(asked, 6);
  EXPECT_EQ(stopped.triangles.size(), 4U * t->triangles.size()) << "amid the rounds of a level";
}

TEST(SemiRegular, WhereAFeatureLeavesItsBackboneMiddlesDoNotGoBackToIt)
{
  // Along one side of a patch of 3 x 3 squares, whose samples are not on the backbone any more.
  const auto t = meshes::patch(3);
  const auto chains = chainsOf(*t);
  const auto isInside = [&](int v) { return t->samples[v].kind == SampleKind::Backbone; };
  std::set<int> moved;
  for (const int v : chains[0])
  {
    if (isInside(v))
    {
      Sample& s = t->samples[v];
      const SurfacePlace place = t->atlas->walk().walk(
        { s.face, s.bary }, 0.1 * (Vec3(0.5, 0.5, 0) - positionOf(*t->atlas, s)));
      s = { SampleKind::Interior, place.face, place.bary, -1, 0., -1 };
      moved.insert(v);
    }
  }
  ASSERT_EQ(moved.size(), 2U);
  SubdividedMesh mesh;
  ASSERT_TRUE(
    subdivideSemiRegularly(*t->atlas, t->samples, t->triangles, chains, 2, 0, mesh, {}).ok());
  ASSERT_EQ(mesh.chains[0].size(), 4 * (chains[0].size() - 1) + 1);
  double before = -1;
  int off = 0;
  for (const BackboneVertex& v : mesh.chains[0])
  {
    EXPECT_GT(v.arcLength, before) << "in order";
    before = v.arcLength;
    const auto [a, b] = mesh.parents[v.vertex.index()];
    if (a < 0)
    {
      continue;
    }
    const Sample& s = mesh.samples[v.vertex.index()];
    const Vec3 middle =
      0.5 * (positionOf(*t->atlas, mesh.samples[a]) + positionOf(*t->atlas, mesh.samples[b]));
    EXPECT_LT((positionOf(*t->atlas, s) - middle).norm(), 1e-12);
    EXPECT_EQ(s.kind, SampleKind::Interior) << "every piece has an end that is off";
    ++off;
  }
  EXPECT_EQ(off, 9);
  // Relaxed, what was simplified stays, and what is new is free to go.
  SubdividedMesh relaxed;
  ASSERT_TRUE(
    subdivideSemiRegularly(*t->atlas, t->samples, t->triangles, chains, 2, 10, relaxed, {}).ok());
  for (const int v : moved)
  {
    EXPECT_LT(
      (positionOf(*t->atlas, relaxed.samples[v]) - positionOf(*t->atlas, t->samples[v])).norm(),
      1e-12);
  }
  EXPECT_EQ(idsOf(relaxed.chains), idsOf(mesh.chains));
}
