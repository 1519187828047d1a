// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Control maps: each option means what it says, only what is asked for is needed, bad input is one
// sentence.
#include "Check.h"

#include "vtkCommand.h"
#include "vtkControlMap.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using test::check;

constexpr int Size = 64;

using Field = std::function<double(double, double)>; // of the place in the unit square

void addMap(vtkImageData* image, const char* name, const Field& field)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  for (int i = 0; i < Size * Size; ++i)
  {
    array->InsertNextValue(
      static_cast<float>(field((i % Size + 0.5) / Size, (i / Size + 0.5) / Size)));
  }
  image->GetPointData()->AddArray(array);
}

/// Two charts; the second has twice the mean curvature and four times the area.
vtkSmartPointer<vtkPartitionedDataSetCollection> makeMaps(
  const Field& mean = [](double x, double) { return x; })
{
  auto maps = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  for (unsigned int c = 0; c < 2; ++c)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(Size, Size, 1);
    image->SetSpacing(1. / Size, 1. / Size, 1);
    image->SetOrigin(0.5 / Size, 0.5 / Size, 0);
    addMap(image, "AreaDistortion", [c](double, double y) { return (c ? 4. : 1.) * (0.5 + y); });
    addMap(image, "MeanCurvature",
      [&](double x, double y) { return (c + 1) * mean(x, y) * (y < 0.5 ? -1 : 1); });
    addMap(image, "GaussianCurvature", [](double, double y) { return -y; });
    maps->SetPartition(c, 0, image);
  }
  return maps;
}

vtkFloatArray* controlOf(vtkControlMap* filter, unsigned int chart)
{
  auto* image = vtkImageData::SafeDownCast(filter->GetOutput()->GetPartition(chart, 0));
  return image ? vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("Control")) : nullptr;
}

/// Control over area distortion at pixels (x, y) of a chart.
double importanceAt(vtkControlMap* filter, unsigned int chart, int x, int y)
{
  auto* image = vtkImageData::SafeDownCast(filter->GetOutput()->GetPartition(chart, 0));
  vtkFloatArray* control = controlOf(filter, chart);
  return control ? control->GetValue(y * Size + x) /
      image->GetPointData()->GetArray("AreaDistortion")->GetComponent(y * Size + x, 0)
                 : -1.;
}

bool isUniform(vtkControlMap* filter)
{
  bool uniform = true;
  for (unsigned int c = 0; c < 2; ++c)
  {
    for (int i = 0; i < Size; ++i)
    {
      uniform = uniform && std::abs(importanceAt(filter, c, i, (7 * i) % Size) - 1.) < 1e-6;
    }
  }
  return uniform;
}

void testKindsAndGamma()
{
  vtkNew<vtkControlMap> filter;
  auto maps = makeMaps();
  filter->SetInputDataObject(maps);
  filter->SetMinimumDensity(0.);
  filter->Update();
  check(isUniform(filter), "uniform control is the area distortion");
  auto* out = vtkImageData::SafeDownCast(filter->GetOutput()->GetPartition(1, 0));
  check(out->GetPointData()->GetArray("MeanCurvature") != nullptr, "arrays are passed on");
  check(out->GetPointData()->GetScalars() == controlOf(filter, 1), "Control is the active scalars");
  auto* in = vtkImageData::SafeDownCast(maps->GetPartition(1, 0));
  check(!in->GetPointData()->GetArray("Control") && out != in, "the input stays as it is");

  filter->SetImportanceToMean();
  for (double gamma : { 0.5, 1., 2. })
  {
    filter->SetGamma(gamma);
    filter->Update();
    const double ratio = importanceAt(filter, 0, 40, 3) / importanceAt(filter, 0, 10, 60);
    check(std::abs(ratio - std::pow(40.5 / 10.5, gamma)) < 1e-3 * ratio,
      "the magnitude of the mean curvature to the power gamma");
    const double charts = importanceAt(filter, 1, 12, 9) / importanceAt(filter, 0, 12, 9);
    check(std::abs(charts - std::pow(2., gamma)) < 1e-3 * charts, "one scale for all charts");
  }
  filter->SetGamma(0.);
  filter->Update();
  check(isUniform(filter), "gamma 0 is uniform");

  filter->SetGamma(1.);
  const auto expectRatio = [&](const char* what, double (*f)(double H, double K)) {
    filter->Update();
    const auto at = [&](int x, int y) { return std::abs(f((x + 0.5) / Size, -(y + 0.5) / Size)); };
    const double ratio = importanceAt(filter, 0, 20, 50) / importanceAt(filter, 0, 13, 37);
    check(std::abs(ratio - at(20, 50) / at(13, 37)) < 2e-3 * ratio, what);
  };
  filter->SetImportanceToGaussian();
  expectRatio("Gaussian", [](double, double K) { return K; });
  filter->SetImportanceToMinimum();
  expectRatio("minimum", [](double H, double K) { return H - std::sqrt(H * H - K); });
  filter->SetImportanceToMaximum();
  expectRatio("maximum", [](double H, double K) { return H + std::sqrt(H * H - K); });
  filter->SetImportanceToTotal();
  expectRatio("total", [](double H, double K) { return 4 * H * H - 2 * K; });
  filter->SetImportanceToL2();
  expectRatio("L2", [](double H, double K) { return std::cbrt(9 * H * H - K); });
}

