// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCDTRemesh.h"

#include "MeshCreation.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkCDTRemesh);

stipple::Status vtkCDTRemesh::MakeMesh(stipple::MeshRequest& request)
{
  std::vector<stipple::Triangle> triangles;
  const stipple::Status status =
    stipple::createMesh(request.atlas, request.samples, triangles, request.progress);
  if (status.ok())
  {
    const stipple::FeatureGraph& graph = request.atlas.graph();
    request.mesh->ShallowCopy(stipple::meshToPolyData(request.atlas, request.samples, triangles));
    request.lines->ShallowCopy(stipple::featureLines(
      graph, stipple::backboneChains(graph, request.samples), request.mesh, true));
  }
  return status;
}

void vtkCDTRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
