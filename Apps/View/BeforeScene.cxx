// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BeforeScene.h"

#include "AtlasSurface.h"
#include "SceneActors.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
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
using Pixel = std::array<unsigned char, 3>;
constexpr Pixel SurfacePixel = { { 222, 229, 238 } };
constexpr Pixel SamplePixel = { { 24, 44, 96 } };
constexpr Color TagOrange = { { 0.93, 0.50, 0.05 } };

vtkImageData* imageOf(vtkPartitionedDataSetCollection* images, std::size_t chart)
{
  return images && chart < images->GetNumberOfPartitionedDataSets()
    ? vtkImageData::SafeDownCast(
        images->GetPartitionAsDataObject(static_cast<unsigned int>(chart), 0))
    : nullptr;
}

/// The chart's surface with its parameters as texture coordinates in [0, 1].
vtkSmartPointer<vtkPolyData> texturedSurface(vtkPolyData* chart)
{
  vtkSmartPointer<vtkPolyData> surface = bareSurface(chart);
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

/// Lengths on the surface of steps in the parameter plane, for every triangle of a chart.
std::vector<SurfaceMetric> metricsOf(vtkPolyData* chart)
{
  std::vector<SurfaceMetric> metrics;
  vtkDataArray* uvs = chart->GetPointData()->GetArray("UV");
  vtkCellArray* cells = chart->GetPolys();
  for (vtkIdType f = 0; uvs && f < cells->GetNumberOfCells(); ++f)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCellAtId(f, size, ids);
    Eigen::Matrix2d plane;
    Eigen::Matrix<double, 3, 2> space;
    for (int k = 0; k < 2; ++k)
    {
      plane.col(k) = Vec2(uvs->GetComponent(ids[k + 1], 0) - uvs->GetComponent(ids[0], 0),
        uvs->GetComponent(ids[k + 1], 1) - uvs->GetComponent(ids[0], 1));
      space.col(k) = Vec3(chart->GetPoint(ids[k + 1])) - Vec3(chart->GetPoint(ids[0]));
    }
    const Eigen::Matrix<double, 3, 2> jacobian = space * plane.inverse();
    const Eigen::Matrix2d m = jacobian.transpose() * jacobian;
    metrics.push_back(
      m.allFinite() ? SurfaceMetric{ m(0, 0), m(0, 1), m(1, 1) } : SurfaceMetric{ 1, 0, 1 });
  }
  return metrics;
}

/// Paints a disc on the surface into the texture, as dark as `strength` (0 to 1); its middle and
/// the metric are in pixels of the texture.
void paintDot(
  vtkImageData* texture, double x, double y, const SurfaceMetric& m, double radius, double strength)
{
  constexpr double Farthest = 24; // pixels: a dot on a bad map must not cost much
  const int width = texture->GetDimensions()[0];
  const int height = texture->GetDimensions()[1];
  auto* pixels = reinterpret_cast<Pixel*>(texture->GetScalarPointer());
  const double determinant = std::max(m.uu * m.vv - m.uv * m.uv, 1e-12 * m.uu * m.vv);
  const int reachX =
    static_cast<int>(std::min(Farthest, radius * std::sqrt(m.vv / determinant)) + 1.5);
  const int reachY =
    static_cast<int>(std::min(Farthest, radius * std::sqrt(m.uu / determinant)) + 1.5);
  for (int py = std::max(0, static_cast<int>(y) - reachY);
       py <= std::min(height - 1, static_cast<int>(y) + reachY); ++py)
  {
    for (int px = std::max(0, static_cast<int>(x) - reachX);
         px <= std::min(width - 1, static_cast<int>(x) + reachX); ++px)
    {
      const double dx = px + 0.5 - x;
      const double dy = py + 0.5 - y;
      const double onSurface = std::sqrt(m.uu * dx * dx + 2 * m.uv * dx * dy + m.vv * dy * dy);
      const double inPlane = std::sqrt(dx * dx + dy * dy);
      // Pixels from the rim, on the line through the middle.
      const double depth = onSurface > 0 ? inPlane * (radius / onSurface - 1) : 1;
      const double cover = strength * std::clamp(depth + 0.5, 0., 1.);
      Pixel& pixel = pixels[static_cast<vtkIdType>(py) * width + px];
      for (int k = 0; cover > 0 && k < 3; ++k)
      {
        pixel[k] = static_cast<unsigned char>(pixel[k] + cover * (SamplePixel[k] - pixel[k]));
      }
    }
  }
}

