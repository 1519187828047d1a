// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPGeometryRemesher on one rank: what is promised of every mesh, and of borders of blocks.
#include "BlockMeshes.h"
#include "MeshCheck.h"
#include "PolyDataConversion.h"
#include "Shapes.h"
#include "SurfaceRepair.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkIntArray.h"
#include "vtkPGeometryRemesher.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <map>

using namespace stipple;

namespace
{
void keepError(vtkObject*, unsigned long, void* text, void* said)
{
  *static_cast<std::string*>(text) += static_cast<const char*>(said);
}

struct Remeshing
{
  vtkNew<vtkPGeometryRemesher> filter;
  TriangleSurface mesh;
  std::string error;

  Remeshing(vtkDataObject* input, int points, int triangles)
  {
    this->filter->SetInputDataObject(input);
    this->filter->SetNumberOfPoints(points);
    this->filter->SetTrianglesPerBlock(triangles);
  }
  vtkPartitionedDataSet* output()
  {
    return vtkPartitionedDataSet::SafeDownCast(this->filter->GetOutputDataObject(0));
  }
  vtkPolyData* borders() { return vtkPolyData::SafeDownCast(this->filter->GetOutputDataObject(1)); }
  /// Whether there is a mesh of so many points that may be handed to a user.
  testing::AssertionResult update(vtkPolyData* surface)
  {
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(keepError);
    observer->SetClientData(&this->error);
    this->filter->AddObserver(vtkCommand::ErrorEvent, observer);
    this->filter->Update();
    if (!this->error.empty())
    {
      return testing::AssertionFailure() << this->error;
    }
    const std::string wrong = test::joinBlocks(this->output(), this->mesh);
    if (!wrong.empty())
    {
      return testing::AssertionFailure() << wrong;
    }
    if (this->mesh.numberOfVertices() != this->filter->GetNumberOfPoints())
    {
      return testing::AssertionFailure() << this->mesh.numberOfVertices() << " points";
    }
    RepairedSurface reference;
    Status status = repairSurface(surface, reference);
    if (status.ok())
    {
      status = checkMesh(this->mesh, reference.surface, reference.surface.topology(), {});
    }
    return status.ok() ? testing::AssertionSuccess()
                       : testing::AssertionFailure() << status.message();
  }
};

vtkSmartPointer<vtkPolyData> data(const TriangleSurface& surface)
{
  return shapes::toPolyData(surface);
}

struct Shape
{
  const char* name;
  TriangleSurface surface;
  int points;
  int triangles;
};

std::vector<Shape> allShapes()
{
  return { { "sphere", shapes::sphere(1., 5), 1500, 4000 },
    { "torus", shapes::torus(2., 0.7, 120, 60), 2000, 3000 },
    { "cube", shapes::cube(24), 1500, 1500 }, { "open grid", shapes::grid(60, 0.3), 900, 1500 },
    { "perforated slab", shapes::perforatedSlab(3, 2, 6), 1200, 400 } };
}
}

TEST(PGeometryRemesher, meshesOfBlocksAreWhatMeshesArePromisedToBe)
{
  for (const Shape& shape : allShapes())
  {
    const auto input = data(shape.surface);
    Remeshing run(input, shape.points, shape.triangles);
    EXPECT_TRUE(run.update(input)) << shape.name;
    EXPECT_GT(run.filter->GetNumberOfBlocks(), 2) << shape.name;
    EXPECT_GT(run.filter->GetNumberOfBorderPoints(), 10) << shape.name;
  }
}

TEST(PGeometryRemesher, bordersCannotBeTold)
{
  for (const Shape& shape : { allShapes()[0], allShapes()[1] })
  {
    const auto input = data(shape.surface);
    Remeshing run(input, 4000, shape.triangles);
    ASSERT_TRUE(run.update(input)) << shape.name;
    const test::BorderFigures f = test::measureBorders(run.mesh, run.borders());
    EXPECT_GT(f.trianglesNear, 300) << shape.name;
    EXPECT_NEAR(f.lengthNear / f.lengthElse, 1., 0.03) << shape.name;
    EXPECT_GT(f.qualityNear, f.qualityElse - 0.01) << shape.name;
    EXPECT_GT(f.smallestAngle, 25.) << shape.name;
  }
}

TEST(PGeometryRemesher, creasesAcrossBlocksAreKept)
{
  const auto input = data(shapes::cube(24)); // from 0 to 1
  Remeshing run(input, 2000, 1200);
  ASSERT_TRUE(run.update(input));
  // Each of the 12 edges of the cube is edges of the mesh, end to end.
  double length = 0;
  for (const Halfedge h : run.mesh.halfedges())
  {
    const Vec3& x = run.mesh.point(run.mesh.tail(h));
    const Vec3& y = run.mesh.point(run.mesh.head(h));
    int sides = 0;
    for (int k = 0; k < 3; ++k)
    {
      const bool isOn = (std::abs(x[k]) < 1e-9 && std::abs(y[k]) < 1e-9) ||
        (std::abs(x[k] - 1.) < 1e-9 && std::abs(y[k] - 1.) < 1e-9);
      sides += isOn ? 1 : 0;
    }
    length += sides == 2 ? 0.5 * run.mesh.edgeLength(h) : 0.;
  }
  EXPECT_NEAR(length, 12., 1e-6);
}

