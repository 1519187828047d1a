// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What vtkControlMap does on the surface rather than in the charts: gradation, band-pass, painting
// and projected pictures, none of which may show a seam. The surface is the unit square in the
// plane z = 0, cut into 2 x 2 charts of unlike resolution.
#include "Check.h"
#include "SyntheticAtlas.h"

#include "vtkCommand.h"
#include "vtkControlMap.h"
#include "vtkDataArraySelection.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using test::check;

constexpr int GridSize = 40;

/// Atlas, maps and control of a square whose points carry the array "Quantity".
class Pipeline
{
public:
  template <typename F>
  explicit Pipeline(F quantity)
  {
    const auto n = static_cast<double>(GridSize);
    for (int k = 0; k < 4; ++k)
    {
      const int ci = k % 2;
      const int cj = k / 2;
      this->Builder.addGrid(
        GridSize, GridSize,
        [=](int i, int j) { return stipple::Vec3(0.5 * (ci + i / n), 0.5 * (cj + j / n), 0.); },
        ci == 0 ? stipple::Vec2(1., 0.5) : stipple::Vec2(1., 1.));
    }
    this->Builder.finish();
    for (unsigned int c = 0; c < 4; ++c)
    {
      auto* chart =
        vtkPolyData::SafeDownCast(this->Builder.Result.charts->GetPartitionAsDataObject(c, 0));
      vtkNew<vtkFloatArray> array;
      array->SetName("Quantity");
      for (vtkIdType i = 0; i < chart->GetNumberOfPoints(); ++i)
      {
        const double* p = chart->GetPoint(i);
        array->InsertNextValue(static_cast<float>(quantity(p[0], p[1])));
      }
      chart->GetPointData()->AddArray(array);
      vtkNew<vtkFloatArray> area;
      area->SetName("AreaDistortion");
      for (vtkIdType i = 0; i < chart->GetNumberOfCells(); ++i)
      {
        area->InsertNextValue(c % 2 == 0 ? 0.5f : 0.25f);
      }
      chart->GetCellData()->AddArray(area);
    }
    this->Maps->SetInputDataObject(this->Builder.Result.charts);
    this->Maps->SetBackendToCPU();
    this->Maps->SetMapSize(100);
    this->Maps->GetMapSelection()->DisableAllArrays();
    for (const char* name : { "AreaDistortion", "FaceIndex", "Position", "Quantity" })
    {
      this->Maps->GetMapSelection()->EnableArray(name);
    }
    this->Control->SetInputConnection(0, this->Maps->GetOutputPort());
    this->Control->SetInputDataObject(1, this->Builder.Result.charts);
    this->Control->SetImportanceToArray();
    this->Control->SetImportanceArrayName("Quantity");
    this->Control->SetMinimumDensity(0.);
    this->Control->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Control->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  }

  /// The importance at (x, y) of the square; on a seam, of the chart on the given side.
  double at(double x, double y, bool right = false)
  {
    const int ci = x > 0.5 || (x == 0.5 && right) ? 1 : 0;
    const int cj = y > 0.5 ? 1 : 0;
    auto* image = vtkImageData::SafeDownCast(
      this->Control->GetOutput()->GetPartition(static_cast<unsigned int>(2 * cj + ci), 0));
    const int* size = image->GetDimensions();
    const int i = std::clamp(static_cast<int>((2. * x - ci) * size[0]), 0, size[0] - 1);
    const int j = std::clamp(static_cast<int>((2. * y - cj) * size[1]), 0, size[1] - 1);
    const vtkIdType pixel = static_cast<vtkIdType>(j) * size[0] + i;
    vtkPointData* data = image->GetPointData();
    return data->GetArray("Control")->GetComponent(pixel, 0) /
      data->GetArray("AreaDistortion")->GetComponent(pixel, 0);
  }
  /// The largest step across the seam x = 1/2, which is half a hundredth wide (two half pixels).
  double largestStep()
  {
    double largest = 0;
    for (int i = 0; i < 200; ++i)
    {
      const double y = (i + 0.5) / 200.;
      largest = std::max(largest, std::abs(this->at(0.5, y, true) - this->at(0.5, y, false)));
    }
    return largest;
  }
  bool update()
  {
    this->Errors->Clear();
    this->Control->Update();
    if (this->Errors->GetError())
    {
      std::cerr << this->Errors->GetErrorMessage();
    }
    return !this->Errors->GetError();
  }

