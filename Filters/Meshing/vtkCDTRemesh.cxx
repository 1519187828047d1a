// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCDTRemesh.h"

#include "FilterInputs.h"
#include "MeshCreation.h"
#include "RegionTransfer.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkCDTRemesh);

struct vtkCDTRemesh::Internals
{
  stipple::Atlas::Pointer Atlas;
};

vtkCDTRemesh::vtkCDTRemesh()
  : Implementation(new Internals)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkCDTRemesh::~vtkCDTRemesh() = default;

int vtkCDTRemesh::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    port == 1 ? "vtkPartitionedDataSetCollection" : "vtkPolyData");
  return 1;
}

int vtkCDTRemesh::RequestData(
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
    std::vector<stipple::Triangle> triangles;
    stipple::Status status = inputs.read(atlas, samples);
    if (status.ok())
    {
      status = stipple::createMesh(*atlas, samples, triangles, progress);
    }
    if (status.ok())
    {
      const auto mesh = stipple::meshToPolyData(*atlas, samples, triangles);
      const auto chains = stipple::backboneChains(atlas->graph(), samples);
      stipple::transferRegions(*atlas, chains, mesh);
      const auto lines = stipple::featureLines(atlas->graph(), chains, mesh, true);
      vtkPolyData::GetData(outputVector, 0)->ShallowCopy(mesh);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(lines);
    }
    return status;
  });
}

void vtkCDTRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
