// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ImportanceSource.h"

#include "FloatValues.h"
#include "Importance.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
/// A point array of a map by its name; null if it is not there for every pixel.
vtkDataArray* find(vtkImageData* map, const char* name)
{
  vtkDataArray* array = name ? map->GetPointData()->GetArray(name) : nullptr;
  return array && array->GetNumberOfTuples() == map->GetNumberOfPoints() ? array : nullptr;
}

using CurvatureFormula = double (*)(double H, double K);

CurvatureFormula formulaOf(ImportanceKind importance)
{
  switch (importance)
  {
    case ImportanceKind::Minimum:
      return minimumCurvature;
    case ImportanceKind::Maximum:
      return maximumCurvature;
    case ImportanceKind::Total:
      return totalCurvature;
    case ImportanceKind::L2:
      return optimalL2Density;
    default:
      return nullptr;
  }
}
}

PictureBrightness::PictureBrightness(vtkImageData* image)
{
  const int* dimensions = image->GetDimensions();
  this->Width = dimensions[0];
  this->Height = dimensions[1];
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int components = scalars->GetNumberOfComponents();
  this->Value.resize(static_cast<std::size_t>(this->Width) * this->Height);
  for (std::size_t i = 0; i < this->Value.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    this->Value[i] = static_cast<float>(components < 3 ? scalars->GetComponent(id, 0)
                                                       : 0.2126 * scalars->GetComponent(id, 0) +
          0.7152 * scalars->GetComponent(id, 1) + 0.0722 * scalars->GetComponent(id, 2));
  }
}

float PictureBrightness::operator()(double x, double y) const
{
  const double u = std::clamp(x * this->Width - 0.5, 0., this->Width - 1.);
  const double v = std::clamp(y * this->Height - 0.5, 0., this->Height - 1.);
  const int i = std::min(static_cast<int>(u), std::max(0, this->Width - 2));
  const int j = std::min(static_cast<int>(v), std::max(0, this->Height - 2));
  const double s = u - i;
  const double t = v - j;
  const auto at = [this](int p, int q) {
    return this->Value[static_cast<std::size_t>(std::min(q, this->Height - 1)) * this->Width +
      std::min(p, this->Width - 1)];
  };
  return static_cast<float>((1. - t) * ((1. - s) * at(i, j) + s * at(i + 1, j)) +
    t * ((1. - s) * at(i, j + 1) + s * at(i + 1, j + 1)));
}

std::string ImportanceSource::fillFromPicture(vtkImageData* map, float* magnitudes) const
{
  const int width = map->GetDimensions()[0];
  const int height = map->GetDimensions()[1];
  if (this->projection == PictureProjection::Chart)
  {
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        *magnitudes++ = (*this->picture)((x + 0.5) / width, (y + 0.5) / height);
      }
    }
    return {};
  }
  vtkDataArray* position = find(map, "Position");
  if (!position || position->GetNumberOfComponents() != 3)
  {
    return "Position";
  }
  const int axis = static_cast<int>(this->projection) - static_cast<int>(PictureProjection::XAxis);
  const int across = axis == 0 ? 1 : 0;
  const int up = axis == 2 ? 1 : 2;
  const auto unit = [this](double x, int k) {
    const double size = this->bounds[2 * k + 1] - this->bounds[2 * k];
    return size > 0 ? (x - this->bounds[2 * k]) / size : 0.5;
  };
  double p[3];
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    position->GetTuple(i, p);
    magnitudes[i] = (*this->picture)(unit(p[across], across), unit(p[up], up));
  }
  return {};
}

std::string ImportanceSource::fill(vtkImageData* map, float* magnitudes) const
{
  if (this->importance == ImportanceKind::Image)
  {
    return this->fillFromPicture(map, magnitudes);
  }
  const vtkIdType n = map->GetNumberOfPoints();
  static const char* const names[] = { nullptr, "MeanCurvature", "GaussianCurvature",
    "MinimumCurvature", "MaximumCurvature", "TotalCurvature", nullptr, nullptr };
  const char* name = this->importance == ImportanceKind::Array
    ? this->arrayName
    : names[static_cast<int>(this->importance)];
  if (vtkDataArray* direct = find(map, name))
  {
    const FloatValues values(direct);
    for (vtkIdType i = 0; i < n; ++i)
    {
      magnitudes[i] = std::abs(values[i]);
    }
    return {};
  }
  const CurvatureFormula formula = formulaOf(this->importance);
  if (!formula)
  {
    return name ? name : "(no ImportanceArrayName set)";
  }
  vtkDataArray* mean = find(map, "MeanCurvature");
  vtkDataArray* gaussian = find(map, "GaussianCurvature");
  if (!mean || !gaussian)
  {
    return mean ? "GaussianCurvature" : "MeanCurvature";
  }
  const FloatValues H(mean);
  const FloatValues K(gaussian);
  for (vtkIdType i = 0; i < n; ++i)
  {
    magnitudes[i] = static_cast<float>(std::abs(formula(H[i], K[i])));
  }
  return {};
}
}
