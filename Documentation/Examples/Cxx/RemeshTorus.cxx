// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The whole pipeline as one filter, and what VTK's demand-driven pipeline makes of a changed
// parameter.
#include <vtkCleanPolyData.h>
#include <vtkGeometryRemesher.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPolyData.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(80);
  source->SetVResolution(80);
  vtkNew<vtkCleanPolyData> surface; // the source's first and last points differ in the last digit
  surface->SetTolerance(1e-6);
  surface->SetInputConnection(source->GetOutputPort());

  vtkNew<vtkGeometryRemesher> remesher;
  remesher->SetInputConnection(surface->GetOutputPort());
  remesher->SetNumberOfPoints(2000);
  remesher->Update();
  std::cout << remesher->GetOutput()->GetNumberOfPoints() << " points, uniform\n";
  if (remesher->GetOutput()->GetNumberOfPoints() != 2000)
  {
    return EXIT_FAILURE;
  }

  // Charts are kept, and so are the maps, unless they need another size for another number: what
  // follows executes again.
  remesher->SetImportanceToMean();
  remesher->SetNumberOfPoints(1000);
  remesher->Update();
  std::cout << remesher->GetOutput()->GetNumberOfPoints()
            << " points, more of them on the inside\n";
  return remesher->GetOutput()->GetNumberOfPoints() == 1000 ? EXIT_SUCCESS : EXIT_FAILURE;
}
