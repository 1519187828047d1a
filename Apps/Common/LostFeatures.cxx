// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LostFeatures.h"

#include "Backbones.h"
#include "CellLocator.h"
#include "Geometry.h"

#include "vtkCellArray.h"
#include "vtkConformalAtlas.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuadRemesh.h"
#include "vtkRemeshOptimizer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace stipple
{
namespace
{
/// Of the nearest segment's length: a chord of a quarter of a circle is off by as much.
constexpr double Far = 0.2;
/// Of the mean segment after: segments before are looked at in pieces that are no longer.
constexpr double Piece = 0.5;
constexpr double MostPieces = 1000;

void forEachSegment(vtkPolyData* lines, const std::function<void(vtkIdType, vtkIdType)>& f)
{
  vtkCellArray* cells = lines->GetLines();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCellAtId(i, size, ids);
    for (vtkIdType k = 1; k < size; ++k)
    {
      f(ids[k - 1], ids[k]);
    }
  }
}

/// Of segments by their ends; 0 if there are none.
double meanLength(vtkPoints* ends)
{
  double sum = 0;
  const vtkIdType number = ends->GetNumberOfPoints() / 2;
  for (vtkIdType i = 0; i < number; ++i)
  {
    sum += (Vec3(ends->GetPoint(2 * i)) - Vec3(ends->GetPoint(2 * i + 1))).norm();
  }
  return number > 0 ? sum / static_cast<double>(number) : 0.;
}
}

vtkSmartPointer<vtkPolyData> lostFeatures(vtkPolyData* before, vtkPolyData* after)
{
  constexpr int Sharp = 0;
  constexpr int Boundary = 1;
  vtkNew<vtkPoints> ends;
  ends->SetDataTypeToDouble();
  vtkNew<vtkCellArray> segments; // one a cell, for the locator
  for (const int type : { Sharp, Boundary })
  {
    vtkSmartPointer<vtkPolyData> lines = backbonesOfType(after, type);
    forEachSegment(lines, [&](vtkIdType a, vtkIdType b) {
      const vtkIdType ids[2] = { ends->InsertNextPoint(lines->GetPoint(a)),
        ends->InsertNextPoint(lines->GetPoint(b)) };
      segments->InsertNextCell(2, ids);
    });
  }
  vtkNew<vtkPolyData> kept;
  kept->SetPoints(ends);
  kept->SetLines(segments);
  std::optional<CellLocator> locator;
  if (segments->GetNumberOfCells() > 0)
  {
    locator.emplace(kept);
  }
  auto lost = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> lines;
  vtkSmartPointer<vtkPolyData> sharp = creasesTo(before, nullptr);
  const auto isFar = [&](const Vec3& place) {
    const CellLocator::Place nearest = locator->nearest(place);
    const double length =
      (Vec3(ends->GetPoint(2 * nearest.cell)) - Vec3(ends->GetPoint(2 * nearest.cell + 1))).norm();
    return nearest.squaredDistance > Far * Far * length * length;
  };
  const double mean = meanLength(ends);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  forEachSegment(sharp, [&](vtkIdType a, vtkIdType b) {
    const Vec3 begin(sharp->GetPoint(a));
    const Vec3 along = Vec3(sharp->GetPoint(b)) - begin;
    const int pieces = mean > 0.
      ? static_cast<int>(std::clamp(std::ceil(along.norm() / (Piece * mean)), 1., MostPieces))
      : 1;
    const auto place = [&](double piece) { return Vec3(begin + piece / pieces * along); };
    int first = -1; // of a stretch that is lost
    for (int i = 0; i <= pieces; ++i)
    {
      const bool far = i < pieces && (!locator || isFar(place(i + 0.5)));
      if (!far && first >= 0)
      {
        const vtkIdType ids[2] = { places->InsertNextPoint(place(first).data()),
          places->InsertNextPoint(place(i).data()) };
        lines->InsertNextCell(2, ids);
      }
      first = !far ? -1 : first < 0 ? i : first;
    }
  });
  lost->SetPoints(places);
  lost->SetLines(lines);
  return lost;
}

int numberOfSimplifiedFeatures(vtkGeometryRemesher* remesher)
{
  return remesher->GetPattern() == vtkGeometryRemesher::QUADS
    ? remesher->GetQuadMesher()->GetNumberOfSimplifiedFeatures()
    : remesher->GetOptimizer()->GetNumberOfSimplifiedFeatures();
}

vtkSmartPointer<vtkPolyData> lostFeatures(vtkGeometryRemesher* remesher)
{
  return numberOfSimplifiedFeatures(remesher) == 0
    ? nullptr
    : lostFeatures(vtkPolyData::SafeDownCast(remesher->GetAtlas()->GetOutputDataObject(1)),
        vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1)));
}
}
