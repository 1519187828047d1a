// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Small meshes on surfaces of known shape, for the kernels of the optimisation.
#ifndef stipple_OptimizerMeshes_h
#define stipple_OptimizerMeshes_h

#include "../Cxx/SyntheticAtlas.h"
#include "MeshCreation.h"
#include "MeshEdit.h"
#include "VertexStar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace meshes
{
using namespace stipple;

inline int eulerOf(const OptimizedMesh& mesh)
{
  return mesh.vertices().size() - mesh.edges().size() + mesh.faces().size();
}

struct TestMesh
{
  synthetic::Builder builder;
  stipple::Atlas::Pointer atlas;
  DensityField density;
  std::vector<Sample> samples;
  std::vector<Triangle> triangles;
  OptimizedMesh mesh;
  MeshEdit edit{ mesh };

  void read()
  {
    synthetic::MadeAtlas& made = this->builder.finish();
    const Status status = stipple::Atlas::read(made.charts, made.graphData, this->atlas);
    EXPECT_TRUE(this->builder.ok() && status.ok()) << status.message();
  }
  void build()
  {
    const Status status =
      this->mesh.build(*this->atlas, this->density, this->samples, this->triangles);
    EXPECT_TRUE(status.ok()) << status.message();
  }
  /// The place of the surface above (x, y) in the chart's parameters; one chart.
  SurfacePlace placeAt(double x, double y) const
  {
    const AtlasSurface& s = this->atlas->surface();
    for (int f = 0; f < s.numberOfFaces(); ++f)
    {
      const Vec3 b = barycentric(Vec2(x, y), s.cornerUV(f, 0), s.cornerUV(f, 1), s.cornerUV(f, 2));
      if (b.minCoeff() > -1e-12)
      {
        return { f, clampedBarycentric(b) };
      }
    }
    ADD_FAILURE() << "no face at " << x << " " << y;
    return {};
  }
  SurfacePoint pointAt(double x, double y) const { return this->mesh.pointAt(this->placeAt(x, y)); }
  Edge edgeBetween(int a, int b) const
  {
    Edge result;
    this->mesh.forEachHalfedge(Vertex(a),
      [&](Halfedge h) { result = this->mesh.to(h) == Vertex(b) ? this->mesh.edge(h) : result; });
    EXPECT_TRUE(result.valid()) << "no edge between " << a << " and " << b;
    return result;
  }
};

/// n x n squares with a place each, at(i, j), as one more chart that only its outline bounds.
template <typename At>
void addOpenChart(synthetic::Builder& builder, const At& at, int n, const Vec2& extent)
{
  builder.addGrid(n, n, at, extent);
  const std::array<std::array<int, 2>, 5> corner = { { { { 0, 0 } }, { { n, 0 } }, { { n, n } },
    { { 0, n } }, { { 0, 0 } } } };
  for (int k = 0; k < 4; ++k)
  {
    builder.addBackbone(BackboneType::Boundary,
      synthetic::run(at, corner[k][0], corner[k][1], corner[k + 1][0], corner[k + 1][1]));
  }
}

/// The same as the only chart; not yet read.
template <typename At>
std::unique_ptr<TestMesh> openChart(const At& at, int n, const Vec2& extent)
{
  auto t = std::make_unique<TestMesh>();
  addOpenChart(t->builder, at, n, extent);
  return t;
}

/// m x m squares, each cut in two along its diagonal from low (u, v), on the surface position(u, v)
/// over the unit square, which has n x n squares, 4 m x 4 m unless told. Vertex (i, j) is
/// j (m + 1) + i; the sides are backbones, counterclockwise from v = 0.
inline std::unique_ptr<TestMesh> patchOf(
  int m, const std::function<Vec3(double, double)>& position, int n = 0)
{
  n = n > 0 ? n : 4 * m;
  const auto at = [=](int i, int j) {
    return position(static_cast<double>(i) / n, static_cast<double>(j) / n);
  };
  auto t = openChart(at, n, Vec2(1, 1));
  t->read();
  for (int j = 0; j <= m; ++j)
  {
    for (int i = 0; i <= m; ++i)
    {
      Sample s;
      const SurfacePlace place = t->placeAt(static_cast<double>(i) / m, static_cast<double>(j) / m);
      s.face = place.face;
      s.bary = place.bary;
      const bool endX = i == 0 || i == m;
      const bool endY = j == 0 || j == m;
      if (endX && endY)
      {
        s.kind = SampleKind::Corner;
        int k = 0;
        place.bary.maxCoeff(&k);
        s.surfacePoint = t->atlas->surface().triangles[place.face][k];
      }
      else if (endX || endY)
      {
        s.kind = SampleKind::Backbone;
        s.backbone = j == 0 ? 0 : i == m ? 1 : j == m ? 2 : 3;
        const int along = s.backbone == 0 ? i
          : s.backbone == 1               ? j
          : s.backbone == 2               ? m - i
                                          : m - j;
        const std::vector<double>& arc = t->atlas->traces()[s.backbone].arcLength;
        const int segment = along * n / m;
        s.arcLength = arc[segment] +
          (along * n % m) * (arc[segment + 1] - arc[segment]) / static_cast<double>(m);
      }
      t->samples.push_back(s);
      if (i > 0 && j > 0)
      {
        const int v = j * (m + 1) + i;
        t->triangles.push_back({ v - m - 2, v - m - 1, v });
        t->triangles.push_back({ v - m - 2, v, v - 1 });
      }
    }
  }
  t->build();
  return t;
}

/// The same over the flat unit square, or at a height above it.
inline std::unique_ptr<TestMesh> patch(
  int m, const std::function<double(double, double)>& height = [](double, double) { return 0.; })
{
  return patchOf(m, [=](double x, double y) { return Vec3(x, y, height(x, y)); });
}

constexpr int FoldedRow = 9; ///< vertices in a row of foldedPatch()

/// 8 x 8 squares, folded in the middle, so that vertex (i, j) is over (i, 8 - j), and the two
/// sheets, as wide as 4 squares, hang together at (i, 4). The upper one is 0.1 over the other, but
/// at (3, 5) 0.02; the lower one is 0.07 high at (4, 3). In the squares between these vertices and
/// the fold there is room for the other diagonal in each sheet, but not in both. Vertices near
/// these two are free, or constraints.
inline std::unique_ptr<TestMesh> foldedPatch(bool isHeld)
{
  auto t = patchOf(8, [](double u, double v) {
    const auto tent = [&](int i, int j) {
      return std::max(0., 1. - 8. * std::max(std::abs(u - i / 8.), std::abs(v - j / 8.)));
    };
    return v > 0.5 ? Vec3(u, 1. - v, 0.1 * std::min(1., 8. * (v - 0.5)) - 0.08 * tent(3, 5))
                   : Vec3(u, v, 0.07 * tent(4, 3));
  });
  for (int j = 2; isHeld && j <= 6; ++j)
  {
    for (int i = 2; i <= 5; ++i)
    {
      t->samples[FoldedRow * j + i].kind = SampleKind::Constraint;
    }
  }
  t->build();
  return t;
}

/// n points on the unit sphere, or the cube [-1, 1]^3, triangulated but not optimised.
inline std::unique_ptr<TestMesh> cube(int n, bool sphere)
{
  auto t = std::make_unique<TestMesh>();
  synthetic::cube(t->builder, sphere ? 16 : 1, sphere);
  t->read();
  t->samples = synthetic::sample(t->atlas->surface(), t->atlas->graph(), t->atlas->traces(), n);
  const Status status = createMesh(*t->atlas, t->samples, t->triangles, {});
  EXPECT_TRUE(status.ok()) << status.message();
  t->build();
  return t;
}

/// All that the mesh is, to compare byte by byte: its triangles, however they are numbered, and
/// where its vertices are.
struct Snapshot
{
  std::vector<Triangle> triangles;
  std::vector<std::array<double, 15>> vertices;
  explicit Snapshot(const OptimizedMesh& mesh)
    : triangles(mesh.triangles())
  {
    for (const Vertex v : mesh.vertices())
    {
      const VertexState& s = mesh.state(v);
      this->vertices.push_back({ { s.position.x(), s.position.y(), s.position.z(), s.normal.x(),
        s.normal.y(), s.normal.z(), s.otherNormal.x(), s.otherNormal.y(), s.otherNormal.z(),
        s.place.bary[0], s.place.bary[1], s.place.bary[2], static_cast<double>(s.place.face),
        s.density, s.arcLength } });
    }
  }
  bool operator==(const Snapshot& o) const
  {
    return this->triangles == o.triangles && this->vertices == o.vertices;
  }
};

/// The quality of the worst triangle.
inline double worstOf(const OptimizedMesh& mesh)
{
  double worst = 10;
  for (const Face f : mesh.faces())
  {
    worst = std::min(worst, faceQuality(mesh, f));
  }
  return worst;
}
}

#endif
