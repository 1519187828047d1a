// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAtlasMeshAlgorithm.h"

#include "FilterExecution.h"
#include "MeshCreation.h"
#include "RegionTransfer.h"
#include "TextureTransfer.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

vtkAtlasMeshAlgorithm::vtkAtlasMeshAlgorithm()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkAtlasMeshAlgorithm::~vtkAtlasMeshAlgorithm() = default;

int vtkAtlasMeshAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  const bool images = port == 3;
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    port == 1 || images ? "vtkPartitionedDataSetCollection" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), images ? 1 : 0);
  return 1;
}

int vtkAtlasMeshAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* given = vtkPolyData::GetData(inputVector[0]);
  auto* charts = vtkPartitionedDataSetCollection::GetData(inputVector[1]);
  auto* graph = vtkPolyData::GetData(inputVector[2]);
  return stipple::execute(this, this->ErrorCode, [&](const stipple::Progress& progress) {
    if (!given || !charts || given->GetNumberOfPoints() == 0)
    {
      return stipple::Status::success();
    }
    std::vector<stipple::Sample> samples;
    stipple::Status status = stipple::Atlas::read(charts, graph, this->Atlas);
    if (status.ok())
    {
      status = stipple::readSamples(given, *this->Atlas, samples);
    }
    if (status.ok())
    {
      stipple::MeshRequest request = { *this->Atlas, given, samples, progress,
        vtkPolyData::GetData(outputVector, 0), vtkPolyData::GetData(outputVector, 1) };
      status = this->MakeMesh(request);
      if (status.ok())
      {
        stipple::transferRegions(request.atlas, request.lines, request.mesh);
        status = stipple::transferTexture(request.atlas, request.lines, request.mesh);
      }
    }
    return status;
  });
}
