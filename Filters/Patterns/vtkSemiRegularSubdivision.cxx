// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSemiRegularSubdivision.h"

#include "JoinedCreases.h"
#include "MeshCreation.h"
#include "PolyDataConversion.h"
#include "SemiRegularSubdivision.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSemiRegularSubdivision);

namespace
{
void addHierarchy(const stipple::SubdividedMesh& mesh, vtkPolyData* data)
{
  vtkNew<vtkIntArray> level;
  level->SetName("SubdivisionLevel");
  level->SetNumberOfValues(static_cast<vtkIdType>(mesh.level.size()));
  vtkNew<vtkIdTypeArray> parents;
  parents->SetName("ParentPointIds");
  parents->SetNumberOfComponents(2);
  parents->SetNumberOfTuples(static_cast<vtkIdType>(mesh.parents.size()));
  for (std::size_t i = 0; i < mesh.level.size(); ++i)
  {
    const vtkIdType id = static_cast<vtkIdType>(i);
    level->SetValue(id, mesh.level[i]);
    parents->SetTypedComponent(id, 0, mesh.parents[i][0]);
    parents->SetTypedComponent(id, 1, mesh.parents[i][1]);
  }
  vtkNew<vtkIdTypeArray> base;
  base->SetName("BaseCellId");
  base->SetNumberOfValues(static_cast<vtkIdType>(mesh.baseTriangle.size()));
  for (std::size_t f = 0; f < mesh.baseTriangle.size(); ++f)
  {
    base->SetValue(static_cast<vtkIdType>(f), mesh.baseTriangle[f]);
  }
  data->GetPointData()->AddArray(level);
  data->GetPointData()->AddArray(parents);
  data->GetCellData()->AddArray(base);
}
}

vtkSemiRegularSubdivision::vtkSemiRegularSubdivision()
{
  this->SetNumberOfInputPorts(4); // with feature lines
}

int vtkSemiRegularSubdivision::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 3)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  return 1;
}

stipple::Status vtkSemiRegularSubdivision::MakeMesh(stipple::MeshRequest& request)
{
  const stipple::FeatureGraph& graph = request.atlas.graph();
  const stipple::JoinedCreases& creases = request.atlas.joinedCreases();
  const std::vector<stipple::Sample> samples = creases.joined(request.samples);
  auto* lines = vtkPolyData::SafeDownCast(this->GetInputDataObject(3, 0));
  stipple::TriangleSurface given;
  stipple::SubdividedMesh mesh;
  std::vector<std::vector<int>> chains;
  stipple::Status status = stipple::readPolyData(request.given, given);
  if (status.ok() && lines)
  {
    status = stipple::readFeatureLines(lines, graph, request.given->GetNumberOfPoints(), chains);
    chains = creases.joined(chains);
  }
  else
  {
    chains = stipple::backboneChains(creases.atlas().graph(), samples);
  }
  if (status.ok())
  {
    status = stipple::subdivideSemiRegularly(creases.atlas(), samples, given.triangles, chains,
      this->NumberOfSubdivisions, this->NumberOfIterations, mesh, request.progress);
  }
  if (status.ok())
  {
    request.mesh->ShallowCopy(
      stipple::meshToPolyData(request.atlas, creases.original(mesh.samples), mesh.triangles));
    addHierarchy(mesh, request.mesh);
    request.lines->ShallowCopy(stipple::featureLines(
      graph, creases.original(stipple::idsOf(mesh.chains)), request.mesh, false));
  }
  return status;
}

void vtkSemiRegularSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSubdivisions: " << this->NumberOfSubdivisions << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
}
