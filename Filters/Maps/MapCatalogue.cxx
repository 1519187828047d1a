// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapCatalogue.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
constexpr int numberOfDefaults = 7;

/// An array's own values where they are doubles one behind the other, else copies.
void takeValues(vtkDataArray* array, MapValues& result)
{
  result.components = array->GetNumberOfComponents();
  if (auto* doubles = vtkDoubleArray::FastDownCast(array))
  {
    result.values = doubles->GetPointer(0);
    return;
  }
  const vtkIdType n = array->GetNumberOfTuples();
  result.made.resize(static_cast<std::size_t>(n) * result.components);
  for (vtkIdType i = 0; i < n; ++i)
  {
    array->GetTuple(i, result.made.data() + i * result.components);
  }
  result.values = result.made.data();
}

std::string arrayNames(vtkPolyData* chart)
{
  std::string names;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(chart->GetPointData()),
         static_cast<vtkDataSetAttributes*>(chart->GetCellData()) })
  {
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* array = data->GetArray(k);
      if (array && array->GetName() && array->GetNumberOfComponents() <= 4)
      {
        names += (names.empty() ? "" : ", ") + std::string(array->GetName());
      }
    }
  }
  return names;
}
} // namespace

const std::vector<std::string>& MapCatalogue::names()
{
  static const std::vector<std::string> all{ "AreaDistortion", "FaceIndex", "GaussianCurvature",
    "MeanCurvature", "MinimumCurvature", "MaximumCurvature", "TotalCurvature", "Position",
    "Normal" };
  return all;
}

bool MapCatalogue::isDefault(const std::string& name)
{
  const auto& all = MapCatalogue::names();
  return std::find(all.begin(), all.begin() + numberOfDefaults, name) !=
    all.begin() + numberOfDefaults;
}

Status MapCatalogue::read(vtkPartitionedDataSetCollection* charts, const Stop& stop)
{
  this->Charts.clear();
  this->Normals.clear();
  if (Status status = Atlas::read(charts, nullptr, this->Charted, stop); !status.ok())
  {
    return status;
  }
  const AtlasSurface& s = this->Charted->surface();
  this->Charts.resize(s.numberOfCharts());
  for (int c = 0; c < s.numberOfCharts(); ++c)
  {
    if (isAsked(stop))
    {
      return Status::aborted();
    }
    const std::string name = "chart " + std::to_string(c);
    MapChart& chart = this->Charts[c];
    chart.extent = s.extent[Chart(c)];
    chart.uv.resize(s.charts[c]->GetNumberOfPoints(), Vec2::Zero());
    for (int f = s.chartBegin[c]; f < s.chartBegin[c + 1]; ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Vec2& uv = s.cornerUV(f, k);
        const int point = s.chartPoints[f][k];
        // Far outside the rectangle, fixed-point arithmetic would overflow.
        if (!(std::abs(uv.x()) <= 2. * chart.extent.x() &&
              std::abs(uv.y()) <= 2. * chart.extent.y()))
        {
          return Status::error("The UV of point " + std::to_string(point) + " of " + name +
            " is outside the chart's rectangle: pass output port 0 of vtkConformalAtlas.");
        }
        chart.uv[point] = uv;
      }
      chart.triangles.push_back(s.chartPoints[f]);
      chart.area.push_back(static_cast<float>(s.faceArea(f)));
    }
    if (chart.triangles.empty())
    {
      return Status::error(
        "The " + name + " has no triangle: pass output port 0 of vtkConformalAtlas.");
    }
  }
  return Status::success();
}

