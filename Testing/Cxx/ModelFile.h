// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Reads the tests' models (Testing/Data/fetch-models.sh), which are OFF files.
#ifndef ModelFile_h
#define ModelFile_h

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <fstream>
#include <string>

namespace test
{
/// Null if there is no such file, or something else in it.
inline vtkSmartPointer<vtkPolyData> readOff(const std::string& name)
{
  std::ifstream file(name);
  std::string word;
  vtkIdType points = 0;
  vtkIdType cells = 0;
  vtkIdType edges = 0;
  file >> word >> points >> cells >> edges;
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3] = { 0, 0, 0 };
    file >> p[0] >> p[1] >> p[2];
    coordinates->InsertNextPoint(p);
  }
  vtkNew<vtkCellArray> polygons;
  for (vtkIdType i = 0; i < cells; ++i)
  {
    int n = 0;
    file >> n;
    polygons->InsertNextCell(n);
    for (int k = 0; k < n; ++k)
    {
      vtkIdType p = 0;
      file >> p;
      polygons->InsertCellPoint(p);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(coordinates);
  mesh->SetPolys(polygons);
  return file ? mesh : nullptr;
}
}

#endif