  synthetic::Builder Builder;
  vtkNew<vtkGeometryMapRenderer> Maps;
  vtkNew<vtkControlMap> Control;
  vtkNew<vtkTest::ErrorObserver> Errors;
};

bool near(double value, double expected, double tolerance, const std::string& what)
{
  const bool good = std::abs(value - expected) <= tolerance;
  check(good, what + ": " + std::to_string(value) + " for " + std::to_string(expected));
  return good;
}

void testGradation()
{
  // A step in the left charts, close to the seam.
  Pipeline p([](double x, double) { return x < 0.45 ? 0.1 : 1.; });
  check(p.update() && p.largestStep() < 1e-3, "a constant beside the seam");
  const double percent = 5.;
  const double sigma = 0.01 * percent * std::sqrt(2.);
  p.Control->SetGradation(percent);
  check(p.update(), "gradation");
  for (double x : { 0.3, 0.4, 0.44, 0.49, 0.51, 0.53, 0.6, 0.7 })
  {
    const double middle = 0.5 * (0.45 + 0.45 - 0.5 / GridSize); // the map is linear over a square
    const double expected = 0.1 + 0.9 * 0.5 * std::erfc((middle - x) / sigma / std::sqrt(2.));
    near(p.at(x, 0.3), expected, 0.03, "the step is the error function at " + std::to_string(x));
  }
  // The slope at the seam, times the distance of the pixels' centres, and little more.
  const double slope = 0.9 / sigma / std::sqrt(2. * synthetic::Pi);
  check(p.largestStep() < 1.2 * slope * 0.005,
    "no step at the seam: " + std::to_string(p.largestStep()));
  p.Control->SetGradation(2. * percent);
  check(p.update(), "another size");
  check(p.at(0.3, 0.3) > 0.16 && p.at(0.6, 0.3) < 0.97, "is wider");
}

void testBandPass()
{
  // A wide slope, and on it narrow ripples in the upper half: the band keeps the ripples.
  const auto ripple = [](double x, double y) {
    return y > 0.5 ? 0.1 * std::sin(2. * synthetic::Pi * x / 0.1) : 0.;
  };
  Pipeline p([=](double x, double y) { return 0.3 + 0.5 * x + ripple(x, y); });
  p.Control->SetBandPass(0.3, 4.);
  check(p.update(), "band-pass");
  double ripples = 0;
  double slope = 0;
  for (int i = 0; i < 60; ++i)
  {
    const double x = 0.2 + 0.6 * i / 60.;
    ripples = std::max(ripples, p.at(x, 0.8));
    slope = std::max(slope, p.at(x, 0.2));
  }
  check(ripples > 0.8, "what is of the band's size is scaled to one: " + std::to_string(ripples));
  check(slope < 0.1 * ripples, "what is larger is gone: " + std::to_string(slope));
  p.Control->SetBandPass(4., 10.);
  check(p.update(), "a coarser band");
  double coarse = 0;
  for (int i = 0; i < 60; ++i)
  {
    const double x = 0.3 + 0.4 * i / 60.;
    coarse = std::max(coarse, std::abs(p.at(x + 0.05, 0.8) - p.at(x, 0.8)));
  }
  check(coarse < 0.2, "what is finer is gone: " + std::to_string(coarse));
}

