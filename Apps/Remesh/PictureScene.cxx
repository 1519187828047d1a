// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureScene.h"

#include "MapPicture.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"
#include "SavedFiles.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
#include "vtkLightKit.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

namespace stipple
{
namespace
{
using Color = std::array<double, 3>;
constexpr Color Ink = { { 0.16, 0.18, 0.21 } };
constexpr Color Paper = { { 1., 1., 1. } };
constexpr Color Clay = { { 0.82, 0.86, 0.91 } };
constexpr Color Edge = { { 0.24, 0.28, 0.34 } };
constexpr Color FeatureRed = { { 0.86, 0.10, 0.13 } };
constexpr Color BoundaryBlue = { { 0.10, 0.32, 0.70 } };
constexpr Color SampleBlue = { { 0.10, 0.20, 0.42 } };

/// A direction from which most models show three of their sides; y is up.
constexpr Color ViewFrom = { { 0.55, 0.38, 1.0 } };
constexpr double ViewAngle = 24;

std::string grouped(long long number)
{
  std::string text = std::to_string(number);
  for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3)
  {
    text.insert(i, ",");
  }
  return text;
}

void addText(vtkRenderer* renderer, const std::string& text, int x, int y, int size, bool bold,
  const Color& color = Ink)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(x, y);
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->SetBold(bold);
  property->SetColor(color[0], color[1], color[2]);
  property->SetVerticalJustificationToTop();
  property->SetLineSpacing(1.35);
  renderer->AddActor2D(actor);
}

void addLabel(vtkRenderer* renderer, const PanelLayout& layout, const std::string& name,
  const std::string& detail)
{
  const int s = layout.scale;
  addText(renderer, name, 16 * s, layout.height - 12 * s, 20 * s, true);
  addText(renderer, detail, 16 * s, layout.height - 38 * s, 14 * s, false, { { 0.4, 0.42, 0.46 } });
}

/// Closer than ResetCamera(), which makes room for the sphere around the bounding box: the surface
/// just fits.
void aimCamera(vtkRenderer* renderer, vtkPolyData* surface, const PanelLayout& layout)
{
  Vec3 from(ViewFrom[0], ViewFrom[1], ViewFrom[2]);
  from.normalize();
  const Vec3 right = Vec3::UnitY().cross(from).normalized();
  const Vec3 up = from.cross(right);
  const TriangleSurface triangles = fromPolyData(surface);
  Eigen::Matrix3d axes;
  axes << right, up, from;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (const Triangle& t : triangles.triangles)
  {
    for (const int p : t)
    {
      const Vec3 q = axes.transpose() * triangles.points[p];
      low = low.cwiseMin(q);
      high = high.cwiseMax(q);
    }
  }
  const Vec3 center = 0.5 * (low + high);
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  const double margin = 1. - 2. * 48. * layout.scale / layout.height; // below the label
  double distance = 0;
  for (const Triangle& t : triangles.triangles)
  {
    for (const int p : t)
    {
      const Vec3 q = axes.transpose() * triangles.points[p] - center;
      distance =
        std::max(distance, q.z() + std::max(std::abs(q.x()), std::abs(q.y())) / (margin * tangent));
    }
  }
  const Vec3 focus = axes * center;
  const Vec3 position = focus + (distance > 0 ? distance : 1.) * from;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  camera->SetViewAngle(ViewAngle);
}

/// Pixels of the picture that a length at the model's centre takes.
double pixelsOf(double length, vtkRenderer* renderer, const PanelLayout& layout)
{
  const double height = 2. * renderer->GetActiveCamera()->GetDistance() *
    std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  return length / height * layout.height / layout.scale;
}

double meanEdge(vtkPolyData* mesh)
{
  // Of triangles near equilateral, from the area of the surface: two sides of one are enough to
  // see.
  const TriangleSurface surface = fromPolyData(mesh);
  return surface.triangles.empty() ? 0.
                                   : std::sqrt(4. / std::sqrt(3.) * surface.area() /
                                       static_cast<double>(surface.triangles.size()));
}

vtkProperty* addSurface(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> faces; // the bare surface: no array of the user's colours it
  faces->SetPoints(mesh->GetPoints());
  faces->SetPolys(mesh->GetPolys());
  faces->SetStrips(mesh->GetStrips());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(faces);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(Clay[0], Clay[1], Clay[2]);
  property->SetInterpolationToFlat();
  property->SetAmbient(0.08);
  property->SetDiffuse(0.92);
  renderer->AddActor(actor);
  return property;
}

/// Edges where they are far enough apart to be seen.
void showEdges(vtkProperty* property, double pixels, const PanelLayout& layout)
{
  if (pixels < 3.)
  {
    return;
  }
  // The denser the mesh, the fainter its edges: they must not hide the shading.
  const double strength = std::clamp((pixels - 2.) / 10., 0.35, 1.);
  property->EdgeVisibilityOn();
  property->SetEdgeColor(Clay[0] + strength * (Edge[0] - Clay[0]),
    Clay[1] + strength * (Edge[1] - Clay[1]), Clay[2] + strength * (Edge[2] - Clay[2]));
  property->SetLineWidth(static_cast<float>(pixels > 8. ? 1. * layout.scale : 0.5 * layout.scale));
}

