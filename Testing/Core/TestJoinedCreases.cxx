// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Creases go on where seams end: on a can, whose side is cut between its two circles.
#include "JoinedCreases.h"

#include "MeshCreation.h"
#include "PolyDataConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkCylinderSource.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

using namespace stipple;

namespace
{
constexpr int Sides = 90;
constexpr double Radius = 1.;

struct Can
{
  vtkNew<vtkGeometryRemesher> remesher;
  Atlas::Pointer atlas;
  std::vector<Sample> samples;

  Can()
  {
    vtkNew<vtkCylinderSource> source;
    source->SetRadius(Radius);
    source->SetHeight(2.);
    source->SetResolution(Sides);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(source->GetOutputPort());
    this->remesher->SetInputConnection(triangles->GetOutputPort());
    this->remesher->SetNumberOfPoints(900);
    this->remesher->SetNumberOfCharts(8);
    this->remesher->Update();
    vtkConformalAtlas* stage = this->remesher->GetAtlas();
    EXPECT_TRUE(
      Atlas::read(vtkPartitionedDataSetCollection::SafeDownCast(stage->GetOutputDataObject(0)),
        vtkPolyData::SafeDownCast(stage->GetOutputDataObject(1)), this->atlas)
        .ok());
    EXPECT_TRUE(
      readSamples(vtkPolyData::SafeDownCast(this->remesher->GetSampler()->GetOutputDataObject(0)),
        *this->atlas, this->samples)
        .ok());
  }
  Vec3 position(const Sample& sample) const
  {
    return this->atlas->surface().position(sample.face, sample.bary);
  }
};

std::vector<int> creasesOf(const FeatureGraph& graph)
{
  std::vector<int> result;
  for (std::size_t b = 0; b < graph.backbones.size(); ++b)
  {
    if (graph.backbones[b].type == BackboneType::Sharp)
    {
      result.push_back(static_cast<int>(b));
    }
  }
  return result;
}

const double Circle = 2. * Sides * Radius * std::sin(Pi / Sides);
}

TEST(JoinedCreases, AreAsLongAsWhatTheyAreMadeOf)
{
  const Can can;
  const FeatureGraph& before = can.atlas->graph();
  ASSERT_GT(creasesOf(before).size(), 4U) << "seams end on the circles";
  const JoinedCreases creases(*can.atlas);
  const FeatureGraph& graph = creases.atlas().graph();
  const std::vector<int> circles = creasesOf(graph);
  ASSERT_EQ(circles.size(), 2U);
  for (const int b : circles)
  {
    EXPECT_TRUE(graph.backbones[b].closed);
    EXPECT_GE(graph.backbones[b].numberOfSegments(), Sides) << "seams may cut edges";
    EXPECT_NEAR(creases.atlas().traces()[b].length(), Circle, 1e-6);
  }
  const auto seams = [](const FeatureGraph& of) {
    return std::count_if(of.backbones.begin(), of.backbones.end(),
      [](const Backbone& b) { return b.type == BackboneType::Seam; });
  };
  EXPECT_EQ(seams(graph), seams(before));
}

TEST(JoinedCreases, SamplesStayWhereTheyAre)
{
  const Can can;
  const JoinedCreases creases(*can.atlas);
  int onNodes = 0;
  for (const Sample& sample : can.samples)
  {
    const Sample joined = creases.joined(sample);
    EXPECT_LT((can.position(joined) - can.position(sample)).norm(), 1e-12);
    if (joined.kind != SampleKind::Backbone)
    {
      continue;
    }
    const SurfacePlace place = creases.atlas().placeOfBackbone(joined.backbone, joined.arcLength);
    EXPECT_LT(
      (can.position(sample) - can.atlas->surface().position(place.face, place.bary)).norm(), 1e-9);
    const Sample back = creases.original(joined);
    const SurfacePlace there = can.atlas->placeOfBackbone(back.backbone, back.arcLength);
    EXPECT_LT(
      (can.position(sample) - can.atlas->surface().position(there.face, there.bary)).norm(), 1e-9);
    if (sample.kind == SampleKind::Corner)
    {
      ++onNodes; // others are where seams meet
      EXPECT_EQ(joined.surfacePoint, -1);
    }
    else
    {
      EXPECT_EQ(back.backbone, sample.backbone);
      EXPECT_NEAR(back.arcLength, sample.arcLength, 1e-9);
    }
  }
  EXPECT_EQ(onNodes, static_cast<int>(creasesOf(can.atlas->graph()).size()))
    << "as many nodes as lines of closed ones";
}

TEST(JoinedCreases, ChainsOfVerticesAreOne)
{
  const Can can;
  const JoinedCreases creases(*can.atlas);
  const std::vector<std::vector<int>> chains = backboneChains(can.atlas->graph(), can.samples);
  const std::vector<std::vector<int>> joined = creases.joined(chains);
  for (const int b : creasesOf(creases.atlas().graph()))
  {
    const std::vector<int>& chain = joined[b];
    ASSERT_GT(chain.size(), 10U);
    EXPECT_EQ(chain.front(), chain.back());
    EXPECT_EQ(std::set<int>(chain.begin(), chain.end()).size() + 1, chain.size());
    double length = 0;
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      length +=
        (can.position(can.samples[chain[i]]) - can.position(can.samples[chain[i - 1]])).norm();
    }
    EXPECT_NEAR(length, Circle, 0.05) << "in their order";
  }
  EXPECT_EQ(creases.joined(creases.original(joined)), joined);
}

TEST(JoinedCreases, VerticesSlideWhereSeamsEnd)
{
  Can can;
  auto* lines = vtkPolyData::SafeDownCast(can.remesher->GetOutputDataObject(1));
  ASSERT_EQ(lines->GetNumberOfLines(), 2);
  std::vector<Vec3> vertices;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType line = 0; line < 2; ++line)
  {
    EXPECT_EQ(lines->GetCellData()->GetArray("Closed")->GetComponent(line, 0), 1.);
    lines->GetLines()->GetCellAtId(line, size, ids);
    std::transform(ids, ids + size, std::back_inserter(vertices),
      [&](vtkIdType id) { return Vec3(lines->GetPoint(id)); });
  }
  int nodes = 0;
  int withVertex = 0;
  for (const Sample& sample : can.samples)
  {
    const Vec3 p = can.position(sample);
    if (sample.kind == SampleKind::Corner && std::abs(p.y()) > 1. - 1e-6)
    {
      ++nodes;
      withVertex += std::any_of(vertices.begin(), vertices.end(),
                      [&](const Vec3& v) { return (v - p).norm() < 1e-4; })
        ? 1
        : 0;
    }
  }
  EXPECT_GT(nodes, 4);
  EXPECT_LE(withVertex, 1);
}
