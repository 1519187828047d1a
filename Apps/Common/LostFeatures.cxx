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

#include <functional>
#include <optional>

namespace stipple
{
namespace
{
/// Of the nearest segment's length: a chord of a quarter of a circle is off by as much.
constexpr double Far = 0.2;

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
  forEachSegment(sharp, [&](vtkIdType a, vtkIdType b) {
    const Vec3 middle = 0.5 * (Vec3(sharp->GetPoint(a)) + Vec3(sharp->GetPoint(b)));
    bool far = !locator;
    if (locator)
    {
      const CellLocator::Place nearest = locator->nearest(middle);
      const double length =
        (Vec3(ends->GetPoint(2 * nearest.cell)) - Vec3(ends->GetPoint(2 * nearest.cell + 1)))
          .norm();
      far = nearest.squaredDistance > Far * Far * length * length;
    }
    if (far)
    {
      const vtkIdType ids[2] = { a, b };
      lines->InsertNextCell(2, ids);
    }
  });
  lost->SetPoints(sharp->GetPoints());
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