void testStrokes()
{
  Pipeline p([](double, double) { return 1.; });
  p.Control->SetImportanceToUniform();
  check(p.Control->AddStroke(0.48, 0.3, 0.1, 0.2, 3.), "a stroke");
  check(p.update(), "painting");
  near(p.at(0.48, 0.3), 4., 0.05, "adds its strength at its centre, which is on the surface");
  near(p.at(0.6, 0.3), 1. + 3. * std::pow(1. - 0.36, 2), 0.1, "fades in the next chart");
  near(p.at(0.7, 0.3), 1., 1e-6, "ends at its radius");
  check(p.largestStep() < 0.12, "no step at the seam: " + std::to_string(p.largestStep()));

  const double before = p.at(0.48, 0.3);
  p.Control->AddStroke(0.48, 0.3, 0., 0.1, -1.);
  check(p.update() && p.at(0.48, 0.3) < 0.05, "erases");
  p.Control->SetMinimumDensity(0.25);
  check(p.update(), "a floor");
  near(p.at(0.48, 0.3), 0.25 * 2.9, 0.25, "the floor is a part of the largest that is left");
  p.Control->SetMinimumDensity(0.);
  p.Control->RemoveLastStroke();
  check(p.update() && p.at(0.48, 0.3) == before, "undone to the bit");

  vtkNew<vtkDoubleArray> saved;
  saved->DeepCopy(p.Control->GetStrokes());
  check(saved->GetNumberOfTuples() == 1 && saved->GetComponent(0, 4) == 3., "strokes as numbers");
  p.Control->RemoveAllStrokes();
  check(p.update() && p.at(0.48, 0.3) == 1., "all gone");
  p.Control->SetStrokes(saved);
  const vtkMTimeType time = p.Control->GetMTime();
  p.Control->SetStrokes(saved);
  check(p.Control->GetMTime() == time, "the same strokes change nothing");
  check(p.update() && p.at(0.48, 0.3) == before, "and back from the numbers");
  p.Control->SetStrokes(nullptr);
  check(p.Control->GetNumberOfStrokes() == 0, "nullptr is none");

  const double bad[][5] = { { 0, 0, 0, -1e-9, 1 }, { 0, 0, 0, -1, 1 }, { 0, 0, 0, 1, -1.01 },
    { std::nan(""), 0, 0, 1, 1 }, { 0, 0, 0, INFINITY, 1 } };
  for (const auto& s : bad)
  {
    p.Errors->Clear();
    check(!p.Control->AddStroke(s[0], s[1], s[2], s[3], s[4]) && p.Errors->GetError() &&
        p.Control->GetNumberOfStrokes() == 0,
      "what is no stroke is refused");
  }
  p.Errors->Clear();
  vtkNew<vtkDoubleArray> four;
  four->SetNumberOfComponents(4);
  four->InsertNextTuple4(0, 0, 0, 1);
  p.Control->SetStrokes(four);
  check(p.Errors->GetError() && p.Control->GetNumberOfStrokes() == 0, "nor arrays of other shapes");

  p.Control->AddStroke(0.5, 0.5, 0., 5., -1.);
  p.Control->AddStroke(0.1, 0.1, 0., 0.05, 0.5);
  check(p.update(), "strokes over each other");
  near(p.at(0.1, 0.1), 0.5, 0.05, "in their order");
}

void testSizePlaces()
{
  vtkNew<vtkControlMap> control;
  vtkNew<vtkTest::ErrorObserver> errors;
  control->AddObserver(vtkCommand::ErrorEvent, errors);
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(4);
  places->InsertNextTuple4(1., 2., 3., 0.5);
  control->SetSizePlaces(places);
  check(control->GetSizePlaces()->GetNumberOfTuples() == 1 &&
      control->GetSizePlaces()->GetComponent(0, 3) == 0.5,
    "places of sizes as numbers");
  const vtkMTimeType time = control->GetMTime();
  control->SetSizePlaces(places);
  check(control->GetMTime() == time, "the same places change nothing");
  for (const double length : { 0., -1., std::nan(""), static_cast<double>(INFINITY) })
  {
    errors->Clear();
    places->SetComponent(0, 3, length);
    control->SetSizePlaces(places);
    check(errors->GetError() && control->GetSizePlaces()->GetComponent(0, 3) == 0.5,
      "what is no length is refused");
  }
  vtkNew<vtkDoubleArray> three;
  three->SetNumberOfComponents(3);
  three->InsertNextTuple3(1., 2., 3.);
  errors->Clear();
  control->SetSizePlaces(three);
  check(errors->GetError() && control->GetMTime() == time, "nor are arrays of other shapes taken");
  control->SetSizePlaces(nullptr);
  check(control->GetSizePlaces()->GetNumberOfTuples() == 0 && control->GetMTime() > time,
    "nullptr is none");
}

