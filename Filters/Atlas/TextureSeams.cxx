// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureSeams.h"

#include "AtlasConstants.h"
#include "CornerTexture.h"
#include "Geometry.h"
#include "SurfaceArrays.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace stipple
{
TextureSeams::TextureSeams(vtkPolyData* input, const RepairedSurface& repaired)
  : Input(vtkSmartPointer<vtkPolyData>::New())
  , Repaired(repaired)
  , Texture(input->GetPointData()->GetTCoords())
  , SamePlace(AtlasConstants::SamePlace * input->GetLength())
{
  this->Input->CopyStructure(input);
  this->Input->BuildCells(); // not the caller's, which others may be reading
}

Vec2 TextureSeams::coordinates(int inputPoint) const
{
  const Vec2 value(
    this->Texture->GetComponent(inputPoint, 0), this->Texture->GetComponent(inputPoint, 1));
  return value.allFinite() ? value : Vec2(0., 0.);
}

Vec2 TextureSeams::at(int cell, int point) const
{
  vtkIdType size;
  const vtkIdType* ids;
  this->Input->GetCellPoints(cell, size, ids);
  const RepairedSurface& r = this->Repaired;
  for (vtkIdType k = 0; k < size; ++k)
  {
    const int welded = r.pointOfInput[static_cast<std::size_t>(ids[k])];
    if (welded >= 0 && r.sourcePoint[welded] == r.sourcePoint[point])
    {
      return this->coordinates(static_cast<int>(ids[k]));
    }
  }
  // A corner at the same place but for rounding took its part, or the edge of a flat face was
  // swapped: then the plane of the largest triangle of the cell.
  const auto place = [&](vtkIdType k) {
    Vec3 x;
    this->Input->GetPoint(ids[k], x.data());
    return x;
  };
  for (vtkIdType k = 0; k < size; ++k)
  {
    if ((place(k) - r.surface.points[point]).norm() <= this->SamePlace)
    {
      return this->coordinates(static_cast<int>(ids[k]));
    }
  }
  double largest = 0.;
  vtkIdType best = 0;
  for (vtkIdType k = 1; k + 1 < size; ++k)
  {
    const double area = (place(k) - place(0)).cross(place(k + 1) - place(0)).norm();
    if (area > largest)
    {
      largest = area;
      best = k;
    }
  }
  if (best == 0)
  {
    return this->coordinates(r.sourcePoint[point]);
  }
  const Vec3 b =
    barycentricInSpace(r.surface.points[point], place(0), place(best), place(best + 1));
  return b[0] * this->coordinates(static_cast<int>(ids[0])) +
    b[1] * this->coordinates(static_cast<int>(ids[best])) +
    b[2] * this->coordinates(static_cast<int>(ids[best + 1]));
}

void TextureSeams::mark(CutSurface& surface) const
{
  double tolerance = 0.;
  for (int k = 0; k < 2; ++k)
  {
    double range[2];
    this->Texture->GetRange(range, k);
    tolerance = std::max(tolerance, AtlasConstants::TextureJump * (range[1] - range[0]));
  }
  for (const Halfedge h : surface.halfedges())
  {
    const Halfedge twin = surface.twin[h];
    if (!twin.valid() || twin < h)
    {
      continue;
    }
    const int cell = surface.sourceCell[faceOf(h).index()];
    const int other = surface.sourceCell[faceOf(twin).index()];
    const auto jumps = [&](Vertex v) {
      return !((this->at(cell, v.index()) - this->at(other, v.index())).lpNorm<Eigen::Infinity>() <=
        tolerance);
    };
    if (cell != other && (jumps(surface.tail(h)) || jumps(surface.head(h))))
    {
      surface.setKeep(h, Keep::Border);
    }
  }
}

std::vector<vtkSmartPointer<vtkDoubleArray>> TextureSeams::corners(
  const CutSurface& surface, const std::vector<FlatChart>& charts) const
{
  const std::vector<PointWeights> weights = weightsOfInserted(surface);
  const auto value = [&](int cell, int p) -> Vec2 {
    if (p < surface.numberOfOriginalPoints)
    {
      return this->at(cell, p);
    }
    Vec2 sum = Vec2::Zero();
    for (const auto& [origin, weight] : weights[p - surface.numberOfOriginalPoints])
    {
      sum += weight * this->at(cell, origin);
    }
    return sum;
  };
  std::vector<vtkSmartPointer<vtkDoubleArray>> result;
  for (const FlatChart& chart : charts)
  {
    const std::vector<Face>& faces = chart.mesh.faces;
    result.push_back(newCornerTexture(static_cast<vtkIdType>(faces.size())));
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const int cell = surface.sourceCell[faces[f].index()];
      for (int k = 0; k < 3; ++k)
      {
        setTextureOfCorner(result.back(), static_cast<vtkIdType>(f), k,
          value(cell, surface.vertex(faces[f], k).index()));
      }
    }
  }
  return result;
}
}
