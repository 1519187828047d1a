// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The maps keep the contract: the pixel grid, what each map means, that they integrate; they are
// lazy, do not depend on the number of threads, and bad input is one clear sentence.
#include "Check.h"
#include "ImageRegression.h"
#include "MapContactSheet.h"
#include "MapPicture.h"
#include "PolyDataConversion.h"
#include "SyntheticCharts.h"

#include "vtkCommand.h"
#include "vtkDataArraySelection.h"
#include "vtkExecutive.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkSMPTools.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>

namespace
{
using test::check;

vtkImageData* imageOf(vtkGeometryMapRenderer* maps, unsigned int chart)
{
  return vtkImageData::SafeDownCast(maps->GetOutput()->GetPartition(chart, 0));
}

void testMeaning(vtkPartitionedDataSetCollection* atlas)
{
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(atlas);
  maps->SetBackendToCPU();
  maps->SetMapSize(512);
  for (const char* name : { "Position", "Normal", "Heat", "Quad", "Region", "UV" })
  {
    maps->GetMapSelection()->EnableArray(name);
  }
  maps->Update();
  check(maps->GetOutput()->GetNumberOfPartitionedDataSets() == 2, "one image a chart");
  const double extents[2][2] = { { 1., 0.6 }, { 0.5, 1. } };
  for (unsigned int c = 0; c < 2; ++c)
  {
    vtkImageData* image = imageOf(maps, c);
    auto* chart = vtkPolyData::SafeDownCast(atlas->GetPartitionAsDataObject(c, 0));
    const int w = image->GetDimensions()[0];
    const int h = image->GetDimensions()[1];
    check(std::max(w, h) == 512, "the longer side is MapSize");
    const double dx = extents[c][0] / w;
    const double dy = extents[c][1] / h;
    check(std::abs(dx / dy - 1.) < 0.01, "pixels are square");
    check(std::abs(image->GetSpacing()[0] - dx) < 1e-15 &&
        std::abs(image->GetOrigin()[1] - 0.5 * dy) < 1e-15,
      "origin and spacing are the contract's");
    vtkPointData* data = image->GetPointData();
    check(data->GetNumberOfArrays() == 13, "as many arrays as were selected");
    for (const char* name : { "AreaDistortion", "MeanCurvature", "Position", "Heat", "Region" })
    {
      check(data->GetArray(name)->GetDataType() == VTK_FLOAT, std::string(name) + " is float");
    }
    check(data->GetArray("FaceIndex")->GetDataType() == VTK_INT, "FaceIndex is int");

    double sum = 0.;
    double worstUV = 0.;
    double worstPosition = 0.;
    double worstTotal = 0.;
    double worstLow = 0.;
    double worstNormal = 0.;
    bool inside = true;
    for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
    {
      sum += data->GetArray("AreaDistortion")->GetComponent(p, 0) * dx * dy;
      const auto face = static_cast<vtkIdType>(data->GetArray("FaceIndex")->GetComponent(p, 0));
      if (face < 0 || face >= chart->GetNumberOfCells())
      {
        check(false, "every pixel has a face");
        return;
      }
      // The map of the parameter itself is where the pixel is.
      double center[3];
      image->GetPoint(p, center);
      const double* uv = data->GetArray("UV")->GetTuple2(p);
      const stipple::Vec2 q(uv[0], uv[1]);
      worstUV = std::max(worstUV, (q - stipple::Vec2(center[0], center[1])).norm());
      // Position is the point of the face above the pixel's centre; the centre is in the face.
      vtkIdType n = 0;
      const vtkIdType* corner = nullptr;
      chart->GetPolys()->GetCellAtId(face, n, corner);
      stipple::Vec2 t[3];
      stipple::Vec3 x[3];
      for (int k = 0; k < 3; ++k)
      {
        chart->GetPointData()->GetArray("UV")->GetTuple(corner[k], t[k].data());
        chart->GetPoint(corner[k], x[k].data());
      }
      const stipple::Vec3 b = stipple::barycentric({ center[0], center[1] }, t[0], t[1], t[2]);
      inside = inside && b.minCoeff() > -2e-3;
      const stipple::Vec3 wanted = b[0] * x[0] + b[1] * x[1] + b[2] * x[2];
      stipple::Vec3 got;
      data->GetArray("Position")->GetTuple(p, got.data());
      worstPosition = std::max(worstPosition, (got - wanted).norm());
      check(data->GetArray("Region")->GetComponent(p, 0) == face % 7,
        "a cell array is constant on a face");
      const double k1 = data->GetArray("MinimumCurvature")->GetComponent(p, 0);
      const double k2 = data->GetArray("MaximumCurvature")->GetComponent(p, 0);
      const double mean = data->GetArray("MeanCurvature")->GetComponent(p, 0);
      check(
        k1 <= k2 && std::abs(0.5 * (k1 + k2) - mean) < 1e-5, "H is the principal curvatures' mean");
      double wantedLow = 0;
      for (int k = 0; k < 3; ++k)
      {
        const double h =
          chart->GetPointData()->GetArray("MeanCurvature")->GetComponent(corner[k], 0);
        const double g =
          chart->GetPointData()->GetArray("GaussianCurvature")->GetComponent(corner[k], 0);
        wantedLow += b[k] * (h - std::sqrt(std::max(h * h - g, 0.)));
      }
      worstLow = std::max(worstLow, std::abs(k1 - wantedLow));
      worstTotal = std::max(worstTotal,
        std::abs(data->GetArray("TotalCurvature")->GetComponent(p, 0) - k1 * k1 - k2 * k2));
      stipple::Vec3 normal;
      data->GetArray("Normal")->GetTuple(p, normal.data());
      worstNormal = std::max(worstNormal, std::abs(normal.norm() - 1.));
      check(normal.z() > 0.3, "normals point to the side that counterclockwise triangles show");
      if (test::failures > 5)
      {
        return;
      }
    }
    const double area = stipple::fromPolyData(chart).area();
    std::cout << "chart " << c << ": area " << area << ", the map's " << sum << "\n";
    check(std::abs(sum - area) < 0.005 * area, "AreaDistortion integrates to the surface's area");
    check(worstUV < 1e-4, "the parameter's map is the pixels' centres");
    check(worstPosition < 1e-4, "Position is the point of the face");
    check(inside, "the centre lies in the face");
    check(worstLow < 1e-4, "the least curvature is that of the points");
    check(worstTotal < 1e-4, "the principal curvatures' squares");
    check(worstNormal < 1e-5, "normals are unit vectors");
  }
  // Welded along the seam, where the last column of chart 0 meets the first of chart 1.
  vtkImageData* a = imageOf(maps, 0);
  vtkImageData* b = imageOf(maps, 1);
  const int middle0 = a->GetDimensions()[1] / 2;
  const int middle1 = b->GetDimensions()[1] / 2;
  stipple::Vec3 na;
  stipple::Vec3 nb;
  a->GetPointData()->GetArray("Normal")->GetTuple(
    static_cast<vtkIdType>(middle0 + 1) * a->GetDimensions()[0] - 1, na.data());
  b->GetPointData()->GetArray("Normal")->GetTuple(
    static_cast<vtkIdType>(middle1) * b->GetDimensions()[0], nb.data());
  check((na - nb).norm() < 0.03, "normals agree across the seam");
}

void testLaziness(vtkPartitionedDataSetCollection* atlas)
{
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(atlas);
  maps->SetBackendToCPU();
  maps->SetNumberOfSamples(2000);
  maps->Update();
  check(imageOf(maps, 0)->GetPointData()->GetNumberOfArrays() == 7, "seven maps by default");
  check(maps->GetNumberOfRenderedMaps() == 14, "all maps are made at first");
  vtkDataArray* faces = imageOf(maps, 0)->GetPointData()->GetArray("FaceIndex");
  maps->GetMapSelection()->EnableArray("Heat");
  maps->Update();
  check(maps->GetNumberOfRenderedMaps() == 2, "one more map is one more map a chart");
  check(imageOf(maps, 0)->GetPointData()->GetArray("FaceIndex") == faces, "the faces are kept");
  check(imageOf(maps, 0)->GetPointData()->GetArray("Heat") != nullptr, "the new map is there");
  maps->GetMapSelection()->DisableArray("Heat");
  maps->Update();
  check(maps->GetNumberOfRenderedMaps() == 0, "a map less is nothing to make");
  check(imageOf(maps, 0)->GetPointData()->GetArray("Heat") == nullptr, "and it is gone");

  // A few samples more want the same images: the filter is as it was.
  const vtkMTimeType before = maps->GetMTime();
  maps->SetNumberOfSamples(2001);
  check(maps->GetMTime() == before, "the same sizes do not modify the filter");
  const int width = imageOf(maps, 0)->GetDimensions()[0];
  maps->SetNumberOfSamples(20000);
  check(maps->GetMTime() > before, "other sizes do");
  maps->Update();
  check(imageOf(maps, 0)->GetDimensions()[0] > 2 * width, "ten times the samples, a larger map");
  check(maps->GetNumberOfRenderedMaps() == 14, "all of them anew");

  const auto other = synthetic::makeAtlas(20, 20);
  maps->SetInputDataObject(other);
  maps->Update();
  check(maps->GetNumberOfRenderedMaps() == 14, "another atlas, other maps");
}

void testThreads(vtkPartitionedDataSetCollection* atlas)
{
  vtkSmartPointer<vtkPartitionedDataSetCollection> outputs[2];
  for (int k = 0; k < 2; ++k)
  {
    vtkNew<vtkGeometryMapRenderer> maps;
    maps->SetInputDataObject(atlas);
    maps->SetBackendToCPU();
    maps->SetMapSize(300);
    maps->GetMapSelection()->EnableAllArrays();
    const vtkSMPTools::Config threads(k == 0 ? 1 : 4, k == 0 ? "Sequential" : "STDThread", false);
    vtkSMPTools::LocalScope(threads, [&] { maps->Update(); });
    outputs[k] = maps->GetOutput();
  }
  for (unsigned int c = 0; c < 2; ++c)
  {
    auto* a = vtkImageData::SafeDownCast(outputs[0]->GetPartition(c, 0));
    auto* b = vtkImageData::SafeDownCast(outputs[1]->GetPartition(c, 0));
    for (int k = 0; k < a->GetPointData()->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* u = a->GetPointData()->GetArray(k);
      vtkDataArray* v = b->GetPointData()->GetArray(u->GetName());
      check(std::memcmp(u->GetVoidPointer(0), v->GetVoidPointer(0),
              u->GetNumberOfValues() * u->GetDataTypeSize()) == 0,
        std::string(u->GetName()) + ": the same bytes for any number of threads");
    }
  }
}

std::string errorOf(vtkPartitionedDataSetCollection* atlas, const char* map)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->AddObserver(vtkCommand::ErrorEvent, errors);
  maps->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors); // "algorithm returned failure"
  maps->SetBackendToCPU();
  maps->SetInputDataObject(atlas);
  maps->GetMapSelection()->EnableArray(map);
  maps->Update();
  check(maps->GetOutput()->GetNumberOfPartitionedDataSets() == 0, "no output after an error");
  return errors->GetErrorMessage();
}

