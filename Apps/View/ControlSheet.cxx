// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ControlSheet.h"

#include "AtlasSurface.h"
#include "ColorBar.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace stipple
{
namespace
{
constexpr int Gap = 6;       // pixels between charts
constexpr int LeastSide = 8; // pixels; nothing is shown in a smaller box
constexpr int NumberOfShades = 1024;
constexpr Pixel Rim = { { 150, 158, 170 } };

/// From white to dark, with the root of the control.
std::vector<Pixel> makeShades()
{
  std::vector<Pixel> result;
  for (int i = 0; i < NumberOfShades; ++i)
  {
    const double share = std::sqrt(static_cast<double>(i) / (NumberOfShades - 1));
    result.push_back({ { static_cast<unsigned char>(255 - 225 * share),
      static_cast<unsigned char>(255 - 215 * share),
      static_cast<unsigned char>(255 - 190 * share) } });
  }
  return result;
}

vtkImageData* imageOf(vtkPartitionedDataSetCollection* images, int chart)
{
  return images && chart < static_cast<int>(images->GetNumberOfPartitionedDataSets())
    ? vtkImageData::SafeDownCast(images->GetPartitionAsDataObject(chart, 0))
    : nullptr;
}

Vec2 extentOf(vtkPolyData* chart)
{
  vtkDataArray* extent = chart ? chart->GetFieldData()->GetArray("ChartExtent") : nullptr;
  return extent ? Vec2(extent->GetComponent(0, 0), extent->GetComponent(0, 1)) : Vec2(1, 1);
}

double areaOf(vtkPolyData* chart)
{
  double area = 0;
  vtkCellArray* cells = chart->GetPolys();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCellAtId(i, size, ids);
    area += triangleArea(
      Vec3(chart->GetPoint(ids[0])), Vec3(chart->GetPoint(ids[1])), Vec3(chart->GetPoint(ids[2])));
  }
  return area;
}

/// The control that 99 % of the pixels stay below.
double highControl(vtkPartitionedDataSetCollection* controls)
{
  std::vector<float> values;
  for (unsigned int c = 0; c < controls->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* array = vtkFloatArray::SafeDownCast(
      imageOf(controls, static_cast<int>(c))->GetPointData()->GetArray("Control"));
    const vtkIdType step = array ? std::max<vtkIdType>(1, array->GetNumberOfValues() / 4000) : 1;
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); i += step)
    {
      values.push_back(array->GetValue(i));
    }
  }
  if (values.empty())
  {
    return 1;
  }
  const auto place =
    values.begin() + static_cast<long>(0.99 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place > 0 ? *place : 1;
}
}

ControlSheet::ControlSheet(Touch touch)
  : OnTouch(std::move(touch))
{
}

void ControlSheet::setCharts(vtkPartitionedDataSetCollection* charts)
{
  this->Charts = charts;
  this->Lengths.clear();
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    vtkPolyData* chart = chartOf(charts, c);
    const Vec2 extent = extentOf(chart);
    this->Lengths.push_back(std::sqrt(areaOf(chart) / (extent[0] * extent[1])));
  }
  this->Controls = nullptr;
  this->First.clear();
  this->place();
}

void ControlSheet::setControls(vtkPartitionedDataSetCollection* controls)
{
  this->Controls = controls;
  this->Old = true;
}

void ControlSheet::setBox(const Rect& box)
{
  if (box.w != this->Box.w || box.h != this->Box.h)
  {
    Control::setBox(box);
    this->place();
  }
  Control::setBox(box);
}

void ControlSheet::place()
{
  this->Old = true;
  const int width = static_cast<int>(this->Box.w);
  const int height = static_cast<int>(this->Box.h);
  if (!this->Charts || width < LeastSide || height < LeastSide)
  {
    this->Tiles.clear();
    return;
  }
  if (this->First.empty())
  {
    this->arrange();
    this->First = this->Tiles;
    this->FirstWidth = width;
    this->FirstHeight = height;
  }
  const double factor = std::min(
    static_cast<double>(width) / this->FirstWidth, static_cast<double>(height) / this->FirstHeight);
  this->Tiles = this->First;
  for (Tile& tile : this->Tiles)
  {
    const int top = static_cast<int>(std::lround(factor * (this->FirstHeight - tile.y - tile.h)));
    tile.x = static_cast<int>(std::lround(factor * tile.x));
    tile.w = std::max(1, static_cast<int>(factor * tile.w));
    tile.h = std::max(1, static_cast<int>(factor * tile.h));
    tile.y = height - top - tile.h;
  }
}

std::vector<Rect> ControlSheet::tiles() const
{
  std::vector<Rect> result(this->Tiles.size());
  for (const Tile& tile : this->Tiles)
  {
    result[static_cast<std::size_t>(tile.chart)] = { this->Box.x + static_cast<float>(tile.x),
      this->Box.y + static_cast<float>(tile.y), static_cast<float>(tile.w),
      static_cast<float>(tile.h) };
  }
  return result;
}

/// Each tile, the highest first, as high up as it fits below those before it; false if the picture
/// is too small.
bool ControlSheet::arrange(double scale, int width, int height)
{
  this->Tiles.clear();
  for (std::size_t c = 0; c < this->Lengths.size(); ++c)
  {
    const Vec2 extent = extentOf(chartOf(this->Charts, static_cast<unsigned int>(c)));
    Tile tile;
    tile.chart = static_cast<int>(c);
    tile.w = std::max(4, static_cast<int>(scale * this->Lengths[c] * extent[0]));
    tile.h = std::max(4, static_cast<int>(scale * this->Lengths[c] * extent[1]));
    this->Tiles.push_back(tile);
  }
  std::stable_sort(
    this->Tiles.begin(), this->Tiles.end(), [](const Tile& a, const Tile& b) { return a.h > b.h; });
  std::vector<int> free(static_cast<std::size_t>(width), height); // of every column, up to where
  for (Tile& tile : this->Tiles)
  {
    int best = -1;
    for (int x = 0; x + tile.w <= width; ++x)
    {
      const int columns = std::min(tile.w + Gap, width - x);
      const int top = *std::min_element(free.begin() + x, free.begin() + x + columns);
      if (top > best)
      {
        best = top;
        tile.x = x;
      }
    }
    tile.y = best - tile.h;
    if (tile.y < 0)
    {
      return false;
    }
    const int columns = std::min(tile.w + Gap, width - tile.x);
    std::fill_n(free.begin() + tile.x, columns, tile.y - Gap);
  }
  return true;
}

void ControlSheet::arrange()
{
  const int width = static_cast<int>(this->Box.w);
  const int height = static_cast<int>(this->Box.h);
  double low = 0;
  double high = width / *std::max_element(this->Lengths.begin(), this->Lengths.end());
  high *= 8; // a rectangle may be narrow
  for (int i = 0; i < 30; ++i)
  {
    const double middle = 0.5 * (low + high);
    (this->arrange(middle, width, height) ? low : high) = middle;
  }
  this->arrange(low, width, height);
}

void ControlSheet::draw()
{
  const int width = static_cast<int>(this->Box.w);
  const int height = static_cast<int>(this->Box.h);
  this->Picture = vtkSmartPointer<vtkImageData>::New();
  this->Picture->SetDimensions(width, height, 1);
  this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<Pixel*>(this->Picture->GetScalarPointer());
  std::fill_n(pixels, static_cast<std::size_t>(width) * height,
    Pixel{ { shades::Ground.r, shades::Ground.g, shades::Ground.b } });
  const auto toShade =
    static_cast<float>(NumberOfShades - 1) / static_cast<float>(highControl(this->Controls));
  const std::vector<Pixel> shadeOf = makeShades();
  std::vector<int> columns;
  for (const Tile& tile : this->Tiles)
  {
    vtkImageData* image = imageOf(this->Controls, tile.chart);
    auto* control = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("Control"));
    const int* size = image->GetDimensions();
    const int end = std::min(tile.w, width - tile.x);
    columns.clear();
    for (int x = 0; x < end; ++x)
    {
      columns.push_back(static_cast<int>((x + 0.5) / tile.w * size[0]));
    }
    for (int y = 0; control && y < tile.h && tile.y + y >= 0 && tile.y + y < height; ++y)
    {
      const auto row = static_cast<vtkIdType>((y + 0.5) / tile.h * size[1]);
      const float* values = control->GetPointer(row * size[0]);
      Pixel* out = pixels + static_cast<std::size_t>(tile.y + y) * width + tile.x;
      for (int x = 0; x < end; ++x)
      {
        const bool rim = x == 0 || y == 0 || x == tile.w - 1 || y == tile.h - 1;
        const float shade = std::min(values[columns[x]] * toShade, NumberOfShades - 1.f);
        out[x] = rim ? Rim : shadeOf[static_cast<std::size_t>(std::max(0.f, shade))];
      }
    }
  }
}

void ControlSheet::paint(Canvas& canvas)
{
  if (!this->Controls || this->Tiles.empty())
  {
    canvas.text(
      this->Box.x, this->Box.top() - 12 * canvas.scale(), "no charts yet", { 12, shades::Quiet });
    return;
  }
  if (this->Old)
  {
    this->draw();
    this->Old = false;
  }
  const int* size = this->Picture->GetDimensions();
  canvas.image(
    { this->Box.x, this->Box.y, static_cast<float>(size[0]), static_cast<float>(size[1]) },
    this->Picture);
}

bool ControlSheet::positionAt(const Pointer& pointer, Vec3& position) const
{
  const double px = pointer.x - this->Box.x;
  const double py = pointer.y - this->Box.y;
  for (const Tile& tile : this->Tiles)
  {
    const double u = (px - tile.x) / tile.w;
    const double v = (py - tile.y) / tile.h;
    vtkImageData* image = imageOf(this->Controls, tile.chart);
    if (u < 0 || u >= 1 || v < 0 || v >= 1 || !image)
    {
      continue;
    }
    const int* size = image->GetDimensions();
    const vtkIdType pixel =
      static_cast<vtkIdType>(v * size[1]) * size[0] + static_cast<vtkIdType>(u * size[0]);
    vtkPolyData* chart = chartOf(this->Charts, static_cast<unsigned int>(tile.chart));
    vtkDataArray* faces = image->GetPointData()->GetArray("FaceIndex");
    vtkDataArray* uvs = chart->GetPointData()->GetArray("UV");
    if (!faces || !uvs)
    {
      return false;
    }
    vtkIdType count;
    const vtkIdType* ids;
    chart->GetPolys()->GetCellAtId(
      static_cast<vtkIdType>(faces->GetComponent(pixel, 0)), count, ids);
    const auto uvOf = [&](vtkIdType p) {
      return Vec2(uvs->GetComponent(p, 0), uvs->GetComponent(p, 1));
    };
    const Vec2 extent = extentOf(chart);
    const Vec2 at(u * extent[0], v * extent[1]);
    Eigen::Matrix2d edges;
    edges << uvOf(ids[1]) - uvOf(ids[0]), uvOf(ids[2]) - uvOf(ids[0]);
    Vec2 weights = edges.inverse() * (at - uvOf(ids[0]));
    if (!weights.allFinite())
    {
      weights = Vec2(1. / 3, 1. / 3);
    }
    // The pixel's centre lies in the triangle, the pointer next to it.
    weights = weights.cwiseMax(0.);
    weights /= std::max(1., weights.sum());
    position = (1 - weights.sum()) * Vec3(chart->GetPoint(ids[0])) +
      weights[0] * Vec3(chart->GetPoint(ids[1])) + weights[1] * Vec3(chart->GetPoint(ids[2]));
    return true;
  }
  return false;
}

bool ControlSheet::press(const Pointer& pointer)
{
  Vec3 position;
  if (pointer.secondary || !this->Controls || !this->positionAt(pointer, position))
  {
    return false;
  }
  this->Last = pointer;
  this->OnTouch({ position }, true, false);
  return true;
}

void ControlSheet::drag(const Pointer& pointer)
{
  std::vector<Vec3> positions;
  for (const Pointer& there : wayOf(this->Last, pointer))
  {
    Vec3 position;
    if (this->positionAt(there, position))
    {
      positions.push_back(position);
    }
  }
  this->Last = pointer;
  this->OnTouch(positions, false, false);
}

void ControlSheet::release(const Pointer&)
{
  this->OnTouch({}, false, true);
}
}
