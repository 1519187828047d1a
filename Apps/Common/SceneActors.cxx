// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneActors.h"

#include "PolyDataConversion.h"
#include "TextNumbers.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkLightKit.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
std::string grouped(long long number)
{
  std::string text = std::to_string(number);
  for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3)
  {
    text.insert(i, ",");
  }
  return text;
}

std::string numberText(double number)
{
  constexpr double LargestWhole = 9'007'199'254'740'992.; // 2^53
  return number == std::trunc(number) && std::abs(number) < LargestWhole
    ? grouped(static_cast<long long>(number))
    : shortestText(number);
}

std::array<unsigned char, 3> chartColor(int chart)
{
  const double hue = std::fmod(0.58 + 0.618033988749895 * chart, 1.);
  double rgb[3];
  vtkMath::HSVToRGB(
    hue, 0.30 + 0.08 * (chart % 3), 0.96 - 0.06 * ((chart / 3) % 3), rgb, rgb + 1, rgb + 2);
  return { { static_cast<unsigned char>(255 * rgb[0]), static_cast<unsigned char>(255 * rgb[1]),
    static_cast<unsigned char>(255 * rgb[2]) } };
}

vtkSmartPointer<vtkPolyData> bareSurface(vtkPolyData* mesh)
{
  auto faces = vtkSmartPointer<vtkPolyData>::New();
  faces->SetPoints(mesh->GetPoints());
  faces->SetPolys(mesh->GetPolys());
  faces->SetStrips(mesh->GetStrips());
  return faces;
}

void setSurfaceLook(vtkProperty* property)
{
  property->SetColor(Clay[0], Clay[1], Clay[2]);
  property->SetInterpolationToFlat();
  setShading(property, false);
}

void setShading(vtkProperty* property, bool hasLegend)
{
  const double evenly = hasLegend ? 0.6 : 0.08;
  property->SetAmbient(evenly);
  property->SetDiffuse(1. - evenly);
}

void setEdgeLook(vtkProperty* property, double pixels, double scale)
{
  if (pixels < 3.)
  {
    property->EdgeVisibilityOff();
    return;
  }
  // The denser the mesh, the fainter its edges: they must not hide the shading.
  const double strength = std::clamp((pixels - 2.) / 10., 0.35, 1.);
  property->EdgeVisibilityOn();
  property->SetEdgeColor(Clay[0] + strength * (Edge[0] - Clay[0]),
    Clay[1] + strength * (Edge[1] - Clay[1]), Clay[2] + strength * (Edge[2] - Clay[2]));
  property->SetLineWidth(static_cast<float>(pixels > 8. ? scale : 0.5 * scale));
}

bool showsInspectionEdges(double pixels)
{
  // A pixel wide they cover 2 sqrt(3) / length of equilateral triangles: three quarters of these,
  // where no shading is left to see.
  constexpr double Shortest = 4.6;
  return pixels >= Shortest;
}

void setInspectionEdgeLook(vtkProperty* property, double pixels, double scale)
{
  if (!showsInspectionEdges(pixels))
  {
    property->EdgeVisibilityOff();
    return;
  }
  const double strength = std::clamp((pixels - 2.) / 6., 0.1, 0.85);
  property->EdgeVisibilityOn();
  property->SetEdgeColor(Clay[0] + strength * (Edge[0] - Clay[0]),
    Clay[1] + strength * (Edge[1] - Clay[1]), Clay[2] + strength * (Edge[2] - Clay[2]));
  property->SetLineWidth(static_cast<float>(scale * std::clamp((pixels - 4.) / 14., 0.15, 1.)));
}

vtkSmartPointer<vtkActor> lineActor(vtkPolyData* lines, const Color& color, double width)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->ScalarVisibilityOff();
  // Nearer than the surface that they lie on, wherever that is steep.
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -8);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> wireActor(vtkPolyData* surface)
{
  vtkSmartPointer<vtkActor> actor = lineActor(surface, Edge, 1);
  actor->GetProperty()->SetRepresentationToWireframe();
  return actor;
}

double meanEdge(vtkPolyData* mesh)
{
  const TriangleSurface surface = fromPolyData(mesh);
  return surface.triangles.empty() ? 0.
                                   : std::sqrt(4. / std::sqrt(3.) * surface.area() /
                                       static_cast<double>(surface.triangles.size()));
}

void addLights(vtkRenderer* renderer)
{
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.85);
  lights->SetKeyLightWarmth(0.53);
  lights->AddLightsToRenderer(renderer);
}

void addInspectionLights(vtkRenderer* renderer)
{
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.57);
  lights->SetKeyLightWarmth(0.53);
  lights->SetKeyToHeadRatio(1.0);
  lights->AddLightsToRenderer(renderer);
}

void aimCamera(vtkRenderer* renderer, vtkPolyData* surface, double aspect, double margin)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(ViewFrom[0], ViewFrom[1], ViewFrom[2]);
  camera->SetViewUp(0, 1, 0);
  fitCamera(renderer, surface, aspect, margin);
}

void fitCamera(vtkRenderer* renderer, vtkPolyData* surface, double aspect, double margin)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vec3 from = -Vec3(camera->GetDirectionOfProjection());
  const Vec3 right = Vec3(camera->GetViewUp()).cross(from).normalized();
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
  const double tangent =
    (1. - 2. * margin) * std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  double distance = 0;
  for (const Triangle& t : triangles.triangles)
  {
    for (const int p : t)
    {
      const Vec3 q = axes.transpose() * triangles.points[p] - center;
      distance =
        std::max(distance, q.z() + std::max(std::abs(q.x()) / aspect, std::abs(q.y())) / tangent);
    }
  }
  const Vec3 focus = axes * center;
  const Vec3 position = focus + (distance > 0 ? distance : 1.) * from;
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  camera->SetViewAngle(ViewAngle);
}
}
