// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The stages one by one, and a VTK imaging filter of the user's own between the control map and the
// sampler.
#include <vtkCDTRemesh.h>
#include <vtkCleanPolyData.h>
#include <vtkConformalAtlas.h>
#include <vtkControlMap.h>
#include <vtkErrorDiffusionSampler.h>
#include <vtkGeometryMapRenderer.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPolyData.h>
#include <vtkRemeshOptimizer.h>

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

  vtkNew<vtkConformalAtlas> atlas; // port 0: charts, port 1: feature graph
  atlas->SetInputConnection(surface->GetOutputPort());

  vtkNew<vtkGeometryMapRenderer> maps;
  maps->SetInputConnection(atlas->GetOutputPort(0));
  maps->SetNumberOfSamples(3000); // chooses the size of the maps

  vtkNew<vtkControlMap> control;
  control->SetInputConnection(maps->GetOutputPort());
  control->SetImportanceToMean();
  control->SetGamma(0.5);

  vtkNew<vtkImageGaussianSmooth> smooth; // VTK runs it over every image of the collection
  smooth->SetInputConnection(control->GetOutputPort());
  smooth->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Control");
  smooth->SetDimensionality(2);
  smooth->SetStandardDeviations(2., 2.);

  vtkNew<vtkErrorDiffusionSampler> sampler;
  sampler->SetInputConnection(0, smooth->GetOutputPort());
  sampler->SetInputConnection(1, atlas->GetOutputPort(0));
  sampler->SetInputConnection(2, atlas->GetOutputPort(1));
  sampler->SetNumberOfSamples(3000);

  vtkNew<vtkCDTRemesh> mesher;
  mesher->SetInputConnection(0, sampler->GetOutputPort(0));
  mesher->SetInputConnection(1, atlas->GetOutputPort(0));
  mesher->SetInputConnection(2, atlas->GetOutputPort(1));

  vtkNew<vtkRemeshOptimizer> optimizer;
  optimizer->SetInputConnection(0, mesher->GetOutputPort(0));
  optimizer->SetInputConnection(1, atlas->GetOutputPort(0));
  optimizer->SetInputConnection(2, atlas->GetOutputPort(1));
  optimizer->Update();

  vtkPolyData* mesh = vtkPolyData::SafeDownCast(optimizer->GetOutputDataObject(0));
  std::cout << mesh->GetNumberOfPoints() << " points, " << mesh->GetNumberOfCells()
            << " triangles\n";
  return mesh->GetNumberOfPoints() == 3000 ? EXIT_SUCCESS : EXIT_FAILURE;
}
