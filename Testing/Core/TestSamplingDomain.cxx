// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What sampling derives from charts and feature graph, and the surface with its long edges split.
#include "SamplingDomain.h"
#include "SurfaceRefinement.h"
#include "SyntheticControl.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace synthetic;

namespace
{
constexpr int PixelsAcross = 8;

/// A cube with side 2 as six charts of 8 x 8 squares, and constraints on it.
struct Cube
{
  Builder builder;
  SamplingDomain domain;
  Cube() { cube(this->builder, PixelsAcross, false); }
  Status read(const std::vector<ConstraintPoint>& constraints = {})
  {
    this->builder.Result.graph.constraints = constraints;
    synthetic::MadeAtlas& atlas = this->builder.finish();
    stipple::Atlas::Pointer read;
    const Status status = stipple::Atlas::read(atlas.charts, atlas.graphData, read);
    return status.ok() ? readSamplingDomain(read, this->domain) : status;
  }
};

ConstraintPoint constraint(int chart, int cell, const Vec3& bary)
{
  ConstraintPoint c;
  c.chart = chart;
  c.chartCell = cell;
  c.bary = bary;
  return c;
}
}

TEST(SamplingDomain, SortsConstraints)
{
  Cube c;
  // Triangle 0 is (0, 0), (1, 0), (1, 1): its first corner is a node, its first edge on a backbone.
  ASSERT_TRUE(
    c.read({ constraint(2, 0, Vec3(1., 0., 0.)), constraint(2, 0, Vec3(0.75, 0.25, 0.)),
             constraint(2, 0, Vec3(0.75, 0.25, 0.)), constraint(2, 0, Vec3(0.5, 0.25, 0.25)),
             constraint(2, 0, Vec3(0.5, 0.25, 0.25)) })
      .ok());
  const SamplingDomain& d = c.domain;
  EXPECT_EQ(d.fixedSamples.size(), 8u + 1u) << "corners, and one constraint inside";
  EXPECT_EQ(d.chartConstraints[2].size(), 1u);
  std::size_t places = 0;
  for (std::size_t b = 0; b < d.fixedPlaces.size(); ++b)
  {
    places += d.fixedPlaces[b].size();
    for (const double s : d.fixedPlaces[b])
    {
      EXPECT_NEAR(std::min(s, d.traces()[b].length() - s), 0.25 * 2. / PixelsAcross, 1e-12);
      const Sample x = d.backboneSample(static_cast<int>(b), s);
      EXPECT_EQ(x.kind, SampleKind::Backbone);
      EXPECT_EQ(x.backbone, static_cast<int>(b));
      const Vec3 p = d.surface().position(x.face, x.bary);
      const Vec3 wanted =
        c.builder.Result.surface.position(d.surface().chartBegin[2], Vec3(0.75, 0.25, 0.));
      EXPECT_LT((p - wanted).norm(), 1e-12);
    }
  }
  EXPECT_EQ(places, 1u) << "the one on a backbone belongs to it";
  EXPECT_EQ(d.samples(d.fixedPlaces).size(), 10u);
}

TEST(SamplingDomain, MeasuresParametersAndBackbones)
{
  Cube c;
  ASSERT_TRUE(c.read().ok());
  const SamplingDomain& d = c.domain;
  for (const FirstFundamentalForm& m : d.atlas->metric())
  {
    EXPECT_NEAR(m.squared(Vec2(1., 0.)), 4., 1e-5);
    EXPECT_NEAR(m.dot(Vec2(1., 0.), Vec2(0., 1.)), 0., 1e-5);
  }
  EXPECT_EQ(std::count(d.onBackbone.begin(), d.onBackbone.end(), 1), 12 * PixelsAcross * 2);
  const BackbonePlaces places(12, { 0.5, 1.5 });
  EXPECT_EQ(d.interval(places, 3, 0), (std::array<double, 2>{ { 0., 0.5 } }));
  EXPECT_EQ(d.interval(places, 3, 1), (std::array<double, 2>{ { 0.5, 1.5 } }));
  EXPECT_EQ(d.interval(places, 3, 2), (std::array<double, 2>{ { 1.5, d.traces()[3].length() } }));
}

TEST(SamplingDomain, RefusesAGraphOfOtherCharts)
{
  Cube c;
  EXPECT_EQ(c.read({ constraint(2, 2 * PixelsAcross * PixelsAcross, Vec3(1., 0., 0.)) }).code(),
    StatusCode::BadInput);
  Cube open;
  open.builder.Result.graph.backbones.clear();
  const Status status = open.read();
  EXPECT_EQ(status.code(), StatusCode::BadInput);
  EXPECT_NE(status.message().find("no backbone along the boundary"), std::string::npos)
    << status.message();
}

TEST(SurfaceRefinement, HalvesEdgesWithoutCracks)
{
  Cube c;
  ASSERT_TRUE(c.read().ok());
  const AtlasSurface& s = c.domain.surface();
  const ControlMaps maps(s, 64);
  const double longest = 0.15;
  const RefinedSurface r = refine(s, maps.images, longest);
  ASSERT_EQ(r.uv.size(), r.triangles.size());
  ASSERT_EQ(r.face.size(), r.triangles.size());
  EXPECT_TRUE(std::is_sorted(r.face.begin(), r.face.end()));
  TriangleSurface refined;
  refined.points = r.points;
  refined.triangles = r.triangles;
  refined.connect();
  EXPECT_NEAR(refined.area(), s.area(), 1e-9);
  const SurfaceTopology topology = refined.topology();
  EXPECT_EQ(topology.euler, 2);
  EXPECT_EQ(topology.boundaryLoops, 0) << "points are shared across seams";
  for (std::size_t t = 0; t < r.triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& p = r.points[r.triangles[t][k]];
      EXPECT_LE((r.points[r.triangles[t][(k + 1) % 3]] - p).norm(), longest + 1e-12);
      int face = r.face[t];
      Vec3 bary;
      locate(s, s.faceChart[face], r.uv[t][k], face, face, bary);
      EXPECT_LT((s.position(face, bary) - p).norm(), 1e-9) << "parameters go with positions";
    }
  }
}

TEST(SurfaceRefinement, FindsThePlacesOfPixels)
{
  Cube c;
  ASSERT_TRUE(c.read().ok());
  const AtlasSurface& s = c.domain.surface();
  const ControlMaps maps(s, 40);
  const RefinedSurface r = refine(s, maps.images, 0.1);
  for (int chart = 0; chart < s.numberOfCharts(); ++chart)
  {
    const std::vector<PixelPlace> places = placePixels(s, r, chart, maps.images[chart]);
    ASSERT_EQ(static_cast<int>(places.size()), maps.images[chart].numberOfPixels());
    for (int i = 0; i < static_cast<int>(places.size()); ++i)
    {
      ASSERT_GE(places[i].triangle, 0);
      Vec3 p = Vec3::Zero();
      for (int k = 0; k < 3; ++k)
      {
        p += static_cast<double>(places[i].bary[k]) * r.points[r.triangles[places[i].triangle][k]];
      }
      EXPECT_LT((p - maps.position(s, chart, i)).norm(), 1e-5);
    }
  }
}
