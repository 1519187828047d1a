// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapContactSheet.h"

#include "MapPicture.h"

#include "vtkDataArray.h"
#include "vtkFreeTypeTools.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stipple
{
namespace
{
/// Dark text with its lower left corner at (left, bottom), cut to the picture and to a width.
void paintText(
  vtkImageData* picture, int left, int bottom, int width, const std::string& text, int size)
{
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->SetColor(0., 0., 0.);
  vtkNew<vtkImageData> letters;
  int used[2] = { 0, 0 };
  if (!vtkFreeTypeTools::GetInstance()->RenderString(property, text, 72, letters, used))
  {
    return;
  }
  const int* extent = letters->GetExtent();
  const int* picturesize = picture->GetDimensions();
  for (int y = extent[2]; y <= extent[3]; ++y)
  {
    for (int x = extent[0]; x <= extent[1]; ++x)
    {
      const int i = left + x - extent[0];
      const int j = bottom + y - extent[2];
      if (x - extent[0] >= width || i < 0 || j < 0 || i >= picturesize[0] || j >= picturesize[1])
      {
        continue;
      }
      const auto* letter = static_cast<unsigned char*>(letters->GetScalarPointer(x, y, extent[4]));
      auto* p = static_cast<unsigned char*>(picture->GetScalarPointer(i, j, 0));
      for (int k = 0; k < 3; ++k)
      {
        p[k] = static_cast<unsigned char>((letter[3] * letter[k] + (255 - letter[3]) * p[k]) / 255);
      }
    }
  }
}
}

vtkSmartPointer<vtkImageData> mapContactSheet(
  vtkPartitionedDataSetCollection* maps, const ContactSheetOptions& options)
{
  const std::vector<std::string> names = options.maps.empty() ? mapNames(maps) : options.maps;
  const int charts = maps
    ? std::min<int>(std::max(1, options.maximumCharts), maps->GetNumberOfPartitionedDataSets())
    : 0;
  if (names.empty() || charts == 0)
  {
    return nullptr;
  }
  const int tile = std::max(16, options.tile);
  const int gap = 6;
  const int fontSize = std::clamp(tile / 13, 9, 18);
  const int header = options.labels ? fontSize + 6 : 0;
  const int margin = options.labels ? 3 * fontSize : 0;
  // Rows as high as their charts.
  std::vector<std::array<int, 2>> tiles;
  int height = header + gap;
  for (int c = 0; c < charts; ++c)
  {
    vtkImageData* image = mapsOfChart(maps, c);
    double width2 = 1.;
    double height2 = 1.;
    if (image)
    {
      width2 = image->GetDimensions()[0] * image->GetSpacing()[0];
      height2 = image->GetDimensions()[1] * image->GetSpacing()[1];
    }
    const double scale = tile / std::max(width2, height2);
    tiles.push_back({ std::max(1, static_cast<int>(std::lround(width2 * scale))),
      std::max(1, static_cast<int>(std::lround(height2 * scale))) });
    height += tiles.back()[1] + gap;
  }
  const int columns = static_cast<int>(names.size());
  auto picture = whitePicture(margin + columns * (tile + gap) + gap, height);
  for (int m = 0; m < columns; ++m)
  {
    const MapColors colors(maps, names[m]);
    const int left = margin + gap + m * (tile + gap);
    int top = height - header - gap;
    if (options.labels)
    {
      paintText(picture, left, height - header, tile, names[m], fontSize);
    }
    for (int c = 0; c < charts; ++c)
    {
      vtkImageData* image = mapsOfChart(maps, c);
      vtkDataArray* array = image ? image->GetPointData()->GetArray(names[m].c_str()) : nullptr;
      if (array)
      {
        paintMap(picture, left, top - tiles[c][1], tiles[c][0], tiles[c][1], image, array, colors);
      }
      if (options.labels && m == 0)
      {
        paintText(
          picture, gap, top - tiles[c][1] / 2 - fontSize / 2, margin, std::to_string(c), fontSize);
      }
      top -= tiles[c][1] + gap;
    }
  }
  return picture;
}
} // namespace stipple
