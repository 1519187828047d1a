// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraMoves.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <cmath>

namespace stipple
{
Vec3 focalPlaneAt(vtkRenderer* renderer, double x, double y)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const int* origin = renderer->GetOrigin();
  const int* size = renderer->GetSize();
  const Vec3 focus(camera->GetFocalPoint());
  const Vec3 ahead(camera->GetDirectionOfProjection());
  const Vec3 right = ahead.cross(Vec3(camera->GetViewUp())).normalized();
  const Vec3 up = right.cross(ahead);
  // Of half the view's height.
  const double dx = 2. * (x - origin[0] - 0.5 * size[0]) / size[1];
  const double dy = 2. * (y - origin[1] - 0.5 * size[1]) / size[1];
  const double half =
    camera->GetDistance() * std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  return focus + half * (dx * right + dy * up);
}

std::array<double, 9> placeOf(vtkCamera* camera)
{
  std::array<double, 9> place;
  camera->GetPosition(place.data());
  camera->GetFocalPoint(place.data() + 3);
  camera->GetViewUp(place.data() + 6);
  return place;
}

void zoomAbout(vtkCamera* camera, const Vec3& center, double factor)
{
  const Vec3 position = center + (Vec3(camera->GetPosition()) - center) / factor;
  const Vec3 focus = center + (Vec3(camera->GetFocalPoint()) - center) / factor;
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focus.data());
}
}
