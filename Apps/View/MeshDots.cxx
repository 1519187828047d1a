// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshDots.h"

#include "NearestTriangle.h"
#include "PolyDataConversion.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// A dot's radius is less than this, over the root of the area that belongs to it.
constexpr double Reach = 0.35;

template <typename Array>
Array* addArray(vtkPolyData* data, const char* name, int components, vtkIdType size)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  data->GetPointData()->AddArray(array);
  return array;
}

/// A third of the triangles around each vertex.
std::vector<double> areasOfVertices(const TriangleSurface& mesh)
{
  std::vector<double> areas(mesh.points.size(), 0.);
  for (const Face face : mesh.faces())
  {
    for (const int p : mesh.triangle(face))
    {
      areas[static_cast<std::size_t>(p)] += mesh.faceArea(face) / 3;
    }
  }
  return areas;
}

Vec2 parameterAt(const AtlasSurface& surface, Face face, const Vec3& position)
{
  const Vec3 bary = barycentricInSpace(
    position, surface.point(face, 0), surface.point(face, 1), surface.point(face, 2));
  return surface.parameter(face, bary.allFinite() ? clampedBarycentric(bary) : Vec3(1, 0, 0));
}

/// Other charts within a radius of a place on a face: the faces there that are the nearest to it.
void findBeyond(const NearestTriangle& nearest, const AtlasSurface& surface, const Vec3& position,
  Face start, double radius, int dot, std::vector<DotBeyond>& found)
{
  constexpr std::size_t MostFaces = 200; // of a dot that is larger than it looks
  std::vector<Face> seen = { start };
  std::vector<std::pair<double, Face>> best; // by chart other than the start's
  for (std::size_t i = 0; i < seen.size() && seen.size() < MostFaces; ++i)
  {
    for (const Halfedge h : halfedgesOf(seen[i]))
    {
      const Halfedge twin = surface.twin[h];
      if (!twin.valid() || std::find(seen.begin(), seen.end(), faceOf(twin)) != seen.end())
      {
        continue;
      }
      const Face face = faceOf(twin);
      const double squared = nearest.squaredDistance(position, face.index());
      if (squared > radius * radius)
      {
        continue;
      }
      seen.push_back(face);
      const Chart chart = surface.faceChart[face];
      if (chart == surface.faceChart[start])
      {
        continue;
      }
      const auto known = std::find_if(best.begin(), best.end(),
        [&](const auto& entry) { return surface.faceChart[entry.second] == chart; });
      if (known == best.end())
      {
        best.emplace_back(squared, face);
      }
      else if (squared < known->first)
      {
        *known = { squared, face };
      }
    }
  }
  for (const auto& [squared, face] : best)
  {
    found.push_back(
      { dot, surface.faceChart[face].index(), face.index(), parameterAt(surface, face, position) });
  }
}
}

MeshDots placeOnCharts(
  const std::vector<PlacedDot>& places, const AtlasSurface& surface, const NearestTriangle& nearest)
{
  const auto n = static_cast<vtkIdType>(places.size());
  MeshDots dots;
  dots.samples = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  dots.samples->SetPoints(points);
  auto* chart = addArray<vtkIntArray>(dots.samples, "ChartId", 1, n);
  auto* cell = addArray<vtkIntArray>(dots.samples, "ChartCellId", 1, n);
  auto* kind = addArray<vtkIntArray>(dots.samples, "SampleKind", 1, n);
  auto* uv = addArray<vtkDoubleArray>(dots.samples, "UV", 2, n);
  auto* density = addArray<vtkDoubleArray>(dots.samples, "Density", 1, n);
  kind->FillValue(0);
  std::vector<std::vector<DotBeyond>> beyond(places.size());
  vtkSMPTools::For(0, n, 256, [&](vtkIdType begin, vtkIdType end) {
    int hint = -1;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const PlacedDot& place = places[static_cast<std::size_t>(i)];
      hint = place.face >= 0 ? place.face : hint;
      hint = place.onFace ? hint : nearest.find(place.position, hint).face;
      const Face face(hint);
      points->SetPoint(i, place.position.data());
      chart->SetValue(i, surface.faceChart[face].index());
      cell->SetValue(i, surface.chartCell(face));
      const Vec2 parameter = parameterAt(surface, face, place.position);
      uv->SetTypedTuple(i, parameter.data());
      density->SetValue(i, place.area > 0 ? 1 / place.area : 0);
      findBeyond(nearest, surface, place.position, face, Reach * std::sqrt(place.area),
        static_cast<int>(i), beyond[static_cast<std::size_t>(i)]);
    }
  });
  for (const auto& some : beyond)
  {
    dots.beyond.insert(dots.beyond.end(), some.begin(), some.end());
  }
  return dots;
}

MeshDots placeOnCharts(vtkPolyData* mesh, const Atlas& atlas)
{
  const TriangleSurface triangles = fromPolyData(mesh);
  const std::vector<double> areas = areasOfVertices(triangles);
  std::vector<PlacedDot> places;
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    places.push_back({ triangles.points[i], areas[i] });
  }
  return placeOnCharts(places, atlas.surface(), NearestTriangle(atlas.surface()));
}
}