void testQuantile()
{
  // A thousandth of the surface, noise, must not take the whole range, nor all samples.
  vtkNew<vtkControlMap> filter;
  auto maps = makeMaps();
  auto* array = vtkFloatArray::SafeDownCast(vtkImageData::SafeDownCast(maps->GetPartition(0, 0))
                                              ->GetPointData()
                                              ->GetArray("MeanCurvature"));
  for (int i = 0; i < 8; ++i)
  {
    array->SetValue(500 * i, i == 0 ? std::nanf("") : 1e9f);
  }
  filter->SetInputDataObject(maps);
  filter->SetImportanceToMean();
  filter->SetMinimumDensity(0.);
  filter->Update();
  check(importanceAt(filter, 1, 50, 50) > 0.7, "the 99.5 % quantile is one");
  check(importanceAt(filter, 0, 500 % Size, 500 / Size) == 1., "what is larger is clamped");
  check(importanceAt(filter, 0, 0, 0) == 0., "NaN is nothing");
}

void testFloorAndTransfer()
{
  vtkNew<vtkControlMap> filter;
  filter->SetInputDataObject(makeMaps());
  filter->SetImportanceToMean();
  filter->SetMinimumDensity(0.3);
  filter->Update();
  double least = 1e9;
  double most = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    for (unsigned int c = 0; c < 2; ++c)
    {
      least = std::min(least, importanceAt(filter, c, i % Size, i / Size));
      most = std::max(most, importanceAt(filter, c, i % Size, i / Size));
    }
  }
  check(std::abs(least - 0.3 * most) < 1e-6 && most > 0.98 && most <= 1.,
    "the floor is 0.3 of the maximum: " + std::to_string(least) + " " + std::to_string(most));

  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0., 1.);
  function->AddPoint(1., 0.2);
  filter->SetMinimumDensity(0.);
  filter->SetTransferFunction(function);
  filter->Update();
  check(importanceAt(filter, 1, 5, 5) > importanceAt(filter, 1, 50, 5),
    "the transfer function turns it round");
  check(std::abs(importanceAt(filter, 1, 63, 20) - 0.2) < 0.02, "and ends where it says");
  const double before = importanceAt(filter, 0, 63, 20);
  function->RemoveAllPoints();
  function->AddPoint(0., 0.);
  function->AddPoint(1., 1.);
  filter->Update();
  check(
    std::abs(importanceAt(filter, 0, 63, 20) - before) > 0.05, "a change of the function is seen");

  function->RemoveAllPoints();
  function->AddPoint(0., 0.);
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  check(observer->GetWarning() && isUniform(filter), "all zero is uniform, with a warning");
}

