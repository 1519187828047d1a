// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityField.h"

#include "Tuning.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
Status DensityField::read(vtkPartitionedDataSetCollection* images, const AtlasSurface& surface)
{
  this->Map.clear();
  this->AtPoints.clear();
  if (!images || images->GetNumberOfPartitionedDataSets() == 0)
  {
    return Status::success();
  }
  const unsigned int n = images->GetNumberOfPartitionedDataSets();
  if (static_cast<int>(n) != surface.numberOfCharts())
  {
    return Status::error("There are " + std::to_string(n) + " control images for " +
      std::to_string(surface.numberOfCharts()) +
      " charts: pass the output of vtkControlMap for these charts.");
  }
  float largest = 0;
  float smallest = VTK_FLOAT_MAX;
  std::vector<Image> map(n);
  for (unsigned int c = 0; c < n; ++c)
  {
    vtkPartitionedDataSet* set = images->GetPartitionedDataSet(c);
    auto* image = set && set->GetNumberOfPartitions() > 0
      ? vtkImageData::SafeDownCast(set->GetPartitionAsDataObject(0))
      : nullptr;
    vtkDataArray* control = image ? image->GetPointData()->GetArray("Control") : nullptr;
    if (!control)
    {
      return Status::error("Control image " + std::to_string(c) +
        " is no vtkImageData with the point array Control: pass the output of vtkControlMap.");
    }
    vtkDataArray* distortion = image->GetPointData()->GetArray("AreaDistortion");
    Image& m = map[c];
    m.width = image->GetDimensions()[0];
    m.height = image->GetDimensions()[1];
    m.extent = surface.extent[c];
    // Without the map of the distortion, its mean over the chart must do.
    double area = 0;
    for (int f = surface.chartBegin[c]; !distortion && f < surface.chartBegin[c + 1]; ++f)
    {
      area += surface.faceArea(f);
    }
    const double mean = area / (m.extent.x() * m.extent.y());
    m.density.resize(static_cast<std::size_t>(m.width) * m.height);
    for (std::size_t i = 0; i < m.density.size(); ++i)
    {
      const vtkIdType id = static_cast<vtkIdType>(i);
      const double a = distortion ? distortion->GetComponent(id, 0) : mean;
      const double d = control->GetComponent(id, 0) / a;
      m.density[i] = a > 0 && d > 0 && std::isfinite(d) ? static_cast<float>(d) : 0.f;
      largest = std::max(largest, m.density[i]);
      smallest = std::min(smallest, m.density[i]);
    }
  }
  if (largest <= 0 || largest - smallest <= Tuning::UniformDensity * largest)
  {
    return Status::success(); // uniform
  }
  for (Image& m : map)
  {
    for (float& d : m.density)
    {
      d = std::max(d / largest, static_cast<float>(Tuning::SmallestDensity));
    }
  }
  this->Map = std::move(map);
  return Status::success();
}

void DensityField::setAtPoints(std::vector<double> density)
{
  this->Map.clear();
  this->AtPoints.clear();
  const auto [least, most] = std::minmax_element(density.begin(), density.end());
  if (density.empty() || !(*most > 0) || *most - *least <= Tuning::UniformDensity * *most)
  {
    return;
  }
  const double largest = *most;
  for (double& d : density)
  {
    d = std::max(d / largest, static_cast<double>(Tuning::SmallestDensity));
  }
  this->AtPoints = std::move(density);
}

double DensityField::at(const AtlasSurface& surface, const SurfacePlace& place) const
{
  if (!this->AtPoints.empty())
  {
    const Triangle& t = surface.triangles[place.face];
    return place.bary[0] * this->AtPoints[t[0]] + place.bary[1] * this->AtPoints[t[1]] +
      place.bary[2] * this->AtPoints[t[2]];
  }
  if (this->Map.empty())
  {
    return 1.;
  }
  const Image& m = this->Map[surface.faceChart[place.face]];
  const Vec2 uv = surface.parameter(place.face, place.bary);
  const double x = std::clamp(uv.x() / m.extent.x() * m.width - 0.5, 0., m.width - 1.);
  const double y = std::clamp(uv.y() / m.extent.y() * m.height - 0.5, 0., m.height - 1.);
  const int i = std::min(static_cast<int>(x), std::max(0, m.width - 2));
  const int j = std::min(static_cast<int>(y), std::max(0, m.height - 2));
  const int right = m.width > 1 ? 1 : 0;
  const int up = m.height > 1 ? m.width : 0;
  const float* d = m.density.data() + static_cast<std::size_t>(j) * m.width + i;
  const double s = x - i;
  const double t = y - j;
  return (1. - t) * ((1. - s) * d[0] + s * d[right]) + t * ((1. - s) * d[up] + s * d[up + right]);
}
}
