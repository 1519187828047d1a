// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePicker.h"

#include "CoincidentPoints.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkTriangleStrip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

namespace stipple
{
namespace
{
/// Direction of the ray of a perspective camera through a pixel, of length 1. It follows from the
/// camera's own frame. vtkRenderer::DisplayToWorld would take it from the clipping planes, which
/// follow whatever is drawn at the time: the last digits of a place would hang on how far a mesh
/// is.
Vec3 rayThrough(vtkRenderer* renderer, double x, double y)
{
  renderer->SetDisplayPoint(x, y, 0);
  renderer->DisplayToView();
  const double* view = renderer->GetViewPoint();
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vec3 ahead = (Vec3(camera->GetFocalPoint()) - Vec3(camera->GetPosition())).normalized();
  const Vec3 right = ahead.cross(Vec3(camera->GetViewUp())).normalized();
  const Vec3 up = right.cross(ahead);
  const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  return (ahead + half * (view[0] * renderer->GetTiledAspectRatio() * right + view[1] * up))
    .normalized();
}

vtkSmartPointer<vtkCellArray> renumbered(vtkCellArray* cells, const std::vector<vtkIdType>& ids)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->AllocateCopy(cells);
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    cells->GetCellAtId(c, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      corners->SetId(i, ids[corners->GetId(i)]);
    }
    result->InsertNextCell(corners);
  }
  return result;
}
}

SurfacePicker::SurfacePicker(vtkPolyData* input)
  : Input(vtkSmartPointer<vtkPolyData>::New())
{
  this->Input->SetPoints(input->GetPoints());
  const std::vector<vtkIdType> firstAt = firstAtPlace(input);
  for (std::size_t p = 0; p < firstAt.size(); ++p)
  {
    this->NumberOfPoints += firstAt[p] == static_cast<vtkIdType>(p);
  }
  this->Input->SetPolys(renumbered(input->GetPolys(), firstAt));
  const vtkSmartPointer<vtkCellArray> strips = renumbered(input->GetStrips(), firstAt);
  vtkIdType size;
  const vtkIdType* corners;
  for (vtkIdType strip = 0; strip < strips->GetNumberOfCells(); ++strip)
  {
    strips->GetCellAtId(strip, size, corners);
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(size), corners, this->Input->GetPolys());
  }
  this->Input->BuildLinks();
  this->Locator = std::make_unique<CellLocator>(this->Input);
}

SurfacePicker::~SurfacePicker() = default;

bool SurfacePicker::pick(vtkRenderer* renderer, double x, double y, PickedPlace& place) const
{
  const Vec3 eye(renderer->GetActiveCamera()->GetPosition());
  // Beyond the surface wherever it is hit.
  const Vec3 center(this->Input->GetCenter());
  const Vec3 end =
    eye + ((center - eye).norm() + this->Input->GetLength()) * rayThrough(renderer, x, y);
  double t = 0;
  const CellLocator::Place hit = this->Locator->firstHit(eye, end, t);
  if (hit.cell < 0)
  {
    return false;
  }
  place = this->placeOn(hit.cell, hit.position);
  return true;
}

PickedPlace SurfacePicker::nearest(const Vec3& position) const
{
  const CellLocator::Place nearest = this->Locator->nearest(position);
  return this->placeOn(nearest.cell, nearest.position);
}

PickedPlace SurfacePicker::placeOn(vtkIdType cell, const Vec3& position) const
{
  PickedPlace place;
  place.position = position;
  vtkNew<vtkIdList> ids;
  this->Input->GetCellPoints(cell, ids);
  const vtkIdType size = ids->GetNumberOfIds();
  double nearestEdge = std::numeric_limits<double>::max();
  double nearestPoint = nearestEdge;
  Vec3 normal = Vec3::Zero();
  for (vtkIdType k = 0; k < size; ++k)
  {
    const vtkIdType p = ids->GetId(k);
    const vtkIdType q = ids->GetId((k + 1) % size);
    const Vec3 a(this->Input->GetPoint(p));
    const Vec3 b(this->Input->GetPoint(q));
    normal += (a - place.position).cross(b - place.position);
    if (const double d = distanceToSegment(place.position, a, b); d < nearestEdge)
    {
      nearestEdge = d;
      place.edge = { { std::min(p, q), std::max(p, q) } };
    }
    if (const double d = (a - place.position).norm(); d < nearestPoint)
    {
      nearestPoint = d;
      place.point = p;
    }
  }
  place.normal = normal.norm() > 0 ? normal.normalized() : Vec3::UnitZ();
  return place;
}

std::vector<std::array<vtkIdType, 2>> SurfacePicker::shortestPath(
  vtkIdType from, vtkIdType to) const
{
  // Dijkstra over the faces' sides.
  using Entry = std::pair<double, vtkIdType>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  std::unordered_map<vtkIdType, double> distance = { { from, 0. } };
  std::unordered_map<vtkIdType, vtkIdType> before;
  front.push({ 0., from });
  vtkNew<vtkIdList> cells;
  vtkNew<vtkIdList> ids;
  while (!front.empty() && front.top().second != to)
  {
    const auto [d, p] = front.top();
    front.pop();
    if (d > distance[p])
    {
      continue;
    }
    this->Input->GetPointCells(p, cells);
    for (vtkIdType c = 0; c < cells->GetNumberOfIds(); ++c)
    {
      this->Input->GetCellPoints(cells->GetId(c), ids);
      const vtkIdType size = ids->GetNumberOfIds();
      const vtkIdType corner = ids->IsId(p);
      for (const vtkIdType side : { (corner + 1) % size, (corner + size - 1) % size })
      {
        const vtkIdType q = ids->GetId(side);
        const double length =
          d + (Vec3(this->Input->GetPoint(p)) - Vec3(this->Input->GetPoint(q))).norm();
        const auto known = distance.find(q);
        if (known == distance.end() || length < known->second)
        {
          distance[q] = length;
          before[q] = p;
          front.push({ length, q });
        }
      }
    }
  }
  std::vector<std::array<vtkIdType, 2>> path;
  for (vtkIdType p = to; p != from;)
  {
    const auto step = before.find(p);
    if (step == before.end())
    {
      return {};
    }
    path.push_back({ { std::min(p, step->second), std::max(p, step->second) } });
    p = step->second;
  }
  return path;
}
}
