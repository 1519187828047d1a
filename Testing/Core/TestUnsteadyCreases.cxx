// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Creases that bend the same way all along, and others, on roofs of known shape.
#include "OptimizerMeshes.h"
#include "UnsteadyCreases.h"

#include <algorithm>
#include <functional>

using namespace stipple;

namespace
{
constexpr int Ridge = 0; ///< backbone
constexpr double Degree = Pi / 180.;

/// Samples next to the middles of edges on the ridge, of every so manieth: each makes a poor
/// triangle.
void addPoorTriangles(meshes::TestMesh& t, std::size_t every)
{
  std::vector<double> onRidge; // which is as long as its x
  for (const Sample& s : t.samples)
  {
    if (s.kind == SampleKind::Backbone && s.backbone == Ridge)
    {
      onRidge.push_back(s.arcLength);
    }
  }
  std::sort(onRidge.begin(), onRidge.end());
  for (std::size_t i = 1; i < onRidge.size(); i += every)
  {
    const double height = 0.05 * (onRidge[i] - onRidge[i - 1]);
    const SurfacePlace place = t.placeAt(0.5 * (onRidge[i - 1] + onRidge[i]), 0.5 + height);
    Sample sample;
    sample.face = place.face;
    sample.bary = place.bary;
    t.samples.push_back(sample);
  }
}

/// A roof over [0, 1] x [-1/2, 1/2] whose ridge runs along x, with a mesh that has poor triangles
/// at every so manieth edge of it. Its sides fall by an angle.
std::unique_ptr<meshes::TestMesh> roof(
  const std::function<double(double)>& fall, Keep keep = Keep::Nothing, std::size_t every = 1)
{
  constexpr int N = 48;
  const auto at = [&](int i, int j) {
    const double x = static_cast<double>(i) / N;
    const double y = static_cast<double>(j) / N - 0.5;
    return Vec3(x, y, -std::abs(y) * std::tan(fall(x)));
  };
  auto t = std::make_unique<meshes::TestMesh>();
  t->builder.addGrid(N, N, at);
  t->builder.addBackbone(BackboneType::Sharp, synthetic::run(at, 0, N / 2, N, N / 2));
  t->builder.Result.graph.backbones[Ridge].keep = keep;
  const std::array<std::array<int, 2>, 7> outline = { { { { 0, 0 } }, { { N, 0 } },
    { { N, N / 2 } }, { { N, N } }, { { 0, N } }, { { 0, N / 2 } }, { { 0, 0 } } } };
  for (std::size_t k = 0; k + 1 < outline.size(); ++k)
  {
    t->builder.addBackbone(BackboneType::Boundary,
      synthetic::run(at, outline[k][0], outline[k][1], outline[k + 1][0], outline[k + 1][1]));
  }
  t->read();
  t->samples = synthetic::sample(t->atlas->surface(), t->atlas->graph(), t->atlas->traces(), 2000);
  addPoorTriangles(*t, every);
  const Status status = createMesh(*t->atlas, t->samples, t->triangles, {});
  EXPECT_TRUE(status.ok()) << status.message();
  t->build();
  return t;
}

double steady(double)
{
  return 30. * Degree;
}

/// By 20 degrees up and down along each twelfth of the ridge.
double unsteady(double x)
{
  return (30. + 10. * std::sin(24. * Pi * x)) * Degree;
}

CreaseProfile profileOf(const meshes::TestMesh& t, double edgeLength)
{
  return { *t.atlas, t.mesh.surfaceWalk(), Ridge, edgeLength };
}
}

TEST(UnsteadyCreases, AProfileIsWhatTheRoofIs)
{
  const auto even = roof(steady);
  const CreaseProfile profile = profileOf(*even, 0.1);
  EXPECT_NEAR(profile.bend, 60. * Degree, 1e-6);
  EXPECT_NEAR(profile.unsteadiness, 0., 1e-6);
  EXPECT_TRUE(profile.isSteady());
  // An edge across it is the base of a triangle of 120 degrees whose tip is on the ridge.
  EXPECT_NEAR(profile.depth(), 0.5 * std::tan(30. * Degree), 1e-6);

  const auto uneven = roof(unsteady);
  const CreaseProfile other = profileOf(*uneven, 0.1);
  EXPECT_NEAR(other.bend, 60. * Degree, 3. * Degree);
  EXPECT_FALSE(other.isSteady());

  const auto fading = roof([](double x) { return (40. - 20. * x) * Degree; });
  const CreaseProfile fades = profileOf(*fading, 0.1);
  EXPECT_NEAR(fades.bend, 60. * Degree, 1. * Degree);
  EXPECT_TRUE(fades.isSteady()) << fades.unsteadiness;
}