TEST(PGeometryRemesher, regionsAcrossBlocksAreKept)
{
  const auto input = data(shapes::sphere(1., 5));
  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  const TriangleSurface surface = fromPolyData(input);
  for (const Face f : surface.faces())
  {
    region->InsertNextValue(surface.position(f, Vec3::Constant(1. / 3.)).z() > 0.3 ? 7 : 3);
  }
  input->GetCellData()->AddArray(region);
  Remeshing run(input, 2500, 4000);
  run.filter->GetRemesher()->GetAtlas()->SetRegionArrayName("Region");
  ASSERT_TRUE(run.update(input));
  // Where two regions meet, the mesh has an edge, near the plane between them.
  int wrong = 0;
  int cells = 0;
  for (unsigned int b = 0; b < run.output()->GetNumberOfPartitions(); ++b)
  {
    auto* block = vtkPolyData::SafeDownCast(run.output()->GetPartitionAsDataObject(b));
    if (!block)
    {
      continue;
    }
    vtkDataArray* labels = block->GetCellData()->GetArray("Region");
    ASSERT_NE(labels, nullptr);
    const TriangleSurface part = fromPolyData(block);
    for (const Face f : part.faces())
    {
      const bool isAbove = labels->GetComponent(f.index(), 0) == 7.;
      for (int k = 0; k < 3; ++k)
      {
        const double z = part.point(f, k).z();
        wrong += isAbove ? z < 0.24 : z > 0.36; // an edge of the input is .06 long
      }
      ++cells;
    }
  }
  EXPECT_EQ(cells, run.mesh.numberOfFaces());
  EXPECT_EQ(wrong, 0);
}

TEST(PGeometryRemesher, arraysComeAlong)
{
  const auto input = data(shapes::torus(2., 0.7, 120, 60));
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    height->InsertNextValue(input->GetPoint(p)[2]);
  }
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    number->InsertNextValue(static_cast<int>(c));
  }
  input->GetPointData()->AddArray(height);
  input->GetCellData()->AddArray(number);
  Remeshing run(input, 2000, 3000);
  ASSERT_TRUE(run.update(input));
  const TriangleSurface surface = fromPolyData(input);
  for (unsigned int b = 0; b < run.output()->GetNumberOfPartitions(); ++b)
  {
    auto* block = vtkPolyData::SafeDownCast(run.output()->GetPartitionAsDataObject(b));
    if (!block)
    {
      continue;
    }
    vtkDataArray* z = block->GetPointData()->GetArray("Height");
    vtkDataArray* source = block->GetPointData()->GetArray("SourceCellId");
    ASSERT_NE(z, nullptr);
    ASSERT_NE(source, nullptr);
    for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
    {
      Vec3 x;
      block->GetPoint(p, x.data());
      ASSERT_NEAR(z->GetComponent(p, 0), x.z(), 1e-6);
      const Face f(static_cast<int>(source->GetComponent(p, 0)));
      const Vec3 centre = surface.position(f, Vec3::Constant(1. / 3.));
      ASSERT_LT((centre - x).norm(), 0.12); // a triangle is .16 long
    }
    vtkDataArray* cell = block->GetCellData()->GetArray("Number");
    ASSERT_NE(cell, nullptr);
    EXPECT_GE(cell->GetRange()[0], 0.);
    EXPECT_LT(cell->GetRange()[1], surface.numberOfFaces());
  }
}

TEST(PGeometryRemesher, densityOfAnArrayIsFollowedAcrossBlocks)
{
  const auto input = data(shapes::grid(80));
  vtkNew<vtkDoubleArray> weight;
  weight->SetName("Weight");
  double bounds[6];
  input->GetBounds(bounds);
  const double middle = 0.5 * (bounds[0] + bounds[1]);
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    weight->InsertNextValue(
      1. + 3. * (input->GetPoint(p)[0] - bounds[0]) / (bounds[1] - bounds[0]));
  }
  input->GetPointData()->AddArray(weight);
  Remeshing run(input, 2500, 3000);
  run.filter->GetRemesher()->SetImportanceToArray();
  run.filter->GetRemesher()->SetImportanceArrayName("Weight");
  ASSERT_TRUE(run.update(input));
  int left = 0;
  for (const Vec3& x : run.mesh.points)
  {
    left += x.x() < middle ? 1 : 0;
  }
  // The integrals of 1 + 3 x over the two halves: 0.875 to 1.625.
  EXPECT_NEAR(left / 2500., 0.35, 0.03);
}

