// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapPicture.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace stipple
{
namespace
{
using Color = MapColors::Color;

vtkDataArray* arrayOf(vtkImageData* image, const std::string& name)
{
  return image ? image->GetPointData()->GetArray(name.c_str()) : nullptr;
}

unsigned char channel(double value)
{
  return static_cast<unsigned char>(std::lround(255. * std::clamp(value, 0., 1.)));
}

Color mix(const Color& a, const Color& b, double t)
{
  Color c;
  for (int k = 0; k < 3; ++k)
  {
    c[k] = channel((a[k] + t * (b[k] - a[k])) / 255.);
  }
  return c;
}

}

MapColors::MapColors(vtkPartitionedDataSetCollection* maps, const std::string& name)
{
  vtkDataArray* first = arrayOf(mapsOfChart(maps, 0), name);
  this->Components = first ? first->GetNumberOfComponents() : 1;
  this->Kind = name == "FaceIndex" ? Faces
    : name == "Halftone"           ? AsIs
    : this->Components > 1         ? Channels
    : name == "GaussianCurvature" || name == "MeanCurvature" || name == "MinimumCurvature" ||
      name == "MaximumCurvature"
    ? Diverging
    : InverseGreys;
  if (this->Kind == Faces || this->Kind == AsIs)
  {
    return;
  }
  for (int k = 0; k < std::min(3, this->Components); ++k)
  {
    this->findRange(maps, name, k);
  }
  if (name == "Normal")
  {
    this->Low.fill(-1.);
    this->High.fill(1.);
  }
  if (this->Kind == InverseGreys && this->Low[0] < 0.)
  {
    this->Kind = Diverging;
  }
}

MapColors::Color MapColors::operator()(vtkDataArray* array, vtkIdType pixel) const
{
  const double v = array->GetComponent(pixel, 0);
  switch (this->Kind)
  {
    case Faces:
    {
      // A bijective mix of the bits, so that neighbours differ.
      auto h = static_cast<std::uint32_t>(v) * 2654435761u + 0x9e3779b9u;
      h = (h ^ (h >> 15)) * 2246822519u;
      h ^= h >> 13;
      return { static_cast<unsigned char>(80 + (h & 127)),
        static_cast<unsigned char>(80 + ((h >> 8) & 127)),
        static_cast<unsigned char>(80 + ((h >> 16) & 127)) };
    }
    case AsIs:
      return { channel(v / 255.), channel(v / 255.), channel(v / 255.) };
    case Channels:
    {
      Color c{ 0, 0, 0 };
      for (int k = 0; k < std::min(3, this->Components); ++k)
      {
        const double width = this->High[k] - this->Low[k];
        c[k] = channel(width > 0. ? (array->GetComponent(pixel, k) - this->Low[k]) / width : 0.5);
      }
      return c;
    }
    case Diverging:
    {
      const double most = std::max(std::abs(this->Low[0]), std::abs(this->High[0]));
      const double t = most > 0. ? std::clamp(v / most, -1., 1.) : 0.;
      const Color white{ 247, 247, 247 };
      return t < 0. ? mix(white, { 33, 102, 172 }, -t) : mix(white, { 178, 24, 43 }, t);
    }
    default:
    {
      const double t = this->High[0] > 0. ? std::sqrt(std::clamp(v / this->High[0], 0., 1.)) : 0.;
      return { channel(1. - t), channel(1. - t), channel(1. - t) };
    }
  }
}

void MapColors::findRange(
  vtkPartitionedDataSetCollection* maps, const std::string& name, int component)
{
  std::vector<double> values;
  for (unsigned int c = 0; c < maps->GetNumberOfPartitionedDataSets(); ++c)
  {
    if (vtkDataArray* array = arrayOf(mapsOfChart(maps, static_cast<int>(c)), name))
    {
      const vtkIdType n = array->GetNumberOfTuples();
      const vtkIdType step = std::max<vtkIdType>(1, n / 20000);
      for (vtkIdType p = 0; p < n && component < array->GetNumberOfComponents(); p += step)
      {
        const double v = array->GetComponent(p, component);
        if (std::isfinite(v))
        {
          values.push_back(v);
        }
      }
    }
  }
  if (values.empty())
  {
    return;
  }
  const std::size_t cut = values.size() / 100;
  std::nth_element(values.begin(), values.begin() + cut, values.end());
  this->Low[component] = values[cut];
  std::nth_element(values.begin(), values.end() - 1 - cut, values.end());
  this->High[component] = values[values.size() - 1 - cut];
}

vtkImageData* mapsOfChart(vtkPartitionedDataSetCollection* maps, int chart)
{
  return maps && chart >= 0 &&
      static_cast<unsigned int>(chart) < maps->GetNumberOfPartitionedDataSets()
    ? vtkImageData::SafeDownCast(
        maps->GetPartitionAsDataObject(static_cast<unsigned int>(chart), 0))
    : nullptr;
}

vtkSmartPointer<vtkImageData> whitePicture(int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* p = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(p, p + 3 * static_cast<std::size_t>(width) * height, 255);
  return image;
}

void paintMap(vtkImageData* picture, int left, int bottom, int width, int height,
  vtkImageData* image, vtkDataArray* array, const MapColors& colors)
{
  const int* size = image->GetDimensions();
  const int pictureWidth = picture->GetDimensions()[0];
  auto* pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (int y = 0; y < height; ++y)
  {
    const int y0 = static_cast<int>(static_cast<std::int64_t>(y) * size[1] / height);
    const int y1 =
      std::max(y0 + 1, static_cast<int>(static_cast<std::int64_t>(y + 1) * size[1] / height));
    for (int x = 0; x < width; ++x)
    {
      const int x0 = static_cast<int>(static_cast<std::int64_t>(x) * size[0] / width);
      const int x1 =
        std::max(x0 + 1, static_cast<int>(static_cast<std::int64_t>(x + 1) * size[0] / width));
      // At most 16 of the pixels: a large map is a picture soon enough.
      const int stepX = std::max(1, (x1 - x0) / 4);
      const int stepY = std::max(1, (y1 - y0) / 4);
      int sum[3] = { 0, 0, 0 };
      int count = 0;
      for (int j = y0; j < y1; j += stepY)
      {
        for (int i = x0; i < x1; i += stepX, ++count)
        {
          const Color c = colors(array, static_cast<vtkIdType>(j) * size[0] + i);
          for (int k = 0; k < 3; ++k)
          {
            sum[k] += c[k];
          }
        }
      }
      unsigned char* p =
        pixels + 3 * (static_cast<std::size_t>(bottom + y) * pictureWidth + left + x);
      for (int k = 0; k < 3; ++k)
      {
        p[k] = static_cast<unsigned char>((sum[k] + count / 2) / count);
      }
    }
  }
}

std::vector<std::string> mapNames(vtkPartitionedDataSetCollection* maps)
{
  std::vector<std::string> names;
  if (vtkImageData* image = mapsOfChart(maps, 0))
  {
    for (int k = 0; k < image->GetPointData()->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* array = image->GetPointData()->GetArray(k);
      if (array && array->GetName())
      {
        names.emplace_back(array->GetName());
      }
    }
  }
  return names;
}

vtkSmartPointer<vtkImageData> mapPicture(
  vtkPartitionedDataSetCollection* maps, int chart, const std::string& name)
{
  vtkImageData* image = mapsOfChart(maps, chart);
  vtkDataArray* array = arrayOf(image, name);
  if (!array)
  {
    return nullptr;
  }
  const int* size = image->GetDimensions();
  auto picture = whitePicture(size[0], size[1]);
  paintMap(picture, 0, 0, size[0], size[1], image, array, MapColors(maps, name));
  return picture;
}

} // namespace stipple
