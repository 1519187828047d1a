// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceSets.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace stipple;

TEST(FaceSets, AreWhatHangsTogetherInTheOrderOfFirstTriangles)
{
  TriangleSurface s = shapes::cube(3);
  const FaceSets whole(s, [](Halfedge) { return true; });
  EXPECT_EQ(whole.number, 1);
  EXPECT_EQ(whole.faces().front().size(), s.triangles.size());

  const FaceSets sides(s,
    [&](Halfedge h) { return s.faceNormal(faceOf(h)).dot(s.faceNormal(faceOf(s.twin[h]))) > 0.5; });
  EXPECT_EQ(sides.number, 6);
  Face last;
  for (const std::vector<Face>& side : sides.faces())
  {
    EXPECT_EQ(side.size(), s.triangles.size() / 6);
    EXPECT_GT(side.front(), last);
    last = side.front();
    for (const Face f : side)
    {
      EXPECT_EQ(sides.of[f], sides.of[side.front()]);
      EXPECT_NEAR(s.faceNormal(f).dot(s.faceNormal(side.front())), 1., 1e-12);
    }
  }
}

TEST(FaceSets, EndAtTheBoundary)
{
  TriangleSurface s;
  s.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 3, 1, 0 } };
  s.triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  s.connect();
  EXPECT_EQ(FaceSets(s, [](Halfedge) { return true; }).number, 2);
}
