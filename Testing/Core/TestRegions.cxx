// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Regions: labels of cells, whose borders meshes keep.
#include "FeatureGraphBuilder.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"
#include "RegionArrays.h"
#include "RegionTransfer.h"
#include "Shapes.h"

#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkFieldData.h"
#include "vtkGeometryRemesher.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

using namespace stipple;

namespace
{
using LabelOf = std::function<int(const Vec3&)>;

/// Every triangle with the label of its centroid.
vtkSmartPointer<vtkPolyData> labelled(const TriangleSurface& surface, const LabelOf& labelOf)
{
  auto data = shapes::toPolyData(surface);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Part");
  for (const Triangle& t : surface.triangles)
  {
    labels->InsertNextValue(
      labelOf((surface.points[t[0]] + surface.points[t[1]] + surface.points[t[2]]) / 3.));
  }
  data->GetCellData()->AddArray(labels);
  return data;
}

/// Of a sphere of latitudes and longitudes: between them, each other triangle of a row is on the
/// other side.
vtkSmartPointer<vtkPolyData> jaggedHalves()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  sphere->Update();
  return labelled(
    fromPolyData(sphere->GetOutput()), [](const Vec3& x) { return x.z() > 0. ? 1 : 0; });
}

std::map<int, double> areas(vtkPolyData* data)
{
  const TriangleSurface surface = fromPolyData(data);
  vtkDataArray* labels = data->GetCellData()->GetArray("Part");
  std::map<int, double> result;
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    result[static_cast<int>(labels->GetComponent(f, 0))] += surface.faceArea(f);
  }
  return result;
}

/// Points inside the surface's regions bear cells of one label each: that of their place. No cell
/// can reach over a border then.
int crossings(vtkPolyData* input, vtkPolyData* mesh)
{
  vtkDataArray* wanted = input->GetCellData()->GetArray("Part");
  vtkDataArray* labels = mesh->GetCellData()->GetArray("Part");
  vtkDataArray* source = mesh->GetPointData()->GetArray("SourceCellId");
  vtkDataArray* kind = mesh->GetPointData()->GetArray("SampleKind");
  const TriangleSurface surface = fromPolyData(mesh);
  int count = 0;
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    for (const int p : surface.triangles[f])
    {
      const auto cell = static_cast<vtkIdType>(source->GetComponent(p, 0));
      count += kind->GetComponent(p, 0) == 0. &&
          wanted->GetComponent(cell, 0) != labels->GetComponent(f, 0)
        ? 1
        : 0;
    }
  }
  return count;
}
}

TEST(Regions, NumbersAndNames)
{
  vtkNew<vtkIntArray> ids;
  for (const int id : { 7, -1, 7, 3 })
  {
    ids->InsertNextValue(id);
  }
  EXPECT_EQ(numberRegions(ids), (std::vector<int>{ 2, 0, 2, 1 }));
  vtkNew<vtkStringArray> words;
  for (const char* word : { "skin", "bone", "skin" })
  {
    words->InsertNextValue(word);
  }
  EXPECT_EQ(numberRegions(words), (std::vector<int>{ 1, 0, 1 }));
  EXPECT_EQ(regionNamesOf("MaterialIds"), "MaterialNames");
  EXPECT_EQ(regionNamesOf("Part"), "PartNames");
  EXPECT_EQ(regionNamesOf("Id"), "IdNames");

  vtkNew<vtkPolyData> data;
  EXPECT_EQ(regionArrayName(data), "");
  setRegionArrayName(data, "Part");
  EXPECT_EQ(regionArrayName(data), "Part");
  vtkAbstractArray* found = nullptr;
  EXPECT_EQ(findRegions(data, "Part", found).message(),
    "The input has no cell array 'Part' of regions; it has none.");
  vtkNew<vtkIntArray> pairs;
  pairs->SetName("Part");
  pairs->SetNumberOfComponents(2);
  data->GetCellData()->AddArray(pairs);
  EXPECT_FALSE(findRegions(data, "Part", found).ok());
}

// A border to and fro across squares turns by a right angle at every point, but as a whole not at
// all; that of a square does at four.
TEST(Regions, BordersHaveTheCornersThatSeveralEdgesTell)
{
  CutSurface plate = shapes::cutSurface(shapes::saddle(16));
  const auto markBorder = [&plate](const std::function<bool(int column, int row)>& isIn) {
    for (const Halfedge h : plate.halfedges())
    {
      const auto in = [&](Halfedge halfedge) {
        const Triangle& t = plate.triangles[faceOf(halfedge).index()];
        const Vec3 c = (plate.points[t[0]] + plate.points[t[1]] + plate.points[t[2]]) / 3.;
        return isIn(static_cast<int>(8 * (c.x() + 1)), static_cast<int>(8 * (c.y() + 1)));
      };
      if (!plate.isBoundary(h) && in(h) != in(plate.twin[h]))
      {
        plate.setKeep(h, Keep::Border);
      }
    }
  };
  const auto cornersInside = [&plate] {
    const FeatureGraph graph = buildFeatureGraph(plate, 60.);
    std::set<int> corners;
    for (const Backbone& b : graph.backbones)
    {
      for (const int p : b.points)
      {
        const bool isInside = plate.points[p].head<2>().cwiseAbs().maxCoeff() < 0.7;
        if (b.keep == Keep::Border && graph.isCorner[p] && isInside)
        {
          corners.insert(p);
        }
      }
    }
    return corners.size();
  };
  markBorder(
    [](int column, int row) { return column >= 4 && column < 12 && row >= 4 && row < 12; });
  EXPECT_EQ(cornersInside(), 4U);

  plate = shapes::cutSurface(shapes::saddle(16));
  markBorder([](int column, int row) { return row < 8 + column % 2; });
  EXPECT_EQ(cornersInside(), 0U);
}