void testGammaKeepsWhatItCan()
{
  // The quantity's map is gone: a new gamma must not ask for it again, a new importance must.
  Pipeline p([](double x, double) { return 0.2 + 0.8 * x; });
  check(p.update(), "first");
  const double one = p.at(0.2, 0.2) / p.at(0.8, 0.2);
  for (unsigned int c = 0; c < 4; ++c)
  {
    auto* image = vtkImageData::SafeDownCast(p.Maps->GetOutput()->GetPartition(c, 0));
    auto* array = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("Quantity"));
    array->FillValue(1.f); // behind the pipeline's back
  }
  p.Control->SetGamma(2.);
  check(p.update(), "gamma");
  near(p.at(0.2, 0.2) / p.at(0.8, 0.2), one * one, 1e-3, "the quantity of before, squared");
  p.Control->SetImportanceToUniform();
  p.update();
  p.Control->SetImportanceToArray();
  p.Control->SetImportanceArrayName("Position");
  check(p.update(), "another quantity");
  check(std::abs(p.at(0.2, 0.2) - std::pow(std::hypot(0.2, 0.2) / std::hypot(1., 1.), 2)) < 0.02,
    "is read");
}

void testProjection()
{
  // Brightness rises from 1 to 3 along the picture's x and by 4 along its y.
  Pipeline p([](double, double) { return 1.; });
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(2, 2, 1);
  picture->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < 4; ++i)
  {
    picture->SetScalarComponentFromDouble(i % 2, i / 2, 0, 0, 1. + 2. * (i % 2) + 4. * (i / 2));
  }
  p.Control->SetImportanceToImage();
  p.Control->SetImportanceImage(picture);
  check(p.update(), "pasted");
  near(p.at(0.1, 0.1), p.at(0.6, 0.1), 1e-3, "every chart has the whole picture");
  p.Control->SetImageProjectionToZAxis();
  check(p.update(), "projected along z");
  const auto expected = [](double x, double y) {
    const auto t = [](double s) { return std::clamp(2. * s - 0.5, 0., 1.); };
    return (1. + 2. * t(x) + 4. * t(y)) / 7.;
  };
  for (double x : { 0.1, 0.4, 0.6, 0.9 })
  {
    for (double y : { 0.1, 0.45, 0.7 })
    {
      near(p.at(x, y), expected(x, y), 0.01, "over all charts");
    }
  }
  check(p.largestStep() < 0.01, "no step at the seam");
  p.Control->SetImageProjectionToYAxis(); // the square has no height: the middle of the picture
  check(p.update(), "projected along y");
  near(p.at(0.9, 0.2) / p.at(0.1, 0.7), 5. / 3., 0.02, "x across");
  p.Control->SetImageProjectionToXAxis();
  check(p.update(), "projected along x");
  near(p.at(0.9, 0.8) / p.at(0.4, 0.1), 5. / 3., 0.02, "y across");

  p.Maps->GetMapSelection()->DisableArray("Position");
  check(!p.update() && p.Errors->GetErrorMessage().find("Position") != std::string::npos,
    "a projection names the map that it lacks");
}

void testFaceIndexOfOtherCharts()
{
  Pipeline p([](double, double) { return 1.; });
  p.Control->AddStroke(0.5, 0.5, 0., 0.1, 1.);
  p.Maps->GetMapSelection()->DisableArray("FaceIndex");
  check(!p.update() && p.Errors->GetErrorMessage().find("FaceIndex") != std::string::npos,
    "painting names the map that it lacks");
  p.Maps->GetMapSelection()->EnableArray("FaceIndex");
  synthetic::Builder other;
  synthetic::bumpyGrid(other, 2, 3);
  other.finish();
  p.Control->SetInputDataObject(1, other.Result.charts);
  check(!p.update() && p.Errors->GetErrorMessage().find("same atlas") != std::string::npos,
    "charts of another atlas");
  synthetic::Builder one;
  synthetic::torus(one, 8, 6);
  one.finish();
  p.Control->SetInputDataObject(1, one.Result.charts);
  check(!p.update() && p.Errors->GetErrorMessage().find("port 1") != std::string::npos,
    "another number of charts");
}
}

int TestControlMapSurface(int, char*[])
{
  testGradation();
  testBandPass();
  testStrokes();
  testSizePlaces();
  testGammaKeepsWhatItCan();
  testProjection();
  testFaceIndexOfOtherCharts();
  return test::exitStatus();
}
