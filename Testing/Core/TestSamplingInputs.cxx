// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What sampling reads: arrays as floats, control images, pictures, importances, control maps.
#include "ControlImage.h"
#include "ControlMapBuilder.h"
#include "FloatValues.h"
#include "ImportanceSource.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

using namespace stipple;

namespace
{
vtkSmartPointer<vtkImageData> image(int width, int height)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(width, height, 1);
  return result;
}

void addArray(vtkImageData* to, const char* name, const std::function<double(int)>& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (int i = 0; i < to->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(value(i));
  }
  to->GetPointData()->AddArray(array);
}

/// A picture that is 0 on the left and 1 on the right.
vtkSmartPointer<vtkImageData> twoPixels()
{
  auto picture = image(2, 1);
  vtkNew<vtkFloatArray> scalars;
  scalars->InsertNextValue(0.f);
  scalars->InsertNextValue(1.f);
  picture->GetPointData()->SetScalars(scalars);
  return picture;
}
}

TEST(FloatValues, BorrowsFloatsAndTakesTheNormOfTuples)
{
  vtkNew<vtkFloatArray> floats;
  floats->InsertNextValue(-2.5f);
  EXPECT_EQ(FloatValues(floats).data(), floats->GetPointer(0));
  vtkNew<vtkIntArray> pairs;
  pairs->SetNumberOfComponents(2);
  pairs->InsertNextTuple2(3, -4);
  EXPECT_FLOAT_EQ(FloatValues(pairs)[0], 5.f);
  vtkNew<vtkIntArray> single;
  single->InsertNextValue(-4);
  EXPECT_FLOAT_EQ(FloatValues(single)[0], -4.f) << "one component keeps its sign";
}

TEST(ControlImage, FindsThePixelOfAParameter)
{
  ControlImage c;
  c.width = 5;
  c.height = 3;
  c.extent = Vec2(1., 0.6);
  for (int i = 0; i < c.numberOfPixels(); ++i)
  {
    EXPECT_EQ(c.pixelAt(c.centre(i)), i);
  }
  EXPECT_EQ(c.pixelAt(Vec2(-1., -1.)), 0);
  EXPECT_EQ(c.pixelAt(Vec2(2., 2.)), 14);
  EXPECT_NEAR(c.pixelArea(), 0.04, 1e-15);
  const PixelBox box = c.pixelsAround(Vec2(0.25, 0.25), Vec2(0.35, 0.25), Vec2(0.35, 0.35));
  EXPECT_LE(box.xBegin, 1);
  EXPECT_GE(box.xEnd, 2);
  EXPECT_LE(box.yBegin, 1);
  EXPECT_GE(box.yEnd, 2);
}

TEST(ControlImage, SumsWhatIsWanted)
{
  const float none = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, 4> control = { { 2.f, -1.f, none, 6.f } };
  const std::array<float, 4> area = { { 4.f, 1.f, 1.f, 0.f } };
  ControlImage c;
  c.width = 2;
  c.height = 2;
  c.extent = Vec2(1., 0.5);
  c.control = control.data();
  c.areaDistortion = area.data();
  const ControlMass mass = controlMass(c);
  EXPECT_NEAR(mass.total, 8. * c.pixelArea(), 1e-12);
  EXPECT_NEAR(mass.largest, 6., 1e-12);
  EXPECT_NEAR(c.density(0), 0.5, 1e-12);
  EXPECT_EQ(c.density(1), 0.);
  EXPECT_EQ(c.density(2), 0.);
  EXPECT_EQ(c.density(3), 0.) << "no surface below";
  const std::array<float, 4> infinite = { { 1.f, std::numeric_limits<float>::infinity(), 0.f,
    0.f } };
  c.control = infinite.data();
  EXPECT_TRUE(std::isinf(controlMass(c).total));
}

TEST(PictureBrightness, IsLinearBetweenPixels)
{
  const PictureBrightness brightness(twoPixels());
  EXPECT_FLOAT_EQ(brightness(0.25, 0.5), 0.f);
  EXPECT_FLOAT_EQ(brightness(0.5, 0.5), 0.5f);
  EXPECT_FLOAT_EQ(brightness(0.6, 0.1), 0.7f);
  EXPECT_FLOAT_EQ(brightness(1., 0.9), 1.f) << "clamped beyond the last pixel's middle";
  auto red = image(1, 1);
  vtkNew<vtkFloatArray> colour;
  colour->SetNumberOfComponents(3);
  colour->InsertNextTuple3(1., 0., 0.);
  red->GetPointData()->SetScalars(colour);
  EXPECT_FLOAT_EQ(PictureBrightness(red)(0.5, 0.5), 0.2126f) << "Rec. 709";
}