TEST(Regions, MeshesKeepThemExactly)
{
  const auto octant = [](const Vec3& x) {
    return (x.x() > 0 ? 1 : 0) + (x.y() > 0 ? 2 : 0) + (x.z() > 0 ? 4 : 0);
  };
  const auto stripes = [](const Vec3& x) { return static_cast<int>(std::floor(4 * x.x() + 100)); };
  const struct
  {
    const char* name;
    TriangleSurface surface;
    LabelOf labelOf;
    int points;
  } models[] = {
    { "torus", shapes::torus(2, 1, 96, 48), octant, 6000 },
    { "sphere", shapes::sphere(1, 5), octant, 6000 },
    { "slab", shapes::perforatedSlab(2, 1, 8), stripes, 4000 },
    { "saddle", shapes::saddle(32), stripes, 2000 },
    { "cube", shapes::cube(16),
      [](const Vec3& x) {
        Vec3::Index axis = 0;
        (x.array() - 0.5).abs().maxCoeff(&axis);
        return static_cast<int>(2 * axis) + (x[axis] > 0.5 ? 1 : 0);
      },
      2000 },
  };
  for (const auto& model : models)
  {
    SCOPED_TRACE(model.name);
    const auto input = labelled(model.surface, model.labelOf);
    vtkNew<vtkStringArray> names;
    names->SetName("PartNames");
    names->InsertNextValue("first");
    input->GetFieldData()->AddArray(names);
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(input);
    remesher->SetNumberOfPoints(model.points);
    remesher->GetAtlas()->SetRegionArrayName("Part");
    for (const int pattern : { vtkGeometryRemesher::TRIANGLES, vtkGeometryRemesher::SEMIREGULAR })
    {
      remesher->SetPattern(pattern);
      remesher->SetNumberOfSubdivisions(1);
      remesher->Update();
      vtkPolyData* mesh = remesher->GetOutput();
      ASSERT_GE(mesh->GetNumberOfPoints(), model.points);
      EXPECT_EQ(crossings(input, mesh), 0);
      EXPECT_EQ(regionArrayName(mesh), "Part");
      EXPECT_TRUE(mesh->GetFieldData()->HasArray("PartNames"));
      const auto before = areas(input);
      const auto after = areas(mesh);
      ASSERT_EQ(after.size(), before.size());
      double whole = 0;
      for (const auto& [label, area] : before)
      {
        whole += area;
      }
      for (const auto& [label, area] : before)
      {
        EXPECT_NEAR(after.at(label), area, 0.001 * whole) << label;
      }
    }
  }
}

// The seam runs along the border, too: it would cross each of 60 teeth twice.
TEST(Regions, SeamsAlongJaggedBordersDoNotCrossThem)
{
  const auto input = jaggedHalves();
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(input);
  remesher->GetAtlas()->SetRegionArrayName("Part");
  for (const int points : { 1000, 2000, 4000 })
  {
    remesher->SetNumberOfPoints(points);
    remesher->Update();
    EXPECT_GT(measureQuality(fromPolyData(remesher->GetOutput())).minimumAngle, 20.) << points;
  }
}

// The same border where edges are twice as long as its teeth are wide: tips may go, areas stay.
TEST(Regions, TeethThatAreFinerThanEdgesLeaveNoSlivers)
{
  const auto input = jaggedHalves();
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(input);
  remesher->GetAtlas()->SetRegionArrayName("Part");
  remesher->SetNumberOfPoints(500);
  remesher->Update();
  vtkPolyData* mesh = remesher->GetOutput();
  const MeshQuality q = measureQuality(fromPolyData(mesh));
  EXPECT_GT(q.minimumAngle, 20.);
  EXPECT_LT(q.percentBelow30, 2.);
  EXPECT_EQ(crossings(input, mesh), 0);
  const auto before = areas(input);
  const auto after = areas(mesh);
  ASSERT_EQ(after.size(), 2U);
  EXPECT_NEAR(after.at(0) / after.at(1), before.at(0) / before.at(1), 0.005);
}

// Stripes far narrower than the spacing: there is no good mesh of so few points, but a right one.
TEST(Regions, NarrowOnesStay)
{
  const auto input = labelled(shapes::saddle(40),
    [](const Vec3& x) { return static_cast<int>(std::floor(10 * (x.x() + 1))) % 2; });
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(input);
  remesher->SetNumberOfPoints(400);
  remesher->GetAtlas()->SetRegionArrayName("Part");
  remesher->Update();
  EXPECT_EQ(remesher->GetOutput()->GetNumberOfPoints(), 400);
  EXPECT_EQ(crossings(input, remesher->GetOutput()), 0);
  const auto before = areas(input);
  const auto after = areas(remesher->GetOutput());
  EXPECT_NEAR(after.at(0), before.at(0), 0.02 * before.at(0));
  EXPECT_NEAR(after.at(1), before.at(1), 0.02 * before.at(1));
}

TEST(Regions, AnArrayThatIsMissingIsAnError)
{
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(labelled(shapes::sphere(1, 2), [](const Vec3&) { return 0; }));
  atlas->SetRegionArrayName("Nothing");
  const int before = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  atlas->Update();
  vtkObject::SetGlobalWarningDisplay(before);
  EXPECT_EQ(atlas->GetErrorCode(), static_cast<unsigned long>(vtkGeometryRemesher::BAD_INPUT));
}
