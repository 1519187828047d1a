// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What is lost of features is shown stretch by stretch.
#include "LostFeatures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace stipple
{
namespace
{
using Line = std::vector<std::array<double, 2>>;

/// Sharp lines in the plane.
vtkSmartPointer<vtkPolyData> sharpLines(const std::vector<Line>& lines)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> types;
  types->SetName("BackboneType");
  for (const Line& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const auto& [x, y] : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(x, y, 0));
    }
    types->InsertNextValue(0);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(cells);
  result->GetCellData()->AddArray(types);
  return result;
}
}

TEST(LostFeatures, WhatIsKeptIsNotLost)
{
  const auto before = sharpLines({ { { 0, 0 }, { 10, 0 } }, { { 0, 5 }, { 10, 5 } } });
  const auto after = sharpLines(
    { { { 0, 0 }, { 3, 0 }, { 6, 0.1 }, { 10, 0 } }, { { 0, 5 }, { 5, 5 }, { 10, 5 } } });
  EXPECT_EQ(lostFeatures(before, after)->GetNumberOfLines(), 0);
}

TEST(LostFeatures, AStretchOfALongEdgeIsLost)
{
  const auto before = sharpLines({ { { 0, 0 }, { 100, 0 } } });
  // The middle is kept, and two notches are not.
  const auto after = sharpLines({ { { 0, 0 }, { 10, 0 }, { 12, 0 }, { 14, 2 }, { 16, 0 }, { 18, 0 },
    { 20, 0 }, { 22, 0 }, { 24, 0 }, { 80, 0 }, { 82, 0 }, { 85, 4 }, { 88, 0 }, { 100, 0 } } });
  const auto lost = lostFeatures(before, after);
  ASSERT_EQ(lost->GetNumberOfLines(), 2);
  for (const auto& [line, begin, end] :
    { std::array<double, 3>{ 0, 12, 16 }, std::array<double, 3>{ 1, 82, 88 } })
  {
    double bounds[6];
    lost->GetCellBounds(static_cast<vtkIdType>(line), bounds);
    EXPECT_GE(bounds[0], begin - 1);
    EXPECT_LE(bounds[1], end + 1);
    EXPECT_GT(bounds[1] - bounds[0], 0.3 * (end - begin));
    EXPECT_EQ(bounds[3], 0) << "of the line before";
  }
}

TEST(LostFeatures, WithoutLinesAllAreLost)
{
  const auto before = sharpLines({ { { 0, 0 }, { 1, 0 }, { 2, 0 } } });
  EXPECT_EQ(lostFeatures(before, sharpLines({}))->GetNumberOfLines(), 2);
  EXPECT_EQ(lostFeatures(sharpLines({}), before)->GetNumberOfLines(), 0);
}
}