/// The polylines of a type, by the cell array BackboneType.
void addLines(vtkRenderer* renderer, vtkPolyData* lines, int type, const Color& color, double width)
{
  vtkDataArray* types = lines ? lines->GetCellData()->GetArray("BackboneType") : nullptr;
  if (!types)
  {
    return;
  }
  vtkNew<vtkCellArray> cells;
  const vtkIdType first = lines->GetNumberOfVerts();
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    if (static_cast<int>(types->GetComponent(first + i, 0)) == type)
    {
      vtkIdType size;
      const vtkIdType* ids;
      lines->GetLines()->GetCellAtId(i, size, ids);
      cells->InsertNextCell(size, ids);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(lines->GetPoints());
  data->SetLines(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void addFeatures(vtkRenderer* renderer, vtkPolyData* lines, const PanelLayout& layout)
{
  addLines(renderer, lines, 1, BoundaryBlue, 2. * layout.scale);
  addLines(renderer, lines, 0, FeatureRed, 2. * layout.scale);
}

/// A light colour for each chart; neighbours in number are far apart in hue.
std::array<unsigned char, 3> chartColor(int chart)
{
  const double hue = std::fmod(0.58 + 0.618033988749895 * chart, 1.);
  double rgb[3];
  vtkMath::HSVToRGB(
    hue, 0.30 + 0.08 * (chart % 3), 0.96 - 0.06 * ((chart / 3) % 3), rgb, rgb + 1, rgb + 2);
  return { { static_cast<unsigned char>(255 * rgb[0]), static_cast<unsigned char>(255 * rgb[1]),
    static_cast<unsigned char>(255 * rgb[2]) } };
}

void addCharts(vtkRenderer* renderer, const PictureContent& content, const PanelLayout& layout)
{
  const vtkSmartPointer<vtkPolyData> surface = chartsInOnePiece(content.charts);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("ChartColor");
  colors->SetNumberOfComponents(3);
  vtkDataArray* ids = surface->GetCellData()->GetArray("ChartId");
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    colors->InsertNextTypedTuple(chartColor(static_cast<int>(ids->GetComponent(c, 0))).data());
  }
  vtkNew<vtkPolyData> faces;
  faces->SetPoints(surface->GetPoints());
  faces->SetPolys(surface->GetPolys());
  faces->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(faces);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
  addLines(renderer, content.graph, 2, Ink, 2. * layout.scale);
  addFeatures(renderer, content.graph, layout);
}

void addSamples(vtkRenderer* renderer, const PictureContent& content, const PanelLayout& layout)
{
  addSurface(renderer, content.before);
  addFeatures(renderer, content.graph, layout);
  vtkNew<vtkPolyData> points;
  points->SetPoints(content.samples->GetPoints());
  points->SetVerts(content.samples->GetVerts());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  vtkDataArray* kinds = content.samples->GetPointData()->GetArray("SampleKind");
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    const double kind = kinds ? kinds->GetComponent(p, 0) : 0;
    const Color& color = kind == 3 ? BoundaryBlue : (kind == 2 ? FeatureRed : SampleBlue);
    const unsigned char rgb[3] = { static_cast<unsigned char>(255 * color[0]),
      static_cast<unsigned char>(255 * color[1]), static_cast<unsigned char>(255 * color[2]) };
    colors->InsertNextTypedTuple(rgb);
  }
  points->GetPointData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(points);
  // A dot faces the viewer: bring it forward until a slanting surface does not cut it in half.
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-150.);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const double spacing = pixelsOf(meanEdge(content.after), renderer, layout);
  actor->GetProperty()->SetPointSize(
    static_cast<float>(layout.scale * std::clamp(0.32 * spacing, 1., 5.)));
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void addMaps(vtkRenderer* renderer, const PictureContent& content, const PanelLayout& layout)
{
  const int charts = static_cast<int>(content.maps->GetNumberOfPartitionedDataSets());
  ContactSheetOptions options;
  options.maps = { "AreaDistortion", "MeanCurvature", "Control" };
  options.maximumCharts = std::min(charts, layout.height / layout.scale > 700 ? 6 : 4);
  const double width = layout.width / layout.scale - 24.;
  const double height = layout.height / layout.scale - 76.;
  // Charts are of any shape: see how large the sheet becomes, then let it fill the panel.
  vtkSmartPointer<vtkImageData> sheet = mapContactSheet(content.maps, options);
  for (int attempt = 0; sheet && attempt < 4; ++attempt)
  {
    const int* size = sheet->GetDimensions();
    const double growth = std::min(width / size[0], height / size[1]);
    if (growth >= 1. && growth < 1.05)
    {
      break;
    }
    options.tile = std::clamp(static_cast<int>(options.tile * growth), 16, 1024);
    sheet = mapContactSheet(content.maps, options);
  }
  if (!sheet)
  {
    return;
  }
  const int* size = sheet->GetDimensions();
  vtkNew<vtkImageActor> actor;
  actor->SetInputData(sheet);
  actor->InterpolateOff();
  renderer->AddActor(actor);
  // A pixel of the sheet is a pixel of the picture, below the label, or smaller if it must.
  const double zoom = std::min({ 1., width / size[0], height / size[1] });
  const double* spacing = sheet->GetSpacing();
  const double* origin = sheet->GetOrigin();
  const double x = origin[0] + 0.5 * (size[0] - 1) * spacing[0];
  const double y = origin[1] + 0.5 * (size[1] - 1) * spacing[1] + 26. / zoom * spacing[1];
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(x, y, 0);
  camera->SetPosition(x, y, 100);
  camera->SetViewUp(0, 1, 0);
  camera->SetParallelScale(0.5 * layout.height / layout.scale / zoom * spacing[1]);
  renderer->ResetCameraClippingRange();
}
}

