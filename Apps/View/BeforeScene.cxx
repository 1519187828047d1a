// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BeforeScene.h"

#include "AtlasSurface.h"
#include "Backbones.h"
#include "ColorBar.h"
#include "DrawingOrder.h"
#include "SceneActors.h"
#include "SurfaceShading.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
constexpr Pixel SurfacePixel = { { 222, 229, 238 } };
constexpr Color TagOrange = { { 0.93, 0.50, 0.05 } };

vtkSmartPointer<vtkImageData> onePixel(const Pixel& color)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(1, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  *static_cast<Pixel*>(image->GetScalarPointer()) = color;
  return image;
}

bool hasLines(vtkActor* actor)
{
  auto* lines = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
  return lines && lines->GetNumberOfLines() > 0;
}

/// The chart's surface with its parameters as texture coordinates in [0, 1].
vtkSmartPointer<vtkPolyData> texturedSurface(vtkPolyData* chart)
{
  vtkSmartPointer<vtkPolyData> surface = bareSurface(chart);
  surface->SetPolys(inDrawingOrder(chart));
  vtkDataArray* uv = chart->GetPointData()->GetArray("UV");
  vtkDataArray* extent = chart->GetFieldData()->GetArray("ChartExtent");
  if (uv && extent)
  {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("TextureCoordinates");
    coordinates->SetNumberOfComponents(2);
    coordinates->SetNumberOfTuples(uv->GetNumberOfTuples());
    for (vtkIdType p = 0; p < uv->GetNumberOfTuples(); ++p)
    {
      coordinates->SetTuple2(p, uv->GetComponent(p, 0) / extent->GetComponent(0, 0),
        uv->GetComponent(p, 1) / extent->GetComponent(0, 1));
    }
    surface->GetPointData()->SetTCoords(coordinates);
  }
  return surface;
}
}

BeforeScene::BeforeScene(vtkRenderer* renderer, vtkPolyData* input, bool solid)
  : Renderer(renderer)
  , Input(input)
  , Solid(solid)
  , InputEdge(meanEdge(input))
{
  vtkNew<vtkPolyDataMapper> mapper;
  const vtkSmartPointer<vtkPolyData> surface = bareSurface(input);
  surface->SetPolys(inDrawingOrder(input));
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  this->Surface = vtkSmartPointer<vtkActor>::New();
  this->Surface->SetMapper(mapper);
  setSurfaceLook(this->Surface->GetProperty());
  addPlainLight(this->Surface);
  this->Surface->GetProperty()->SetBackfaceCulling(solid);
  renderer->AddActor(this->Surface);
  this->Wires = wireActor(surface);
  renderer->AddActor(this->Wires);
  for (int type = 0; type < 3; ++type)
  {
    vtkNew<vtkPolyData> none;
    this->Lines.push_back(
      lineActor(none, type == 0 ? FeatureRed : (type == 1 ? BoundaryBlue : Ink), 1));
    renderer->AddActor(this->Lines.back());
  }
  vtkNew<vtkPolyData> none;
  this->Edges = lineActor(none, TagOrange, 1);
  this->Brush = lineActor(none, TagOrange, 1);
  this->Points = lineActor(none, TagOrange, 1);
  this->Points->GetProperty()->RenderPointsAsSpheresOn();
  for (vtkActor* actor : { this->Edges.Get(), this->Brush.Get(), this->Points.Get() })
  {
    actor->PickableOff();
    renderer->AddActor(actor);
  }
}

BeforeScene::~BeforeScene() = default;

void BeforeScene::setAtlas(vtkPartitionedDataSetCollection* charts, vtkPolyData* graph)
{
  for (const Chart& chart : this->Charts)
  {
    this->Renderer->RemoveActor(chart.actor);
  }
  for (vtkActor* actor : this->Samples.actors())
  {
    this->Renderer->RemoveActor(actor);
  }
  this->Charts.clear();
  this->Dots.reset();
  this->Density.clear();
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    Chart chart;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(texturedSurface(chartOf(charts, c)));
    mapper->ScalarVisibilityOff();
    chart.actor = vtkSmartPointer<vtkActor>::New();
    chart.actor->SetMapper(mapper);
    setSurfaceLook(chart.actor->GetProperty());
    chart.actor->GetProperty()->SetColor(1, 1, 1);
    chart.actor->GetProperty()->SetBackfaceCulling(this->Solid);
    addPlainLight(chart.actor);
    chart.texture = vtkSmartPointer<vtkImageData>::New();
    vtkNew<vtkTexture> texture;
    texture->SetInputData(chart.texture);
    texture->SetColorModeToDirectScalars();
    texture->InterpolateOn();
    texture->RepeatOff();
    texture->EdgeClampOn();
    chart.actor->SetTexture(texture);
    this->Renderer->AddActor(chart.actor);
    this->Charts.push_back(chart);
  }
  this->showTextures();
  this->Samples.setCharts(charts);
  for (vtkActor* actor : this->Samples.actors())
  {
    actor->GetProperty()->SetBackfaceCulling(this->Solid);
    this->Renderer->AddActor(actor);
  }
  for (int type = 0; type < 3; ++type)
  {
    static_cast<vtkPolyDataMapper*>(this->Lines[type]->GetMapper())
      ->SetInputData(type == 0 ? creasesTo(graph, nullptr) : backbonesOfType(graph, type));
  }
  this->showRightActors();
}