Status MapCatalogue::find(const std::string& name, int c, MapValues& result)
{
  result = {};
  if (name == "Position")
  {
    takeValues(this->Charted->surface().charts[c]->GetPoints()->GetData(), result);
    return Status::success();
  }
  if (name == "Normal")
  {
    this->findNormals(c, result);
    return Status::success();
  }
  const bool total = name == "TotalCurvature";
  const int sign = name == "MinimumCurvature" ? -1 : (name == "MaximumCurvature" ? 1 : 0);
  if (!total && sign == 0)
  {
    return this->findArray(name, c, result);
  }
  MapValues mean;
  MapValues gaussian;
  for (const auto& [source, values] :
    { std::make_pair("MeanCurvature", &mean), std::make_pair("GaussianCurvature", &gaussian) })
  {
    const Status status = this->findArray(source, c, *values);
    if (!status.ok())
    {
      return status;
    }
    if (values->kind != MapKind::Linear || values->components != 1)
    {
      return Status::error("The map " + name + " needs " + source +
        " as a point array of one component on chart " + std::to_string(c) + ".");
    }
  }
  // The principal curvatures are those of the points, H -+ R, and linear in between. From H and K
  // of a pixel, H^2 - K would cancel where the surface is like a sphere.
  result.kind = total ? MapKind::TotalCurvature : MapKind::Linear;
  const std::size_t points = this->Charts[c].uv.size();
  result.made.reserve((total ? 2 : 1) * points);
  for (std::size_t p = 0; p < points; ++p)
  {
    const double h = mean.values[p];
    const double r = std::sqrt(std::max(h * h - gaussian.values[p], 0.));
    result.made.push_back(h + sign * r);
    if (total)
    {
      result.made.push_back(r);
    }
  }
  result.values = result.made.data();
  return Status::success();
}

Status MapCatalogue::findArray(const std::string& name, int c, MapValues& result) const
{
  vtkPolyData* chart = this->Charted->surface().charts[c];
  vtkDataArray* point = chart->GetPointData()->GetArray(name.c_str());
  vtkDataArray* cell = chart->GetCellData()->GetArray(name.c_str());
  // A point and a cell array may share a name: the smooth one is the better map, but for the area
  // distortion, which is the atlas' own.
  if (cell && name == "AreaDistortion")
  {
    point = nullptr;
  }
  vtkDataArray* array = point ? point : cell;
  if (!array)
  {
    return Status::error("There is no array " + name + " on chart " + std::to_string(c) +
      " to make a map of: it has " + arrayNames(chart) + ".");
  }
  if (array->GetNumberOfComponents() > 4)
  {
    return Status::error("The array " + name + " has " +
      std::to_string(array->GetNumberOfComponents()) +
      " components, and a map has 1 to 4: split the array.");
  }
  result.kind = point ? MapKind::Linear : MapKind::Constant;
  takeValues(array, result);
  return Status::success();
}

/// The charts' own normals if they carry some; else the angle-weighted ones of the surface, welded
/// along the seams so that the maps of neighbouring charts agree there.
void MapCatalogue::findNormals(int c, MapValues& result)
{
  const AtlasSurface& s = this->Charted->surface();
  result.kind = MapKind::UnitVector;
  result.components = 3;
  vtkDataArray* given = s.charts[c]->GetPointData()->GetNormals();
  if (given && given->GetNumberOfComponents() == 3)
  {
    takeValues(given, result);
    return;
  }
  if (this->Normals.empty())
  {
    this->Normals.assign(s.points.size(), Vec3::Zero());
    for (int f = 0; f < s.numberOfFaces(); ++f)
    {
      const Vec3 normal = s.faceNormal(f);
      for (int k = 0; k < 3; ++k)
      {
        const Vec3 u = s.point(f, (k + 1) % 3) - s.point(f, k);
        const Vec3 v = s.point(f, (k + 2) % 3) - s.point(f, k);
        this->Normals[s.triangles[f][k]] += std::atan2(u.cross(v).norm(), u.dot(v)) * normal;
      }
    }
    for (Vec3& normal : this->Normals)
    {
      const double length = normal.norm();
      normal = length > 0. ? Vec3(normal / length) : Vec3(Vec3::Zero());
    }
  }
  result.made.assign(3 * this->Charts[c].uv.size(), 0.);
  for (int f = s.chartBegin[c]; f < s.chartBegin[c + 1]; ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& normal = this->Normals[s.triangles[f][k]];
      std::copy(normal.data(), normal.data() + 3, result.made.data() + 3 * s.chartPoints[f][k]);
    }
  }
  result.values = result.made.data();
}
} // namespace stipple
