// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The atlas as a filter: charts, features and constraints it is given, errors, progress and abort;
// and a picture of the paper's Figure 4, the seam that slips away against the one that does not.
#include "Check.h"
#include "ImageRegression.h"
#include "Shapes.h"

#include "Atlas.h"
#include "ChartGraph.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using test::check;

vtkPolyData* graphOf(vtkConformalAtlas* atlas)
{
  return vtkPolyData::SafeDownCast(atlas->GetOutputDataObject(1));
}

int numberOfCharts(vtkConformalAtlas* atlas)
{
  return static_cast<int>(atlas->GetOutput()->GetNumberOfPartitionedDataSets());
}

vtkPolyData* chart(vtkConformalAtlas* atlas, int i)
{
  return stipple::chartOf(atlas->GetOutput(), static_cast<unsigned int>(i));
}

stipple::FeatureGraph readGraph(vtkConformalAtlas* atlas)
{
  stipple::Atlas::Pointer read;
  check(
    stipple::Atlas::read(atlas->GetOutput(), graphOf(atlas), read).ok(), "the atlas can be read");
  return read ? read->graph() : stipple::FeatureGraph();
}

int numberOfBackbones(vtkConformalAtlas* atlas, stipple::BackboneType type)
{
  const stipple::FeatureGraph graph = readGraph(atlas);
  int count = 0;
  for (const stipple::Backbone& b : graph.backbones)
  {
    count += b.type == type;
  }
  return count;
}

/// What an observer of errors heard last.
std::string errorOf(vtkConformalAtlas* atlas)
{
  std::string message;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&message);
  command->SetCallback([](vtkObject*, unsigned long, void* data, void* text) {
    *static_cast<std::string*>(data) = static_cast<const char*>(text);
  });
  const unsigned long tag = atlas->AddObserver(vtkCommand::ErrorEvent, command);
  atlas->Update();
  atlas->RemoveObserver(tag);
  return message;
}

void testCharts()
{
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(shapes::toPolyData(shapes::hornedSphere(4)));
  atlas->SetNumberOfCharts(4);
  atlas->SetMaximumDensityRatio(30);
  atlas->Update();
  check(numberOfCharts(atlas) >= 4, "four charts or more");
  double largest = 0;
  for (int c = 0; c < numberOfCharts(atlas); ++c)
  {
    vtkDataArray* ratio = chart(atlas, c)->GetFieldData()->GetArray("DensityRatio");
    check(ratio && ratio->GetNumberOfTuples() == 1, "every chart tells its density ratio");
    largest = std::max(largest, ratio ? ratio->GetComponent(0, 0) : 0.);
  }
  check(largest <= 30 && largest > 1, "the ratios keep the bound");
  check(largest == atlas->GetDensityRatio(), "the atlas tells the largest");
  stipple::AtlasSurface surface;
  check(stipple::readAtlas(atlas->GetOutput(), surface).ok(), "the charts can be read");
  check(
    surface.topology().euler == 2 && surface.topology().manifold, "the charts weld to a sphere");
}

void testRefinementLevel()
{
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(shapes::toPolyData(shapes::hornedSphere(4)));
  atlas->SetMaximumDensityRatio(30);
  atlas->Update();
  const int charts = numberOfCharts(atlas);
  const double ratio = atlas->GetDensityRatio();
  atlas->SetMaximumDensityRatio(300);
  atlas->Update();
  check(atlas->GetDensityRatio() > ratio, "a larger bound is used");
  atlas->SetRefinementLevel(1);
  atlas->Update();
  check(numberOfCharts(atlas) == charts && atlas->GetDensityRatio() == ratio,
    "the next level keeps a tenth of the bound");
}

void testFeatureCurves()
{
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(shapes::toPolyData(shapes::sphere(1, 4)));
  vtkNew<vtkPolyData> curves;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const int n = 12;
  lines->InsertNextCell(n + 1);
  for (int i = 0; i <= n; ++i)
  {
    const double a = i * 0.1;
    lines->InsertCellPoint(
      points->InsertNextPoint(std::cos(a), std::sin(a) * 0.8, std::sin(a) * 0.6));
  }
  curves->SetPoints(points);
  curves->SetLines(lines);
  atlas->SetFeatureCurves(curves);
  atlas->Update();
  check(numberOfBackbones(atlas, stipple::BackboneType::Sharp) >= 1, "the curve is a feature");
  const vtkMTimeType before = atlas->GetMTime();
  curves->Modified();
  check(atlas->GetMTime() > before, "the atlas changes with its curves");
  atlas->SetFeatureCurves(nullptr);
  atlas->Update();
  check(numberOfBackbones(atlas, stipple::BackboneType::Sharp) == 0, "and without them");
}