void BeforeScene::setCreases(vtkPolyData* creases)
{
  auto* mapper = static_cast<vtkPolyDataMapper*>(this->Lines[0]->GetMapper());
  const auto sizeOf = [](vtkPolyData* lines) {
    return std::pair(lines->GetNumberOfLines(), lines->GetLines()->GetNumberOfConnectivityIds());
  };
  if (creases && sizeOf(creases) != sizeOf(mapper->GetInput()))
  {
    mapper->SetInputData(creases);
    this->showRightActors();
  }
}

void BeforeScene::setDensity(std::vector<vtkSmartPointer<vtkImageData>> density)
{
  this->Density = std::move(density);
  this->showTextures();
}

void BeforeScene::setDots(std::shared_ptr<const DotImages> dots)
{
  if (dots && dots != this->Dots)
  {
    this->Dots = std::move(dots);
    this->Samples.setImages(*this->Dots);
  }
}

/// Colours of charts, or of densities where these are shown and there.
void BeforeScene::showTextures()
{
  const bool density =
    this->View.display == Display::Density && this->Density.size() == this->Charts.size();
  for (std::size_t c = 0; c < this->Charts.size(); ++c)
  {
    vtkImageData* texture = this->Charts[c].texture;
    setShading(this->Charts[c].actor->GetProperty(), density);
    if (density)
    {
      texture->ShallowCopy(this->Density[c]);
    }
    else
    {
      texture->ShallowCopy(onePixel(
        this->View.display == Display::Charts ? chartColor(static_cast<int>(c)) : SurfacePixel));
    }
  }
}

void BeforeScene::setMissed(const MeshColors& colors)
{
  this->Missed = &colors;
  this->paintMissed();
}

void BeforeScene::paintMissed()
{
  auto* mapper = static_cast<vtkPolyDataMapper*>(this->Surface->GetMapper());
  const bool shown = showsMissed(this->View) && this->Missed && !this->Missed->missed.empty();
  mapper->SetScalarVisibility(shown);
  setShading(this->Surface->GetProperty(), shown);
  if (!shown)
  {
    return;
  }
  mapper->GetInput()->GetPointData()->SetScalars(
    missedScale(*this->Missed).colorsOf(this->Missed->missed));
  mapper->SetScalarModeToUsePointData();
  mapper->SetColorModeToDirectScalars();
}

void BeforeScene::setView(const ViewState& view, float lineWidth)
{
  const bool repaint = view.display != this->View.display;
  const bool recolor = showsMissed(view) != showsMissed(this->View);
  this->View = view;
  this->LineWidth = lineWidth;
  if (repaint)
  {
    this->showTextures();
  }
  if (recolor)
  {
    this->paintMissed();
  }
  this->showRightActors();
}

void BeforeScene::showRightActors()
{
  const bool wires = this->View.wireframe;
  const bool charts = !wires && this->View.display != Display::Input && !this->Charts.empty();
  this->Surface->SetVisibility(!charts && !wires);
  this->Wires->SetVisibility(wires);
  this->Wires->GetProperty()->SetLineWidth(this->LineWidth);
  const bool samples = this->View.display == Display::Samples;
  for (const Chart& chart : this->Charts)
  {
    chart.actor->SetVisibility(charts && !samples);
  }
  for (vtkActor* actor : this->Samples.actors())
  {
    actor->SetVisibility(charts && samples);
  }
  for (int type = 0; type < 3; ++type)
  {
    const bool on =
      type == 2 ? this->View.seams || this->View.display == Display::Charts : this->View.features;
    this->Lines[type]->SetVisibility(on && hasLines(this->Lines[type]));
    this->Lines[type]->GetProperty()->SetLineWidth((type == 2 ? 1.5F : 2.5F) * this->LineWidth);
  }
  this->Edges->GetProperty()->SetLineWidth(4 * this->LineWidth);
  this->Brush->GetProperty()->SetLineWidth(2.5F * this->LineWidth);
  this->Points->GetProperty()->SetPointSize(11 * this->LineWidth);
  const bool edges = this->View.display == Display::Input;
  setInspectionEdgeLook(
    this->Surface->GetProperty(), edges ? this->InputEdge * this->Zoom : 0, this->LineWidth);
}

