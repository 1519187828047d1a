// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Ghost cells against rings that are grown over the whole mesh.
#include "BlockGhosts.h"

#include "Shapes.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPGeometryRemesher.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

using namespace stipple;

namespace
{
using Corners = std::array<vtkIdType, 3>; // by global ids, the least first

vtkPolyData* partition(vtkPartitionedDataSet* blocks, unsigned int b)
{
  return vtkPolyData::SafeDownCast(blocks->GetPartitionAsDataObject(b));
}

vtkIdType globalId(vtkPolyData* data, vtkIdType p)
{
  return static_cast<vtkIdType>(data->GetPointData()->GetGlobalIds()->GetComponent(p, 0));
}

Corners cornersOf(vtkPolyData* data, vtkIdType t)
{
  vtkNew<vtkIdList> points;
  data->GetPolys()->GetCellAtId(t, points);
  Corners corners = { { globalId(data, points->GetId(0)), globalId(data, points->GetId(1)),
    globalId(data, points->GetId(2)) } };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// A surface whose triangles are dealt to partitions by a rule, with arrays that tell points and
/// triangles from one another.
vtkSmartPointer<vtkPartitionedDataSet> dealt(
  const TriangleSurface& surface, int partitions, const std::function<int(const Vec3&)>& rule)
{
  auto blocks = vtkSmartPointer<vtkPartitionedDataSet>::New();
  blocks->SetNumberOfPartitions(static_cast<unsigned int>(partitions));
  for (int b = 0; b < partitions; ++b)
  {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("Ids");
    vtkNew<vtkIntArray> number;
    number->SetName("Triangle");
    vtkNew<vtkStringArray> names;
    names->SetName("Names");
    std::map<int, vtkIdType> newId;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const Triangle& c = surface.triangles[t];
      if (rule((surface.points[c[0]] + surface.points[c[1]] + surface.points[c[2]]) / 3.) != b)
      {
        continue;
      }
      Corners corners = {};
      for (int k = 0; k < 3; ++k)
      {
        const auto [found, isNew] = newId.try_emplace(c[k], points->GetNumberOfPoints());
        if (isNew)
        {
          points->InsertNextPoint(surface.points[c[k]].data());
          ids->InsertNextValue(c[k]);
          names->InsertNextValue("point " + std::to_string(c[k]));
        }
        corners[k] = found->second;
      }
      cells->InsertNextCell(3, corners.data());
      number->InsertNextValue(static_cast<int>(t));
    }
    if (number->GetNumberOfTuples() > 0)
    {
      data->SetPoints(points);
      data->SetPolys(cells);
      data->GetPointData()->SetGlobalIds(ids);
      data->GetPointData()->AddArray(names);
      data->GetCellData()->AddArray(number);
      blocks->SetPartition(static_cast<unsigned int>(b), data);
    }
  }
  return blocks;
}

/// Triangles that so many rings about a set have, without the set.
std::set<Corners> rings(const std::set<Corners>& all, const std::set<Corners>& inside, int levels)
{
  std::set<Corners> grown = inside;
  for (int level = 0; level < levels; ++level)
  {
    std::set<vtkIdType> points;
    for (const Corners& c : grown)
    {
      points.insert(c.begin(), c.end());
    }
    for (const Corners& c : all)
    {
      if (std::any_of(c.begin(), c.end(), [&](vtkIdType p) { return points.count(p) > 0; }))
      {
        grown.insert(c);
      }
    }
  }
  std::set<Corners> result;
  std::set_difference(
    grown.begin(), grown.end(), inside.begin(), inside.end(), std::inserter(result, result.end()));
  return result;
}

struct Triangles
{
  std::set<Corners> own;
  std::set<Corners> ghosts;
};

Triangles trianglesOf(vtkPolyData* data)
{
  Triangles result;
  for (vtkIdType t = 0; t < data->GetNumberOfPolys(); ++t)
  {
    vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
    auto& list = ghosts && ghosts->GetValue(t) != 0 ? result.ghosts : result.own;
    EXPECT_TRUE(list.insert(cornersOf(data, t)).second) << "a triangle is there twice";
  }
  return result;
}

int slab(const Vec3& centre)
{
  return std::clamp(static_cast<int>(2. + 2. * centre.x()), 0, 3); // a partition has no triangle
}
}

