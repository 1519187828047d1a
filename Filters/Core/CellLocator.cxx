// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellLocator.h"

#include "PolyDataConversion.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <cmath>

namespace stipple
{
namespace
{
/// The power of two that makes a length one from 512 to 1,024; 1 where that is no number.
double scaleOf(double length)
{
  constexpr int Exponent = 10;
  int exponent = 0;
  std::frexp(length, &exponent);
  const double scale = std::ldexp(1., Exponent - exponent);
  return length > 0 && std::isnormal(length) && std::isnormal(scale) ? scale : 1.;
}
}

struct CellLocator::Internals
{
  explicit Internals(vtkPolyData* cells)
    : scale(scaleOf(cells->GetLength()))
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(cells->GetNumberOfPoints());
    for (vtkIdType p = 0; p < cells->GetNumberOfPoints(); ++p)
    {
      const Vec3 scaled = this->scale * Vec3(cells->GetPoint(p));
      points->SetPoint(p, scaled.data());
    }
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(cells);
    copy->SetPoints(points);
    this->locator->SetDataSet(copy);
    this->locator->BuildLocator();
  }

  double scale;
  vtkNew<vtkStaticCellLocator> locator;
  vtkNew<vtkGenericCell> cell;
};

CellLocator::CellLocator(vtkPolyData* cells)
  : Inside(std::make_unique<Internals>(cells))
{
}

CellLocator::CellLocator(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
  : CellLocator(toPolyData(points, triangles))
{
}

CellLocator::~CellLocator() = default;

CellLocator::Place CellLocator::nearest(const Vec3& position) const
{
  const Internals& d = *this->Inside;
  const Vec3 scaled = d.scale * position;
  Place place;
  int part = 0;
  d.locator->FindClosestPoint(
    scaled.data(), place.position.data(), d.cell, place.cell, part, place.squaredDistance);
  place.position /= d.scale;
  place.squaredDistance /= d.scale * d.scale;
  return place;
}

CellLocator::Place CellLocator::firstHit(const Vec3& from, const Vec3& to, double& t) const
{
  const Internals& d = *this->Inside;
  const Vec3 begin = d.scale * from;
  const Vec3 end = d.scale * to;
  Place place;
  Vec3 parameters;
  int part = 0;
  if (!d.locator->IntersectWithLine(begin.data(), end.data(), 0., t, place.position.data(),
        parameters.data(), part, place.cell, d.cell))
  {
    place.cell = -1;
  }
  place.position /= d.scale;
  return place;
}
}
