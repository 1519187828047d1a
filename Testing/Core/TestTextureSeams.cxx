// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Textures: where coordinates jump meshes keep the jump, and corners have those of their side.
#include "CornerTexture.h"
#include "PolyDataConversion.h"
#include "Shapes.h"
#include "TextureSeams.h"
#include "TextureTransfer.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTextureSeamSplitter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace stipple;

namespace
{
const double Height = 3.;

/// The texture of a cylinder: the mantle is unrolled, with a seam along the x axis, and the caps
/// are islands beside it. `inside` tells on which side of the seam a place is meant to be.
Vec2 textureAt(const Vec3& x, const Vec3& inside, const Vec3& normal)
{
  if (std::abs(normal.z()) > 0.7)
  {
    return { 2. + 0.4 * x.x() + (normal.z() > 0 ? 1. : 0.), 0.5 + 0.4 * x.y() };
  }
  const auto angle = [](const Vec3& p) {
    const double a = std::atan2(p.y(), p.x());
    return a < 0. ? a + 2 * Pi : a;
  };
  double a = angle(x);
  a += angle(inside) - a > Pi ? 2 * Pi : a - angle(inside) > Pi ? -2 * Pi : 0.;
  return { a / (2 * Pi), x.z() / Height };
}

/// The largest difference from that texture at the corners of a mesh of triangles.
double largestError(vtkPolyData* mesh)
{
  const TriangleSurface surface = fromPolyData(mesh);
  vtkDataArray* corners = cornerTexture(mesh);
  double largest = corners ? 0. : 1e9;
  for (int f = 0; corners && f < surface.numberOfFaces(); ++f)
  {
    const Triangle& t = surface.triangles[f];
    const Vec3 centre = (surface.points[t[0]] + surface.points[t[1]] + surface.points[t[2]]) / 3.;
    for (int k = 0; k < 3; ++k)
    {
      const Vec2 wanted = textureAt(surface.points[t[k]], centre, surface.faceNormal(f));
      largest = std::max(largest, (textureOfCorner(corners, f, k) - wanted).norm());
    }
  }
  return largest;
}

/// The cylinder with its texture as a reader makes it: points once for each of their coordinates.
vtkSmartPointer<vtkPolyData> texturedCylinder(const TriangleSurface& cylinder)
{
  auto data = shapes::toPolyData(cylinder);
  auto corners = newCornerTexture(data->GetNumberOfPolys());
  for (int f = 0; f < cylinder.numberOfFaces(); ++f)
  {
    const Triangle& t = cylinder.triangles[f];
    const Vec3 centre =
      (cylinder.points[t[0]] + cylinder.points[t[1]] + cylinder.points[t[2]]) / 3.;
    for (int k = 0; k < 3; ++k)
    {
      setTextureOfCorner(
        corners, f, k, textureAt(cylinder.points[t[k]], centre, cylinder.faceNormal(f)));
    }
  }
  data->GetCellData()->AddArray(corners);
  return splitTextureSeams(data);
}

TriangleSurface cylinder()
{
  return shapes::cylinder(1., Height, 48, 24);
}

int numberOfPlaces(vtkPolyData* mesh)
{
  std::set<std::array<double, 3>> places;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x;
    mesh->GetPoint(p, x.data());
    places.insert(x);
  }
  return static_cast<int>(places.size());
}
}

// Two triangles whose common edge has other coordinates on either side.
TEST(TextureSeams, PointsAreThereOnceForEachOfTheirCoordinates)
{
  auto data = toPolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    std::vector<Triangle>{ { 0, 1, 2 }, { 0, 2, 3 } });
  EXPECT_EQ(splitTextureSeams(data), data);
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  for (const int id : { 5, 6, 7, 8 })
  {
    ids->InsertNextValue(id);
  }
  data->GetPointData()->AddArray(ids);
  auto corners = newCornerTexture(2);
  const double first[] = { 0, 0, 1, 0, 1, 1 };
  const double second[] = { 0, 0, 4, 4, 0, 1 }; // point 0 has the same on both sides
  corners->SetTuple(0, first);
  corners->SetTuple(1, second);
  data->GetCellData()->AddArray(corners);
  vtkNew<vtkTextureSeamSplitter> splitter;
  splitter->SetInputData(data);
  splitter->Update();
  vtkPolyData* split = splitter->GetOutput();
  ASSERT_EQ(split->GetNumberOfPoints(), 5);
  EXPECT_EQ(fromPolyData(split).triangles, (std::vector<Triangle>{ { 0, 1, 2 }, { 0, 4, 3 } }));
  EXPECT_EQ(split->GetPointData()->GetArray("Ids")->GetComponent(4, 0), 7);
  ASSERT_NE(split->GetPointData()->GetTCoords(), nullptr);
  EXPECT_EQ(split->GetPointData()->GetTCoords()->GetComponent(4, 1), 4.);
  EXPECT_EQ(split->GetPointData()->GetTCoords()->GetComponent(2, 1), 1.);
  EXPECT_FALSE(split->GetCellData()->HasArray(CornerTextureName));
  EXPECT_EQ(data->GetNumberOfPoints(), 4);
}

