// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One chart triangulated, all of them welded, and the input's attributes on the mesh.
#include "../Cxx/SyntheticAtlas.h"
#include "AttributeTransfer.h"
#include "ChartTriangulation.h"
#include "MeshCreation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace synthetic;

namespace
{
struct Meshing
{
  Builder builder;
  stipple::Atlas::Pointer read;
  std::vector<Sample> samples;
  std::vector<Triangle> triangles;

  void take(int numberOfSamples)
  {
    synthetic::MadeAtlas& atlas = this->builder.finish();
    ASSERT_TRUE(this->builder.ok());
    ASSERT_TRUE(stipple::Atlas::read(atlas.charts, atlas.graphData, this->read).ok());
    this->samples = sample(atlas, numberOfSamples);
  }
  Status create() { return createMesh(*this->read, this->samples, this->triangles, {}); }
  std::vector<SurfacePlace> places() const
  {
    std::vector<SurfacePlace> result;
    for (const Sample& s : this->samples)
    {
      result.push_back({ s.face, s.bary });
    }
    return result;
  }
};
}

TEST(ChartTriangulation, UsesEverySampleAndKeepsBackbones)
{
  Meshing m;
  bumpyGrid(m.builder, 2, 12, true);
  m.take(300);
  const AtlasSurface& surface = m.read->surface();
  const FeatureGraph& graph = m.read->graph();
  const auto graphs = buildChartGraphs(surface, graph, m.read->traces(), m.samples);
  const BackboneIntervals intervals(graph, samplesByBackbone(graph, m.samples));
  for (int c = 0; c < surface.numberOfCharts(); ++c)
  {
    std::vector<int> interior;
    for (std::size_t i = 0; i < m.samples.size(); ++i)
    {
      if (m.samples[i].kind == SampleKind::Interior && surface.faceChart[m.samples[i].face] == c)
      {
        interior.push_back(static_cast<int>(i));
      }
    }
    for (const DelaunayMetric metric : { DelaunayMetric::Plane, DelaunayMetric::Surface })
    {
      ChartTriangulation mesh;
      ASSERT_TRUE(triangulateChart(surface, c, graphs[c], m.read->traces(), graph, intervals,
        m.samples, interior, metric, mesh)
                    .ok());
      EXPECT_TRUE(mesh.complex.isSound());
      std::set<int> used;
      double area = 0;
      for (const Triangle& t : mesh.complex.triangles)
      {
        const double twice =
          orient2(mesh.parameter[t[0]], mesh.parameter[t[1]], mesh.parameter[t[2]]);
        EXPECT_GT(twice, 0.) << "chart " << c;
        area += 0.5 * twice;
        for (int v : t)
        {
          used.insert(mesh.sample[v]);
        }
      }
      EXPECT_LT(area, surface.extent[c].prod() + 1e-12);
      EXPECT_GT(area, 0.9 * surface.extent[c].prod());
      EXPECT_TRUE(std::includes(used.begin(), used.end(), interior.begin(), interior.end()));
      std::set<Label> labels;
      std::set<Label> expected;
      for (Label l : mesh.complex.label)
      {
        if (l.valid())
        {
          labels.insert(l);
        }
      }
      for (const ChartGraph::Segment& s : graphs[c].segments)
      {
        expected.insert(intervals.label(s.backbone, s.interval));
        EXPECT_EQ(intervals.backbone(intervals.label(s.backbone, s.interval)), s.backbone);
      }
      EXPECT_EQ(labels, expected) << "every interval of a backbone is an edge";
    }
  }
}

TEST(MeshCreation, WeldsChartsToTheSurfacesTopology)
{
  for (const int n : { 40, 400 })
  {
    Meshing m;
    cube(m.builder, 8, true);
    m.take(n);
    ASSERT_TRUE(m.create().ok());
    TriangleSurface mesh;
    for (const Sample& s : m.samples)
    {
      mesh.points.push_back(m.read->surface().position(s.face, s.bary));
    }
    mesh.triangles = m.triangles;
    mesh.connect();
    EXPECT_EQ(static_cast<int>(m.triangles.size()), 2 * n - 4) << "Euler's formula";
    EXPECT_TRUE(mesh.topology() == m.read->topology());
    const auto chains = backboneChains(m.read->graph(), m.samples);
    ASSERT_EQ(chains.size(), 12u);
    const auto output = meshToPolyData(*m.read, m.samples, m.triangles);
    EXPECT_EQ(output->GetNumberOfPoints(), n);
    EXPECT_EQ(featureLines(m.read->graph(), chains, output, false)->GetNumberOfLines(), 0)
      << "all are seams";
    EXPECT_GT(featureLines(m.read->graph(), chains, output, true)->GetNumberOfLines(), 0);
  }
}

TEST(MeshCreation, SaysWhatSamplesLack)
{
  Meshing m;
  cube(m.builder, 8, false);
  m.take(8);
  ASSERT_TRUE(m.create().ok()) << "a cube's corners triangulate it";
  EXPECT_EQ(m.triangles.size(), 12u);
  m.samples.erase(m.samples.begin());
  MeshFault fault;
  const Status status = createMesh(*m.read, m.samples, m.triangles, {}, &fault);
  EXPECT_EQ(status.code(), StatusCode::TooFewPoints);
  EXPECT_FALSE(fault.chart.valid()) << "no sample inside would make up for a lacking corner";
  m.samples.back().backbone = 99;
  m.samples.back().kind = SampleKind::Backbone;
  EXPECT_EQ(m.create().code(), StatusCode::BadInput) << "no such backbone";
}