void fillPanel(vtkRenderer* renderer, const PictureContent& content, PicturePanel panel,
  const PanelLayout& layout)
{
  renderer->SetBackground(Paper[0], Paper[1], Paper[2]);
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.85);
  lights->SetKeyLightWarmth(0.53);
  lights->AddLightsToRenderer(renderer);
  aimCamera(renderer, content.before, layout);
  const auto charts = content.charts->GetNumberOfPartitionedDataSets();
  switch (panel)
  {
    case PicturePanel::Before:
      showEdges(addSurface(renderer, content.before),
        pixelsOf(meanEdge(content.before), renderer, layout), layout);
      addFeatures(renderer, content.graph, layout);
      addLabel(renderer, layout, "before",
        grouped(content.before->GetNumberOfPoints()) + " points, " +
          grouped(content.before->GetNumberOfPolys() + content.before->GetNumberOfStrips()) +
          " faces");
      break;
    case PicturePanel::Charts:
      addCharts(renderer, content, layout);
      addLabel(renderer, layout, "charts", grouped(charts) + (charts == 1 ? " chart" : " charts"));
      break;
    case PicturePanel::Maps:
      addMaps(renderer, content, layout);
      addLabel(renderer, layout, "maps",
        "of the first charts: dark is much; blue, red are curvatures below, above 0");
      break;
    case PicturePanel::Samples:
      addSamples(renderer, content, layout);
      addLabel(
        renderer, layout, "samples", grouped(content.samples->GetNumberOfPoints()) + " samples");
      break;
    default:
      showEdges(addSurface(renderer, content.after),
        pixelsOf(meanEdge(content.after), renderer, layout), layout);
      addFeatures(renderer, content.lines, layout);
      addLabel(renderer, layout, "after",
        grouped(content.after->GetNumberOfPoints()) + " points, " +
          grouped(content.after->GetNumberOfPolys()) + " triangles");
  }
  if (panel != PicturePanel::Maps)
  {
    renderer->ResetCameraClippingRange();
  }
}

void fillFacts(vtkRenderer* renderer, const PictureContent& content, const PanelLayout& layout)
{
  const int s = layout.scale;
  renderer->SetBackground(Paper[0], Paper[1], Paper[2]);
  const MeshQuality before = measureQuality(fromPolyData(content.before));
  const MeshQuality after = measureQuality(fromPolyData(content.after));
  addText(renderer, std::filesystem::path(content.name).filename().string(), 40 * s,
    layout.height - 90 * s, 30 * s, true);
  const auto row = [](const char* format, double a, double b) {
    char text[2][32];
    std::snprintf(text[0], sizeof(text[0]), format, a);
    std::snprintf(text[1], sizeof(text[1]), format, b);
    return std::array<std::string, 2>{ { text[0], text[1] } };
  };
  const std::array<std::pair<std::string, std::array<std::string, 2>>, 8> rows = { {
    { "", { { "before", "after" } } },
    { "points", { { grouped(before.numberOfPoints), grouped(after.numberOfPoints) } } },
    { "triangles", { { grouped(before.numberOfTriangles), grouped(after.numberOfTriangles) } } },
    { "mean quality Q", row("%.3f", before.averageQ, after.averageQ) },
    { "least angle, mean",
      row("%.1f\u00b0", before.averageMinimumAngle, after.averageMinimumAngle) },
    { "least angle", row("%.1f\u00b0", before.minimumAngle, after.minimumAngle) },
    { "valence 6", row("%.0f %%", before.percentValence6, after.percentValence6) },
    { "variation of areas", row("%.2f", before.areaVariation, after.areaVariation) },
  } };
  int y = layout.height - 150 * s;
  for (const auto& line : rows)
  {
    addText(renderer, line.first, 40 * s, y, 17 * s, false);
    addText(renderer, line.second[0], 240 * s, y, 17 * s, line.first.empty());
    addText(renderer, line.second[1], 360 * s, y, 17 * s, line.first.empty());
    y -= 32 * s;
  }
}
}