TEST(BlockGhosts, areTheRingsAboutAPartition)
{
  const TriangleSurface surface = shapes::sphere(0.9, 3);
  for (const int levels : { 1, 2, 5 })
  {
    const auto blocks = dealt(surface, 5, slab);
    std::set<Corners> all;
    for (unsigned int b = 0; b < 4; ++b)
    {
      const Triangles part = trianglesOf(partition(blocks, b));
      all.insert(part.own.begin(), part.own.end());
    }
    ASSERT_EQ(all.size(), surface.triangles.size());
    ASSERT_TRUE(addGhostCells(levels, RankMessages(nullptr), blocks).ok());
    EXPECT_EQ(partition(blocks, 4), nullptr);
    std::map<vtkIdType, int> isOwned;
    for (unsigned int b = 0; b < 4; ++b)
    {
      vtkPolyData* data = partition(blocks, b);
      const Triangles part = trianglesOf(data);
      EXPECT_FALSE(part.ghosts.empty());
      EXPECT_EQ(part.ghosts, rings(all, part.own, levels));
      ASSERT_EQ(data->GetPointData()->GetNumberOfTuples(), data->GetNumberOfPoints());
      ASSERT_EQ(data->GetCellData()->GetNumberOfTuples(), data->GetNumberOfPolys());
      auto* names = vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray("Names"));
      for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
      {
        const vtkIdType id = globalId(data, p);
        EXPECT_EQ(names->GetValue(p), "point " + std::to_string(id));
        EXPECT_EQ(Vec3(data->GetPoint(p)), surface.points[static_cast<std::size_t>(id)]);
        isOwned[id] += data->GetPointGhostArray()->GetValue(p) == 0 ? 1 : 0;
      }
      auto* number = vtkIntArray::SafeDownCast(data->GetCellData()->GetArray("Triangle"));
      for (vtkIdType t = 0; t < data->GetNumberOfPolys(); ++t)
      {
        Triangle corners = surface.triangles[static_cast<std::size_t>(number->GetValue(t))];
        std::rotate(
          corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        EXPECT_EQ(cornersOf(data, t), (Corners{ { corners[0], corners[1], corners[2] } }));
      }
    }
    EXPECT_EQ(isOwned.size(), surface.points.size());
    EXPECT_TRUE(std::all_of(
      isOwned.begin(), isOwned.end(), [](const auto& point) { return point.second == 1; }));
  }
}

TEST(BlockGhosts, noneLeavePartitionsAsTheyAre)
{
  const auto blocks = dealt(shapes::sphere(0.9, 2), 5, slab);
  ASSERT_TRUE(addGhostCells(0, RankMessages(nullptr), blocks).ok());
  EXPECT_EQ(partition(blocks, 0)->GetPointGhostArray(), nullptr);
  EXPECT_EQ(partition(blocks, 0)->GetCellGhostArray(), nullptr);
}

TEST(BlockGhosts, areLeftOutOfASurface)
{
  const auto blocks = dealt(shapes::sphere(0.9, 3), 4, slab);
  const auto before = dealt(shapes::sphere(0.9, 3), 4, slab);
  ASSERT_TRUE(addGhostCells(2, RankMessages(nullptr), blocks).ok());
  for (unsigned int b = 0; b < 4; ++b)
  {
    const vtkSmartPointer<vtkPolyData> own = withoutGhosts(partition(blocks, b));
    EXPECT_EQ(trianglesOf(own).own, trianglesOf(partition(before, b)).own);
    EXPECT_FALSE(own->GetPointData()->HasArray("vtkGhostType"));
    EXPECT_FALSE(own->GetCellData()->HasArray("vtkGhostType"));
    EXPECT_EQ(withoutGhosts(own), own);
  }
}

TEST(BlockGhosts, comeWhenTheyAreAskedForAndAreNoPartOfTheInput)
{
  const auto sphere = shapes::toPolyData(shapes::sphere(1., 4));
  vtkNew<vtkPGeometryRemesher> remesher;
  remesher->SetInputDataObject(sphere);
  remesher->SetNumberOfPoints(600);
  remesher->SetTrianglesPerBlock(700);
  const auto ghosts = [&](vtkPGeometryRemesher* filter) {
    auto* mesh = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    std::array<std::size_t, 2> count = { { 0, 0 } };
    for (unsigned int b = 0; b < mesh->GetNumberOfPartitions(); ++b)
    {
      const Triangles triangles = trianglesOf(partition(mesh, b));
      count[0] += triangles.own.size();
      count[1] += triangles.ghosts.size();
    }
    return count;
  };
  remesher->Update();
  EXPECT_EQ(ghosts(remesher), (std::array<std::size_t, 2>{ { 1196, 0 } }));
  remesher->SetMinimumNumberOfGhostLevels(1);
  remesher->Update();
  const auto asked = ghosts(remesher);
  EXPECT_EQ(asked[0], 1196U);
  EXPECT_GT(asked[1], 0U);
  remesher->SetMinimumNumberOfGhostLevels(2);
  remesher->Update();
  EXPECT_EQ(ghosts(remesher)[0], 1196U);
  EXPECT_GT(ghosts(remesher)[1], asked[1]);

  vtkNew<vtkPGeometryRemesher> again;
  again->SetInputDataObject(remesher->GetOutputDataObject(0));
  again->SetNumberOfPoints(300);
  again->SetTrianglesPerBlock(700);
  again->Update();
  EXPECT_EQ(ghosts(again), (std::array<std::size_t, 2>{ { 596, 0 } }));
}