TEST(MeshCreation, TellsTheChartWhereAClosedSurfaceOfThreeSamplesLacksOne)
{
  // A cushion of two charts, glued around: three samples on the seam leave a triangle on either
  // side.
  Meshing m;
  const int n = 4;
  const auto place = [](int i, int j, double side) {
    const bool isInside = i > 0 && i < n && j > 0 && j < n;
    return Vec3(i, j, isInside ? side : 0.);
  };
  m.builder.addGrid(n, n, [&](int i, int j) { return place(i, j, 1); });
  m.builder.addGrid(n, n, [&](int i, int j) { return place(n - i, j, -1); });
  std::vector<Vec3> around;
  for (int k = 0; k < 4 * n; ++k)
  {
    const int side = k / n;
    const int at = k % n;
    around.push_back(side == 0 ? place(at, 0, 0)
        : side == 1            ? place(n, at, 0)
        : side == 2            ? place(n - at, n, 0)
                               : place(0, n - at, 0));
  }
  m.builder.addBackbone(BackboneType::Seam, around, true);
  synthetic::MadeAtlas& atlas = m.builder.finish();
  ASSERT_TRUE(m.builder.ok());
  ASSERT_TRUE(stipple::Atlas::read(atlas.charts, atlas.graphData, m.read).ok());
  for (const double s : { 1., 6., 11. })
  {
    const SurfacePlace there = m.read->placeOfBackbone(0, s);
    Sample sample;
    sample.kind = SampleKind::Backbone;
    sample.face = there.face;
    sample.bary = there.bary;
    sample.backbone = 0;
    sample.arcLength = s;
    m.samples.push_back(sample);
  }
  MeshFault fault;
  EXPECT_EQ(
    createMesh(*m.read, m.samples, m.triangles, {}, &fault).code(), StatusCode::TooFewPoints);
  ASSERT_TRUE(fault.chart.valid());
  Sample inside;
  inside.kind = SampleKind::Interior;
  inside.face = m.read->surface().chartBegin[fault.chart.index()] + n * n;
  inside.bary = Vec3::Constant(1. / 3.);
  m.samples.push_back(inside);
  EXPECT_TRUE(createMesh(*m.read, m.samples, m.triangles, {}, &fault).ok()) << "one there helps";
  EXPECT_EQ(m.triangles.size(), 4U);
}

TEST(MeshCreation, StopsWhenAsked)
{
  Meshing m;
  cube(m.builder, 8, true);
  m.take(100);
  const Status status =
    createMesh(*m.read, m.samples, m.triangles, [](double f) { return f < 0.5; });
  EXPECT_TRUE(status.isAbort());
}

TEST(AttributeTransfer, InterpolatesAndTakesTheNearest)
{
  Meshing m;
  bumpyGrid(m.builder, 2, 12);
  m.take(250);
  ASSERT_TRUE(m.create().ok());
  const AtlasSurface& surface = m.read->surface();
  vtkNew<vtkPolyData> mesh;
  transferAttributes(surface, m.read->walk(), m.places(), m.triangles, mesh);
  vtkDataArray* height = mesh->GetPointData()->GetArray("Height");
  vtkDataArray* label = mesh->GetPointData()->GetArray("Label");
  vtkDataArray* material = mesh->GetCellData()->GetArray("Material");
  ASSERT_TRUE(height && label && material);
  EXPECT_FALSE(mesh->GetPointData()->GetArray("SurfacePointId")) << "the charts' own";
  ASSERT_EQ(height->GetNumberOfTuples(), 250);
  for (int i = 0; i < 250; ++i)
  {
    const Sample& s = m.samples[i];
    const Vec3 p = surface.position(s.face, s.bary);
    EXPECT_NEAR(height->GetTuple1(i), p.x() + 2. * p.y() + 3. * p.z(), 1e-9);
    Vec3 nearest = surface.point(s.face, 0); // not that of the largest weight
    for (const int k : { 1, 2 })
    {
      const Vec3 corner = surface.point(s.face, k);
      nearest = (corner - p).norm() < (nearest - p).norm() ? corner : nearest;
    }
    EXPECT_EQ(label->GetTuple1(i), nearest.x() > 0.5 ? 7 : 3);
  }
  const std::vector<int> under =
    facesUnderTriangles(surface, m.read->walk(), m.places(), m.triangles);
  ASSERT_EQ(under.size(), m.triangles.size());
  for (std::size_t t = 0; t < under.size(); ++t)
  {
    EXPECT_EQ(material->GetTuple1(static_cast<vtkIdType>(t)), surface.faceChart[under[t]]);
    Vec3 centroid = Vec3::Zero();
    for (int v : m.triangles[t])
    {
      centroid += surface.position(m.samples[v].face, m.samples[v].bary) / 3.;
    }
    Vec3 face = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      face += surface.point(under[t], k) / 3.;
    }
    EXPECT_LT((face - centroid).head<2>().norm(), 2. / 24.) << "the face is below the triangle";
  }
}
