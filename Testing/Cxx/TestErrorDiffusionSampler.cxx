// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The sampler in its pipeline: exact counts, the contract's arrays, halftones, execution on demand,
// errors.
#include "Check.h"
#include "SyntheticAtlas.h"

#include "vtkCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <string>

namespace
{
using test::check;

/// Counts the executions of a filter.
struct Executions
{
  explicit Executions(vtkAlgorithm* filter)
  {
    filter->AddObserver(vtkCommand::StartEvent, this, &Executions::count);
  }
  void count() { ++this->number; }
  int number = 0;
};

struct Pipeline
{
  vtkNew<vtkConformalAtlas> atlas;
  vtkNew<vtkGeometryMapRenderer> maps;
  vtkNew<vtkControlMap> control;
  vtkNew<vtkErrorDiffusionSampler> sampler;
  vtkNew<vtkTest::ErrorObserver> observer;
  explicit Pipeline(vtkAlgorithm* source)
  {
    this->atlas->SetInputConnection(source->GetOutputPort());
    this->maps->SetInputConnection(this->atlas->GetOutputPort(0));
    this->maps->SetBackendToCPU();
    this->control->SetInputConnection(this->maps->GetOutputPort());
    this->sampler->SetInputConnection(0, this->control->GetOutputPort());
    this->sampler->SetInputConnection(1, this->atlas->GetOutputPort(0));
    this->sampler->SetInputConnection(2, this->atlas->GetOutputPort(1));
    this->sampler->AddObserver(vtkCommand::ErrorEvent, this->observer);
    this->sampler->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->observer);
  }
};

void checkContract(vtkErrorDiffusionSampler* sampler, const std::string& name)
{
  vtkPolyData* samples = sampler->GetOutput();
  const vtkIdType n = samples->GetNumberOfPoints();
  check(samples->GetNumberOfVerts() == n, name + ": a vertex a sample");
  const std::pair<const char*, int> arrays[] = { { "SampleKind", 1 }, { "ChartId", 1 },
    { "ChartCellId", 1 }, { "BarycentricCoordinates", 3 }, { "UV", 2 }, { "SourceCellId", 1 },
    { "BackboneId", 1 }, { "ArcLength", 1 }, { "SurfacePointId", 1 }, { "Density", 1 } };
  for (const auto& [array, components] : arrays)
  {
    vtkDataArray* data = samples->GetPointData()->GetArray(array);
    check(data && data->GetNumberOfTuples() == n && data->GetNumberOfComponents() == components,
      name + ": array " + array);
  }
  // Black pixels: as many as samples inside charts at most, and as those on backbones on both
  // sides.
  auto* control = vtkPartitionedDataSetCollection::SafeDownCast(sampler->GetInputDataObject(0, 0));
  vtkPartitionedDataSetCollection* halftones = sampler->GetHalftones();
  check(halftones->GetNumberOfPartitionedDataSets() == control->GetNumberOfPartitionedDataSets(),
    name + ": a halftone a chart");
  vtkIdType black = 0;
  for (unsigned int c = 0; c < halftones->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* image = vtkImageData::SafeDownCast(halftones->GetPartition(c, 0));
    auto* pixels = image
      ? vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetArray("Halftone"))
      : nullptr;
    check(pixels && image->GetPointData()->GetScalars() == pixels &&
        image->GetPointData()->GetArray("AreaDistortion"),
      name + ": Halftone is the active scalars, beside the other arrays");
    for (vtkIdType i = 0; pixels && i < pixels->GetNumberOfValues(); ++i)
    {
      check(pixels->GetValue(i) == 0 || pixels->GetValue(i) == 255, name + ": black or white");
      black += pixels->GetValue(i) == 0;
    }
  }
  vtkIdType inside = 0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    inside += samples->GetPointData()->GetArray("SampleKind")->GetComponent(i, 0) == 0;
  }
  check(black >= inside && black <= inside + 3 * (n - inside),
    name + ": black pixels are the samples: " + std::to_string(black) + " " +
      std::to_string(inside) + " " + std::to_string(n));
}

void testPipeline(vtkAlgorithm* source, const std::string& name)
{
  Pipeline p(source);
  p.maps->SetNumberOfSamples(20000);
  p.sampler->SetNumberOfSamples(0);
  p.sampler->Update();
  const int least = p.sampler->GetMinimumNumberOfSamples();
  check(least > 0 &&
      p.observer->GetErrorMessage().find("at least " + std::to_string(least)) != std::string::npos,
    name + ": too few is an error that names the least: " + p.observer->GetErrorMessage());
  check(p.sampler->GetOutput()->GetNumberOfPoints() == 0, name + ": and empties the output");
  p.observer->Clear();
  for (int importance : { vtkControlMap::UNIFORM, vtkControlMap::MEAN, vtkControlMap::L2 })
  {
    p.control->SetImportance(importance);
    for (int n : { least, least + 1, 100 + least, 1000, 20000 })
    {
      p.sampler->SetNumberOfSamples(n);
      p.sampler->Update();
      check(
        p.sampler->GetOutput()->GetNumberOfPoints() == n, name + ": exactly " + std::to_string(n));
    }
  }
  check(!p.observer->GetError(), name + ": " + p.observer->GetErrorMessage());
  checkContract(p.sampler, name);
}