void testErrors()
{
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  check(contains(errorOf(synthetic::makeAtlas(8, 8), "Cheese"), "no array Cheese on chart 0"),
    "an unknown map is named");
  auto atlas = synthetic::makeAtlas(8, 8);
  vtkPolyData::SafeDownCast(atlas->GetPartitionAsDataObject(1, 0))
    ->GetPointData()
    ->RemoveArray("MeanCurvature");
  check(contains(errorOf(atlas, "TotalCurvature"), "MeanCurvature on chart 1"),
    "a missing curvature is named");
  atlas = synthetic::makeAtlas(8, 8);
  vtkPolyData::SafeDownCast(atlas->GetPartitionAsDataObject(1, 0))
    ->GetFieldData()
    ->RemoveArray("ChartExtent");
  check(contains(errorOf(atlas, "Heat"), "Chart 1"), "a chart without an extent is named");
  atlas = synthetic::makeAtlas(8, 8);
  vtkPolyData::SafeDownCast(atlas->GetPartitionAsDataObject(0, 0))
    ->GetPointData()
    ->GetArray("UV")
    ->SetComponent(11, 0, 1e9);
  check(
    contains(errorOf(atlas, "Heat"), "UV of point 11 of chart 0"), "a point far outside is named");

  vtkNew<vtkPartitionedDataSetCollection> nothing;
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->AddObserver(vtkCommand::ErrorEvent, errors);
  maps->SetInputDataObject(nothing);
  maps->Update();
  check(!errors->GetError() && maps->GetOutput()->GetNumberOfPartitionedDataSets() == 0,
    "no charts, no maps, no error");
}

