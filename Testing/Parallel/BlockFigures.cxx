// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// StippleBlockFigures MODEL POINTS TRIANGLES [REFINEMENTS [RINGS]]: remeshes a .ply model, refined
// by Loop's rule so often, in blocks of so many triangles, and prints figures of the mesh and of
// the time. Under mpiexec every rank has the part of the model's triangles that is its turn.
#include "BlockMeshes.h"
#include "MeshCheck.h"
#include "SurfaceRepair.h"

#include "vtkCellArray.h"
#include "vtkGeometryRemesher.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkPGeometryRemesher.h"
#include "vtkPLYReader.h"
#include "vtkTimerLog.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc < 4)
  {
    std::fprintf(stderr, "usage: %s MODEL.ply POINTS TRIANGLES [REFINEMENTS [RINGS]]\n", argv[0]);
    return 2;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  vtkSmartPointer<vtkPolyData> model = reader->GetOutput();
  if (argc > 4 && std::atoi(argv[4]) > 0)
  {
    vtkNew<vtkLoopSubdivisionFilter> refine;
    refine->SetInputData(model);
    refine->SetNumberOfSubdivisions(std::atoi(argv[4]));
    refine->Update();
    model = refine->GetOutput();
  }
  vtkNew<vtkPGeometryRemesher> remesher;
  remesher->SetInputDataObject(model);
  remesher->SetNumberOfPoints(std::atoi(argv[2]));
  remesher->SetTrianglesPerBlock(std::atoi(argv[3]));
  if (argc > 5)
  {
    remesher->SetHealingRings(std::atoi(argv[5]));
  }
  const double begin = vtkTimerLog::GetUniversalTime();
  remesher->Update();
  const double seconds = vtkTimerLog::GetUniversalTime() - begin;
  if (remesher->GetErrorCode() != 0)
  {
    return 1;
  }
  stipple::TriangleSurface mesh;
  const std::string wrong =
    test::joinBlocks(vtkPartitionedDataSet::SafeDownCast(remesher->GetOutputDataObject(0)), mesh);
  stipple::RepairedSurface reference;
  stipple::Status status = stipple::repairSurface(model, reference);
  if (wrong.empty() && status.ok())
  {
    status = stipple::checkMesh(mesh, reference.surface, reference.surface.topology(), {});
  }
  const test::BorderFigures f =
    test::measureBorders(mesh, vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1)));
  std::printf("%lld triangles, %d blocks, %d border points, %zu points%s%s\n",
    static_cast<long long>(model->GetNumberOfPolys()), remesher->GetNumberOfBlocks(),
    remesher->GetNumberOfBorderPoints(), mesh.points.size(), wrong.empty() ? "" : ": ",
    wrong.c_str());
  std::printf("check: %s\n", status.ok() ? "ok" : status.message().c_str());
  std::printf("near borders, elsewhere: length %g %g (%+.2f %%), Q %.4f %.4f (%+.4f), valence 6 "
              "%.1f %.1f %%; smallest angle %.2f; %d triangles near\n",
    f.lengthNear, f.lengthElse, 100. * (f.lengthNear / f.lengthElse - 1.), f.qualityNear,
    f.qualityElse, f.qualityNear - f.qualityElse, 100. * f.regularNear, 100. * f.regularElse,
    f.smallestAngle, f.trianglesNear);
  std::printf("seconds %.2f:", seconds);
  for (int phase = 0; phase < vtkPGeometryRemesher::NUMBER_OF_PHASES; ++phase)
  {
    std::printf(" %.2f", remesher->GetPhaseSeconds(phase));
  }
  std::printf("\n");
  return wrong.empty() && status.ok() ? 0 : 1;
}