void testConstraints()
{
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(shapes::toPolyData(shapes::torus(3, 1, 60, 20)));
  vtkNew<vtkPoints> positions;
  positions->InsertNextPoint(4.2, 0, 0);
  atlas->SetConstraints(positions);
  atlas->Update();
  const double* extent =
    vtkDoubleArray::SafeDownCast(chart(atlas, 0)->GetFieldData()->GetArray("ChartExtent"))
      ->GetPointer(0);
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  const std::array<double, 3> place = { 0., 0.4 * extent[0], 0.7 * extent[1] };
  places->InsertNextTuple(place.data());
  atlas->SetChartConstraints(places);
  atlas->Update();
  const stipple::FeatureGraph graph = readGraph(atlas);
  check(graph.constraints.size() == 2, "two constraints");
  if (graph.constraints.size() == 2)
  {
    check((graph.constraints[0].position - stipple::Vec3(4, 0, 0)).norm() < 0.02,
      "a position is moved to the surface");
    stipple::AtlasSurface surface;
    check(stipple::readAtlas(atlas->GetOutput(), surface).ok(), "the charts can be read");
    const stipple::ConstraintPoint& c = graph.constraints[1];
    const int face = surface.chartBegin[c.chart] + c.chartCell;
    stipple::Vec2 uv = stipple::Vec2::Zero();
    for (int k = 0; k < 3; ++k)
    {
      uv += c.bary[k] * surface.cornerUV(face, k);
    }
    check(c.chart == 0 && (uv - stipple::Vec2(place[1], place[2])).norm() < 1e-9,
      "a place of a chart is met");
    check((surface.position(face, c.bary) - c.position).norm() < 1e-9, "it lies on the surface");
  }
  places->SetComponent(0, 1, 1.5);
  places->Modified();
  check(errorOf(atlas).find("not in a chart") != std::string::npos, "a place outside is an error");
  check(numberOfCharts(atlas) == 0, "an error leaves no charts");
}

/// What users hand over is checked: one sentence that names what is wrong, and no charts.
void testMalformedOptions()
{
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(shapes::toPolyData(shapes::sphere(1, 3)));
  const auto refuses = [&](const std::string& what, const std::string& name) {
    const std::string error = errorOf(atlas);
    check(error.find(what) != std::string::npos, name + ": \"" + what + "\" is in: " + error);
    check(numberOfCharts(atlas) == 0, name + " leaves no charts");
  };
  const auto accepts = [&](const std::string& name) {
    const std::string error = errorOf(atlas);
    check(error.empty() && numberOfCharts(atlas) > 0, name + " is no error, but: " + error);
  };

  vtkNew<vtkIdTypeArray> edges;
  atlas->SetFeatureEdges(edges);
  for (const int components : { 1, 3 })
  {
    edges->Initialize();
    edges->SetNumberOfComponents(components);
    edges->SetNumberOfTuples(2);
    edges->Fill(0);
    refuses("two components", "an array of " + std::to_string(components) + " components");
  }
  edges->Initialize();
  edges->SetNumberOfComponents(2);
  edges->SetNumberOfTuples(1);
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(642), VTK_ID_MAX, VTK_ID_MIN })
  {
    edges->SetTypedComponent(0, 0, 0);
    edges->SetTypedComponent(0, 1, id);
    edges->Modified();
    refuses("Feature edge 0 joins the points 0 and " + std::to_string(id), "an id out of range");
  }
  edges->SetTypedComponent(0, 1, 0);
  edges->Modified();
  refuses("which no edge of the input joins", "an edge from a point to itself");
  edges->SetNumberOfTuples(0);
  edges->Modified();
  accepts("an empty array of edges");
  atlas->SetFeatureEdges(nullptr);

  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  atlas->SetConstraints(positions);
  accepts("no constraint");
  positions->InsertNextPoint(0, 0, 1);
  for (const double x : { std::nan(""), -HUGE_VAL })
  {
    positions->SetPoint(0, 0, x, 1);
    positions->Modified();
    refuses("Constraint 0 has a coordinate that is not a finite number", "a constraint nowhere");
  }
  atlas->SetConstraints(nullptr);

  vtkNew<vtkDoubleArray> places;
  atlas->SetChartConstraints(places);
  places->SetNumberOfComponents(2);
  places->SetNumberOfTuples(3);
  places->Fill(0);
  refuses("need three components", "places of two components");
  places->Initialize();
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(1);
  for (const std::array<double, 3>& place :
    { std::array<double, 3>{ -1, 0.5, 0.1 }, { 99, 0.5, 0.1 }, { std::nan(""), 0.5, 0.1 },
      { 0, std::nan(""), 0.1 }, { 0, 0.5, -3 }, { HUGE_VAL, 0.5, 0.1 } })
  {
    places->SetTuple(0, place.data());
    places->Modified();
    refuses("Chart constraint 0", "a place that is none");
  }
  atlas->SetChartConstraints(nullptr);

  vtkNew<vtkPolyData> curves;
  atlas->SetFeatureCurves(curves);
  accepts("curves without lines");
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  curves->SetLines(lines);
  refuses("Feature curve 0 has a point 0, but there are 0 points", "a curve without points");
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0.9, 0.1, 0);
  curves->SetPoints(points);
  for (const vtkIdType id : { vtkIdType(-7), vtkIdType(2), VTK_ID_MAX })
  {
    lines->Initialize();
    lines->InsertNextCell({ 0, id });
    curves->Modified();
    refuses("Feature curve 0 has a point " + std::to_string(id), "a curve of points out of range");
  }
  points->SetPoint(1, std::nan(""), 0, 0);
  lines->Initialize();
  lines->InsertNextCell({ 0, 1 });
  curves->Modified();
  refuses("Point 1 of the feature curves", "a curve through nowhere");
}