void testImageAndArray()
{
  vtkNew<vtkControlMap> filter;
  auto maps = makeMaps();
  for (unsigned int c = 0; c < 2; ++c)
  {
    vtkNew<vtkDoubleArray> flow; // double, three components
    flow->SetName("Flow");
    flow->SetNumberOfComponents(3);
    for (int i = 0; i < Size * Size; ++i)
    {
      flow->InsertNextTuple3(3. * (i % Size), 4. * (i % Size), 0.);
    }
    vtkImageData::SafeDownCast(maps->GetPartition(c, 0))->GetPointData()->AddArray(flow);
  }
  filter->SetInputDataObject(maps);
  filter->SetMinimumDensity(0.);
  filter->SetImportanceToArray();
  filter->SetImportanceArrayName("Flow");
  filter->Update();
  check(std::abs(importanceAt(filter, 0, 40, 2) / importanceAt(filter, 1, 8, 60) - 5.) < 0.01,
    "the norm of an array");

  vtkNew<vtkImageData> picture; // red fades to the right: luminance 0.2126
  picture->SetDimensions(2, 1, 1);
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetNumberOfComponents(3);
  rgb->InsertNextTuple3(200, 0, 0);
  rgb->InsertNextTuple3(40, 0, 0);
  picture->GetPointData()->SetScalars(rgb);
  filter->SetImportanceToImage();
  filter->SetImportanceImage(picture);
  filter->Update();
  check(std::abs(importanceAt(filter, 0, 0, 5) / importanceAt(filter, 0, 63, 50) - 5.) < 0.05,
    "a picture's brightness");
  check(std::abs(importanceAt(filter, 0, 31, 5) - 0.6) < 0.02, "linear between its pixels");
}

/// What works on the surface needs the charts; TestControlMapSurface tests what it then does.
void testChartsAreAskedFor()
{
  vtkNew<vtkControlMap> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputDataObject(makeMaps());
  filter->SetImportanceToMean();
  const auto isRefused = [&](const char* what) {
    observer->Clear();
    filter->Modified();
    filter->Update();
    const bool named = observer->GetErrorMessage().find(what) != std::string::npos &&
      observer->GetErrorMessage().find("port 1") != std::string::npos;
    check(named && !controlOf(filter, 0), std::string(what) + " without charts is an error");
  };
  filter->SetGradation(5.);
  isRefused("Gradation");
  filter->SetGradation(0.);
  filter->SetBandPass(0., 5.);
  isRefused("BandPass");
  filter->SetBandPass(3., 2.);
  observer->Clear();
  filter->Update();
  check(observer->GetErrorMessage().find("BandPass lets nothing through") != std::string::npos,
    "a band-pass whose sizes do not ascend");
  filter->SetBandPass(0., 0.);
  filter->AddStroke(0., 0., 0., 1., 1.);
  isRefused("Painting");
  filter->RemoveLastStroke();
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(1, 1, 1);
  picture->AllocateScalars(VTK_FLOAT, 1);
  filter->SetImportanceImage(picture);
  filter->SetImportanceToImage();
  filter->SetImageProjectionToZAxis();
  isRefused("projected");
}

void testFlat()
{
  vtkNew<vtkControlMap> filter;
  filter->SetInputDataObject(makeMaps([](double x, double) { return 1e-9 * x; }));
  filter->SetImportanceToMean();
  filter->Update();
  check(isUniform(filter), "rounding noise of a flat surface is no curvature");
}

void testBadInput()
{
  vtkNew<vtkControlMap> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  auto maps = makeMaps();
  vtkImageData::SafeDownCast(maps->GetPartition(1, 0))
    ->GetPointData()
    ->RemoveArray("MeanCurvature");
  filter->SetInputDataObject(maps);
  filter->Update();
  check(!observer->GetError(), "a map that is not asked for is not needed");
  filter->SetImportanceToMean();
  filter->Update();
  check(observer->GetErrorMessage().find("Map 1 has no point array MeanCurvature") !=
        std::string::npos &&
      filter->GetOutput()->GetNumberOfPartitionedDataSets() == 0,
    "a missing map is named, the output emptied");
  observer->Clear();
  filter->SetGamma(0.);
  filter->Update();
  check(!observer->GetError(), "nor is it needed with gamma 0");
  filter->SetGamma(1.);
  filter->SetImportanceToImage();
  filter->Update();
  check(observer->GetErrorMessage().find("ImportanceImage") != std::string::npos, "no picture");
  observer->Clear();
  vtkNew<vtkPartitionedDataSetCollection> nothing;
  filter->SetInputDataObject(nothing);
  filter->Update();
  check(!observer->GetError(), "empty input is no error: " + observer->GetErrorMessage());
}
}

int TestControlMap(int, char*[])
{
  testKindsAndGamma();
  testQuantile();
  testFloorAndTransfer();
  testImageAndArray();
  testChartsAreAskedFor();
  testFlat();
  testBadInput();
  return test::exitStatus();
}
