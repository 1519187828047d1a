// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCDTRemesh.h"

#include "FilterInputs.h"
#include "MeshCreation.h"

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
  vtkPolyData* meshOutput = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* linesOutput = vtkPolyData::GetData(outputVector, 1);
  if (inputs.isEmpty())
  {
    return 1;
  }
  stipple::Atlas::Pointer& atlas = this->Implementation->Atlas;
  std::vector<stipple::Sample> samples;
  std::vector<stipple::Triangle> triangles;
  stipple::Status status = inputs.read(atlas, samples);
  if (status.ok())
  {
    status = stipple::createMesh(*atlas, samples, triangles, stipple::progressOf(this));
  }
  if (!status.ok())
  {
    return stipple::endAfter(status, this);
  }
  const auto mesh = stipple::meshToPolyData(*atlas, samples, triangles);
  const auto lines = stipple::featureLines(
    atlas->graph(), stipple::backboneChains(atlas->graph(), samples), mesh, true);
  meshOutput->ShallowCopy(mesh);
  linesOutput->ShallowCopy(lines);
  this->UpdateProgress(1.);
  return 1;
}

void vtkCDTRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
