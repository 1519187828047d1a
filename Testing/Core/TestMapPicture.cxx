// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapContactSheet.h"
#include "MapPicture.h"
#include "SyntheticCharts.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <array>

using namespace stipple;

namespace
{
using Color = std::array<int, 3>;

/// An image of 4 x 2 pixels with one array of values.
template <typename Array>
vtkSmartPointer<vtkPartitionedDataSetCollection> makeMaps(
  const char* name, const std::vector<double>& values, int components = 1)
{
  auto maps = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 2, 1);
  const auto array = synthetic::makeArray<Array>(name, components, 8);
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    array->SetComponent(k / components, k % components, values[k]);
  }
  image->GetPointData()->AddArray(array);
  maps->SetPartition(0, 0, image);
  return maps;
}

Color colorAt(vtkImageData* picture, int i, int j)
{
  const auto* p = static_cast<unsigned char*>(picture->GetScalarPointer(i, j, 0));
  return { p[0], p[1], p[2] };
}

/// The colors of the 8 pixels.
template <typename Array>
std::vector<Color> colors(const char* name, const std::vector<double>& values, int components = 1)
{
  const auto picture = mapPicture(makeMaps<Array>(name, values, components), 0, name);
  std::vector<Color> result;
  for (int p = 0; p < 8; ++p)
  {
    result.push_back(colorAt(picture, p % 4, p / 4));
  }
  return result;
}

TEST(MapPicture, FacesAreToldApart)
{
  const auto c = colors<vtkIntArray>("FaceIndex", { 5, 5, 6, 6, 5, 7, 7, 6 });
  EXPECT_EQ(c[0], c[1]);
  EXPECT_EQ(c[0], c[4]);
  EXPECT_EQ(c[2], c[7]);
  EXPECT_NE(c[0], c[2]);
  EXPECT_NE(c[2], c[5]);
  EXPECT_NE(c[0], c[5]);
}

TEST(MapPicture, SignedArraysAreBlueWhiteAndRed)
{
  for (const char* name : { "MeanCurvature", "Anything" })
  {
    const auto c = colors<vtkFloatArray>(name, { -2, -1, 0, 1, 2, 2, 2, 2 });
    EXPECT_GT(c[0][2], c[0][0] + 100) << name << ": blue";
    EXPECT_GT(c[4][0], c[4][2] + 100) << name << ": red";
    EXPECT_EQ(c[2], (Color{ 247, 247, 247 })) << name << ": white";
    EXPECT_GT(c[1][0], c[0][0]) << name << ": paler towards zero";
  }
}

TEST(MapPicture, PositiveArraysAreTheDarkerTheMore)
{
  const auto c = colors<vtkFloatArray>("AreaDistortion", { 0, 1, 4, 9, 16, 16, 16, 16 });
  for (int p = 0; p < 5; ++p)
  {
    EXPECT_EQ(c[p][0], c[p][2]) << "grey";
    EXPECT_NEAR(c[p][0], 255. * (1. - p / 4.), 1.) << "by the square root";
  }
}

TEST(MapPicture, VectorsAreColorsAndHalftonesThemselves)
{
  std::vector<double> normals(24, 0.);
  normals[0] = 1.;  // +x
  normals[5] = -1.; // the second one is -z
  const auto c = colors<vtkFloatArray>("Normal", normals, 3);
  EXPECT_EQ(c[0], (Color{ 255, 128, 128 }));
  EXPECT_EQ(c[1], (Color{ 128, 128, 0 }));
  const auto h = colors<vtkUnsignedCharArray>("Halftone", { 0, 255, 0, 255, 255, 0, 0, 17 });
  EXPECT_EQ(h[0], (Color{ 0, 0, 0 }));
  EXPECT_EQ(h[1], (Color{ 255, 255, 255 }));
  EXPECT_EQ(h[7], (Color{ 17, 17, 17 }));
}

TEST(MapPicture, WhatIsNotThereHasNoPicture)
{
  const auto maps = makeMaps<vtkFloatArray>("Heat", { 1, 2, 3, 4, 5, 6, 7, 8 });
  EXPECT_EQ(mapNames(maps), std::vector<std::string>{ "Heat" });
  EXPECT_TRUE(mapNames(nullptr).empty());
  EXPECT_NE(mapPicture(maps, 0, "Heat"), nullptr);
  EXPECT_EQ(mapPicture(maps, 0, "Cold"), nullptr);
  EXPECT_EQ(mapPicture(maps, 1, "Heat"), nullptr);
  EXPECT_EQ(mapPicture(maps, -1, "Heat"), nullptr);
  EXPECT_EQ(mapContactSheet(nullptr), nullptr);
}

TEST(MapPicture, ASheetHasATileForEachMapOfEachChart)
{
  auto maps = makeMaps<vtkFloatArray>("Dark", { 1, 1, 1, 1, 1, 1, 1, 1 });
  vtkImageData::SafeDownCast(maps->GetPartitionAsDataObject(0, 0))
    ->GetPointData()
    ->AddArray(synthetic::makeArray<vtkUnsignedCharArray>("Halftone", 1, 8));
  vtkNew<vtkImageData> tall; // twice as high as wide, and without the second map
  tall->SetDimensions(2, 4, 1);
  const auto dark = synthetic::makeArray<vtkFloatArray>("Dark", 1, 8);
  dark->FillComponent(0, 1.);
  tall->GetPointData()->AddArray(dark);
  maps->SetPartition(1, 0, tall);
  ContactSheetOptions options;
  options.tile = 32;
  options.labels = false;
  const auto plain = mapContactSheet(maps, options);
  // Two columns of 32; rows of 16 and 32; gaps of 6 between and around them.
  EXPECT_EQ(plain->GetDimensions()[0], 2 * 32 + 3 * 6);
  EXPECT_EQ(plain->GetDimensions()[1], 16 + 32 + 3 * 6);
  const Color black{ 0, 0, 0 };
  const Color white{ 255, 255, 255 };
  EXPECT_EQ(colorAt(plain, 6, 16 + 32 + 2 * 6 - 1), black) << "the first chart is on top";
  EXPECT_EQ(colorAt(plain, 6 + 31, 6 + 32 + 6), black) << "as wide as the tile";
  EXPECT_EQ(colorAt(plain, 6 + 15, 6 + 31), black) << "the second one is narrow";
  EXPECT_EQ(colorAt(plain, 6 + 16, 6 + 31), white);
  EXPECT_EQ(colorAt(plain, 2 * 6 + 32, 6), white) << "a map that a chart has not";
  options.maximumCharts = 1;
  options.maps = { "Dark" };
  EXPECT_EQ(mapContactSheet(maps, options)->GetDimensions()[1], 16 + 2 * 6);
  EXPECT_EQ(mapContactSheet(maps, options)->GetDimensions()[0], 32 + 2 * 6);
  options.labels = true;
  const auto labelled = mapContactSheet(maps, options);
  const int* size = labelled->GetDimensions();
  EXPECT_GT(size[0], 32 + 2 * 6);
  int dots = 0; // of the map's name, above the tile
  for (int j = 16 + 2 * 6; j < size[1]; ++j)
  {
    for (int i = 0; i < size[0]; ++i)
    {
      dots += colorAt(labelled, i, j)[0] < 128 ? 1 : 0;
    }
  }
  EXPECT_GT(dots, 10);
}
} // namespace