TEST(UnsteadyCreases, AnEdgeIsNoLongerThanWhatItCutsOff)
{
  CreaseProfile profile;
  profile.bend = 90. * Degree;
  EXPECT_NEAR(profile.depth(), 0.5, 1e-12);
  profile.bend = 119. * Degree; // the height of a regular triangle, nearly
  EXPECT_NEAR(profile.depth(), 0.5 * std::sqrt(3.), 0.02);
  profile.bend = 121. * Degree;
  EXPECT_GT(profile.depth(), 1e6) << "the rim of a thin sheet";
}

TEST(UnsteadyCreases, AreGivenUpWhereTrianglesArePoor)
{
  const auto t = roof(unsteady);
  OptimizedMesh& mesh = t->mesh;
  const std::vector<OptimizedMesh::Chain> before = mesh.chains();
  EXPECT_EQ(giveUpUnsteadyCreases(mesh, 1., 1. * Degree), 0) << "none is as poor";
  EXPECT_EQ(giveUpUnsteadyCreases(mesh, 0.), 0);
  EXPECT_EQ(mesh.chains(), before);
  ASSERT_EQ(giveUpUnsteadyCreases(mesh, 1.), 1);
  EXPECT_EQ(mesh.numberOfSimplifiedFeatures(), 1);
  EXPECT_TRUE(mesh.chains()[Ridge].empty());
  EXPECT_FALSE(mesh.isCreaseBackbone(Ridge));
  for (std::size_t b = 1; b < before.size(); ++b)
  {
    EXPECT_EQ(mesh.chains()[b], before[b]) << "the outline stays";
  }
  for (const BackboneVertex& v : before[Ridge])
  {
    const bool isEnd = v == before[Ridge].front() || v == before[Ridge].back();
    EXPECT_EQ(mesh.freedom(v.vertex), isEnd ? Freedom::None : Freedom::Surface);
  }
  const Vertex first = before[Ridge][1].vertex;
  EXPECT_FALSE(mesh.isCrease(t->edgeBetween(first.index(), before[Ridge][2].vertex.index())));
  EXPECT_EQ(mesh.samples()[first.index()].kind, SampleKind::Interior);
  // It was a wall, and parted normals.
  const SurfacePoint far = mesh.walk(t->placeAt(0.5, 0.4), Vec3(0., 0.2, 0.));
  EXPECT_GT(far.position.y(), 0.02);
  EXPECT_GT(mesh.normal(first).z(), 0.95);
  EXPECT_EQ(giveUpUnsteadyCreases(mesh, 1.), 0);
}

TEST(UnsteadyCreases, OthersStay)
{
  const auto even = roof(steady);
  const meshes::Snapshot before(even->mesh);
  EXPECT_EQ(giveUpUnsteadyCreases(even->mesh, 1.), 0);
  EXPECT_TRUE(meshes::Snapshot(even->mesh) == before);
  EXPECT_EQ(even->mesh.numberOfSimplifiedFeatures(), 0);

  const auto named = roof(unsteady, Keep::Line);
  EXPECT_EQ(giveUpUnsteadyCreases(named->mesh, 1.), 0) << "users named it";

  const auto rarelyPoor = roof(unsteady, Keep::Nothing, 10);
  EXPECT_EQ(giveUpUnsteadyCreases(rarelyPoor->mesh, 1.), 0)
    << "few triangles are not worth all of it";

  const auto steep = roof([](double x) { return 35. * Degree + unsteady(x); });
  EXPECT_EQ(giveUpUnsteadyCreases(steep->mesh, 1.), 0) << "it is the rim of a sheet";
}
