// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraMoves.h"

#include "CellLocator.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
namespace
{
/// Three corners of a cell.
std::array<Vec3, 3> cornersOf(vtkPolyData* mesh, vtkIdType cell)
{
  vtkIdType size;
  const vtkIdType* ids;
  mesh->GetPolys()->GetCellAtId(cell, size, ids);
  return { { Vec3(mesh->GetPoint(ids[0])), Vec3(mesh->GetPoint(ids[1])),
    Vec3(mesh->GetPoint(ids[2])) } };
}

Vec3 normalOf(const std::array<Vec3, 3>& corners)
{
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

/// What one sees of a mesh.
class Outlook
{
public:
  explicit Outlook(vtkPolyData* mesh)
    : Mesh(mesh)
    , Locator(mesh)
  {
  }

  /// How far one sees.
  double reach(const Vec3& place, const Vec3& direction) const
  {
    double t = 1;
    return this->hit(place, direction, t) < 0 ? std::numeric_limits<double>::infinity()
                                              : t * this->Mesh->GetLength();
  }
  /// Whether one looks at the back of what one sees.
  bool isInside(const Vec3& place, const Vec3& direction) const
  {
    double t = 1;
    const vtkIdType cell = this->hit(place, direction, t);
    return cell >= 0 && normalOf(cornersOf(this->Mesh, cell)).dot(direction) > 0;
  }

private:
  /// The cell that is seen first, t of the mesh's diagonal away; -1 if there is none.
  vtkIdType hit(const Vec3& place, const Vec3& direction, double& t) const
  {
    return this->Locator.firstHit(place, place + this->Mesh->GetLength() * direction, t).cell;
  }

  vtkPolyData* Mesh;
  CellLocator Locator;
};

constexpr double Own = 0.05; // of the size: what is so near is not in the way

/// At a place, of something of that size, from a side or, where the mesh is in the way, aslant.
void look(vtkCamera* camera, const Outlook& outlook, const Vec3& middle, double size, Vec3 from)
{
  constexpr double ShareOfView = 0.1;
  const double wanted =
    0.5 * size / ShareOfView / std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  // Straight on, but where the surface is in the way, as in a crevice: aslant from where it is not,
  // or the least.
  constexpr double Before = 0.8; // of the way to it
  const Vec3 right = from.unitOrthogonal();
  const Vec3 ahead = from.cross(right);
  double distance = 0;
  Vec3 best = from;
  for (const double tilt : { 0., 25., 50., 70. })
  {
    for (int turn = 0; turn < (tilt > 0 ? 12 : 1) && distance < wanted; ++turn)
    {
      const double slope = vtkMath::RadiansFromDegrees(tilt);
      const double around = vtkMath::RadiansFromDegrees(30. * turn);
      const Vec3 direction = std::cos(slope) * from +
        std::sin(slope) * (std::cos(around) * right + std::sin(around) * ahead);
      const double clear =
        std::min(wanted, Before * outlook.reach(middle + Own * size * direction, direction));
      if (clear > distance)
      {
        distance = clear;
        best = direction;
      }
    }
  }
  from = best;
  distance = std::max(distance, size); // never in the triangle itself
  const Vec3 position = middle + distance * from;
  Vec3 up(camera->GetViewUp());
  up = std::abs(up.normalized().dot(from)) < 0.95 ? up : from.unitOrthogonal();
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
}
}

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

void lookAt(vtkCamera* camera, vtkPolyData* mesh, vtkIdType cell, bool isSolid)
{
  const std::array<Vec3, 3> corners = cornersOf(mesh, cell);
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
  const double size = std::max({ (corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(),
    (corners[0] - corners[2]).norm() });
  Vec3 from = normalOf(corners);
  from = from.norm() > 1e-9 * size * size ? from.normalized()
                                          : -Vec3(camera->GetDirectionOfProjection());
  const Outlook outlook(mesh);
  if (isSolid && outlook.isInside(middle + Own * size * from, from))
  {
    from = -from;
  }
  look(camera, outlook, middle, size, from);
}

void lookAt(
  vtkCamera* camera, vtkPolyData* surface, const Vec3& place, double size, const Vec3& from)
{
  look(camera, Outlook(surface), place, size, from);
}

void zoomAbout(vtkCamera* camera, const Vec3& center, double factor)
{
  const Vec3 position = center + (Vec3(camera->GetPosition()) - center) / factor;
  const Vec3 focus = center + (Vec3(camera->GetFocalPoint()) - center) / factor;
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focus.data());
}
}