TEST(ImportanceSource, ReadsOrDerivesCurvatures)
{
  const auto map = image(2, 2);
  ImportanceSource source;
  source.importance = ImportanceKind::Total;
  std::array<float, 4> values = {};
  EXPECT_EQ(source.fill(map, values.data()), "MeanCurvature") << "names what is missing";
  addArray(map, "MeanCurvature", [](int i) { return -i; });
  EXPECT_EQ(source.fill(map, values.data()), "GaussianCurvature");
  addArray(map, "GaussianCurvature", [](int i) { return 0.5 * i; });
  EXPECT_EQ(source.fill(map, values.data()), "");
  EXPECT_FLOAT_EQ(values[3], 4.f * 9.f - 2.f * 1.5f) << "k1^2 + k2^2 = 4 H^2 - 2 K";
  source.importance = ImportanceKind::Mean;
  EXPECT_EQ(source.fill(map, values.data()), "");
  EXPECT_FLOAT_EQ(values[2], 2.f) << "the magnitude";
  addArray(map, "TotalCurvature", [](int) { return 7.; });
  source.importance = ImportanceKind::Total;
  EXPECT_EQ(source.fill(map, values.data()), "");
  EXPECT_FLOAT_EQ(values[3], 7.f) << "an array of its own goes before";
  source.importance = ImportanceKind::Array;
  source.arrayName = "Weight";
  EXPECT_EQ(source.fill(map, values.data()), "Weight");
}

TEST(ImportanceSource, LaysAPictureOnChartsOrProjectsIt)
{
  const PictureBrightness brightness(twoPixels());
  const auto map = image(2, 2);
  ImportanceSource source;
  source.importance = ImportanceKind::Image;
  source.picture = &brightness;
  std::array<float, 4> values = {};
  EXPECT_EQ(source.fill(map, values.data()), "");
  EXPECT_EQ(values, (std::array<float, 4>{ { 0.f, 1.f, 0.f, 1.f } }));
  source.projection = PictureProjection::YAxis; // x runs across
  source.bounds = { { -1., 1., 0., 0., 0., 4. } };
  EXPECT_EQ(source.fill(map, values.data()), "Position");
  vtkNew<vtkDoubleArray> position;
  position->SetName("Position");
  position->SetNumberOfComponents(3);
  for (const double x : { 1., 0., -1., -0.5 })
  {
    position->InsertNextTuple3(x, 5., 2.);
  }
  map->GetPointData()->AddArray(position);
  EXPECT_EQ(source.fill(map, values.data()), "");
  EXPECT_EQ(values, (std::array<float, 4>{ { 1.f, 0.5f, 0.f, 0.f } }));
}

TEST(ControlMapBuilder, ScalesRaisesAndWeighsAnImportance)
{
  vtkNew<vtkPartitionedDataSetCollection> maps;
  const auto map = image(10, 10);
  maps->SetPartition(0, 0, map);
  ControlMapBuilder builder;
  ControlMapOptions options;
  std::vector<vtkSmartPointer<vtkFloatArray>> control;
  std::string warning;
  const auto build = [&] {
    return builder.build(maps, nullptr, nullptr, options, {}, control, warning);
  };
  EXPECT_EQ(build().code(), StatusCode::BadInput) << "no AreaDistortion";
  addArray(map, "AreaDistortion", [](int i) { return i == 0 ? 0. : 2.; });
  ASSERT_TRUE(build().ok());
  ASSERT_EQ(control.size(), 1u);
  EXPECT_FLOAT_EQ(control[0]->GetValue(0), 0.f) << "nothing where there is no surface";
  EXPECT_FLOAT_EQ(control[0]->GetValue(5), control[0]->GetValue(99)) << "uniform";
  options.importance = ImportanceKind::Array;
  options.arrayName = "Weight";
  EXPECT_EQ(build().code(), StatusCode::BadInput) << "no such map";
  addArray(map, "Weight", [](int i) { return i < 50 ? 1. : -4.; });
  options.gamma = 0.5;
  options.minimumDensity = 0.;
  ASSERT_TRUE(build().ok());
  EXPECT_NEAR(control[0]->GetValue(99), 2., 0.02)
    << "the largest importance is 1, to half a percent of its quantile";
  EXPECT_NEAR(control[0]->GetValue(10) / control[0]->GetValue(99), 0.5, 1e-4) << "(1/4)^gamma";
  options.minimumDensity = 0.8;
  ASSERT_TRUE(build().ok());
  EXPECT_NEAR(control[0]->GetValue(10) / control[0]->GetValue(99), 0.8, 1e-4) << "the floor";
  EXPECT_TRUE(warning.empty());
  options.gradation = 1.;
  EXPECT_EQ(build().code(), StatusCode::BadInput) << "gradation works on the surface";

  options = {};
  options.sizeArray = "Length";
  EXPECT_EQ(build().code(), StatusCode::BadInput) << "no such map";
  addArray(map, "Length", [](int i) { return i < 50 ? 0.1 : 0.2; });
  ASSERT_TRUE(build().ok());
  EXPECT_NEAR(control[0]->GetValue(10), 2. * densityOfEdges(0.1), 1e-3);
  EXPECT_NEAR(control[0]->GetValue(99), 2. * densityOfEdges(0.2), 1e-3);
  const double* spacing = map->GetSpacing();
  EXPECT_NEAR(builder.sizes().numberOfSamples,
    spacing[0] * spacing[1] * 2. * (49. * densityOfEdges(0.1) + 50. * densityOfEdges(0.2)), 0.1)
    << "in its own unit; the first pixel has no area";
  EXPECT_FALSE(builder.sizes().hasGrown);
  options.sizing.smallest = 0.3;
  ASSERT_TRUE(build().ok());
  EXPECT_NEAR(control[0]->GetValue(10), 2. * densityOfEdges(0.3), 1e-3);
  options.sizeArray.clear();
  EXPECT_EQ(build().code(), StatusCode::BadInput) << "a bound on what has no unit";
}