/// A disc for each sample of the halftone, round on the surface, its size a share of the distance
/// to the next samples. `samplesPerControl` is the number of samples over the integral of the
/// control map.
void paintSamples(vtkImageData* halftone, vtkImageData* controls,
  const std::vector<SurfaceMetric>& metrics, double samplesPerControl, vtkImageData* texture)
{
  constexpr int Zoom = 2; // texture pixels a pixel of the halftone
  constexpr double Share = 0.24;
  constexpr double LeastRadius = 0.75; // texture pixels
  constexpr double Stretch = 24;       // bounds the squared ratio of a dot's axes in the texture
  auto* dots = vtkUnsignedCharArray::SafeDownCast(halftone->GetPointData()->GetArray("Halftone"));
  auto* control = vtkFloatArray::SafeDownCast(controls->GetPointData()->GetArray("Control"));
  auto* faces = vtkIntArray::SafeDownCast(controls->GetPointData()->GetArray("FaceIndex"));
  const int* size = halftone->GetDimensions();
  const int* controlSize = controls->GetDimensions();
  texture->SetDimensions(Zoom * size[0], Zoom * size[1], 1);
  texture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(reinterpret_cast<Pixel*>(texture->GetScalarPointer()), texture->GetNumberOfPoints(),
    SurfacePixel);
  const double du = halftone->GetSpacing()[0] / Zoom;
  const double dv = halftone->GetSpacing()[1] / Zoom;
  for (vtkIdType i = 0; dots && control && faces && i < dots->GetNumberOfValues(); ++i)
  {
    if (dots->GetValue(i) != 0)
    {
      continue;
    }
    const auto column = static_cast<int>(i % size[0]);
    const auto row = static_cast<int>(i / size[0]);
    const vtkIdType pixel =
      static_cast<vtkIdType>(row) * controlSize[1] / size[1] * controlSize[0] +
      static_cast<vtkIdType>(column) * controlSize[0] / size[0];
    SurfaceMetric m = metrics[faces->GetValue(pixel)];
    m = { m.uu * du * du, m.uv * du * dv, m.vv * dv * dv };
    // Where the map is squeezed to a thread, dots are not.
    const double trace = (m.uu + m.vv) / Stretch;
    m.uu += trace;
    m.vv += trace;
    const double area = std::sqrt(std::max(0., m.uu * m.vv - m.uv * m.uv)); // of a pixel
    const double wanted = samplesPerControl * control->GetValue(pixel) * du * dv;
    const double radius = wanted > 0 ? Share * std::sqrt(area / wanted) : 0.;
    // A dot smaller than a pixel is a pixel, but paler: as much ink.
    const double least = LeastRadius * std::sqrt(area);
    const double strength = radius < least ? radius * radius / (least * least) : 1.;
    paintDot(
      texture, Zoom * (column + 0.5), Zoom * (row + 0.5), m, std::max(radius, least), strength);
  }
  texture->Modified();
}

/// Integral of the control map over all charts.
double integralOf(vtkPartitionedDataSetCollection* controls)
{
  double sum = 0;
  for (std::size_t c = 0; c < controls->GetNumberOfPartitionedDataSets(); ++c)
  {
    vtkImageData* image = imageOf(controls, c);
    auto* control = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("Control"));
    double part = 0;
    for (vtkIdType i = 0; control && i < control->GetNumberOfValues(); ++i)
    {
      part += control->GetValue(i);
    }
    sum += part * image->GetSpacing()[0] * image->GetSpacing()[1];
  }
  return sum;
}

