// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Users are invited to put filters of their own between the stages: whatever these do to an array,
// the answer is one sentence that names it, not a crash and not gigabytes.
#include "Atlas.h"
#include "PolyDataConversion.h"
#include "UserArrays.h"

#include "vtkCDTRemesh.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDoubleArray.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

using namespace stipple;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Huge = 4294967296.; // 2^32: an int makes 0 of it

/// Counts the errors of an algorithm, and keeps the last.
struct Errors
{
  int count = 0;
  std::string last;
  vtkNew<vtkCallbackCommand> command;

  explicit Errors(vtkAlgorithm* algorithm)
  {
    this->command->SetClientData(this);
    this->command->SetCallback([](vtkObject*, unsigned long, void* self, void* text) {
      ++static_cast<Errors*>(self)->count;
      static_cast<Errors*>(self)->last = static_cast<const char*>(text);
    });
    algorithm->AddObserver(vtkCommand::ErrorEvent, this->command);
  }
};

/// A sphere's atlas of four charts with a constraint, and 200 samples of it.
struct Stages
{
  vtkNew<vtkConformalAtlas> atlas;
  vtkNew<vtkErrorDiffusionSampler> sampler;

  Stages()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(16);
    vtkNew<vtkPoints> constraints;
    constraints->InsertNextPoint(0.3, 0.3, 0.3);
    this->atlas->SetInputConnection(sphere->GetOutputPort());
    this->atlas->SetConstraints(constraints);
    this->atlas->SetNumberOfCharts(4); // seams meet
    vtkNew<vtkGeometryMapRenderer> maps;
    maps->SetInputConnection(this->atlas->GetOutputPort());
    maps->SetMapSize(64);
    maps->SetBackendToCPU();
    vtkNew<vtkControlMap> control;
    control->SetInputConnection(maps->GetOutputPort());
    this->sampler->SetInputConnection(0, control->GetOutputPort());
    this->sampler->SetInputConnection(1, this->atlas->GetOutputPort(0));
    this->sampler->SetInputConnection(2, this->atlas->GetOutputPort(1));
    this->sampler->SetNumberOfSamples(200);
    this->sampler->Update();
  }
};

class UserArrays : public testing::Test
{
protected:
  vtkNew<vtkPartitionedDataSetCollection> charts;
  vtkNew<vtkPolyData> graph;
  vtkNew<vtkPolyData> samples;
  vtkPolyData* chart = nullptr;

  void SetUp() override
  {
    static Stages stages;
    this->charts->DeepCopy(stages.atlas->GetOutput());
    this->graph->DeepCopy(stages.atlas->GetOutputDataObject(1));
    this->samples->DeepCopy(stages.sampler->GetOutputDataObject(0));
    this->chart = chartOf(this->charts, 1);
    ASSERT_EQ(this->read(), "");
    ASSERT_GT(this->graph->GetNumberOfVerts(), 0);
  }

  /// What is said of charts, graph and samples; nothing if they are sound.
  std::string read()
  {
    Atlas::Pointer atlas;
    Status status = Atlas::read(this->charts, this->graph, atlas);
    std::vector<Sample> list;
    if (status.ok())
    {
      status = readSamples(this->samples, *atlas, list);
    }
    return status.message();
  }

  /// Puts another value into a copy of an array, and the array back when it was refused.
  void expectRefused(
    vtkFieldData* data, const char* name, vtkIdType tuple, double value, int component = 0)
  {
    vtkSmartPointer<vtkDataArray> good = data->GetArray(name);
    ASSERT_NE(good, nullptr) << name;
    vtkNew<vtkDoubleArray> bad;
    bad->DeepCopy(good);
    bad->SetName(name);
    bad->SetComponent(tuple, component, value);
    this->expectRefused(data, bad, name + (" of " + std::to_string(value)));
    data->AddArray(good);
  }
  void expectRefused(vtkFieldData* data, vtkDataArray* bad, const std::string& what)
  {
    data->AddArray(bad);
    const std::string message = this->read();
    EXPECT_NE(message.find(bad->GetName()), std::string::npos) << what << ": " << message;
  }

  /// Neither too few tuples, nor other components, nor none.
  void expectShape(vtkFieldData* data, const char* name)
  {
    vtkSmartPointer<vtkDataArray> good = data->GetArray(name);
    ASSERT_NE(good, nullptr) << name;
    const int components = good->GetNumberOfComponents();
    vtkNew<vtkDoubleArray> few;
    few->SetName(name);
    few->SetNumberOfComponents(components);
    few->SetNumberOfTuples(good->GetNumberOfTuples() - 1);
    few->Fill(0);
    this->expectRefused(data, few, "too few tuples");
    vtkNew<vtkDoubleArray> wide;
    wide->SetName(name);
    wide->SetNumberOfComponents(components + 1);
    wide->SetNumberOfTuples(good->GetNumberOfTuples());
    wide->Fill(0);
    this->expectRefused(data, wide, "too many components");
    data->RemoveArray(name);
    EXPECT_NE(this->read().find(name), std::string::npos) << name << " is missing";
    data->AddArray(good);
    ASSERT_EQ(this->read(), "");
  }

