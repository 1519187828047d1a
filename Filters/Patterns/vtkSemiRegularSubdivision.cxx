// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSemiRegularSubdivision.h"

#include "FilterInputs.h"
#include "MeshCreation.h"
#include "PolyDataConversion.h"
#include "RegionTransfer.h"
#include "SemiRegularSubdivision.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSemiRegularSubdivision);

struct vtkSemiRegularSubdivision::Internals
{
  stipple::Atlas::Pointer Atlas;
};

vtkSemiRegularSubdivision::vtkSemiRegularSubdivision()
  : Implementation(new Internals)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkSemiRegularSubdivision::~vtkSemiRegularSubdivision() = default;

int vtkSemiRegularSubdivision::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    port == 1 ? "vtkPartitionedDataSetCollection" : "vtkPolyData");
  return 1;
}

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

int vtkSemiRegularSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const stipple::FilterInputs inputs(inputVector);
  return stipple::execute(this, this->ErrorCode, [&](const stipple::Progress& progress) {
    if (inputs.isEmpty())
    {
      return stipple::Status::success();
    }
    stipple::Atlas::Pointer& atlas = this->Implementation->Atlas;
    std::vector<stipple::Sample> samples;
    stipple::SubdividedMesh mesh;
    stipple::TriangleSurface given;
    stipple::Status status = inputs.read(atlas, samples);
    if (status.ok())
    {
      status = stipple::readPolyData(inputs.samples(), given);
    }
    if (status.ok())
    {
      status = stipple::subdivideSemiRegularly(*atlas, samples, given.triangles,
        this->NumberOfSubdivisions, this->NumberOfIterations, mesh, progress);
    }
    if (status.ok())
    {
      const auto result = stipple::meshToPolyData(*atlas, mesh.samples, mesh.triangles);
      addHierarchy(mesh, result);
      const auto chains = stipple::backboneChains(atlas->graph(), mesh.samples);
      stipple::transferRegions(*atlas, chains, result);
      const auto lines = stipple::featureLines(atlas->graph(), chains, result, false);
      vtkPolyData::GetData(outputVector, 0)->ShallowCopy(result);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(lines);
    }
    return status;
  });
}

void vtkSemiRegularSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSubdivisions: " << this->NumberOfSubdivisions << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
}