void testOnDemand()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  Pipeline p(sphere);
  Executions atlas(p.atlas);
  Executions maps(p.maps);
  Executions control(p.control);
  Executions sampler(p.sampler);
  p.sampler->SetNumberOfSamples(700);
  p.sampler->Update();
  p.sampler->SetNumberOfSamples(800);
  p.sampler->Update();
  check(sampler.number == 2 && control.number == 1, "a count re-executes the sampler alone");
  p.control->SetImportanceToMean();
  p.control->SetGamma(0.);
  p.sampler->Update();
  check(sampler.number == 3 && control.number == 2 && maps.number == 1 && atlas.number == 1,
    "importance and gamma re-execute from the control map on");
  vtkNew<vtkPolyData> withMean;
  withMean->DeepCopy(p.sampler->GetOutput());
  p.control->SetImportanceToUniform();
  p.sampler->Update();
  double a[3];
  double b[3];
  bool same = true;
  for (vtkIdType i = 0; i < 800; ++i)
  {
    withMean->GetPoint(i, a);
    p.sampler->GetOutput()->GetPoint(i, b);
    same = same && std::equal(a, a + 3, b);
  }
  check(same, "gamma 0 is uniform");
  sphere->SetThetaResolution(44);
  p.sampler->Update();
  check(p.sampler->GetOutput()->GetNumberOfPoints() == 800 && atlas.number == 2,
    "a new surface is taken");
}

void testOtherArrayTypes()
{
  // What an imaging filter may leave: Control in double, and by another name, but as active
  // scalars.
  synthetic::Builder builder;
  synthetic::bumpyGrid(builder, 2, 8);
  synthetic::MadeAtlas& atlas = builder.finish();
  for (unsigned int c = 0; c < 4; ++c)
  {
    vtkNew<vtkDoubleArray> area;
    area->SetName("AreaDistortion");
    for (int f = atlas.surface.chartBegin[c]; f < atlas.surface.chartBegin[c + 1]; ++f)
    {
      area->InsertNextValue(atlas.surface.areaDistortion(f));
    }
    stipple::chartOf(atlas.charts, c)->GetCellData()->AddArray(area);
  }
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetBackendToCPU();
  maps->SetInputDataObject(atlas.charts);
  maps->GetMapSelection()->DisableAllArrays();
  maps->GetMapSelection()->EnableArray("AreaDistortion");
  maps->GetMapSelection()->EnableArray("FaceIndex");
  maps->Update();
  vtkNew<vtkPartitionedDataSetCollection> images;
  for (unsigned int c = 0; c < 4; ++c)
  {
    vtkNew<vtkImageData> image;
    image->ShallowCopy(maps->GetOutput()->GetPartition(c, 0));
    vtkNew<vtkDoubleArray> control;
    control->SetName("Smoothed");
    control->DeepCopy(image->GetPointData()->GetArray("AreaDistortion"));
    control->SetName("Smoothed");
    image->GetPointData()->SetScalars(control);
    images->SetPartition(c, 0, image);
  }
  vtkNew<vtkErrorDiffusionSampler> sampler;
  vtkNew<vtkTest::ErrorObserver> observer;
  sampler->AddObserver(vtkCommand::ErrorEvent, observer);
  sampler->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  sampler->SetInputDataObject(0, images);
  sampler->SetInputDataObject(1, atlas.charts);
  sampler->SetInputDataObject(2, atlas.graphData);
  sampler->SetNumberOfSamples(321);
  sampler->Update();
  check(sampler->GetOutput()->GetNumberOfPoints() == 321, "scalars of any type will do");
  checkContract(sampler, "other types");
  vtkImageData::SafeDownCast(images->GetPartition(2, 0))->GetPointData()->RemoveArray("FaceIndex");
  sampler->Modified();
  sampler->Update();
  check(observer->GetErrorMessage().find("Control image 2") != std::string::npos,
    "a missing array is named");
  observer->Clear();
  images->RemovePartitionedDataSet(3);
  sampler->Modified();
  sampler->Update();
  check(observer->GetErrorMessage().find("3 control images and 4 charts") != std::string::npos,
    "images of another atlas are refused");
  observer->Clear();
  vtkNew<vtkPartitionedDataSetCollection> nothing;
  vtkNew<vtkPolyData> noGraph;
  sampler->SetInputDataObject(0, nothing);
  sampler->SetInputDataObject(1, nothing);
  sampler->SetInputDataObject(2, noGraph);
  sampler->Update();
  check(!observer->GetError() && sampler->GetOutput()->GetNumberOfPoints() == 0,
    "empty input is success");
}

void testAbort()
{
  vtkNew<vtkSphereSource> sphere;
  Pipeline p(sphere);
  p.sampler->SetNumberOfSamples(500);
  p.control->Update();
  const unsigned long tag = p.sampler->AddObserver(
    vtkCommand::ProgressEvent, p.sampler.Get(), &vtkAlgorithm::AbortExecuteOn);
  p.sampler->Update();
  check(p.sampler->GetOutput()->GetNumberOfPoints() == 0 &&
      p.observer->GetErrorMessage().find("samples") == std::string::npos,
    "an abort leaves nothing, and is no error of the filter");
  p.sampler->RemoveObserver(tag);
  p.sampler->AbortExecuteOff();
  p.sampler->Modified();
  p.sampler->Update();
  check(p.sampler->GetOutput()->GetNumberOfPoints() == 500, "and the next update is whole");
}
}

int TestErrorDiffusionSampler(int, char*[])
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(50);
  sphere->SetPhiResolution(40);
  testPipeline(sphere, "sphere");
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(20, 30);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  testPipeline(triangles, "plane");
  testOnDemand();
  testOtherArrayTypes();
  testAbort();
  return test::exitStatus();
}