/// A chimney of needles: too few triangles for charts of bounded density.
void testWarning()
{
  vtkNew<vtkConformalAtlas> atlas;
  atlas->SetInputData(shapes::toPolyData(shapes::cylinder(1, 300, 12, 1)));
  std::string warning;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&warning);
  command->SetCallback([](vtkObject*, unsigned long, void* data, void* text) {
    *static_cast<std::string*>(data) = static_cast<const char*>(text);
  });
  atlas->AddObserver(vtkCommand::WarningEvent, command);
  atlas->Update();
  check(numberOfCharts(atlas) > 0, "the chimney has charts");
  check((atlas->GetDensityRatio() > 100) == (warning.find("density ratio") != std::string::npos),
    "a density above the bound is told, and no other");
}

void testProgressAndAbort()
{
  struct Watch
  {
    double last = 0;
    bool falls = false;
    int events = 0;
    double abortAt = 2;
  } watch;
  vtkNew<vtkConformalAtlas> atlas;
  // It tells every 10 ms: large enough for a second and more.
  atlas->SetInputData(shapes::toPolyData(shapes::perforatedSlab(4, 4, 16)));
  atlas->SetNumberOfCharts(8);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback([](vtkObject* caller, unsigned long, void* data, void* amount) {
    auto* w = static_cast<Watch*>(data);
    const double progress = *static_cast<double*>(amount);
    w->falls = w->falls || progress < w->last;
    w->last = progress;
    ++w->events;
    if (progress >= w->abortAt)
    {
      static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
    }
  });
  atlas->AddObserver(vtkCommand::ProgressEvent, command);
  atlas->Update();
  check(watch.events > 10, "progress is told more than ten times");
  check(!watch.falls, "progress does not go back");
  check(numberOfCharts(atlas) >= 8, "eight charts");
  for (double at : { 0.05, 0.3, 0.6 })
  {
    watch = { 0, false, 0, at };
    atlas->Modified();
    const std::string message = errorOf(atlas);
    check(message.empty(), "an abort is not an error, but: " + message);
    check(numberOfCharts(atlas) == 0, "an abort leaves no charts");
    check(watch.last < at + 0.35, "an abort is honoured soon");
    atlas->AbortExecuteOff();
  }
}

/// The charts in colours with their seams, from the side of the horn.
void addAtlas(vtkConformalAtlas* atlas, vtkRenderer* renderer)
{
  const std::array<std::array<double, 3>, 3> colors = { { { 0.93, 0.72, 0.56 }, { 0.55, 0.7, 0.88 },
    { 0.66, 0.83, 0.6 } } };
  for (int c = 0; c < numberOfCharts(atlas); ++c)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(chart(atlas, c));
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colors[c % 3][0], colors[c % 3][1], colors[c % 3][2]);
    renderer->AddActor(actor);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(graphOf(atlas));
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
  vtkNew<vtkActor> seams;
  seams->SetMapper(mapper);
  seams->GetProperty()->SetColor(0.1, 0.1, 0.1);
  seams->GetProperty()->SetLineWidth(3);
  seams->GetProperty()->LightingOff();
  renderer->AddActor(seams);
  renderer->SetBackground(1, 1, 1);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(1, -12, 4);
  camera->SetFocalPoint(1.2, 0, 0);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCameraClippingRange();
}

void testPicture(int argc, char* argv[])
{
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetPlatformToOSMesa();
  window->SetSize(900, 400);
  window->SetMultiSamples(0);
  const std::array<int, 3> placements = { vtkConformalAtlas::VORONOI, vtkConformalAtlas::MIDDLE,
    vtkConformalAtlas::AREA_MEDIAN };
  std::vector<vtkSmartPointer<vtkConformalAtlas>> atlases;
  for (int i = 0; i < 3; ++i)
  {
    auto atlas = vtkSmartPointer<vtkConformalAtlas>::New();
    atlas->SetInputData(shapes::toPolyData(shapes::hornedSphere(5)));
    atlas->SetMaximumDensityRatio(1e9);
    atlas->SetBoundaryPlacement(placements[i]);
    atlas->Update();
    check(numberOfCharts(atlas) == 2, "two charts");
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(i / 3., 0, (i + 1) / 3., 1);
    addAtlas(atlas, renderer);
    window->AddRenderer(renderer);
    atlases.push_back(atlas);
  }
  window->Render();
  check(test::compareWindow(window, "BoundaryPlacement", argc, argv),
    "raw, middle and area-weighted seams look as they should");
}
}

int TestConformalAtlas(int argc, char* argv[])
{
  testCharts();
  testRefinementLevel();
  testFeatureCurves();
  testConstraints();
  testMalformedOptions();
  testWarning();
  testProgressAndAbort();
  testPicture(argc, argv);
  return test::exitStatus();
}
