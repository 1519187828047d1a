// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the views show of a finished mesh: its vertices as dots, its triangles by number.
#include "MeshColors.h"
#include "MeshDots.h"
#include "NearestTriangle.h"
#include "PolyDataConversion.h"
#include "SphereAtlas.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace stipple
{
namespace
{
struct Made
{
  vtkSmartPointer<vtkPolyData> input;
  std::unique_ptr<AtlasResult> atlas;
  std::unique_ptr<MeshResult> mesh;
};

/// The mesh's vertices on the charts.
MeshDots dotsOf(const Made& made, Atlas::Pointer& atlas)
{
  EXPECT_TRUE(Atlas::read(made.atlas->charts, nullptr, atlas).ok());
  return placeOnCharts(made.mesh->mesh, *atlas);
}

/// The sphere remeshed with 400 points.
const Made& made()
{
  static const Made result = [] {
    Made m;
    m.input = sphere(32);
    MeshWorker worker(m.input);
    worker.start(withPoints(400));
    while (!m.mesh)
    {
      if (auto atlas = worker.takeAtlas())
      {
        m.atlas = std::move(atlas);
      }
      m.mesh = worker.takeMesh();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (auto atlas = worker.takeAtlas())
    {
      m.atlas = std::move(atlas);
    }
    return m;
  }();
  return result;
}
}

TEST(MeshDots, AreTheVerticesOnTheCharts)
{
  Atlas::Pointer atlas;
  const MeshDots dots = dotsOf(made(), atlas);
  vtkPolyData* mesh = made().mesh->mesh;
  ASSERT_EQ(dots.samples->GetNumberOfPoints(), 400);
  const AtlasSurface& surface = atlas->surface();
  vtkPointData* data = dots.samples->GetPointData();
  double vertices = 0;
  for (vtkIdType i = 0; i < 400; ++i)
  {
    const Vec3 position(mesh->GetPoint(i));
    EXPECT_EQ(Vec3(dots.samples->GetPoint(i)), position);
    const auto chart = static_cast<int>(data->GetArray("ChartId")->GetComponent(i, 0));
    const Face face(surface.chartBegin[static_cast<std::size_t>(chart)] +
      static_cast<int>(data->GetArray("ChartCellId")->GetComponent(i, 0)));
    EXPECT_EQ(surface.faceChart[face].index(), chart);
    const Vec2 uv(
      data->GetArray("UV")->GetComponent(i, 0), data->GetArray("UV")->GetComponent(i, 1));
    const Vec3 bary = barycentric(
      uv, surface.cornerUV(face, 0), surface.cornerUV(face, 1), surface.cornerUV(face, 2));
    EXPECT_LT((surface.position(face, bary) - position).norm(), 0.01) << i;
    vertices += 1 / data->GetArray("Density")->GetComponent(i, 0);
  }
  // Each vertex has its share of the surface.
  EXPECT_NEAR(vertices, fromPolyData(mesh).area(), 1e-6);
}

TEST(MeshDots, ReachOverSeams)
{
  Atlas::Pointer atlas;
  const MeshDots dots = dotsOf(made(), atlas);
  const AtlasSurface& surface = atlas->surface();
  ASSERT_GT(surface.numberOfCharts(), 1);
  EXPECT_GT(dots.beyond.size(), 5U);
  EXPECT_LT(dots.beyond.size(), 300U);
  vtkDataArray* chart = dots.samples->GetPointData()->GetArray("ChartId");
  for (const DotBeyond& mark : dots.beyond)
  {
    EXPECT_NE(mark.chart, static_cast<int>(chart->GetComponent(mark.dot, 0)));
    EXPECT_EQ(surface.faceChart[Face(mark.face)].index(), mark.chart);
  }
}

TEST(MeshColors, AreTheFiguresOfTheMesh)
{
  const MeshColors& colors = made().mesh->colors;
  const MeshQuality& quality = made().mesh->figures.quality;
  ASSERT_EQ(colors.angle.size(), static_cast<std::size_t>(quality.numberOfTriangles));
  const auto least = std::min_element(colors.angle.begin(), colors.angle.end());
  EXPECT_NEAR(*least, quality.minimumAngle, 1e-4);
  const std::vector<int> worst = worstOf(colors, MeshColoring::Plain);
  EXPECT_EQ(worst, worstOf(colors, MeshColoring::Angle));
  EXPECT_EQ(worst.front(), static_cast<int>(least - colors.angle.begin()));
  EXPECT_EQ(worst.size(), WorstOfAll);
  EXPECT_EQ(std::set<int>(worst.begin(), worst.end()).size(), WorstOfAll);
  for (std::size_t i = 1; i < worst.size(); ++i)
  {
    EXPECT_LE(colors.angle[static_cast<std::size_t>(worst[i - 1])],
      colors.angle[static_cast<std::size_t>(worst[i])]);
  }
  // Triangles of a sphere lie below it.
  const auto most = *std::max_element(colors.deviation.begin(), colors.deviation.end());
  const std::vector<int> farthest = worstOf(colors, MeshColoring::Deviation);
  EXPECT_EQ(colors.deviation[static_cast<std::size_t>(farthest.front())], most);
  EXPECT_LE(colors.deviation[static_cast<std::size_t>(farthest.back())], most);
  EXPECT_EQ(colors.quality[static_cast<std::size_t>(worstOf(colors, MeshColoring::Quality)[0])],
    *std::min_element(colors.quality.begin(), colors.quality.end()));
  EXPECT_GT(most, 0.02F);
  EXPECT_LT(most, 2.F);
}

TEST(MeshColors, TheInputItselfDoesNotDeviate)
{
  const TriangleSurface surface = fromPolyData(made().input);
  const NearestTriangle nearest(surface);
  const MeshColors colors = measureColors(made().input, nearest, [] { return false; });
  EXPECT_LT(*std::max_element(colors.deviation.begin(), colors.deviation.end()), 1e-5F);
  ASSERT_EQ(colors.missed.size(), surface.points.size());
  EXPECT_LT(largestOf(colors.missed), 1e-5);
  EXPECT_TRUE(measureColors(made().input, nearest, [] { return true; }).angle.empty()) << "stopped";
}

TEST(MeshColors, WhatTheMeshLacksIsAtTheInput)
{
  // An ear of the input that the mesh has not, and a point that no triangle uses.
  vtkNew<vtkPolyData> input;
  input->DeepCopy(made().input);
  const vtkIdType tip = 40;
  Vec3 p(input->GetPoint(tip));
  p *= 1.5;
  input->GetPoints()->SetPoint(tip, p.data());
  input->GetPoints()->InsertNextPoint(9, 9, 9);
  const TriangleSurface surface = fromPolyData(input);
  const NearestTriangle nearest(surface);
  const MeshColors colors = measureColors(made().input, nearest, [] { return false; });
  EXPECT_NEAR(largestOf(colors.missed), colors.missed[tip], 1e-6);
  EXPECT_NEAR(colors.missed[tip], 100 * p.norm() / 3 / surface.boundingBoxDiagonal(), 0.1);
  EXPECT_EQ(colors.missed.back(), 0);
  EXPECT_EQ(scaleOf(colors, MeshColoring::Deviation).high, missedScale(colors).high);
}

TEST(MeshColors, LongEdgesAreLookedAtBetweenTheirEnds)
{
  // A square of two triangles, and a mesh of it whose middle is a pit.
  TriangleSurface square;
  square.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0) };
  square.triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  constexpr double Deep = 0.1;
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Vec3& p : square.points)
  {
    points->InsertNextPoint(p.data());
  }
  points->InsertNextPoint(0.5, 0.5, -Deep);
  for (vtkIdType k = 0; k < 4; ++k)
  {
    const vtkIdType ids[3] = { k, (k + 1) % 4, 4 };
    cells->InsertNextCell(3, ids);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  const MeshColors colors = measureColors(mesh, NearestTriangle(square), [] { return false; });
  const double foot = Deep / std::sqrt(1. + 4. * Deep * Deep); // of the middle, on a side of the
                                                               // pit
  ASSERT_EQ(colors.missed.size(), 4U);
  EXPECT_NEAR(colors.missed[0], 100 * foot / std::sqrt(2.), 1e-4);
  EXPECT_NEAR(colors.missed[2], colors.missed[0], 1e-4);
}

TEST(MeshColors, GoodIsBlueAndBadIsRed)
{
  const MeshColors& colors = made().mesh->colors;
  for (const MeshColoring coloring :
    { MeshColoring::Angle, MeshColoring::Quality, MeshColoring::Deviation })
  {
    const ColorScale scale = scaleOf(colors, coloring);
    const bool lowIsGood = coloring == MeshColoring::Deviation;
    const Pixel good = scale.pixelOf(lowIsGood ? scale.low : scale.high);
    const Pixel bad = scale.pixelOf(lowIsGood ? scale.high : scale.low);
    EXPECT_GT(good[2], good[0]);
    EXPECT_GT(bad[0], bad[2]);
    EXPECT_EQ(scale.bar.ticks.front().first, 0);
    EXPECT_EQ(scale.bar.ticks.back().first, 1);
  }
  EXPECT_TRUE(valuesOf(colors, MeshColoring::Plain).empty());
}
}
