// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's Figure 10 in numbers: within one edge of the seams that the charts had, the mesh is
// statistically what it is elsewhere.
#include "AtlasSurface.h"
#include "FeatureGraph.h"
#include "PolyDataConversion.h"
#include "TestModels.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkControlMap.h"
#include "vtkGeometryRemesher.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkImageData.h"
#include "vtkImageShrink3D.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <optional>
#include <set>

using namespace stipple;

namespace
{
struct Model
{
  const char* name;
  int charts;
};

std::ostream& operator<<(std::ostream& os, const Model& model)
{
  return os << model.name;
}

/// Lines in space, and how far a point is from them.
struct Lines
{
  std::vector<std::pair<Vec3, Vec3>> segments;

  double distance(const Vec3& p) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : this->segments)
    {
      least = std::min(least, distanceToSegment(p, a, b));
    }
    return least;
  }
  double length() const
  {
    double sum = 0;
    for (const auto& [a, b] : this->segments)
    {
      sum += (b - a).norm();
    }
    return sum;
  }
};

Lines seamsOf(vtkGeometryRemesher* remesher)
{
  AtlasSurface surface;
  FeatureGraph graph;
  Status status = readAtlas(
    vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2)), surface);
  EXPECT_TRUE(status.ok()) << status.message();
  status =
    readFeatureGraph(vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(3)), surface, graph);
  EXPECT_TRUE(status.ok()) << status.message();
  Lines seams;
  for (const Backbone& b : graph.backbones)
  {
    for (int s = 0; b.type == BackboneType::Seam && s < b.numberOfSegments(); ++s)
    {
      seams.segments.emplace_back(surface.points[b.points[s]], surface.points[b.segmentEnd(s)]);
    }
  }
  return seams;
}

/// Means over what is near the seams ([1]) and over the rest ([0]).
class Means
{
public:
  void add(bool near, double value)
  {
    this->Sum[near] += value;
    ++this->Count[near];
  }
  double near() const { return this->Sum[1] / this->Count[1]; }
  double rest() const { return this->Sum[0] / this->Count[0]; }
  int numberNear() const { return this->Count[1]; }
  int numberOfRest() const { return this->Count[0]; }
  double ratio() const { return this->near() / this->rest(); }

private:
  double Sum[2] = { 0, 0 };
  int Count[2] = { 0, 0 };
};
}

namespace
{
struct Statistics
{
  Means length;
  Means degree;
  Means regular; ///< share of the vertices of valence 6
  Means quality;
};

/// With so many rounds of optimisation, or as many as is the default.
Statistics remesh(const Model& model, std::optional<int> numberOfIterations)
{
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(readModel(model.name));
  remesher->SetNumberOfPoints(5000);
  remesher->SetNumberOfCharts(model.charts);
  if (numberOfIterations)
  {
    remesher->SetNumberOfIterations(*numberOfIterations);
  }
  // Sharp edges are backbones that stay; only seams are looked at.
  remesher->SetFeatureAngle(180.);
  remesher->GetControlMap()->SetGrowth(0.); // edges are shorter on horns, and seams lead there
  remesher->Update();
  TriangleSurface mesh = fromPolyData(remesher->GetOutput());
  mesh.connect();
  EXPECT_EQ(mesh.points.size(), 5000U);
  const Lines seams = seamsOf(remesher);
  EXPECT_FALSE(seams.segments.empty());

  std::set<std::pair<int, int>> edges;
  std::vector<int> valence(mesh.points.size(), 0);
  std::vector<char> onBoundary(mesh.points.size(), 0);
  double mean = 0;
  for (int h = 0; h < 3 * mesh.numberOfFaces(); ++h)
  {
    const int a = mesh.tail(h);
    const int b = mesh.head(h);
    if (edges.insert(std::minmax(a, b)).second)
    {
      ++valence[a];
      ++valence[b];
      mean += (mesh.points[a] - mesh.points[b]).norm();
    }
    if (mesh.twin[h] < 0)
    {
      onBoundary[a] = onBoundary[b] = 1;
    }
  }
  mean /= static_cast<double>(edges.size());
  // Near: the middle of an edge, a vertex, the centroid of a triangle lies less than one mean edge
  // from a seam. Unlike "has a vertex near" that favours neither long edges nor large triangles.
  const auto isNear = [&](const Vec3& p) { return seams.distance(p) < mean; };
  Statistics result;
  auto& [length, degree, regular, quality] = result;
  Means squaredLength;
  for (const auto& [a, b] : edges)
  {
    const Vec3 u = mesh.points[b] - mesh.points[a];
    const bool near = isNear(0.5 * (mesh.points[a] + mesh.points[b]));
    length.add(near, u.norm());
    squaredLength.add(near, u.squaredNorm());
  }
  for (std::size_t v = 0; v < valence.size(); ++v)
  {
    if (!onBoundary[v])
    {
      const bool near = isNear(mesh.points[v]);
      degree.add(near, valence[v]);
      regular.add(near, valence[v] == 6 ? 1. : 0.);
    }
  }
  for (int f = 0; f < mesh.numberOfFaces(); ++f)
  {
    double perimeter = 0;
    double longest = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double edge = (mesh.point(f, k) - mesh.point(f, (k + 1) % 3)).norm();
      perimeter += edge;
      longest = std::max(longest, edge);
    }
    const Vec3 centroid = (mesh.point(f, 0) + mesh.point(f, 1) + mesh.point(f, 2)) / 3.;
    quality.add(
      isNear(centroid), 6. / std::sqrt(3.) * mesh.faceArea(f) / (0.5 * perimeter * longest));
  }
  const auto variation = [](double square, double m) { return std::sqrt(square / (m * m) - 1.); };
  std::cout << model.name << ", " << remesher->GetNumberOfIterations() << " rounds: seams of "
            << seams.length() / mean << " edges, " << degree.numberNear()
            << " vertices near; near / rest: edge length " << length.near() / mean << " / "
            << length.rest() / mean << " of the mean, its variation "
            << variation(squaredLength.near(), length.near()) << " / "
            << variation(squaredLength.rest(), length.rest()) << ", valence " << degree.near()
            << " / " << degree.rest() << ", of valence 6 " << regular.near() << " / "
            << regular.rest() << ", Q " << quality.near() << " / " << quality.rest() << "\n";
  return result;
}
}

