// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Places under the pointer.
#include "SurfacePicker.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"

#include <gtest/gtest.h>

#include <utility>

namespace stipple
{
namespace
{
class SurfacePickerTest : public testing::Test
{
protected:
  void SetUp() override
  {
    Sphere->SetRadius(2);
    Sphere->SetThetaResolution(41);
    Sphere->SetPhiResolution(23);
    Sphere->Update();
    Window->SetSize(640, 480);
    Window->AddRenderer(Renderer);
    Renderer->SetViewport(0.25, 0, 1, 0.75); // a view that is a part of its window
    vtkCamera* camera = Renderer->GetActiveCamera();
    camera->SetPosition(7, -3, 5);
    camera->SetFocalPoint(0.1, 0.2, -0.3);
    camera->SetViewUp(0.3, 1, 0.2);
    camera->SetViewAngle(37);
    camera->SetClippingRange(1, 30);
  }

  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};
}

TEST_F(SurfacePickerTest, PicksWhatIsDrawnAtThePixel)
{
  const SurfacePicker picker(Sphere->GetOutput());
  for (const auto& [x, y] : { std::pair{ 400., 180. }, { 350., 220. }, { 430.25, 140.5 } })
  {
    PickedPlace place;
    ASSERT_TRUE(picker.pick(Renderer, x, y, place));
    EXPECT_NEAR(place.position.norm(), 2, 0.03) << "on the sphere";
    EXPECT_GT(
      place.normal.dot(Vec3(Renderer->GetActiveCamera()->GetPosition()) - place.position), 0)
      << "the nearer side";
    Renderer->SetWorldPoint(place.position[0], place.position[1], place.position[2], 1);
    Renderer->WorldToDisplay();
    const double* pixel = Renderer->GetDisplayPoint();
    EXPECT_NEAR(pixel[0], x, 1e-6);
    EXPECT_NEAR(pixel[1], y, 1e-6);
  }
  PickedPlace place;
  EXPECT_FALSE(picker.pick(Renderer, 165, 5, place)) << "a corner of the view";
}

TEST_F(SurfacePickerTest, TrianglesThatShareNoPointsHaveEdgesInCommon)
{
  // As STL files have them.
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkPolyData* sphere = Sphere->GetOutput();
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < sphere->GetNumberOfPolys(); ++f)
  {
    sphere->GetPolys()->GetCellAtId(f, corners);
    triangles->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      triangles->InsertCellPoint(points->InsertNextPoint(sphere->GetPoint(corners->GetId(k))));
    }
  }
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(points);
  soup->SetPolys(triangles);
  const SurfacePicker whole(sphere);
  const SurfacePicker picker(soup);
  PickedPlace from;
  PickedPlace to;
  PickedPlace wholeFrom;
  PickedPlace wholeTo;
  ASSERT_TRUE(picker.pick(Renderer, 400, 180, from));
  ASSERT_TRUE(picker.pick(Renderer, 300, 240, to));
  ASSERT_TRUE(whole.pick(Renderer, 400, 180, wholeFrom));
  ASSERT_TRUE(whole.pick(Renderer, 300, 240, wholeTo));
  const auto path = picker.shortestPath(from.point, to.point);
  EXPECT_GT(path.size(), 1U);
  EXPECT_EQ(path.size(), whole.shortestPath(wholeFrom.point, wholeTo.point).size());
  for (const auto& [a, b] : path)
  {
    EXPECT_LT(a, b);
    EXPECT_LT(b, points->GetNumberOfPoints());
  }
  // The edge between two faces is one and the same from both sides.
  PickedPlace left;
  PickedPlace right;
  bool found = false;
  for (double x = 350; x < 450 && !found; x += 0.5)
  {
    ASSERT_TRUE(picker.pick(Renderer, x, 180, left));
    ASSERT_TRUE(picker.pick(Renderer, x + 0.5, 180, right));
    found = left.normal != right.normal;
  }
  ASSERT_TRUE(found);
  EXPECT_EQ(left.edge, right.edge);
}

TEST_F(SurfacePickerTest, FindsTheNearestPlaceOfStripsToo)
{
  vtkNew<vtkStripper> strips;
  strips->SetInputData(Sphere->GetOutput());
  strips->Update();
  ASSERT_EQ(strips->GetOutput()->GetNumberOfPolys(), 0);
  for (vtkPolyData* surface : { Sphere->GetOutput(), strips->GetOutput() })
  {
    const SurfacePicker picker(surface);
    for (const Vec3& direction : { Vec3(1, 2, 3), Vec3(-3, 1, 0.5) })
    {
      const PickedPlace place = picker.nearest(2. * direction.normalized());
      EXPECT_GT(place.position.normalized().dot(direction.normalized()), 0.99);
      EXPECT_GT(std::abs(place.normal.dot(direction.normalized())), 0.9);
    }
  }
}

TEST_F(SurfacePickerTest, PlaceDoesNotDependOnWhatElseIsDrawn)
{
  const SurfacePicker picker(Sphere->GetOutput());
  PickedPlace first;
  ASSERT_TRUE(picker.pick(Renderer, 400, 180, first));
  // Whatever is drawn moves the clipping planes; near ones lie before, inside and behind the
  // sphere.
  for (const double near : { 0.003, 1.7, 3.1, 9.1, 12. })
  {
    Renderer->GetActiveCamera()->SetClippingRange(near, 7 * near);
    PickedPlace place;
    ASSERT_TRUE(picker.pick(Renderer, 400, 180, place)) << near;
    EXPECT_EQ(place.position, first.position) << near;
    EXPECT_EQ(place.normal, first.normal) << near;
  }
}
}
