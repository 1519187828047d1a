// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A part of a surface is remeshed, the rest stays.
#include "SelectedPart.h"

#include "PolyDataConversion.h"
#include "Shapes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

using namespace stipple;

namespace
{
/// A surface with "Select" by the triangles' centroids, and an array on its points.
vtkSmartPointer<vtkPolyData> selectable(
  const TriangleSurface& surface, const std::function<bool(const Vec3&)>& isSelected)
{
  auto data = shapes::toPolyData(surface);
  vtkNew<vtkIntArray> select;
  select->SetName("Select");
  for (const Triangle& t : surface.triangles)
  {
    const Vec3 c = (surface.points[t[0]] + surface.points[t[1]] + surface.points[t[2]]) / 3.;
    select->InsertNextValue(isSelected(c) ? 1 : 0);
  }
  data->GetCellData()->AddArray(select);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Height");
  for (const Vec3& p : surface.points)
  {
    heights->InsertNextValue(static_cast<float>(p.z()));
  }
  data->GetPointData()->AddArray(heights);
  return data;
}

int numberSelected(vtkPolyData* data)
{
  vtkDataArray* select = data->GetCellData()->GetArray("Select");
  int count = 0;
  for (vtkIdType f = 0; f < select->GetNumberOfTuples(); ++f)
  {
    count += select->GetComponent(f, 0) != 0. ? 1 : 0;
  }
  return count;
}
}

TEST(SelectedPart, TakesApartAndJoinsWhatItTook)
{
  const auto input = selectable(shapes::cube(4), [](const Vec3& x) { return x.z() > 0.99; });
  SelectedPart part;
  ASSERT_TRUE(part.split(input, "Select").ok());
  EXPECT_EQ(part.part()->GetNumberOfPolys(), 32);
  EXPECT_EQ(part.borderEdges()->GetNumberOfTuples(), 16);
  EXPECT_EQ(part.numberOfBorderPoints(), 16);

  vtkNew<vtkPolyData> lines;
  vtkNew<vtkPolyData> result;
  ASSERT_TRUE(part.join(part.part(), lines, result).ok());
  EXPECT_EQ(result->GetNumberOfPolys(), input->GetNumberOfPolys());
  TriangleSurface joined = fromPolyData(result);
  EXPECT_EQ(numberSelected(result), 32);

  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(part.join(nothing, lines, result).code(), StatusCode::Internal);
}

TEST(SelectedPart, SaysWhatCannotBeSelected)
{
  const auto input = selectable(shapes::cube(2), [](const Vec3&) { return false; });
  SelectedPart part;
  EXPECT_NE(part.split(input, "Select").message().find("no cell is selected"), std::string::npos);
  EXPECT_NE(part.split(input, "Other").message().find("no cell array 'Other'"), std::string::npos);
}

TEST(SelectedPart, TheRestStaysAndTheMeshFits)
{
  const struct
  {
    const char* name;
    TriangleSurface surface;
    std::function<bool(const Vec3&)> isSelected;
    int points;
  } models[] = {
    { "torus", shapes::torus(2, 1, 48, 24), [](const Vec3& x) { return x.x() > 0.3; }, 700 },
    { "sphere", shapes::sphere(1, 4), [](const Vec3& x) { return x.z() < 0.1; }, 400 },
    { "cube", shapes::cube(8), [](const Vec3& x) { return x.x() + x.y() + x.z() > 1.2; }, 500 },
    { "slab", shapes::perforatedSlab(2, 1, 4), [](const Vec3& x) { return x.x() < 2.2; }, 900 },
    { "saddle", shapes::saddle(20), [](const Vec3& x) { return x.norm() < 0.6; }, 300 },
    // Its parts touch in points only, at which the mesh of them has several vertices.
    { "checkered cube", shapes::cube(8),
      [](const Vec3& x) { return std::lround((4. * x).array().floor().sum()) % 2 == 0; }, 600 },
  };
  for (const auto& model : models)
  {
    SCOPED_TRACE(model.name);
    const auto input = selectable(model.surface, model.isSelected);
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(input);
    remesher->SetNumberOfPoints(model.points);
    remesher->SetSelectionArrayName("Select");
    remesher->Update();
    vtkPolyData* mesh = remesher->GetOutput();
    ASSERT_GT(mesh->GetNumberOfPoints(), 0);

    // The rest: the same triangles of the same points, bit for bit, in the same order.
    const TriangleSurface before = fromPolyData(input);
    TriangleSurface after = fromPolyData(mesh);
    std::size_t f = 0;
    std::set<int> rest;
    for (int g = 0; g < before.numberOfFaces(); ++g)
    {
      const Triangle& t = before.triangles[g];
      const Vec3 c = (before.points[t[0]] + before.points[t[1]] + before.points[t[2]]) / 3.;
      if (!model.isSelected(c))
      {
        for (int k = 0; k < 3; ++k)
        {
          ASSERT_EQ(after.points[after.triangles[f][k]], before.points[t[k]]);
          rest.insert(t[k]);
        }
        ++f;
      }
    }
    EXPECT_EQ(mesh->GetNumberOfPoints(), static_cast<vtkIdType>(rest.size()) + model.points);

    // No gap, and the topology.
    TriangleSurface whole = before;
    whole.connect();
    after.connect();
    EXPECT_TRUE(after.topology() == whole.topology());

    // Arrays and provenance.
    vtkDataArray* heights = mesh->GetPointData()->GetArray("Height");
    vtkDataArray* kind = mesh->GetPointData()->GetArray("SampleKind");
    vtkDataArray* source = mesh->GetPointData()->GetArray("SourceCellId");
    vtkDataArray* select = input->GetCellData()->GetArray("Select");
    ASSERT_TRUE(heights && kind && source);
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      EXPECT_NEAR(heights->GetComponent(p, 0), after.points[p].z(), 0.01);
      const bool isRest = p < static_cast<vtkIdType>(rest.size());
      EXPECT_EQ(kind->GetComponent(p, 0) < 0, isRest);
      if (!isRest)
      {
        EXPECT_NE(select->GetComponent(static_cast<vtkIdType>(source->GetComponent(p, 0)), 0), 0.);
      }
    }
    EXPECT_EQ(numberSelected(mesh), mesh->GetNumberOfPolys() - static_cast<vtkIdType>(f));
  }
}

TEST(SelectedPart, TooFewPointsNameThoseThatWork)
{
  const auto input =
    selectable(shapes::perforatedSlab(2, 1, 4), [](const Vec3& x) { return x.x() < 2.2; });
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(input);
  remesher->SetNumberOfPoints(1);
  remesher->SetSelectionArrayName("Select");
  vtkObject::GlobalWarningDisplayOff();
  remesher->Update();
  vtkObject::GlobalWarningDisplayOn();
  ASSERT_EQ(
    remesher->GetErrorCode(), static_cast<unsigned long>(vtkGeometryRemesher::TOO_FEW_POINTS));
  remesher->SetNumberOfPoints(remesher->GetLeastNumberOfPoints());
  remesher->Update();
  EXPECT_GT(remesher->GetOutput()->GetNumberOfPolys(), 0);
}