void testPicture(vtkPartitionedDataSetCollection* atlas, int argc, char* argv[])
{
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputDataObject(atlas);
  maps->SetBackendToCPU();
  maps->SetMapSize(256);
  maps->GetMapSelection()->EnableArray("Position");
  maps->GetMapSelection()->EnableArray("Normal");
  maps->Update();
  stipple::ContactSheetOptions options;
  options.tile = 140;
  const auto sheet = stipple::mapContactSheet(maps->GetOutput(), options);
  check(
    test::comparePicture(sheet, "GeometryMaps", argc, argv), "the contact sheet is the baseline");
  const auto one = stipple::mapPicture(maps->GetOutput(), 1, "AreaDistortion");
  check(one && one->GetDimensions()[0] == 128 && one->GetDimensions()[1] == 256,
    "a map, pixel by pixel");
  check(
    stipple::mapPicture(maps->GetOutput(), 2, "AreaDistortion") == nullptr, "no chart, no picture");
  check(stipple::mapPicture(maps->GetOutput(), 0, "Cheese") == nullptr, "no map, no picture");
}
} // namespace

int TestGeometryMapRenderer(int argc, char* argv[])
{
  const auto atlas = synthetic::makeAtlas();
  testMeaning(atlas);
  testLaziness(atlas);
  testThreads(atlas);
  testErrors();
  testPicture(atlas, argc, argv);
  return test::exitStatus();
}