  /// Puts another point into a cell.
  void expectCellRefused(vtkPolyData* data, vtkCellArray* cells, vtkIdType point)
  {
    vtkSmartPointer<vtkCellArray> good = cells;
    vtkNew<vtkCellArray> bad;
    bad->DeepCopy(good);
    vtkIdType size;
    const vtkIdType* ids;
    bad->GetCellAtId(0, size, ids);
    std::vector<vtkIdType> other(ids, ids + size);
    other[0] = point;
    bad->ReplaceCellAtId(0, size, other.data());
    (cells == data->GetLines() ? data->SetLines(bad) : data->SetPolys(bad));
    EXPECT_NE(this->read().find("has the point"), std::string::npos) << point;
    (data->GetLines() == bad.Get() ? data->SetLines(good) : data->SetPolys(good));
    ASSERT_EQ(this->read(), "");
  }

  vtkIdType sampleOf(SampleKind kind)
  {
    vtkDataArray* array = this->samples->GetPointData()->GetArray("SampleKind");
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      if (array->GetComponent(i, 0) == static_cast<int>(kind))
      {
        return i;
      }
    }
    ADD_FAILURE() << "no sample of kind " << static_cast<int>(kind);
    return 0;
  }
};
}

TEST_F(UserArrays, Charts)
{
  vtkPointData* points = this->chart->GetPointData();
  for (const double id : { -1., -2147483648., Huge, 2147483646., 0.5, NaN })
  {
    this->expectRefused(points, "SurfacePointId", 3, id);
  }
  for (const double id : { -1., Huge, NaN })
  {
    this->expectRefused(this->chart->GetCellData(), "SourceCellId", 2, id);
  }
  this->expectRefused(points, "UV", 5, NaN, 1);
  for (const double extent : { 0., -1., NaN, HUGE_VAL })
  {
    this->expectRefused(this->chart->GetFieldData(), "ChartExtent", 0, extent, 1);
  }
  this->expectShape(points, "UV");
  this->expectShape(points, "SurfacePointId");
  this->expectShape(this->chart->GetCellData(), "SourceCellId");
  this->expectShape(this->chart->GetFieldData(), "ChartExtent");
  for (const vtkIdType point : { vtkIdType(-1), vtkIdType(1000000), vtkIdType(1) << 32 })
  {
    this->expectCellRefused(this->chart, this->chart->GetPolys(), point);
  }
  this->charts->SetPartition(1, 0, nullptr);
  EXPECT_NE(this->read().find("Chart 1 is no vtkPolyData"), std::string::npos);
}

TEST_F(UserArrays, FeatureGraph)
{
  vtkPointData* points = this->graph->GetPointData();
  vtkIdType size;
  const vtkIdType* ids;
  this->graph->GetVerts()->GetCellAtId(0, size, ids);
  const vtkIdType constraint = ids[0];
  this->graph->GetLines()->GetCellAtId(0, size, ids);
  const vtkIdType onLine = ids[0];
  const vtkIdType line = this->graph->GetNumberOfVerts();
  for (const double id : { -1., -7., 1e6, Huge, NaN })
  {
    this->expectRefused(points, "SurfacePointId", onLine, id);
    this->expectRefused(points, "ChartId", constraint, id);
    this->expectRefused(points, "ChartCellId", constraint, id);
    this->expectRefused(this->graph->GetCellData(), "BackboneType", line, id);
    this->expectRefused(this->graph->GetCellData(), "Keep", line, id);
  }
  this->expectRefused(points, "BarycentricCoordinates", constraint, NaN, 1);
  this->expectRefused(points, "BarycentricCoordinates", constraint, 5., 2);
  for (const char* name :
    { "SurfacePointId", "IsCorner", "ChartId", "ChartCellId", "BarycentricCoordinates" })
  {
    this->expectShape(points, name);
  }
  this->expectShape(this->graph->GetCellData(), "BackboneType");
  this->expectShape(this->graph->GetCellData(), "Keep");
  this->expectShape(this->graph->GetCellData(), "Closed");
  for (const char* name : { "Width", "Pitch" })
  {
    this->expectRefused(this->graph->GetCellData(), name, line, NaN);
    this->expectRefused(this->graph->GetCellData(), name, line, -1.);
  }
  for (const vtkIdType point : { -1, 1000000 })
  {
    this->expectCellRefused(this->graph, this->graph->GetLines(), point);
  }
  vtkNew<vtkCellArray> dot;
  dot->InsertNextCell(1, &onLine);
  for (vtkIdType i = 1; i < this->graph->GetNumberOfLines(); ++i)
  {
    this->graph->GetLines()->GetCellAtId(i, size, ids);
    dot->InsertNextCell(size, ids);
  }
  this->graph->SetLines(dot);
  EXPECT_NE(this->read().find("backbone 0 of the feature graph has 1 points"), std::string::npos);
}