class HealedSeams : public testing::TestWithParam<Model>
{
};

TEST_P(HealedSeams, AreMeshedLikeTheRest)
{
  const Statistics s = remesh(GetParam(), {});
  EXPECT_GT(s.degree.numberNear(), 200);
  EXPECT_GT(s.degree.numberOfRest(), 1000);
  EXPECT_NEAR(s.length.ratio(), 1., 0.03);
  EXPECT_NEAR(s.degree.ratio(), 1., 0.03);
  EXPECT_NEAR(s.quality.ratio(), 1., 0.03);
  EXPECT_NEAR(s.regular.near(), s.regular.rest(), 0.1);
}

// Charts are triangulated by lengths on the surface: valences alone might tell where they meet.
TEST_P(HealedSeams, HardlyShowWithoutOptimisation)
{
  const Statistics s = remesh(GetParam(), 0);
  EXPECT_NEAR(s.length.ratio(), 1., 0.03);
  EXPECT_GT(s.quality.ratio(), 0.95);
  EXPECT_NEAR(s.regular.near(), s.regular.rest(), 0.15);
}

// A picture of the documentation, for Documentation/make-pictures.sh, which says where to by
// PICTURES.
TEST(HealedSeamsOfTheBunny, ArePictured)
{
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(readModel("bunny00"));
  remesher->SetNumberOfPoints(5000);
  remesher->SetNumberOfCharts(15);
  remesher->Update();
  const Lines seams = seamsOf(remesher);
  ASSERT_FALSE(seams.segments.empty());
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1., 1., 1.);
  vtkNew<vtkPolyData> faces;
  faces->SetPoints(remesher->GetOutput()->GetPoints());
  faces->SetPolys(remesher->GetOutput()->GetPolys());
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const auto& [a, b] : seams.segments)
  {
    const vtkIdType ends[2] = { points->InsertNextPoint(a.data()),
      points->InsertNextPoint(b.data()) };
    cells->InsertNextCell(2, ends);
  }
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(points);
  lines->SetLines(cells);
  for (vtkPolyData* data : { faces.Get(), lines.Get() })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0., -60.);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    if (data == faces.Get())
    {
      actor->GetProperty()->SetColor(0.88, 0.86, 0.82);
      actor->GetProperty()->EdgeVisibilityOn();
      actor->GetProperty()->SetEdgeColor(0.25, 0.25, 0.28);
      actor->GetProperty()->SetLineWidth(2.F);
      actor->GetProperty()->SetInterpolationToFlat();
    }
    else
    {
      actor->GetProperty()->SetColor(0.85, 0.15, 0.1);
      actor->GetProperty()->SetLineWidth(6.F);
      actor->GetProperty()->LightingOff();
    }
    renderer->AddActor(actor);
  }
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(1600, 1200);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetPosition(0.3, 0.2, 1.);
  camera->SetViewUp(0., 1., 0.);
  renderer->ResetCamera();
  camera->Zoom(3.5);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(grab->GetOutputPort());
  shrink->SetShrinkFactors(2, 2, 1);
  shrink->AveragingOn();
  const char* folder = std::getenv("PICTURES");
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(shrink->GetOutputPort());
  writer->SetFileName(
    ((folder ? std::string(folder) + "/" : testing::TempDir() + "stipple-") + "seams.png").c_str());
  writer->Write();
  EXPECT_EQ(writer->GetErrorCode(), 0UL);
  int red = 0;
  vtkImageData* image = shrink->GetOutput();
  vtkDataArray* pixels = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    red += pixels->GetComponent(i, 0) > 150 && pixels->GetComponent(i, 1) < 100 ? 1 : 0;
  }
  EXPECT_GT(red, 500) << "seams are seen";
}

INSTANTIATE_TEST_SUITE_P(All, HealedSeams,
  testing::Values(Model{ "bunny00", 15 }, Model{ "mannequin-devil", 9 }, Model{ "lion-head", 3 }),
  [](const auto& info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });
