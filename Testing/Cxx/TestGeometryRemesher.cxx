// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The whole pipeline as one filter: what it hands out, what executes again, errors, progress and
// abort.
#include "Check.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"

#include "vtkCDTRemesh.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkCubeSource.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkExecutive.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace
{
using test::check;

/// Counts how often each stage executes.
class Executions
{
public:
  explicit Executions(vtkGeometryRemesher* remesher)
  {
    const std::array<vtkAlgorithm*, 6> stages = { { remesher->GetAtlas(),
      remesher->GetMapRenderer(), remesher->GetControlMap(), remesher->GetSampler(),
      remesher->GetMesher(), remesher->GetOptimizer() } };
    for (int i = 0; i < 6; ++i)
    {
      vtkNew<vtkCallbackCommand> command;
      command->SetClientData(&this->Count[i]);
      command->SetCallback(
        [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
      stages[i]->AddObserver(vtkCommand::StartEvent, command);
    }
  }
  void expect(const std::array<int, 6>& wanted, const std::string& what)
  {
    static const char* names[6] = { "atlas", "maps", "control", "sampler", "mesher", "optimizer" };
    for (int i = 0; i < 6; ++i)
    {
      check(this->Count[i] == wanted[i],
        what + ": the " + names[i] + " executed " + std::to_string(this->Count[i]) +
          " times, not " + std::to_string(wanted[i]));
    }
    this->Count.fill(0);
  }

private:
  std::array<int, 6> Count = {};
};

vtkSmartPointer<vtkAlgorithm> makeTorus()
{
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(60);
  source->SetVResolution(40);
  auto clean = vtkSmartPointer<vtkCleanPolyData>::New(); // first and last points differ in the last
                                                         // digit
  clean->SetTolerance(1e-6);
  clean->SetInputConnection(source->GetOutputPort());
  return clean;
}

void testExecutions()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(40);
  vtkNew<vtkGeometryRemesher> remesher;
  Executions executions(remesher);
  remesher->SetInputConnection(sphere->GetOutputPort());
  remesher->SetNumberOfPoints(1000);
  remesher->GetMapRenderer()->SetBackendToCPU();
  remesher->Update();
  check(remesher->GetOutput()->GetNumberOfPoints() == 1000, "1000 points");
  check(remesher->GetStageSeconds(vtkGeometryRemesher::ATLAS) > 0, "the atlas took time");
  executions.expect({ { 1, 1, 1, 1, 1, 1 } }, "first update");

  remesher->Update();
  executions.expect({ { 0, 0, 0, 0, 0, 0 } }, "nothing changed");

  remesher->SetImportanceToMean();
  remesher->SetGamma(0.5);
  remesher->Update();
  executions.expect({ { 0, 0, 1, 1, 1, 1 } }, "importance and gamma");
  remesher->GetControlMap()->SetMinimumDensity(0.3);
  remesher->Update();
  executions.expect({ { 0, 0, 1, 1, 1, 1 } }, "minimum density");
  check(remesher->GetStageSeconds(vtkGeometryRemesher::CONTROL) > 0, "the control map took time");
  check(remesher->GetStageSeconds(vtkGeometryRemesher::ATLAS) == 0, "the atlas had nothing to do");

  remesher->SetNumberOfPoints(1010);
  remesher->Update();
  executions.expect({ { 0, 0, 1, 1, 1, 1 } }, "ten points more, so that sizes are others");
  check(remesher->GetOutput()->GetNumberOfPoints() == 1010, "1010 points");

  remesher->SetNumberOfPoints(20000);
  remesher->Update();
  executions.expect({ { 0, 1, 1, 1, 1, 1 } }, "twenty times the points need larger maps");

  remesher->GetOptimizer()->SetSmoothingToArea();
  remesher->Update();
  executions.expect({ { 0, 0, 0, 0, 0, 1 } }, "smoothing");

  remesher->GetOptimizer()->SetNumberOfIterations(2);
  remesher->Update();
  executions.expect({ { 0, 0, 0, 0, 0, 1 } }, "a stage's own parameter");

  remesher->SetFeatureAngle(180);
  remesher->Update();
  executions.expect({ { 1, 1, 1, 1, 1, 1 } }, "feature angle");

  sphere->SetRadius(2);
  remesher->Update();
  executions.expect({ { 1, 1, 1, 1, 1, 1 } }, "another input");
}

void testOutputs()
{
  const auto torus = makeTorus();
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputConnection(torus->GetOutputPort());
  remesher->GetMapRenderer()->SetBackendToCPU();
  remesher->Update();
  vtkPolyData* mesh = remesher->GetOutput();
  const vtkIdType welded = remesher->GetAtlas()->GetNumberOfSurfacePoints();
  check(mesh->GetNumberOfPoints() == welded,
    "by default as many points as the input has after welding");
  const stipple::MeshQuality quality = stipple::measureQuality(stipple::fromPolyData(mesh));
  check(quality.euler == remesher->GetAtlas()->GetEulerCharacteristic(),
    "the input's Euler characteristic");
  check(quality.nonManifoldEdges + quality.nonManifoldVertices + quality.misorientedEdges +
        quality.degenerate ==
      0,
    "an oriented manifold");
  const char* types[7] = { "vtkPolyData", "vtkPolyData", "vtkPartitionedDataSetCollection",
    "vtkPolyData", "vtkPartitionedDataSetCollection", "vtkPolyData",
    "vtkPartitionedDataSetCollection" };
  for (int port = 0; port < 7; ++port)
  {
    check(remesher->GetOutputDataObject(port)->IsA(types[port]),
      "type of output " + std::to_string(port));
  }
  auto* charts = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2));
  auto* maps = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(4));
  auto* halftones = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(6));
  check(charts->GetNumberOfPartitionedDataSets() > 0, "charts");
  check(maps->GetNumberOfPartitionedDataSets() == charts->GetNumberOfPartitionedDataSets(),
    "a map a chart");
  check(halftones->GetNumberOfPartitionedDataSets() == charts->GetNumberOfPartitionedDataSets(),
    "a halftone a chart");
  auto* image = vtkImageData::SafeDownCast(maps->GetPartitionAsDataObject(0, 0));
  check(image && image->GetPointData()->GetArray("Control") &&
      image->GetPointData()->GetArray("AreaDistortion"),
    "maps with Control");
  check(vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(5))->GetNumberOfPoints() == welded,
    "samples");
  check(vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1))->GetNumberOfPoints() == welded,
    "feature lines on the mesh's points");
}

void testArrayImportance()
{
  const auto torus = makeTorus();
  torus->Update();
  vtkNew<vtkPolyData> input;
  input->DeepCopy(torus->GetOutputDataObject(0));
  input->GetPointData()->GetNormals()->SetName("Normals");
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(input);
  remesher->SetNumberOfPoints(800);
  remesher->GetMapRenderer()->SetBackendToCPU();
  remesher->SetImportanceArrayName("Normals");
  remesher->SetImportanceToArray();
  remesher->Update();
  check(remesher->GetOutput()->GetNumberOfPoints() == 800, "importance by an array of the input");
}

/// Port 4 has the maps that are selected, and those that the importance needs.
void testSelectedMaps()
{
  const auto torus = makeTorus();
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputConnection(torus->GetOutputPort());
  remesher->SetNumberOfPoints(500);
  remesher->GetMapRenderer()->SetBackendToCPU();
  const auto maps = [&] {
    remesher->Update();
    check(remesher->GetOutput()->GetNumberOfPoints() == 500, "500 points");
    auto* port = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(4));
    auto* image = vtkImageData::SafeDownCast(port->GetPartitionAsDataObject(0, 0));
    std::set<std::string> names;
    for (int k = 0; image && k < image->GetPointData()->GetNumberOfArrays(); ++k)
    {
      names.insert(image->GetPointData()->GetArrayName(k));
    }
    return names;
  };
  using Names = std::set<std::string>;
  const Names least{ "AreaDistortion", "Control", "FaceIndex" };
  const auto with = [&](Names names) {
    names.insert(least.begin(), least.end());
    return names;
  };
  check(maps().size() == 8, "the seven default maps, and Control");
  remesher->GetMapRenderer()->GetMapSelection()->DisableAllArrays();
  check(maps() == least, "what a uniform remeshing needs");
  remesher->SetImportanceToTotal();
  check(maps() == with({ "TotalCurvature" }), "and total curvature");
  remesher->SetImportanceToL2();
  check(maps() == with({ "GaussianCurvature", "MeanCurvature" }), "mean and Gaussian for L2");
  remesher->GetMapRenderer()->GetMapSelection()->EnableArray("Normal");
  remesher->SetImportanceToUniform();
  check(maps() == with({ "Normal" }), "what is selected stays, what was added goes");
}

struct Messages
{
  std::vector<std::string> texts;
  static void add(vtkObject*, unsigned long, void* self, void* text)
  {
    static_cast<Messages*>(self)->texts.emplace_back(static_cast<const char*>(text));
  }
};