TEST_F(UserArrays, Samples)
{
  vtkPointData* points = this->samples->GetPointData();
  const vtkIdType onBackbone = this->sampleOf(SampleKind::Backbone);
  const vtkIdType corner = this->sampleOf(SampleKind::Corner);
  for (const double id : { -1., 1e9, Huge, NaN })
  {
    this->expectRefused(points, "SampleKind", 1, id);
    this->expectRefused(points, "ChartId", 1, id);
    this->expectRefused(points, "ChartCellId", 1, id);
    this->expectRefused(points, "BackboneId", onBackbone, id);
    this->expectRefused(points, "SurfacePointId", corner, id);
  }
  this->expectRefused(points, "BarycentricCoordinates", 1, NaN);
  this->expectRefused(points, "BarycentricCoordinates", 1, 1e9);
  this->expectRefused(points, "ArcLength", onBackbone, NaN);
  for (const char* name : { "SampleKind", "ChartId", "ChartCellId", "BarycentricCoordinates",
         "BackboneId", "ArcLength", "SurfacePointId" })
  {
    this->expectShape(points, name);
  }
}

TEST_F(UserArrays, FiltersSayItOnceAndGiveNothing)
{
  vtkNew<vtkDoubleArray> bad;
  bad->DeepCopy(this->chart->GetPointData()->GetArray("SurfacePointId"));
  bad->SetName("SurfacePointId");
  bad->SetComponent(0, 0, -5);
  this->chart->GetPointData()->AddArray(bad);
  vtkNew<vtkCDTRemesh> mesher;
  mesher->SetInputDataObject(0, this->samples);
  mesher->SetInputDataObject(1, this->charts);
  mesher->SetInputDataObject(2, this->graph);
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(0, this->charts);
  for (vtkAlgorithm* filter :
    { static_cast<vtkAlgorithm*>(mesher), static_cast<vtkAlgorithm*>(maps) })
  {
    Errors errors(filter);
    vtkNew<vtkCallbackCommand> quiet;
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet);
    filter->Update();
    EXPECT_EQ(errors.count, 1) << filter->GetClassName();
    EXPECT_NE(errors.last.find("SurfacePointId of point 0 of chart 1 is -5"), std::string::npos)
      << errors.last;
  }
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MalformedPolyData, IsRefusedByTheAtlas)
{
  const auto refused = [](vtkPolyData* input) {
    vtkNew<vtkConformalAtlas> atlas;
    Errors errors(atlas);
    vtkNew<vtkCallbackCommand> quiet;
    atlas->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet);
    atlas->SetInputData(input);
    atlas->Update();
    EXPECT_EQ(errors.count, 1) << errors.last;
    EXPECT_EQ(atlas->GetOutput()->GetNumberOfPartitionedDataSets(), 0U);
    return errors.last;
  };
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkPolyData> input;
  for (const vtkIdType point : { -1, -7, 77, 1000000 })
  {
    input->DeepCopy(sphere->GetOutput());
    const vtkIdType ids[3] = { 0, point, 2 };
    input->GetPolys()->ReplaceCellAtId(4, 3, ids);
    EXPECT_NE(refused(input).find("has the point " + std::to_string(point)), std::string::npos);
  }
  input->DeepCopy(sphere->GetOutput());
  input->SetPoints(nullptr);
  EXPECT_NE(refused(input).find("there are 0 points"), std::string::npos);

  input->DeepCopy(sphere->GetOutput());
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  for (const vtkIdType offset : { 0, 3, 9000 })
  {
    offsets->InsertNextValue(offset);
  }
  for (const vtkIdType id : { 0, 1, 2, 3, 4, 5 })
  {
    connectivity->InsertNextValue(id);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  input->SetPolys(cells);
  input->GetCellData()->Initialize();
  EXPECT_NE(refused(input).find("contradict"), std::string::npos);

  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  names->InsertNextValue("only one");
  input->DeepCopy(sphere->GetOutput());
  input->GetPointData()->AddArray(names);
  EXPECT_NE(refused(input).find("Names"), std::string::npos);
}

TEST(CheckedNumbers, AreThoseOfAnInt)
{
  EXPECT_EQ(indexBelow(4., 5), 4);
  EXPECT_EQ(indexBelow(5., 5), -1);
  EXPECT_EQ(indexBelow(NaN, 5), -1);
  int count = 0;
  EXPECT_TRUE(checkedCount(7, "points", count).ok());
  EXPECT_EQ(count, 7);
  const Status status = checkedCount(vtkIdType(1) << 33, "points", count);
  EXPECT_NE(status.message().find("8589934592 points"), std::string::npos);
}
