// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceArrays.h"

#include "AtlasConstants.h"
#include "CornerTexture.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace stipple
{
namespace
{
bool isContinuous(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

/// For every inserted point the original one that weighs most in it; of two, the first.
std::vector<int> nearestOriginalPoints(const CutSurface& surface)
{
  std::vector<int> nearest;
  for (const PointWeights& weights : weightsOfInserted(surface))
  {
    nearest.push_back(
      std::max_element(weights.begin(), weights.end(), [](const auto& a, const auto& b) {
        return a.second < b.second || (a.second == b.second && a.first > b.first);
      })->first);
  }
  return nearest;
}

/// Whether two tuples are the same in every component.
bool isSame(vtkAbstractArray* array, vtkIdType i, vtkIdType j)
{
  const int n = array->GetNumberOfComponents();
  for (int k = 0; i != j && k < n; ++k)
  {
    if (array->GetVariantValue(i * n + k) != array->GetVariantValue(j * n + k))
    {
      return false;
    }
  }
  return true;
}
}

std::vector<PointWeights> weightsOfInserted(const CutSurface& surface)
{
  std::vector<PointWeights> weightsOf(surface.inserted.size());
  for (std::size_t j = 0; j < surface.inserted.size(); ++j)
  {
    PointWeights& weights = weightsOf[j];
    const auto add = [&](int point, double weight) {
      const auto found = std::find_if(
        weights.begin(), weights.end(), [&](const auto& other) { return other.first == point; });
      if (found != weights.end())
      {
        found->second += weight;
      }
      else
      {
        weights.emplace_back(point, weight);
      }
    };
    const auto addEnd = [&](int point, double share) {
      if (point < surface.numberOfOriginalPoints)
      {
        add(point, share);
        return;
      }
      for (const auto& [origin, weight] : weightsOf[point - surface.numberOfOriginalPoints])
      {
        add(origin, share * weight);
      }
    };
    const CutSurface::EdgePoint& e = surface.inserted[j];
    addEnd(e.a, 1. - e.t);
    addEnd(e.b, e.t);
  }
  return weightsOf;
}

bool isReservedArrayName(const char* name)
{
  for (const char* own :
    { "UV", "SurfacePointId", "GaussianCurvature", "MeanCurvature", "SourceCellId",
      "AreaDistortion", "ChartId", "ChartCellId", "BarycentricCoordinates", "SampleKind",
      "BackboneId", "ArcLength", "Density", "Control", "FaceIndex", CornerTextureName })
  {
    if (std::string(own) == name)
    {
      return true;
    }
  }
  return false;
}

std::vector<vtkAbstractArray*> usersArrays(vtkDataSetAttributes* data)
{
  std::vector<vtkAbstractArray*> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetName() && !isReservedArrayName(array->GetName()))
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

vtkSmartPointer<vtkAbstractArray> emptyLike(vtkAbstractArray* array)
{
  auto copy = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  copy->SetName(array->GetName());
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  copy->CopyComponentNames(array);
  return copy;
}

std::vector<vtkSmartPointer<vtkAbstractArray>> pointArrays(
  vtkPolyData* input, const RepairedSurface& repaired, const CutSurface& surface)
{
  std::vector<vtkSmartPointer<vtkAbstractArray>> result;
  std::vector<int> nearest; // found for the first array that needs it
  for (vtkAbstractArray* source : usersArrays(input->GetPointData()))
  {
    auto array = emptyLike(source);
    array->SetNumberOfTuples(static_cast<vtkIdType>(surface.points.size()));
    for (int p = 0; p < surface.numberOfOriginalPoints; ++p)
    {
      array->SetTuple(p, repaired.sourcePoint[p], source);
    }
    const bool continuous = isContinuous(source);
    if (!continuous && nearest.empty())
    {
      nearest = nearestOriginalPoints(surface);
    }
    for (std::size_t j = 0; j < surface.inserted.size(); ++j)
    {
      const CutSurface::EdgePoint& e = surface.inserted[j];
      const vtkIdType p = surface.numberOfOriginalPoints + static_cast<vtkIdType>(j);
      if (continuous)
      {
        array->InterpolateTuple(p, e.a, array, e.b, array, e.t);
      }
      else
      {
        array->SetTuple(p, nearest[j], array);
      }
    }
    result.push_back(array);
  }
  return result;
}

ArraysOverEdges::ArraysOverEdges(
  vtkPolyData* input, const RepairedSurface& repaired, const CutSurface& surface)
  : Surface(surface)
  , Cells(usersArrays(input->GetCellData()))
{
  for (vtkSmartPointer<vtkAbstractArray>& array : pointArrays(input, repaired, surface))
  {
    if (isContinuous(array))
    {
      auto* numbers = vtkDataArray::SafeDownCast(array);
      const double largest = numbers->GetMaxNorm();
      this->Numbers.push_back({ array, AtlasConstants::FlatFace * largest });
    }
    else
    {
      this->Labels.push_back(array);
    }
  }
}

bool ArraysOverEdges::allowFlip(Halfedge h, double s, double t) const
{
  const Halfedge g = this->Surface.twin[h];
  const std::vector<int>& source = this->Surface.sourceCell;
  for (vtkAbstractArray* array : this->Cells)
  {
    if (!isSame(array, source[faceOf(h).index()], source[faceOf(g).index()]))
    {
      return false;
    }
  }
  const vtkIdType a = this->Surface.tail(h).index();
  const vtkIdType b = this->Surface.head(h).index();
  const vtkIdType c = this->Surface.tail(previousHalfedge(h)).index();
  const vtkIdType d = this->Surface.tail(previousHalfedge(g)).index();
  for (const Continuous& number : this->Numbers)
  {
    auto* array = vtkDataArray::SafeDownCast(number.array);
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      const auto value = [&](vtkIdType p) { return array->GetComponent(p, k); };
      const double along = (1 - s) * value(a) + s * value(b);
      const double across = (1 - t) * value(c) + t * value(d);
      if (!(std::abs(along - across) <= number.tolerance))
      {
        return false;
      }
    }
  }
  return std::all_of(this->Labels.begin(), this->Labels.end(), [&](const auto& array) {
    return isSame(array, a, b) && isSame(array, a, c) && isSame(array, a, d);
  });
}
}
