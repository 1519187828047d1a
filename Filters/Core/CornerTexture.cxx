// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CornerTexture.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <map>
#include <utility>
#include <vector>

namespace stipple
{
namespace
{
/// The points of a surface, each once for each pair of coordinates that it is used with.
class SplitPoints
{
public:
  explicit SplitPoints(vtkIdType points)
    : First(static_cast<std::size_t>(points), -1)
  {
    for (vtkIdType p = 0; p < points; ++p)
    {
      this->Source.push_back(p);
    }
    this->Coordinates.resize(this->Source.size(), Vec2::Zero());
  }
  vtkIdType with(vtkIdType point, const Vec2& coordinates)
  {
    vtkIdType& first = this->First[static_cast<std::size_t>(point)];
    if (first < 0)
    {
      first = point;
      this->Coordinates[static_cast<std::size_t>(point)] = coordinates;
    }
    if (this->Coordinates[static_cast<std::size_t>(point)] == coordinates)
    {
      return point;
    }
    const auto [copy, fresh] = this->Copies.try_emplace(
      { point, { coordinates.x(), coordinates.y() } }, static_cast<vtkIdType>(this->Source.size()));
    if (fresh)
    {
      this->Source.push_back(point);
      this->Coordinates.push_back(coordinates);
    }
    return copy->second;
  }
  const std::vector<vtkIdType>& source() const { return this->Source; }
  const std::vector<Vec2>& coordinates() const { return this->Coordinates; }

private:
  std::vector<vtkIdType> First; ///< of every point, itself once it is used, else -1
  std::vector<vtkIdType> Source;
  std::vector<Vec2> Coordinates;
  std::map<std::pair<vtkIdType, std::pair<double, double>>, vtkIdType> Copies;
};
}

vtkDataArray* cornerTexture(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetCellData()->GetArray(CornerTextureName);
  const vtkIdType cells = surface->GetNumberOfPolys();
  return array && array->GetNumberOfTuples() == cells && surface->GetNumberOfCells() == cells &&
      array->GetNumberOfComponents() >= 2 * surface->GetPolys()->GetMaxCellSize()
    ? array
    : nullptr;
}

vtkSmartPointer<vtkDoubleArray> newCornerTexture(vtkIdType cells, int corners)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(CornerTextureName);
  array->SetNumberOfComponents(2 * corners);
  array->SetNumberOfTuples(cells);
  array->Fill(0.);
  return array;
}

Vec2 textureOfCorner(vtkDataArray* corners, vtkIdType cell, vtkIdType k)
{
  const int first = static_cast<int>(2 * k);
  return { corners->GetComponent(cell, first), corners->GetComponent(cell, first + 1) };
}

void setTextureOfCorner(vtkDataArray* corners, vtkIdType cell, vtkIdType k, const Vec2& coordinates)
{
  const int first = static_cast<int>(2 * k);
  corners->SetComponent(cell, first, coordinates.x());
  corners->SetComponent(cell, first + 1, coordinates.y());
}

vtkSmartPointer<vtkPolyData> splitTextureSeams(vtkPolyData* surface)
{
  vtkDataArray* corners = cornerTexture(surface);
  if (!corners)
  {
    return surface;
  }
  SplitPoints split(surface->GetNumberOfPoints());
  vtkNew<vtkCellArray> polygons;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    surface->GetPolys()->GetCellAtId(cell, size, ids);
    polygons->InsertNextCell(static_cast<int>(size));
    for (vtkIdType k = 0; k < size; ++k)
    {
      const Vec2 value = textureOfCorner(corners, cell, k);
      polygons->InsertCellPoint(split.with(ids[k], value.allFinite() ? value : Vec2(0., 0.)));
    }
  }
  const auto number = static_cast<vtkIdType>(split.source().size());
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  points->SetNumberOfPoints(number);
  vtkNew<vtkDoubleArray> coordinates;
  vtkDataArray* active = surface->GetPointData()->GetTCoords();
  coordinates->SetName(active && active->GetName() ? active->GetName() : "TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(number);
  for (vtkIdType p = 0; p < number; ++p)
  {
    const auto i = static_cast<std::size_t>(p);
    points->SetPoint(p, surface->GetPoint(split.source()[i]));
    coordinates->SetTuple(p, split.coordinates()[i].data());
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(surface);
  result->SetPoints(points);
  result->SetPolys(polygons);
  vtkPointData* data = result->GetPointData();
  data->Initialize();
  data->CopyAllOn();
  data->CopyAllocate(surface->GetPointData(), number);
  for (vtkIdType p = 0; p < number; ++p)
  {
    data->CopyData(surface->GetPointData(), split.source()[static_cast<std::size_t>(p)], p);
  }
  data->SetTCoords(coordinates);
  result->GetCellData()->RemoveArray(CornerTextureName);
  return result;
}
}
