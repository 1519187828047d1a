// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureScene.h"

#include "Backbones.h"
#include "ChartsInOnePiece.h"
#include "MapContactSheet.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"
#include "SceneActors.h"
#include "Text.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
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

namespace stipple
{
namespace
{
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

/// Pixels of the picture that a length at the model's centre takes.
double pixelsOf(double length, vtkRenderer* renderer, const PanelLayout& layout)
{
  const double height = 2. * renderer->GetActiveCamera()->GetDistance() *
    std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  return length / height * layout.height / layout.scale;
}

vtkProperty* addSurface(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(bareSurface(mesh));
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  setSurfaceLook(actor->GetProperty());
  renderer->AddActor(actor);
  return actor->GetProperty();
}

void addLines(vtkRenderer* renderer, vtkPolyData* lines, const Color& color, double width)
{
  if (lines->GetNumberOfLines() > 0)
  {
    renderer->AddActor(lineActor(lines, color, width));
  }
}

void addFeatures(
  vtkRenderer* renderer, vtkPolyData* lines, vtkPolyData* creases, const PanelLayout& layout)
{
  addLines(renderer, backbonesOfType(lines, 1), BoundaryBlue, 2. * layout.scale);
  addLines(renderer, creases, FeatureRed, 2. * layout.scale);
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
  const vtkSmartPointer<vtkPolyData> faces = bareSurface(surface);
  faces->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(faces);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
  addLines(renderer, backbonesOfType(content.graph, 2), Ink, 2. * layout.scale);
  addFeatures(renderer, content.graph, content.creases, layout);
}

void addSamples(vtkRenderer* renderer, const PictureContent& content, const PanelLayout& layout)
{
  addSurface(renderer, content.before);
  addFeatures(renderer, content.graph, content.creases, layout);
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
  addLights(renderer);
  // The margin leaves room for the label.
  aimCamera(renderer, content.before, 1., 48. * layout.scale / layout.height);
  const auto charts = content.charts->GetNumberOfPartitionedDataSets();
  switch (panel)
  {
    case PicturePanel::Before:
      setEdgeLook(addSurface(renderer, content.before),
        pixelsOf(meanEdge(content.before), renderer, layout), layout.scale);
      addFeatures(renderer, content.graph, content.creases, layout);
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
      setEdgeLook(addSurface(renderer, content.after),
        pixelsOf(meanEdge(content.after), renderer, layout), layout.scale);
      addFeatures(renderer, content.lines, backbonesOfType(content.lines, 0), layout);
      addLabel(renderer, layout, "after",
        grouped(content.after->GetNumberOfPoints()) + " points, " +
          grouped(content.after->GetNumberOfPolys()) +
          (content.after->GetPolys()->IsHomogeneous() == 3 ? " triangles" : " faces"));
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
  addText(renderer, nameOfFile(content.name), 40 * s, layout.height - 90 * s, 30 * s, true);
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
