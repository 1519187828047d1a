// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraMoves.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
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

void lookAt(vtkCamera* camera, const Vec3 corners[3])
{
  constexpr double ShareOfView = 0.1;
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
  const double size = std::max({ (corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(),
    (corners[0] - corners[2]).norm() });
  Vec3 from = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  from = from.norm() > 1e-9 * size * size ? from.normalized()
                                          : -Vec3(camera->GetDirectionOfProjection());
  const double distance =
    0.5 * size / ShareOfView / std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  const Vec3 position = middle + distance * from;
  Vec3 up(camera->GetViewUp());
  up = std::abs(up.normalized().dot(from)) < 0.95 ? up : from.unitOrthogonal();
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
}

void zoomAbout(vtkCamera* camera, const Vec3& center, double factor)
{
  const Vec3 position = center + (Vec3(camera->GetPosition()) - center) / factor;
  const Vec3 focus = center + (Vec3(camera->GetFocalPoint()) - center) / factor;
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focus.data());
}
}
