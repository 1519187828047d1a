// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One atlas, read once: who shares it, and what makes a new one.
#include "Atlas.h"

#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDataArray.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

using namespace stipple;

namespace
{
class AtlasReads : public testing::Test
{
protected:
  vtkNew<vtkConformalAtlas> filter;
  vtkPartitionedDataSetCollection* charts = nullptr;
  vtkPolyData* graph = nullptr;

  void SetUp() override
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(16);
    this->filter->SetInputConnection(sphere->GetOutputPort());
    this->filter->Update();
    this->charts = this->filter->GetOutput();
    this->graph = vtkPolyData::SafeDownCast(this->filter->GetOutputDataObject(1));
  }
  static Atlas::Pointer read(vtkPartitionedDataSetCollection* charts, vtkPolyData* graph)
  {
    Atlas::Pointer atlas;
    const Status status = Atlas::read(charts, graph, atlas);
    EXPECT_TRUE(status.ok()) << status.message();
    return atlas;
  }
};
}

TEST_F(AtlasReads, AreSharedAsLongAsNothingChanges)
{
  const int before = Atlas::numberOfReads();
  const Atlas::Pointer first = read(this->charts, this->graph);
  EXPECT_EQ(read(this->charts, this->graph), first);
  const Atlas::Pointer chartsAlone = read(this->charts, nullptr);
  EXPECT_NE(chartsAlone, first);
  EXPECT_EQ(&chartsAlone->surface(), &first->surface());
  vtkNew<vtkPartitionedDataSetCollection> copy;
  copy->ShallowCopy(this->charts);
  EXPECT_EQ(read(copy, this->graph), first) << "a shallow copy has the same charts";
  EXPECT_EQ(Atlas::numberOfReads(), before + 1);

  vtkNew<vtkPartitionedDataSetCollection> deep;
  deep->DeepCopy(this->charts);
  EXPECT_NE(&read(deep, this->graph)->surface(), &first->surface());
  EXPECT_EQ(Atlas::numberOfReads(), before + 2);
}

TEST_F(AtlasReads, StopWhenAskedAndKeepNothing)
{
  Atlas::Pointer atlas;
  EXPECT_TRUE(Atlas::read(this->charts, this->graph, atlas, [] { return true; }).isAbort());
  EXPECT_EQ(atlas, nullptr);
  EXPECT_TRUE(Atlas::read(this->charts, this->graph, atlas, [] { return false; }).ok());
  EXPECT_NE(atlas, nullptr);
}

TEST_F(AtlasReads, NoticeWhatIsModified)
{
  const Atlas::Pointer first = read(this->charts, this->graph);
  vtkPolyData* chart = chartOf(this->charts, 0);
  vtkDataArray* ids = chart->GetPointData()->GetArray("SurfacePointId");
  const int point = static_cast<int>(ids->GetComponent(0, 0));
  const Vec3 old = first->surface().points[point];
  const Vec3 moved = 2 * old;
  for (unsigned int c = 0; c < this->charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    vtkPolyData* each = chartOf(this->charts, c);
    for (vtkIdType p = 0; p < each->GetNumberOfPoints(); ++p)
    {
      if (each->GetPointData()->GetArray("SurfacePointId")->GetComponent(p, 0) == point)
      {
        each->GetPoints()->SetPoint(p, moved.data());
        each->GetPoints()->Modified();
      }
    }
  }
  EXPECT_EQ(read(this->charts, this->graph)->surface().points[point], moved);
  EXPECT_EQ(first->surface().points[point], old) << "what was read does not change";

  const Atlas::Pointer second = read(this->charts, this->graph);
  this->graph->GetPointData()->GetArray("IsCorner")->Modified();
  const Atlas::Pointer third = read(this->charts, this->graph);
  EXPECT_NE(third, second);
  EXPECT_EQ(&third->surface(), &second->surface());
  ids->Modified();
  EXPECT_NE(&read(this->charts, this->graph)->surface(), &second->surface());
}

TEST_F(AtlasReads, AreForgottenWhenNobodyKeepsThem)
{
  const int before = Atlas::numberOfReads();
  read(this->charts, this->graph);
  read(this->charts, this->graph);
  EXPECT_EQ(Atlas::numberOfReads(), before + 2);
}

TEST_F(AtlasReads, AreDerivedOnceForAllThreads)
{
  const Atlas::Pointer atlas = read(this->charts, this->graph);
  std::vector<const SurfaceWalk*> walk(4);
  std::vector<std::thread> threads;
  for (const SurfaceWalk*& mine : walk)
  {
    threads.emplace_back([&] {
      mine = &atlas->walk();
      EXPECT_EQ(atlas->smoothNormals().size(), atlas->surface().triangles.size());
    });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(std::count(walk.begin(), walk.end(), walk.front()), 4);
  EXPECT_TRUE(atlas->topology() == atlas->surface().topology());
  const AtlasSurface& s = atlas->surface();
  for (const Face f : { Face(0), Face(s.numberOfFaces() - 1) })
  {
    // Lengths of a side, in space and by the metric of the plane.
    const Vec2 step = s.cornerUV(f, 1) - s.cornerUV(f, 0);
    const double length = s.edgeLength(halfedgeOf(f, 0));
    EXPECT_NEAR(atlas->metric()[f].squared(step), length * length, 1e-5 * length * length);
    EXPECT_NEAR(atlas->smoothNormal(f).norm(), 1, 1e-12);
  }
  const VertexNeighbours& n = atlas->vertexNeighbours();
  const Vertex v = s.head(n.outgoing[Vertex(0)]);
  EXPECT_EQ(std::count(n.of[0].begin(), n.of[0].end(), v.index()), 1);
}

TEST(AtlasReadsOfAWholeRun, AreOne)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(30);
  sphere->SetPhiResolution(20);
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputConnection(sphere->GetOutputPort());
  remesher->SetNumberOfPoints(500);
  remesher->GetMapRenderer()->SetBackendToCPU();
  const auto readsOfUpdate = [&] {
    const int before = Atlas::numberOfReads();
    remesher->Update();
    EXPECT_EQ(remesher->GetOutput()->GetNumberOfPoints(), remesher->GetNumberOfPoints());
    return Atlas::numberOfReads() - before;
  };
  EXPECT_EQ(readsOfUpdate(), 1);
  remesher->SetImportanceToMean();
  remesher->SetGamma(0.5);
  EXPECT_EQ(readsOfUpdate(), 0) << "a new gamma";
  remesher->SetGradation(2);
  remesher->GetControlMap()->AddStroke(0.5, 0, 0, 0.1, 1);
  EXPECT_EQ(readsOfUpdate(), 0) << "gradation and a stroke";
  remesher->SetNumberOfPoints(600);
  EXPECT_EQ(readsOfUpdate(), 0) << "more points";
  remesher->SetNumberOfCharts(4);
  EXPECT_EQ(readsOfUpdate(), 1) << "another atlas";
}