void testErrors()
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputConnection(cube->GetOutputPort());
  remesher->GetMapRenderer()->SetBackendToCPU();
  remesher->SetNumberOfPoints(3);
  Messages messages;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&messages);
  command->SetCallback(&Messages::add);
  remesher->AddObserver(vtkCommand::ErrorEvent, command);
  Messages executive;
  vtkNew<vtkCallbackCommand> quiet;
  quiet->SetClientData(&executive);
  quiet->SetCallback(&Messages::add);
  remesher->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet);
  remesher->Update();
  check(messages.texts.size() == 1, "one error, not " + std::to_string(messages.texts.size()));
  const std::string least = std::to_string(remesher->GetSampler()->GetMinimumNumberOfSamples());
  check(!messages.texts.empty() && messages.texts[0].find(least) != std::string::npos,
    "the error names the least number: " + (messages.texts.empty() ? "" : messages.texts[0]));
  for (int port = 0; port < 7; ++port)
  {
    vtkDataObject* output = remesher->GetOutputDataObject(port);
    check(output->GetNumberOfElements(vtkDataObject::POINT) == 0,
      "output " + std::to_string(port) + " is empty");
  }
  check(remesher->GetErrorCode() == vtkGeometryRemesher::TOO_FEW_POINTS, "the error has a code");
  check(
    remesher->GetLeastNumberOfPoints() == std::atoi(least.c_str()), "and the number that works");
  messages.texts.clear();
  remesher->SetNumberOfPoints(remesher->GetLeastNumberOfPoints());
  remesher->Update();
  check(messages.texts.empty(), "the least number works");
  check(remesher->GetErrorCode() == 0, "and leaves no error code");
  check(remesher->GetOutput()->GetNumberOfPoints() == std::atoi(least.c_str()),
    "the least number is exact");
  vtkNew<vtkIdTypeArray> noEdge;
  noEdge->SetNumberOfComponents(2);
  noEdge->InsertNextTuple2(0, 1000);
  remesher->GetAtlas()->SetFeatureEdges(noEdge);
  remesher->Update();
  check(remesher->GetErrorCode() == vtkGeometryRemesher::BAD_INPUT, "bad input has another code");
}

/// As many points as the input has are too few for some inputs: then it is the least that works.
void testAsManyAsTheInput()
{
  vtkNew<vtkPolyData> triangle;
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(0, 0, 0);
  corners->InsertNextPoint(1, 0, 0);
  corners->InsertNextPoint(0, 1, 0);
  triangle->SetPoints(corners);
  vtkNew<vtkCellArray> face;
  face->InsertNextCell({ 0, 1, 2 });
  triangle->SetPolys(face);
  vtkNew<vtkPlatonicSolidSource> tetrahedron;
  tetrahedron->SetSolidTypeToTetrahedron();
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkTriangleFilter> cubeOfTriangles;
  cubeOfTriangles->SetInputConnection(cube->GetOutputPort());
  for (vtkAlgorithm* source : { static_cast<vtkAlgorithm*>(nullptr),
         static_cast<vtkAlgorithm*>(tetrahedron), static_cast<vtkAlgorithm*>(cubeOfTriangles) })
  {
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->GetMapRenderer()->SetBackendToCPU();
    if (source)
    {
      remesher->SetInputConnection(source->GetOutputPort());
    }
    else
    {
      remesher->SetInputData(triangle);
    }
    Messages messages;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&messages);
    command->SetCallback(&Messages::add);
    remesher->AddObserver(vtkCommand::ErrorEvent, command);
    remesher->AddObserver(vtkCommand::WarningEvent, command);
    remesher->Update();
    const vtkIdType points = remesher->GetOutput()->GetNumberOfPoints();
    check(messages.texts.empty(),
      "as many points as a small input has: " +
        (messages.texts.empty() ? "" : messages.texts.front()));
    check(points >= 3 && points >= remesher->GetAtlas()->GetNumberOfSurfacePoints() &&
        points ==
          std::max<vtkIdType>(
            remesher->GetAtlas()->GetNumberOfSurfacePoints(), remesher->GetLeastNumberOfPoints()),
      std::to_string(points) + " points, the least is " +
        std::to_string(remesher->GetLeastNumberOfPoints()));
    remesher->SetNumberOfPoints(static_cast<int>(points));
    remesher->Update();
    check(messages.texts.empty() && remesher->GetOutput()->GetNumberOfPoints() == points,
      "a number that was told works when asked for");
  }
}

/// What the stages' events say, in their order: the stage at its begin, and its complement at its
/// end.
struct StageWatcher
{
  std::vector<int> seen;
  int stopAtEndOf = -1;
  static void look(vtkObject* caller, unsigned long event, void* data, void* stage)
  {
    auto* self = static_cast<StageWatcher*>(data);
    const int s = *static_cast<int*>(stage);
    const bool ends = event == vtkGeometryRemesher::StageEndEvent;
    self->seen.push_back(ends ? ~s : s);
    if (ends && s == self->stopAtEndOf)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  }
};

