// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The models that are timed, and a number of threads for a while.
#ifndef stipple_BenchmarkModels_h
#define stipple_BenchmarkModels_h

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace benchmarks
{
/// NAME.off of the folder MODELS, or of the build's models; null if it is not there.
inline vtkSmartPointer<vtkPolyData> readModel(const std::string& name)
{
  const char* folder = std::getenv("MODELS");
  std::ifstream file(std::string(folder ? folder : STIPPLE_MODELS) + "/" + name + ".off");
  std::string word;
  vtkIdType points = 0;
  vtkIdType cells = 0;
  vtkIdType edges = 0;
  if (!(file >> word >> points >> cells >> edges))
  {
    return nullptr;
  }
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    file >> p[0] >> p[1] >> p[2];
    coordinates->InsertNextPoint(p);
  }
  vtkNew<vtkCellArray> polygons;
  for (vtkIdType i = 0; i < cells; ++i)
  {
    vtkIdType n = 0;
    file >> n;
    polygons->InsertNextCell(static_cast<int>(n));
    for (vtkIdType k = 0; k < n; ++k)
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

inline const char* const NoModel = "model not found: run sh Testing/Data/fetch-models.sh";

/// Runs f with a number of threads.
template <typename F>
void withThreads(int threads, F f)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads), f);
}
}

#endif