void BeforeScene::setZoom(double pixelsPerLength)
{
  this->Zoom = pixelsPerLength;
  this->showRightActors();
}

bool BeforeScene::hidesEdges() const
{
  return this->View.display == Display::Input && !this->View.wireframe &&
    !showsInspectionEdges(this->InputEdge * this->Zoom);
}

bool BeforeScene::hidesDots(double spacing) const
{
  // A dot's radius, a quarter of it, is then the least that is drawn as dark as larger ones.
  constexpr double LeastSpacing = 3; // pixels
  return this->View.display == Display::Samples && !this->View.wireframe &&
    spacing * this->Zoom < LeastSpacing;
}

bool BeforeScene::setMarks(const Session& session)
{
  std::vector<double> marks = session.list("constraints");
  marks.push_back(-1); // no point's id
  const std::vector<double>& edges = session.list("feature_edges");
  marks.insert(marks.end(), edges.begin(), edges.end());
  if (marks == this->Marks)
  {
    return false;
  }
  this->Marks = std::move(marks);
  vtkNew<vtkPoints> positions;
  vtkNew<vtkCellArray> vertices;
  for (const auto& p : session.rows<3>("constraints"))
  {
    const vtkIdType id = positions->InsertNextPoint(p.data());
    vertices->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(positions);
  points->SetVerts(vertices);
  static_cast<vtkPolyDataMapper*>(this->Points->GetMapper())->SetInputData(points);
  this->Points->SetVisibility(vertices->GetNumberOfCells() > 0);
  vtkNew<vtkCellArray> lines;
  for (const auto& edge : session.rows<2>("feature_edges"))
  {
    const vtkIdType ids[2] = { static_cast<vtkIdType>(edge[0]), static_cast<vtkIdType>(edge[1]) };
    lines->InsertNextCell(2, ids);
  }
  vtkNew<vtkPolyData> tagged;
  tagged->SetPoints(this->Input->GetPoints());
  tagged->SetLines(lines);
  static_cast<vtkPolyDataMapper*>(this->Edges->GetMapper())->SetInputData(tagged);
  this->Edges->SetVisibility(lines->GetNumberOfCells() > 0);
  return true;
}

void BeforeScene::setBrush(const std::vector<PickedPlace>& places, double radius)
{
  constexpr int Steps = 48;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const PickedPlace& place : places)
  {
    const Vec3& normal = place.normal;
    Vec3 across = normal.cross(Vec3::UnitX());
    across = across.norm() < 0.1 ? normal.cross(Vec3::UnitY()) : across;
    across.normalize();
    const Vec3 along = normal.cross(across);
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(Steps + 1);
    for (int i = 0; i < Steps; ++i)
    {
      const double angle = 2 * Pi * i / Steps;
      const Vec3 p = place.position + 0.05 * radius * normal +
        radius * (std::cos(angle) * across + std::sin(angle) * along);
      points->InsertNextPoint(p.data());
      lines->InsertCellPoint(first + i);
    }
    lines->InsertCellPoint(first);
  }
  vtkNew<vtkPolyData> circles;
  circles->SetPoints(points);
  circles->SetLines(lines);
  static_cast<vtkPolyDataMapper*>(this->Brush->GetMapper())->SetInputData(circles);
  this->Brush->SetVisibility(!places.empty());
}

bool BeforeScene::hasFeatures() const
{
  return hasLines(this->Lines[0]);
}

vtkActor* BeforeScene::points()
{
  return this->Points;
}

void BeforeScene::setEdgesUnder(const std::vector<std::array<vtkIdType, 2>>& edges)
{
  vtkNew<vtkPolyData> under;
  vtkNew<vtkCellArray> lines;
  for (const auto& edge : edges)
  {
    lines->InsertNextCell(2, edge.data());
  }
  under->SetPoints(this->Input->GetPoints());
  under->SetLines(lines);
  static_cast<vtkPolyDataMapper*>(this->Brush->GetMapper())->SetInputData(under);
  this->Brush->SetVisibility(!edges.empty());
}
}