/// From white over blue to dark red, by the share of the highest density.
Pixel densityPixel(double share)
{
  static const double stops[5][3] = { { 245, 247, 250 }, { 158, 202, 225 }, { 66, 146, 198 },
    { 8, 69, 148 }, { 103, 0, 61 } };
  const double place = std::clamp(share, 0., 1.) * 4;
  const int stop = std::min(3, static_cast<int>(place));
  const double t = place - stop;
  Pixel pixel;
  for (int k = 0; k < 3; ++k)
  {
    pixel[k] = static_cast<unsigned char>((1 - t) * stops[stop][k] + t * stops[stop + 1][k]);
  }
  return pixel;
}

double densityOf(vtkFloatArray* control, vtkFloatArray* area, vtkIdType i)
{
  const double a = area->GetValue(i);
  return a > 0 ? control->GetValue(i) / a : 0;
}
}

BeforeScene::BeforeScene(vtkRenderer* renderer, vtkPolyData* input, bool solid)
  : Renderer(renderer)
  , Input(input)
  , Solid(solid)
  , InputEdge(meanEdge(input))
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(bareSurface(input));
  this->Surface = vtkSmartPointer<vtkActor>::New();
  this->Surface->SetMapper(mapper);
  setSurfaceLook(this->Surface->GetProperty());
  this->Surface->GetProperty()->SetBackfaceCulling(solid);
  renderer->AddActor(this->Surface);
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
  this->Charts.clear();
  this->Halftones = nullptr;
  this->Controls = nullptr;
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
    chart.metrics = metricsOf(chartOf(charts, c));
    chart.texture = vtkSmartPointer<vtkImageData>::New();
    chart.texture->SetDimensions(1, 1, 1);
    chart.texture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::copy(SurfacePixel.begin(), SurfacePixel.end(),
      static_cast<unsigned char*>(chart.texture->GetScalarPointer()));
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
  for (int type = 0; type < 3; ++type)
  {
    static_cast<vtkPolyDataMapper*>(this->Lines[type]->GetMapper())
      ->SetInputData(backbonesOfType(graph, type));
  }
  this->showRightActors();
}

void BeforeScene::setPreview(vtkPartitionedDataSetCollection* halftones,
  vtkPartitionedDataSetCollection* controls, long long numberOfSamples)
{
  this->NumberOfSamples = static_cast<double>(numberOfSamples);
  this->Halftones = halftones;
  this->Controls = controls;
  this->paintTextures();
}

void BeforeScene::paintTextures()
{
  if (!this->Halftones || this->View.display == Display::Input)
  {
    return;
  }
  const double integral = integralOf(this->Controls);
  const double samplesPerControl = integral > 0 ? this->NumberOfSamples / integral : 0;
  double most = 0;
  std::vector<std::pair<vtkFloatArray*, vtkFloatArray*>> maps(this->Charts.size());
  for (std::size_t c = 0; this->View.display == Display::Density && c < this->Charts.size(); ++c)
  {
    vtkPointData* data = imageOf(this->Controls, c)->GetPointData();
    maps[c] = { vtkFloatArray::SafeDownCast(data->GetArray("Control")),
      vtkFloatArray::SafeDownCast(data->GetArray("AreaDistortion")) };
    for (vtkIdType i = 0; maps[c].first && i < maps[c].first->GetNumberOfValues(); i += 7)
    {
      most = std::max(most, densityOf(maps[c].first, maps[c].second, i));
    }
  }
  for (std::size_t c = 0; c < this->Charts.size(); ++c)
  {
    vtkImageData* texture = this->Charts[c].texture;
    if (this->View.display == Display::Samples)
    {
      paintSamples(imageOf(this->Halftones, c), imageOf(this->Controls, c), this->Charts[c].metrics,
        samplesPerControl, texture);
      continue;
    }
    const bool charts = this->View.display == Display::Charts;
    vtkImageData* image = imageOf(this->Controls, c);
    const int one[3] = { 1, 1, 1 };
    texture->SetDimensions(charts ? one : image->GetDimensions());
    texture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixels = reinterpret_cast<Pixel*>(texture->GetScalarPointer());
    for (vtkIdType i = 0; i < texture->GetNumberOfPoints(); ++i)
    {
      pixels[i] = charts
        ? chartColor(static_cast<int>(c))
        : densityPixel(densityOf(maps[c].first, maps[c].second, i) / (most > 0 ? most : 1));
    }
    texture->Modified();
  }
}

