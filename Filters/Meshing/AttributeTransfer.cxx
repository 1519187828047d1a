// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AttributeTransfer.h"

#include "CornerTexture.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

namespace stipple
{
bool isChartArray(const std::string& name)
{
  return name == "UV" || name == "SurfacePointId" || name == "SourceCellId" ||
    name == "AreaDistortion" || name == "LargestNormalCurvature" || name == CornerTextureName;
}

namespace
{
/// Whether an array says something of the surface, and neither of its charts nor of which cells of
/// the data it came in are to be seen.
bool isOfSurface(const char* name)
{
  return name && *name && !isChartArray(name) &&
    name != std::string(vtkDataSetAttributes::GhostArrayName());
}

/// The arrays of that name in all charts; empty if one chart lacks it or has another type of it.
std::vector<vtkAbstractArray*> inAllCharts(
  const AtlasSurface& surface, const char* name, vtkDataSetAttributes* (*data)(vtkPolyData*))
{
  std::vector<vtkAbstractArray*> arrays;
  for (vtkPolyData* chart : surface.charts)
  {
    vtkAbstractArray* array = data(chart)->GetAbstractArray(name);
    if (!array ||
      (!arrays.empty() &&
        (array->GetDataType() != arrays[0]->GetDataType() ||
          array->GetNumberOfComponents() != arrays[0]->GetNumberOfComponents())))
    {
      return {};
    }
    arrays.push_back(array);
  }
  return arrays;
}

vtkDataSetAttributes* pointData(vtkPolyData* data)
{
  return data->GetPointData();
}
vtkDataSetAttributes* cellData(vtkPolyData* data)
{
  return data->GetCellData();
}

vtkSmartPointer<vtkAbstractArray> emptyLike(vtkAbstractArray* source, vtkIdType size)
{
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(source->NewInstance());
  array->SetName(source->GetName());
  array->SetNumberOfComponents(source->GetNumberOfComponents());
  for (int k = 0; k < source->GetNumberOfComponents(); ++k)
  {
    if (source->GetComponentName(k))
    {
      array->SetComponentName(k, source->GetComponentName(k));
    }
  }
  array->SetNumberOfTuples(size);
  return array;
}

void makeUnit(vtkDataArray* normals)
{
  for (vtkIdType i = 0; normals->GetNumberOfComponents() == 3 && i < normals->GetNumberOfTuples();
       ++i)
  {
    Vec3 n;
    normals->GetTuple(i, n.data());
    if (n.norm() > 0)
    {
      n.normalize();
      normals->SetTuple(i, n.data());
    }
  }
}

/// Adds the array, active for what it is active for in the chart.
void handOver(vtkDataSetAttributes* from, vtkAbstractArray* array, vtkDataSetAttributes* to)
{
  to->AddArray(array);
  for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
  {
    vtkAbstractArray* active = from->GetAbstractAttribute(attribute);
    if (active && active->GetName() && std::string(active->GetName()) == array->GetName())
    {
      to->SetActiveAttribute(array->GetName(), attribute);
      if (attribute == vtkDataSetAttributes::NORMALS)
      {
        makeUnit(vtkDataArray::SafeDownCast(array));
      }
    }
  }
}

/// Among the faces that meet at a place, the one that lies best under a triangle with that normal
/// and centroid.
SurfacePlace startUnder(const TriangleSurface& surface, const SurfaceWalk& walk,
  const SurfacePlace& place, const Vec3& normal, const Vec3& towards)
{
  constexpr double OnEdge = 1e-9;
  const auto rate = [&](const SurfacePlace& p) {
    // Turned the same way, and open in the direction of the centroid.
    const SurfacePlace ahead = walk.walk(p, 1e-3 * towards, true);
    return walk.normal(p.face).dot(normal) - (ahead.face == p.face ? 0. : 0.5);
  };
  SurfacePlace start = place;
  double best = rate(place);
  const auto consider = [&](int h, double atTail, double atHead) {
    SurfacePlace p;
    p.face = h / 3;
    p.bary[h % 3] = atTail;
    p.bary[nextHalfedge(h) % 3] = atHead;
    const double r = rate(p);
    if (r > best)
    {
      best = r;
      start = p;
    }
  };
  int largest = 0;
  place.bary.maxCoeff(&largest);
  if (place.bary[largest] > 1. - OnEdge)
  {
    const int first = 3 * place.face + largest;
    int h = surface.twin[previousHalfedge(first)];
    while (h >= 0 && h != first)
    {
      consider(h, 1., 0.);
      h = surface.twin[previousHalfedge(h)];
    }
    for (int g = surface.twin[first]; h < 0 && g >= 0; g = surface.twin[nextHalfedge(g)])
    {
      consider(nextHalfedge(g), 1., 0.);
    }
    return start;
  }
  for (int k = 0; k < 3; ++k)
  {
    const int h = 3 * place.face + k;
    if (place.bary[(k + 2) % 3] < OnEdge && surface.twin[h] >= 0)
    {
      consider(surface.twin[h], place.bary[(k + 1) % 3], place.bary[k]);
    }
  }
  return start;
}
}

std::vector<int> facesUnderTriangles(const TriangleSurface& surface, const SurfaceWalk& walk,
  const std::vector<SurfacePlace>& places, const std::vector<Triangle>& triangles)
{
  std::vector<int> result(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    std::array<Vec3, 3> p;
    int inner = 0; // the corner farthest from the edges of its face: it lies on no crease
    for (int k = 0; k < 3; ++k)
    {
      const SurfacePlace& place = places[triangles[t][k]];
      p[k] = surface.position(place.face, place.bary);
      if (place.bary.minCoeff() > places[triangles[t][inner]].bary.minCoeff())
      {
        inner = k;
      }
    }
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    const Vec3 towards = (p[0] + p[1] + p[2]) / 3. - p[inner];
    const SurfacePlace start =
      startUnder(surface, walk, places[triangles[t][inner]], normal, towards);
    result[t] = walk.walk(start, towards, true).face;
  }
  return result;
}

void transferAttributes(const AtlasSurface& surface, const SurfaceWalk& walk,
  const std::vector<SurfacePlace>& places, const std::vector<Triangle>& triangles,
  vtkPolyData* mesh)
{
  if (surface.charts.empty())
  {
    return;
  }
  vtkPolyData* first = surface.charts.front();
  const vtkIdType numberOfPoints = static_cast<vtkIdType>(places.size());
  vtkNew<vtkIdList> corners;
  corners->SetNumberOfIds(3);
  for (int a = 0; a < first->GetPointData()->GetNumberOfArrays(); ++a)
  {
    const char* name = first->GetPointData()->GetArrayName(a);
    if (!isOfSurface(name))
    {
      continue;
    }
    const auto sources = inAllCharts(surface, name, pointData);
    if (sources.empty())
    {
      continue;
    }
    auto array = emptyLike(sources[0], numberOfPoints);
    const bool floating = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
    for (vtkIdType i = 0; i < numberOfPoints; ++i)
    {
      const SurfacePlace& place = places[i];
      vtkAbstractArray* source = sources[surface.faceChart[place.face]];
      const Triangle& ids = surface.chartPoints[place.face];
      if (floating)
      {
        for (int k = 0; k < 3; ++k)
        {
          corners->SetId(k, ids[k]);
        }
        Vec3 weights = place.bary;
        array->InterpolateTuple(i, corners, source, weights.data());
      }
      else
      {
        const int nearest = nearestCorner(place.bary, surface.point(place.face, 0),
          surface.point(place.face, 1), surface.point(place.face, 2));
        array->SetTuple(i, ids[nearest], source);
      }
    }
    handOver(first->GetPointData(), array, mesh->GetPointData());
  }

  std::vector<int> under;
  for (int a = 0; a < first->GetCellData()->GetNumberOfArrays(); ++a)
  {
    const char* name = first->GetCellData()->GetArrayName(a);
    const auto sources =
      isOfSurface(name) ? inAllCharts(surface, name, cellData) : std::vector<vtkAbstractArray*>();
    if (sources.empty())
    {
      continue;
    }
    if (under.empty())
    {
      under = facesUnderTriangles(surface, walk, places, triangles);
    }
    auto array = emptyLike(sources[0], static_cast<vtkIdType>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const int chart = surface.faceChart[under[t]];
      array->SetTuple(
        static_cast<vtkIdType>(t), under[t] - surface.chartBegin[chart], sources[chart]);
    }
    handOver(first->GetCellData(), array, mesh->GetCellData());
  }
}
}
