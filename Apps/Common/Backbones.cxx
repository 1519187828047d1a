// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Backbones.h"

#include "FeatureGraph.h"
#include "Geometry.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace stipple
{
namespace
{
vtkSmartPointer<vtkPolyData> selectedBackbones(
  vtkPolyData* lines, const std::function<bool(vtkIdType cell)>& isSelected)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  if (!lines)
  {
    return data;
  }
  vtkNew<vtkCellArray> cells;
  const vtkIdType first = lines->GetNumberOfVerts();
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    if (isSelected(first + i))
    {
      vtkIdType size;
      const vtkIdType* ids;
      lines->GetLines()->GetCellAtId(i, size, ids);
      cells->InsertNextCell(size, ids);
    }
  }
  data->SetPoints(lines->GetPoints());
  data->SetLines(cells);
  return data;
}

/// By polyline, how long an edge of the mesh along it is on the average.
std::vector<double> edgesOnBackbones(vtkPolyData* lines, vtkPolyData* samples)
{
  std::vector<double> edges(static_cast<std::size_t>(lines->GetNumberOfLines()), 0.);
  std::vector<int> samplesOn(edges.size(), 0);
  vtkDataArray* backbone = samples->GetPointData()->GetArray("BackboneId");
  for (vtkIdType i = 0; backbone && i < samples->GetNumberOfPoints(); ++i)
  {
    const auto b = static_cast<std::ptrdiff_t>(backbone->GetComponent(i, 0));
    if (b >= 0 && b < static_cast<std::ptrdiff_t>(samplesOn.size()))
    {
      ++samplesOn[b];
    }
  }
  for (std::size_t b = 0; b < edges.size(); ++b)
  {
    vtkIdType size;
    const vtkIdType* ids;
    lines->GetLines()->GetCellAtId(static_cast<vtkIdType>(b), size, ids);
    double length = 0;
    for (vtkIdType i = 1; i < size; ++i)
    {
      length += (Vec3(lines->GetPoint(ids[i])) - Vec3(lines->GetPoint(ids[i - 1]))).norm();
    }
    // A closed one has no ends that are samples besides.
    const bool isClosed = size > 0 && ids[0] == ids[size - 1];
    edges[b] = length / std::max(1, samplesOn[b] + (isClosed ? 0 : 1));
  }
  return edges;
}

bool isOfType(vtkPolyData* lines, int type, vtkIdType cell)
{
  vtkDataArray* types = lines->GetCellData()->GetArray("BackboneType");
  return types && static_cast<int>(types->GetComponent(cell, 0)) == type;
}
}

vtkSmartPointer<vtkPolyData> backbonesOfType(vtkPolyData* lines, int type)
{
  return selectedBackbones(lines, [&](vtkIdType cell) { return isOfType(lines, type, cell); });
}

vtkSmartPointer<vtkPolyData> creasesTo(vtkPolyData* lines, vtkPolyData* samples, bool allAreCreases)
{
  constexpr int Sharp = 0;
  if (allAreCreases)
  {
    return backbonesOfType(lines, Sharp);
  }
  const auto lengths = [&](const char* name) {
    return lines ? lines->GetCellData()->GetArray(name) : nullptr;
  };
  vtkDataArray* widths = lengths("Width");
  vtkDataArray* pitches = lengths("Pitch");
  const std::vector<double> edges =
    samples && (widths || pitches) ? edgesOnBackbones(lines, samples) : std::vector<double>();
  return selectedBackbones(lines, [&](vtkIdType cell) {
    Backbone backbone;
    backbone.width = widths ? widths->GetComponent(cell, 0) : 0.;
    backbone.pitch = pitches ? pitches->GetComponent(cell, 0) : 0.;
    return isOfType(lines, Sharp, cell) &&
      backbone.isCreaseTo(edges.empty() ? 0. : edges[cell - lines->GetNumberOfVerts()]);
  });
}
}
