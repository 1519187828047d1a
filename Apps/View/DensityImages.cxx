// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityImages.h"

#include "ColorBar.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace stipple
{
namespace
{
struct ControlImage
{
  vtkImageData* image = nullptr;
  vtkFloatArray* control = nullptr;
  vtkFloatArray* area = nullptr;
};

std::vector<ControlImage> readImages(vtkPartitionedDataSetCollection* controls)
{
  std::vector<ControlImage> result;
  for (unsigned int c = 0; c < controls->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* image = vtkImageData::SafeDownCast(controls->GetPartitionAsDataObject(c, 0));
    vtkPointData* data = image ? image->GetPointData() : nullptr;
    const ControlImage read = { image,
      data ? vtkFloatArray::SafeDownCast(data->GetArray("Control")) : nullptr,
      data ? vtkFloatArray::SafeDownCast(data->GetArray("AreaDistortion")) : nullptr };
    if (!read.control || !read.area)
    {
      return {};
    }
    result.push_back(read);
  }
  return result;
}

/// All control over all area: what is beside the charts' faces has none.
double meanDensity(const std::vector<ControlImage>& images)
{
  double control = 0;
  double area = 0;
  for (const ControlImage& read : images)
  {
    const double pixel = read.image->GetSpacing()[0] * read.image->GetSpacing()[1];
    double sumOfControl = 0;
    double sumOfArea = 0;
    for (vtkIdType i = 0; i < read.control->GetNumberOfValues(); ++i)
    {
      sumOfControl += read.control->GetValue(i);
      sumOfArea += std::max(0.F, read.area->GetValue(i));
    }
    control += pixel * sumOfControl;
    area += pixel * sumOfArea;
  }
  return control > 0 && area > 0 ? control / area : 1;
}
}

std::vector<vtkSmartPointer<vtkImageData>> densityImages(vtkPartitionedDataSetCollection* controls)
{
  constexpr vtkIdType Grain = 10000;
  const std::vector<ControlImage> images = readImages(controls);
  const double mean = meanDensity(images);
  std::vector<vtkSmartPointer<vtkImageData>> result;
  for (const ControlImage& read : images)
  {
    auto picture = vtkSmartPointer<vtkImageData>::New();
    picture->SetDimensions(read.image->GetDimensions());
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixels = static_cast<Pixel*>(picture->GetScalarPointer());
    const float* control = read.control->GetPointer(0);
    const float* area = read.area->GetPointer(0);
    vtkSMPTools::For(0, picture->GetNumberOfPoints(), Grain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double density = area[i] > 0 ? static_cast<double>(control[i]) / area[i] : 0;
        pixels[i] = divergingColor(densityShare(density / mean));
      }
    });
    result.push_back(picture);
  }
  return result;
}
}
