// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Seams vanish (paper 4.3, Figure 10): edge lengths, shapes and valences within an edge of the
// seams of many charts are those of the rest of the mesh.
#include "Check.h"
#include "Geometry.h"
#include "PolyDataConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStaticPointLocator.h"

#include <cmath>
#include <iostream>
#include <string>

namespace
{
using namespace stipple;
using test::check;

/// A closed surface with bumps, without features.
vtkSmartPointer<vtkPolyData> potato()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(160);
  sphere->SetPhiResolution(100);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(sphere->GetOutput());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Vec3 p;
    surface->GetPoint(i, p.data());
    p *= 2.;
    p *= 1. + 0.15 * std::sin(4. * p.x()) * std::cos(3. * p.y()) + 0.1 * std::sin(5. * p.z());
    p.z() *= 1.5;
    surface->GetPoints()->SetPoint(i, p.data());
  }
  surface->GetPointData()->Initialize();
  return surface;
}

/// The points of the seams, and points between them no farther apart than `step`.
vtkSmartPointer<vtkPolyData> seamPoints(vtkPolyData* featureGraph, double step)
{
  vtkNew<vtkPoints> points;
  vtkDataArray* type = featureGraph->GetCellData()->GetArray("BackboneType");
  const vtkIdType vertices = featureGraph->GetNumberOfVerts();
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType l = 0; l < featureGraph->GetNumberOfLines(); ++l)
  {
    featureGraph->GetLines()->GetCellAtId(l, size, ids);
    for (vtkIdType k = 1; k < size && type->GetTuple1(vertices + l) == 2; ++k)
    {
      Vec3 a;
      Vec3 b;
      featureGraph->GetPoint(ids[k - 1], a.data());
      featureGraph->GetPoint(ids[k], b.data());
      const int pieces = 1 + static_cast<int>((b - a).norm() / step);
      for (int i = 0; i <= pieces; ++i)
      {
        const Vec3 p = a + static_cast<double>(i) / pieces * (b - a);
        points->InsertNextPoint(p.data());
      }
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  return result;
}

/// Means far from seams [0] and near them [1].
struct Means
{
  double sum[2] = { 0, 0 };
  int count[2] = { 0, 0 };
  void add(bool near, double x)
  {
    this->sum[near] += x;
    ++this->count[near];
  }
  void compare(const std::string& what) const
  {
    check(this->count[0] > 300 && this->count[1] > 300, what + ": enough on both sides");
    const double far = this->sum[0] / this->count[0];
    const double near = this->sum[1] / this->count[1];
    std::cout << what << ": " << far << " far from seams, " << near << " near them\n";
    check(std::abs(near - far) < 0.03 * far, what + ": the same near seams");
  }
};
}

int TestSeams(int, char*[])
{
  for (const int charts : { 3, 15 })
  {
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(potato());
    remesher->SetFeatureAngle(180.);
    remesher->SetNumberOfCharts(charts);
    remesher->SetNumberOfPoints(5000);
    remesher->Update();
    check(remesher->GetOutput()->GetNumberOfPoints() == 5000, "as many points as asked for");
    TriangleSurface mesh = fromPolyData(remesher->GetOutput());
    mesh.connect();
    const double edge =
      std::sqrt(mesh.area() / mesh.numberOfFaces() * 4. / std::sqrt(3.)); // were all equilateral
    const auto seams =
      seamPoints(vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(3)), 0.1 * edge);
    check(seams->GetNumberOfPoints() > 0, "there are seams");
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(seams);
    locator->BuildLocator();
    const auto isNear = [&](const Vec3& p) {
      double squared = 0;
      return locator->FindClosestPointWithinRadius(edge, p.data(), squared) >= 0;
    };
    const std::string name = std::to_string(charts) + " charts, ";
    Means length;
    Means quality;
    Means degree;
    std::vector<int> valence(mesh.points.size(), 0);
    for (int f = 0; f < mesh.numberOfFaces(); ++f)
    {
      double longest = 0;
      double perimeter = 0;
      for (int h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Vec3& p = mesh.points[mesh.tail(h)];
        const Vec3& q = mesh.points[mesh.head(h)];
        length.add(isNear(0.5 * (p + q)), (q - p).norm());
        longest = std::max(longest, (q - p).norm());
        perimeter += (q - p).norm();
        ++valence[mesh.tail(h)];
      }
      quality.add(isNear((mesh.point(f, 0) + mesh.point(f, 1) + mesh.point(f, 2)) / 3.),
        12. / std::sqrt(3.) * mesh.faceArea(f) / (perimeter * longest));
    }
    for (std::size_t v = 0; v < valence.size(); ++v)
    {
      degree.add(isNear(mesh.points[v]), valence[v]);
    }
    length.compare(name + "edge length");
    quality.compare(name + "Q");
    degree.compare(name + "valence");
  }
  return test::exitStatus();
}
