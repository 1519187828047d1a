// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Which lines of a feature graph a mesh has as creases.
#include "Backbones.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <vector>

namespace stipple
{
namespace
{
/// Open lines of length 4 from x = 0, at y = 0, 1, 2 ...; the last is a closed square of side 1.
vtkSmartPointer<vtkPolyData> graph(const std::vector<int>& types, const std::vector<double>& widths)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> type;
  type->SetName("BackboneType");
  vtkNew<vtkDoubleArray> width;
  width->SetName("Width");
  for (std::size_t b = 0; b < types.size(); ++b)
  {
    const auto y = static_cast<double>(b);
    std::vector<vtkIdType> ids;
    if (b + 1 < types.size())
    {
      ids = { points->InsertNextPoint(0, y, 0), points->InsertNextPoint(1, y, 0),
        points->InsertNextPoint(4, y, 0) };
    }
    else
    {
      ids = { points->InsertNextPoint(0, y, 0), points->InsertNextPoint(1, y, 0),
        points->InsertNextPoint(1, y + 1, 0), points->InsertNextPoint(0, y + 1, 0) };
      ids.push_back(ids.front());
    }
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    type->InsertNextValue(types[b]);
    width->InsertNextValue(widths[b]);
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  lines->GetCellData()->AddArray(type);
  lines->GetCellData()->AddArray(width);
  return lines;
}

/// So many on each line, and some on none.
vtkSmartPointer<vtkPolyData> samples(const std::vector<int>& numbers)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> backbone;
  backbone->SetName("BackboneId");
  for (int b = -1; b < static_cast<int>(numbers.size()); ++b)
  {
    for (int i = 0; i < (b < 0 ? 5 : numbers[static_cast<std::size_t>(b)]); ++i)
    {
      points->InsertNextPoint(0, 0, 0);
      backbone->InsertNextValue(b);
    }
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(backbone);
  return data;
}

/// The rows that are left, by their first points' y.
std::vector<int> rowsOf(vtkPolyData* lines)
{
  std::vector<int> rows;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    lines->GetLines()->GetCellAtId(i, size, ids);
    rows.push_back(static_cast<int>(lines->GetPoint(ids[0])[1]));
  }
  return rows;
}
}

TEST(Backbones, RoundedOnesAreCreasesToLongEdges)
{
  // Edges of 4 / (samples + 1) on the open lines, of 4 / samples on the closed one; a crease is as
  // wide as half of one at most.
  constexpr int Sharp = 0;
  constexpr int Seam = 2;
  const auto lines = graph({ Sharp, Sharp, Seam, Sharp, Sharp }, { 0., 0.5, 0., 0.5, 0.5 });
  EXPECT_EQ(rowsOf(creasesTo(lines, nullptr)), (std::vector<int>{ 0 }));
  EXPECT_EQ(rowsOf(creasesTo(lines, samples({ 9, 3, 3, 4, 4 }))), (std::vector<int>{ 0, 1, 4 }));
  EXPECT_EQ(rowsOf(creasesTo(lines, samples({ 9, 4, 3, 3, 5 }))), (std::vector<int>{ 0, 3 }));
  EXPECT_EQ(rowsOf(creasesTo(lines, samples({ 0, 0, 0, 0, 0 }))), (std::vector<int>{ 0, 1, 3, 4 }));
  EXPECT_EQ(rowsOf(creasesTo(nullptr, nullptr)), (std::vector<int>{}));
  EXPECT_EQ(rowsOf(backbonesOfType(lines, Seam)), (std::vector<int>{ 2 }));
}
}
