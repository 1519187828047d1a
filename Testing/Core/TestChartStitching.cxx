// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Welding charts: edges that two charts share twice, and triangles without area in space, are
// swapped away.
#include "ChartStitching.h"

#include <gtest/gtest.h>

using namespace stipple;

namespace
{
/// Four samples around a closed seam (or boundary), label i between sample i - 1 and sample i.
struct Ring
{
  AtlasSurface surface;
  FeatureGraph graph;
  std::vector<Sample> samples;
  std::vector<Triangle> triangles;
  ElementArray<Label, char> hasEdge;
  MeshFault fault;

  Ring(const std::vector<Vec3>& positions, BackboneType type)
  {
    this->surface.points = positions;
    this->graph.backbones.resize(1);
    this->graph.backbones[0].type = type;
    this->graph.backbones[0].closed = true;
    for (int i = 0; i < static_cast<int>(positions.size()); ++i)
    {
      this->surface.triangles.push_back({ i, i, i });
      Sample s;
      s.face = i;
      s.bary = Vec3(1, 0, 0);
      this->samples.push_back(s);
    }
  }
  ChartTriangulation chart(const std::vector<Triangle>& tri, const std::vector<Vec2>& uv) const
  {
    const int n = static_cast<int>(uv.size());
    ChartTriangulation mesh;
    mesh.complex.triangles = tri;
    mesh.complex.twin = halfedgeTwins(tri);
    for (Halfedge h : mesh.complex.halfedges())
    {
      const int a = mesh.complex.tail(h).index();
      const int b = mesh.complex.head(h).index();
      mesh.complex.label.push_back(Label((a + 1) % n == b ? b : (b + 1) % n == a ? a : -1));
    }
    for (int v = 0; v < n; ++v)
    {
      mesh.sample.push_back(v);
      mesh.parameter.push_back(uv[v]);
    }
    return mesh;
  }
  Status stitch(const std::vector<ChartTriangulation>& charts)
  {
    std::vector<int> around;
    for (std::size_t i = 0; i < this->samples.size(); ++i)
    {
      around.push_back(static_cast<int>(i));
    }
    return stitchCharts(this->surface, this->graph, BackboneIntervals(this->graph, { around }),
      charts, this->samples, this->triangles, this->hasEdge, this->fault);
  }
};

SurfaceTopology topology(const std::vector<Triangle>& triangles, std::size_t points)
{
  TriangleSurface s;
  s.points.resize(points);
  s.triangles = triangles;
  s.connect();
  return s.topology();
}
}

TEST(ChartStitching, SwapsAnEdgeThatBothChartsHave)
{
  Ring ring({ { 0, 0, 0 }, { 1, 0, 0.5 }, { 1, 1, 0 }, { 0, 1, 0.5 } }, BackboneType::Seam);
  const ChartTriangulation front =
    ring.chart({ { 0, 1, 2 }, { 0, 2, 3 } }, { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  const ChartTriangulation back =
    ring.chart({ { 0, 2, 1 }, { 0, 3, 2 } }, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 0 } });
  ASSERT_TRUE(ring.stitch({ front, back }).ok());
  const SurfaceTopology t = topology(ring.triangles, 4);
  EXPECT_TRUE(t.manifold);
  EXPECT_EQ(t.euler, 2);
  EXPECT_EQ(t.boundaryLoops, 0);
  for (char present : ring.hasEdge)
  {
    EXPECT_TRUE(present);
  }
}

TEST(ChartStitching, SaysSoWhenThereAreTooFewSamples)
{
  // A cylinder cut open whose two rims are the same two samples each: nothing to swap.
  Ring ring({ { 0, 0, 0 }, { 1, 0, 0 } }, BackboneType::Sharp);
  ChartTriangulation chart =
    ring.chart({ { 0, 1, 2 }, { 0, 2, 3 } }, { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  chart.sample = { 0, 1, 0, 1 };
  const std::array<int, 6> labels = { { 0, 1, -1, -1, 0, 1 } };
  for (Halfedge h : chart.complex.halfedges())
  {
    chart.complex.label[h] = Label(labels[h.index()]);
  }
  const Status status = ring.stitch({ chart });
  EXPECT_EQ(status.code(), StatusCode::TooFewPoints);
  EXPECT_EQ(ring.fault.chart, Chart(0));
  ASSERT_EQ(ring.fault.places.size(), 1u) << "a sample in the middle of the diagonal would do";
  EXPECT_EQ(ring.fault.places[0].first, Chart(0));
  EXPECT_EQ(ring.fault.places[0].second, Vec2(0.5, 0.5));
  EXPECT_NE(status.message().find("more points"), std::string::npos);
}

TEST(ChartStitching, SwapsATriangleWithoutAreaAway)
{
  // In the parameter plane the outline turns at sample 1, in space it runs straight on.
  Ring ring({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 } }, BackboneType::Boundary);
  const ChartTriangulation chart =
    ring.chart({ { 0, 1, 2 }, { 0, 2, 3 } }, { { 0, 1 }, { 0, 0 }, { 1, 0 }, { 1, 1 } });
  ASSERT_TRUE(ring.stitch({ chart }).ok());
  ASSERT_EQ(ring.triangles.size(), 2u);
  for (const Triangle& t : ring.triangles)
  {
    EXPECT_GT(
      triangleArea(ring.surface.points[t[0]], ring.surface.points[t[1]], ring.surface.points[t[2]]),
      0.1);
  }
}
