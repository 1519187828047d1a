// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQuadRemesh.h"

#include "MeshCreation.h"
#include "QuadPattern.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkQuadRemesh);

namespace
{
/// The polygons in place of the triangles that stood for them.
void setPolygons(const stipple::QuadMesh& mesh, vtkPolyData* data)
{
  vtkNew<vtkCellArray> cells;
  for (const std::vector<int>& polygon : mesh.polygons)
  {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (int p : polygon)
    {
      cells->InsertCellPoint(p);
    }
  }
  data->SetPolys(cells);
}
}

vtkQuadRemesh::vtkQuadRemesh()
{
  this->SetNumberOfInputPorts(4); // with control images
}

stipple::Status vtkQuadRemesh::MakeMesh(stipple::MeshRequest& request)
{
  auto* images = vtkPartitionedDataSetCollection::SafeDownCast(this->GetInputDataObject(3, 0));
  this->NumberOfSimplifiedFeatures = 0;
  stipple::DensityField density;
  stipple::QuadMesh mesh;
  stipple::Status status = density.read(images, request.atlas.surface());
  if (status.ok())
  {
    status = stipple::meshWithQuads(
      request.atlas, request.samples, mesh, request.progress, density, this->FeatureTolerance);
    this->NumberOfSimplifiedFeatures = mesh.numberOfSimplifiedFeatures;
  }
  if (status.ok())
  {
    // Cell arrays come from one triangle of every polygon.
    std::vector<stipple::Triangle> triangles;
    for (const std::vector<int>& p : mesh.polygons)
    {
      triangles.push_back({ p[0], p[1], p[2] });
    }
    request.mesh->ShallowCopy(stipple::meshToPolyData(request.atlas, mesh.samples, triangles));
    setPolygons(mesh, request.mesh);
    request.lines->ShallowCopy(
      stipple::featureLines(request.atlas.graph(), mesh.chains, request.mesh, false));
  }
  return status;
}

void vtkQuadRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureTolerance: " << this->FeatureTolerance << "\n";
  os << indent << "NumberOfSimplifiedFeatures: " << this->NumberOfSimplifiedFeatures << "\n";
}