void BeforeScene::setView(const ViewState& view, float lineWidth)
{
  const bool repaint = view.display != this->View.display;
  this->View = view;
  this->LineWidth = lineWidth;
  if (repaint)
  {
    this->paintTextures();
  }
  this->showRightActors();
}

void BeforeScene::showRightActors()
{
  const bool charts = this->View.display != Display::Input && !this->Charts.empty();
  this->Surface->SetVisibility(!charts);
  for (const Chart& chart : this->Charts)
  {
    chart.actor->SetVisibility(charts);
  }
  for (int type = 0; type < 3; ++type)
  {
    const bool on =
      type == 2 ? this->View.seams || this->View.display == Display::Charts : this->View.features;
    auto* lines = vtkPolyData::SafeDownCast(this->Lines[type]->GetMapper()->GetInput());
    this->Lines[type]->SetVisibility(on && lines && lines->GetNumberOfLines() > 0);
    this->Lines[type]->GetProperty()->SetLineWidth((type == 2 ? 1.5F : 2.5F) * this->LineWidth);
  }
  this->Edges->GetProperty()->SetLineWidth(4 * this->LineWidth);
  this->Brush->GetProperty()->SetLineWidth(2 * this->LineWidth);
  this->Points->GetProperty()->SetPointSize(11 * this->LineWidth);
  const bool edges = this->View.display == Display::Input;
  setEdgeLook(
    this->Surface->GetProperty(), edges ? this->InputEdge * this->Zoom : 0, this->LineWidth);
}

void BeforeScene::setZoom(double pixelsPerLength)
{
  this->Zoom = pixelsPerLength;
  this->showRightActors();
}

void BeforeScene::setMarks(const Session& session)
{
  vtkNew<vtkPoints> positions;
  vtkNew<vtkCellArray> vertices;
  for (const Vec3& p : session.constraints)
  {
    const vtkIdType id = positions->InsertNextPoint(p.data());
    vertices->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(positions);
  points->SetVerts(vertices);
  static_cast<vtkPolyDataMapper*>(this->Points->GetMapper())->SetInputData(points);
  this->Points->SetVisibility(!session.constraints.empty());
  vtkNew<vtkCellArray> lines;
  for (const auto& edge : session.featureEdges)
  {
    const vtkIdType ids[2] = { static_cast<vtkIdType>(edge[0]), static_cast<vtkIdType>(edge[1]) };
    lines->InsertNextCell(2, ids);
  }
  vtkNew<vtkPolyData> edges;
  edges->SetPoints(this->Input->GetPoints());
  edges->SetLines(lines);
  static_cast<vtkPolyDataMapper*>(this->Edges->GetMapper())->SetInputData(edges);
  this->Edges->SetVisibility(!session.featureEdges.empty());
}

void BeforeScene::setBrush(const Vec3& position, const Vec3& normal, double radius)
{
  vtkNew<vtkPolyData> circle;
  if (radius > 0)
  {
    constexpr int Steps = 48;
    Vec3 across = normal.cross(Vec3::UnitX());
    across = across.norm() < 0.1 ? normal.cross(Vec3::UnitY()) : across;
    across.normalize();
    const Vec3 along = normal.cross(across);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(Steps + 1);
    for (int i = 0; i < Steps; ++i)
    {
      const double angle = 2 * 3.14159265358979323846 * i / Steps;
      const Vec3 p = position + 0.05 * radius * normal +
        radius * (std::cos(angle) * across + std::sin(angle) * along);
      points->InsertNextPoint(p.data());
      lines->InsertCellPoint(i);
    }
    lines->InsertCellPoint(0);
    circle->SetPoints(points);
    circle->SetLines(lines);
  }
  static_cast<vtkPolyDataMapper*>(this->Brush->GetMapper())->SetInputData(circle);
  this->Brush->SetVisibility(radius > 0);
}
}