void testStageEvents()
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputConnection(cube->GetOutputPort());
  remesher->GetMapRenderer()->SetBackendToCPU();
  remesher->SetNumberOfPoints(100);
  StageWatcher watcher;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watcher);
  command->SetCallback(&StageWatcher::look);
  remesher->AddObserver(vtkGeometryRemesher::StageStartEvent, command);
  remesher->AddObserver(vtkGeometryRemesher::StageEndEvent, command);
  remesher->Update();
  check(watcher.seen == std::vector<int>({ 0, ~0, 1, ~1, 2, ~2, 3, ~3, 4, ~4, 5, ~5 }),
    "every stage begins and ends once, in order");
  watcher.seen.clear();
  remesher->Update();
  check(watcher.seen.empty(), "nothing executes, no stage begins");
  watcher.stopAtEndOf = vtkGeometryRemesher::MAPS;
  remesher->SetNumberOfPoints(120);
  remesher->Update();
  check(watcher.seen == std::vector<int>({ 0, ~0, 1, ~1, 2 }), "stopped once the maps are done");
  check(remesher->GetErrorCode() == vtkGeometryRemesher::ABORTED, "a stop has a code");
  watcher.seen.clear();
  watcher.stopAtEndOf = -1;
  remesher->SetNumberOfPoints(5);
  Messages messages;
  vtkNew<vtkCallbackCommand> errors;
  errors->SetClientData(&messages);
  errors->SetCallback(&Messages::add);
  remesher->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  remesher->AddObserver(vtkCommand::ErrorEvent, errors);
  remesher->Update();
  check(watcher.seen == std::vector<int>({ 0, ~0, 1, ~1, 2, ~2, 3 }), "what fails has no end");
}

void testEmptyInput()
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> two;
  two->InsertNextPoint(0, 0, 0);
  two->InsertNextPoint(1, 0, 0);
  points->SetPoints(two);
  for (vtkPolyData* input : { nothing.Get(), points.Get() })
  {
    vtkNew<vtkGeometryRemesher> remesher;
    Messages messages;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&messages);
    command->SetCallback(&Messages::add);
    remesher->AddObserver(vtkCommand::ErrorEvent, command);
    remesher->SetInputData(input);
    remesher->Update();
    check(messages.texts.empty() && remesher->GetOutput()->GetNumberOfPoints() == 0,
      "empty input is no error");
  }
}

struct Watcher
{
  double last = 0;
  double stopAt = 2;
  bool monotonous = true;
  static void look(vtkObject* caller, unsigned long, void* data, void*)
  {
    auto* self = static_cast<Watcher*>(data);
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    self->monotonous = self->monotonous && filter->GetProgress() >= self->last;
    self->last = filter->GetProgress();
    if (self->last >= self->stopAt)
    {
      filter->SetAbortExecute(1);
    }
  }
};

void testProgressAndAbort()
{
  const auto torus = makeTorus();
  torus->Update();
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputDataObject(torus->GetOutputDataObject(0));
  remesher->GetMapRenderer()->SetBackendToCPU();
  remesher->SetNumberOfPoints(2000);
  Watcher watcher;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watcher);
  command->SetCallback(&Watcher::look);
  remesher->AddObserver(vtkCommand::ProgressEvent, command);
  Messages messages;
  vtkNew<vtkCallbackCommand> errors;
  errors->SetClientData(&messages);
  errors->SetCallback(&Messages::add);
  remesher->AddObserver(vtkCommand::ErrorEvent, errors);
  for (const double stopAt : { 0.1, 0.35, 0.5, 0.65, 0.8 })
  {
    watcher = { 0., stopAt, true };
    remesher->Modified();
    remesher->GetAtlas()->Modified();
    remesher->Update();
    check(remesher->GetOutput()->GetNumberOfPoints() == 0, "stopped at " + std::to_string(stopAt));
    check(messages.texts.empty(), "a stop is no error");
  }
  const vtkMTimeType time = remesher->GetMTime();
  check(remesher->GetMTime() == time, "who asks for the time does not change it");
  vtkNew<vtkTriangleFilter> behind;
  behind->SetInputConnection(remesher->GetOutputPort());
  watcher = { 0., 0.5, true };
  behind->Update();
  check(behind->GetOutput()->GetNumberOfPoints() == 0, "nothing behind a stop");
  watcher = {};
  behind->Update(); // nothing was changed since
  check(behind->GetOutput()->GetNumberOfPoints() == 2000, "after a stop filters behind execute");
  check(remesher->GetMTime() < behind->GetOutput()->GetUpdateTime(), "and then all is up to date");
  check(remesher->GetOutput()->GetNumberOfPoints() == 2000,
    "after a stop the next update does the work");
  check(watcher.monotonous && watcher.last == 1., "progress rises to 1");
  remesher->Update();
  check(watcher.last == 1., "and then all is up to date");
}
}

int TestGeometryRemesher(int, char*[])
{
  testExecutions();
  testOutputs();
  testArrayImportance();
  testSelectedMaps();
  testErrors();
  testAsManyAsTheInput();
  testStageEvents();
  testEmptyInput();
  testProgressAndAbort();
  return test::exitStatus();
}