TEST(PGeometryRemesher, oneBlockIsThePlainRemesher)
{
  const auto input = data(shapes::torus(2., 0.7, 60, 30));
  Remeshing run(input, 700, 1000000);
  ASSERT_TRUE(run.update(input));
  EXPECT_EQ(run.filter->GetNumberOfBlocks(), 1);
  vtkNew<vtkGeometryRemesher> plain;
  plain->GetMapRenderer()->SetBackendToCPU();
  plain->SetInputData(input);
  plain->SetNumberOfPoints(700);
  plain->Update();
  const TriangleSurface mesh = fromPolyData(plain->GetOutput());
  EXPECT_EQ(mesh.points, run.mesh.points);
}

TEST(PGeometryRemesher, piecesAreOneSurface)
{
  const auto whole = data(shapes::sphere(1., 4));
  const TriangleSurface surface = fromPolyData(whole);
  vtkNew<vtkPartitionedDataSet> pieces;
  for (int piece = 0; piece < 3; ++piece)
  {
    TriangleSurface part;
    std::map<int, int> newId;
    for (const Face f : surface.faces())
    {
      if (f.index() * 3 / surface.numberOfFaces() != piece)
      {
        continue;
      }
      Triangle t = surface.triangle(f);
      for (int& p : t)
      {
        const auto [found, isNew] = newId.try_emplace(p, part.numberOfVertices());
        if (isNew)
        {
          part.points.push_back(surface.points[p]);
        }
        p = found->second;
      }
      part.triangles.push_back(t);
    }
    pieces->SetPartition(static_cast<unsigned int>(piece), data(part));
  }
  Remeshing run(pieces, 900, 1500);
  EXPECT_TRUE(run.update(whole)); // closed
}

TEST(PGeometryRemesher, whatFailsIsOneSentence)
{
  const auto input = data(shapes::sphere(1., 5));
  Remeshing few(input, 8, 4000);
  EXPECT_FALSE(few.update(input));
  EXPECT_EQ(
    few.filter->GetErrorCode(), static_cast<unsigned long>(vtkGeometryRemesher::TOO_FEW_POINTS));
  EXPECT_NE(few.error.find("has no mesh of 8 points"), std::string::npos) << few.error;
  ASSERT_EQ(few.output()->GetNumberOfPartitions(), 0U);

  Remeshing importance(input, 1000, 4000);
  importance.filter->GetRemesher()->SetImportanceToMean();
  EXPECT_FALSE(importance.update(input));
  EXPECT_NE(importance.error.find("importance over blocks"), std::string::npos);

  const auto broken = data(shapes::sphere(1., 5));
  broken->GetPoints()->SetPoint(17, std::nan(""), 0., 0.);
  Remeshing infinite(broken, 1000, 4000);
  EXPECT_FALSE(infinite.update(broken));
  EXPECT_NE(infinite.error.find("Point 17 of piece 0 is not finite"), std::string::npos)
    << infinite.error;
}

TEST(PGeometryRemesher, oneBlockIsStoppedAmidItsRemeshing)
{
  const auto input = data(shapes::sphere(1., 5));
  Remeshing run(input, 3000, 100000);
  std::vector<double> told;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&told);
  stop->SetCallback([](vtkObject* filter, unsigned long, void* fractions, void* fraction) {
    auto& list = *static_cast<std::vector<double>*>(fractions);
    list.push_back(*static_cast<double*>(fraction));
    if (list.back() > 0.3)
    {
      vtkAlgorithm::SafeDownCast(filter)->SetAbortExecute(1);
    }
  });
  const unsigned long tag = run.filter->AddObserver(vtkCommand::ProgressEvent, stop);
  run.filter->Update();
  EXPECT_EQ(run.filter->GetErrorCode(), static_cast<unsigned long>(vtkGeometryRemesher::ABORTED));
  EXPECT_EQ(run.output()->GetNumberOfPartitions(), 0U);
  EXPECT_GT(told.size(), 2U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LT(told.back(), 0.8); // the remeshing was not done
  run.filter->RemoveObserver(tag);
  run.filter->Modified();
  EXPECT_TRUE(run.update(input)); // and goes on as if nothing had been
}

TEST(PGeometryRemesher, anEmptyInputIsAnEmptyOutput)
{
  vtkNew<vtkPolyData> empty;
  Remeshing run(empty, 100, 1000);
  run.filter->Update();
  EXPECT_EQ(run.filter->GetErrorCode(), 0U);
  EXPECT_EQ(run.output()->GetNumberOfPartitions(), 0U);
}

TEST(PGeometryRemesher, parametersOfTheRemesherAreAsTheyWere)
{
  const auto input = data(shapes::sphere(1., 4));
  Remeshing run(input, 600, 1500);
  vtkGeometryRemesher* remesher = run.filter->GetRemesher();
  remesher->SetFeatureAngle(33.);
  remesher->SetNumberOfPoints(17);
  ASSERT_TRUE(run.update(input));
  EXPECT_EQ(remesher->GetFeatureAngle(), 33.);
  EXPECT_EQ(remesher->GetNumberOfPoints(), 17);
  EXPECT_EQ(remesher->GetAtlas()->GetFixedEdges(), nullptr);
  EXPECT_EQ(remesher->GetAtlas()->GetSharpEdges(), nullptr);
}