TEST(TextureSeams, EdgesWhereCoordinatesJumpAreMarkedAndNoOthers)
{
  const auto data = texturedCylinder(cylinder());
  RepairedSurface repaired;
  ASSERT_TRUE(repairSurface(data, repaired).ok());
  CutSurface surface(repaired.surface, repaired.sourceCell);
  const TextureSeams texture(data, repaired);
  texture.mark(surface);
  int onRims = 0;
  int onSeam = 0;
  for (const Halfedge h : surface.halfedges())
  {
    const Vec3 a = surface.points[surface.tail(h).index()];
    const Vec3 b = surface.points[surface.head(h).index()];
    const bool isRim = std::abs(a.z() - b.z()) < 1e-9 && a.head<2>().norm() > 0.99 &&
      b.head<2>().norm() > 0.99 &&
      std::abs(surface.faceNormal(faceOf(h).index()).z() -
        surface.faceNormal(faceOf(surface.twin[h]).index()).z()) > 0.5;
    const bool isSeam =
      std::abs(a.y()) < 1e-9 && std::abs(b.y()) < 1e-9 && a.x() > 0.99 && b.x() > 0.99;
    onRims += isRim ? 1 : 0;
    onSeam += isSeam ? 1 : 0;
    EXPECT_EQ(surface.keep[h] != Keep::Nothing, isRim || isSeam) << a << b;
  }
  EXPECT_EQ(onRims, 2 * 2 * 48);
  EXPECT_EQ(onSeam, 2 * 24);

  // A corner on a split edge has what lies between.
  const Halfedge h(0);
  std::vector<FlatChart> charts(1);
  charts[0].mesh.faces = { faceOf(h) };
  const auto before = texture.corners(surface, charts)[0];
  surface.splitEdge(h, 0.25);
  const auto after = texture.corners(surface, charts)[0];
  for (int d = 0; d < 2; ++d)
  {
    EXPECT_NEAR(after->GetComponent(0, 2 + d),
      0.75 * before->GetComponent(0, d) + 0.25 * before->GetComponent(0, 2 + d), 1e-12);
    EXPECT_EQ(after->GetComponent(0, 4 + d), before->GetComponent(0, 4 + d));
  }
}

TEST(TextureSeams, MeshesHaveTheirSidesCoordinates)
{
  const auto data = texturedCylinder(cylinder());
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(data);
  remesher->GetAtlas()->KeepTextureSeamsOn();
  for (const int points : { 150, 2000 })
  {
    SCOPED_TRACE(points);
    remesher->SetNumberOfPoints(points);
    remesher->Update();
    vtkPolyData* mesh = remesher->GetOutput();
    ASSERT_EQ(mesh->GetNumberOfPoints(), points);
    // A straight line between places of the mantle is no straight line in angles.
    EXPECT_LT(largestError(mesh), 2e-3);
    const vtkSmartPointer<vtkPolyData> split = splitTextureSeams(mesh);
    EXPECT_EQ(numberOfPlaces(split), points);
    EXPECT_GT(split->GetNumberOfPoints(), points);
  }
  // The same without features and in other patterns.
  remesher->SetFeatureAngle(180);
  remesher->SetNumberOfPoints(1000);
  remesher->Update();
  EXPECT_LT(largestError(remesher->GetOutput()), 2e-3);
  remesher->SetPatternToSemiRegular();
  remesher->SetNumberOfPoints(200);
  remesher->Update();
  EXPECT_LT(largestError(remesher->GetOutput()), 2e-3);
}

TEST(TextureSeams, ThePartThatIsNotRemeshedKeepsItsCoordinates)
{
  const TriangleSurface surface = cylinder();
  const auto data = texturedCylinder(surface);
  vtkNew<vtkIntArray> select;
  select->SetName("Select");
  for (const Triangle& t : surface.triangles)
  {
    select->InsertNextValue(
      surface.points[t[0]].x() + surface.points[t[1]].x() + surface.points[t[2]].x() > 0. ? 1 : 0);
  }
  data->GetCellData()->AddArray(select);
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(data);
  remesher->SetSelectionArrayName("Select");
  remesher->GetAtlas()->KeepTextureSeamsOn();
  remesher->SetNumberOfPoints(800);
  remesher->Update();
  ASSERT_GT(remesher->GetOutput()->GetNumberOfPoints(), 800);
  EXPECT_LT(largestError(remesher->GetOutput()), 2e-3);
}

TEST(TextureSeams, WithoutATextureItIsAnError)
{
  vtkNew<vtkConformalAtlas> atlas;
  atlas->KeepTextureSeamsOn();
  atlas->SetInputData(shapes::toPolyData(shapes::cube(2)));
  vtkObject::GlobalWarningDisplayOff();
  atlas->Update();
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_NE(atlas->GetErrorCode(), 0u);
}

TEST(TextureSeams, ChartsWithoutTheArrayGiveNone)
{
  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputData(texturedCylinder(cylinder()));
  remesher->SetNumberOfPoints(300);
  remesher->Update();
  vtkPolyData* mesh = remesher->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), 300);
  EXPECT_EQ(cornerTexture(mesh), nullptr);
  EXPECT_NE(mesh->GetPointData()->GetTCoords(), nullptr);
}
