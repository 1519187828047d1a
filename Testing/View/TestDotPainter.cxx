// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The pictures that the preview shows: numbered dots, and densities in colours.
#include "ColorBar.h"
#include "DensityImages.h"
#include "DotPainter.h"
#include "NearestTriangle.h"
#include "Preview.h"
#include "SphereAtlas.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace stipple
{
namespace
{
constexpr int Samples = 400;

/// The sphere's charts with the samples of a session of uniform density.
struct Sampled
{
  SamplingInput input = sphereAtlas(32);
  Preview preview;
  Atlas::Pointer atlas;

  Sampled()
  {
    this->preview.setAtlas(this->input);
    Session session = withPoints(Samples);
    session.set("importance", std::string("uniform"));
    EXPECT_TRUE(this->preview.update(session).ok());
    EXPECT_TRUE(Atlas::read(this->input.charts, nullptr, this->atlas).ok());
  }
};

Sampled& sampled()
{
  static Sampled result;
  return result;
}

/// The dot in a texel, -1 if there is none.
int dotAt(vtkImageData* numbers, int x, int y)
{
  const auto* texel = static_cast<const unsigned char*>(numbers->GetScalarPointer(x, y, 0));
  return texel[0] + 256 * texel[1] + 65536 * texel[2] - 1;
}

int dotAt(vtkImageData* numbers, const Vec2& uv, const Vec2& extent)
{
  const int* size = numbers->GetDimensions();
  const auto pixel = [&](int k) {
    return std::min(size[k] - 1, static_cast<int>(uv[k] / extent[k] * size[k]));
  };
  return dotAt(numbers, pixel(0), pixel(1));
}

/// Every dot's own place has its number.
void expectPlaced(const DotImages& images, vtkPolyData* samples)
{
  const AtlasSurface& surface = sampled().atlas->surface();
  ASSERT_EQ(images.numbers.size(), static_cast<std::size_t>(surface.numberOfCharts()));
  const auto* places = static_cast<const float*>(images.places->GetScalarPointer());
  vtkDataArray* uv = samples->GetPointData()->GetArray("UV");
  vtkDataArray* chart = samples->GetPointData()->GetArray("ChartId");
  int missing = 0;
  for (int i = 0; i < Samples; ++i)
  {
    const auto c = static_cast<int>(chart->GetComponent(i, 0));
    missing += dotAt(images.numbers[static_cast<std::size_t>(c)],
                 Vec2(uv->GetComponent(i, 0), uv->GetComponent(i, 1)), surface.extent[c]) != i;
    const Vec3 place =
      Vec3(places[4 * i], places[4 * i + 1], places[4 * i + 2]) + DotPainter::originOf(surface);
    EXPECT_LT((place - Vec3(samples->GetPoint(i))).norm(), 1e-6);
    // Dots do not touch: a sphere of area pi has 400.
    EXPECT_GT(places[4 * i + 3], 0.2 * 0.0886 / 3);
    EXPECT_LT(places[4 * i + 3], 0.35 * 0.0886);
  }
  EXPECT_LE(missing, 4) << "another one is as near";
}

/// How many dots are found in more than one chart.
std::size_t dotsOverSeams(const DotImages& images)
{
  std::vector<std::set<int>> chartsOf(Samples);
  for (std::size_t c = 0; c < images.numbers.size(); ++c)
  {
    const int* size = images.numbers[c]->GetDimensions();
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        const int dot = dotAt(images.numbers[c], x, y);
        if (dot >= 0)
        {
          chartsOf[static_cast<std::size_t>(dot)].insert(static_cast<int>(c));
        }
      }
    }
  }
  return static_cast<std::size_t>(std::count_if(chartsOf.begin(), chartsOf.end(),
    [](const std::set<int>& charts) { return charts.size() > 1; }));
}
}

TEST(DotPainter, SamplesAreWhereTheyLie)
{
  DotPainter painter(sampled().input.charts);
  const auto images = painter.paint(sampled().preview.samples(), sampled().preview.halftones());
  ASSERT_TRUE(images);
  expectPlaced(*images, sampled().preview.samples());
  ASSERT_GT(images->numbers.size(), 1U);
  EXPECT_GT(dotsOverSeams(*images), 5U) << "whole where two charts meet";
}

TEST(DotPainter, VerticesReachOverSeams)
{
  vtkPolyData* samples = sampled().preview.samples();
  std::vector<PlacedDot> places;
  for (vtkIdType i = 0; i < Samples; ++i)
  {
    places.push_back({ Vec3(samples->GetPoint(i)), 3.14 / Samples });
  }
  const AtlasSurface& surface = sampled().atlas->surface();
  const MeshDots dots = placeOnCharts(places, surface, NearestTriangle(surface));
  DotPainter painter(sampled().input.charts);
  const auto images = painter.paint(dots, sampled().preview.halftones());
  ASSERT_TRUE(images);
  expectPlaced(*images, dots.samples);
  EXPECT_GT(dotsOverSeams(*images), 5U);
}

TEST(DotPainter, TheSameTwice)
{
  DotPainter painter(sampled().input.charts);
  const auto first = painter.paint(sampled().preview.samples(), sampled().preview.halftones());
  const auto second = painter.paint(sampled().preview.samples(), sampled().preview.halftones());
  for (std::size_t c = 0; c < first->numbers.size(); ++c)
  {
    vtkImageData* a = first->numbers[c];
    vtkImageData* b = second->numbers[c];
    ASSERT_NE(a, b) << "the window has the first";
    ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
    const auto* bytes = static_cast<const unsigned char*>(a->GetScalarPointer());
    EXPECT_TRUE(std::equal(bytes, bytes + 4 * a->GetNumberOfPoints(),
      static_cast<const unsigned char*>(b->GetScalarPointer())));
  }
}

TEST(DotPainter, EndsWhenItIsStopped)
{
  DotPainter painter(sampled().input.charts);
  EXPECT_FALSE(
    painter.paint(sampled().preview.samples(), sampled().preview.halftones(), [] { return true; }));
}

TEST(DensityImages, AreColorsOfTheMean)
{
  vtkPartitionedDataSetCollection* controls = sampled().preview.controls();
  const auto images = densityImages(controls);
  ASSERT_EQ(images.size(), controls->GetNumberOfPartitionedDataSets());
  const Pixel mean = divergingColor(0.5);
  vtkIdType like = 0;
  vtkIdType inside = 0;
  for (unsigned int c = 0; c < images.size(); ++c)
  {
    auto* control = vtkImageData::SafeDownCast(controls->GetPartitionAsDataObject(c, 0));
    auto* area = vtkFloatArray::SafeDownCast(control->GetPointData()->GetArray("AreaDistortion"));
    ASSERT_EQ(images[c]->GetNumberOfPoints(), control->GetNumberOfPoints());
    const auto* pixels = static_cast<const Pixel*>(images[c]->GetScalarPointer());
    for (vtkIdType i = 0; i < control->GetNumberOfPoints(); ++i)
    {
      inside += area->GetValue(i) > 0;
      int most = 0;
      for (int k = 0; k < 3; ++k)
      {
        most = std::max(most, std::abs(pixels[i][k] - mean[k]));
      }
      like += area->GetValue(i) > 0 && most <= 2;
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GE(like, 0.95 * static_cast<double>(inside)) << "a uniform density is the mean all over";
}

TEST(DensityImages, NeedTheirArrays)
{
  vtkNew<vtkPartitionedDataSetCollection> controls;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  controls->SetPartition(0, 0, image);
  EXPECT_TRUE(densityImages(controls).empty());
}
}
