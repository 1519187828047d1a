// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRemeshOptimizer.h"

#include "FilterInputs.h"
#include "LeastSquaresPlacement.h"
#include "MeshCreation.h"
#include "MeshOptimizer.h"
#include "PolyDataConversion.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkRemeshOptimizer);

struct vtkRemeshOptimizer::Internals
{
  stipple::Atlas::Pointer Atlas;
  stipple::DensityField Density;
};

vtkRemeshOptimizer::vtkRemeshOptimizer()
  : Implementation(new Internals)
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(2);
}

vtkRemeshOptimizer::~vtkRemeshOptimizer() = default;

int vtkRemeshOptimizer::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    port == 1 || port == 3 ? "vtkPartitionedDataSetCollection" : "vtkPolyData");
  if (port == 3)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkRemeshOptimizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const stipple::FilterInputs inputs(inputVector);
  auto* control = vtkPartitionedDataSetCollection::GetData(inputVector[3]);
  vtkPolyData* meshOutput = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* linesOutput = vtkPolyData::GetData(outputVector, 1);
  if (inputs.isEmpty())
  {
    return 1;
  }
  stipple::Atlas::Pointer& atlas = this->Implementation->Atlas;
  stipple::DensityField& density = this->Implementation->Density;
  std::vector<stipple::Sample> samples;
  stipple::OptimizedMesh mesh;
  stipple::Status status = inputs.read(atlas, samples);
  if (status.ok())
  {
    status = density.read(this->FollowDensity ? control : nullptr, atlas->surface());
  }
  stipple::TriangleSurface given;
  if (status.ok())
  {
    status = stipple::readPolyData(inputs.samples(), given);
  }
  if (status.ok())
  {
    status = mesh.build(*atlas, density, samples, given.triangles);
  }
  if (status.ok())
  {
    using Options = stipple::OptimizerOptions;
    Options options;
    options.swaps = static_cast<Options::Swaps>(this->Connectivity);
    options.moves = static_cast<Options::Moves>(this->Smoothing);
    options.iterations = this->NumberOfIterations;
    options.ribs = this->Ribs;
    options.errorReduction = 0.01 * this->ErrorReduction;
    options.acuteCornerAngle = vtkMath::RadiansFromDegrees(this->AcuteCornerAngle);
    status =
      stipple::optimizeMesh(mesh, options, [progress = stipple::progressOf(this)](double fraction) {
        return progress(0.05 + 0.9 * fraction);
      });
  }
  if (!status.ok())
  {
    return stipple::endAfter(status, this);
  }
  const bool moved =
    this->Smoothing != vtkRemeshOptimizer::SMOOTHING_NONE && this->NumberOfIterations > 0;
  const auto result =
    stipple::meshToPolyData(*atlas, moved ? mesh.samples() : samples, mesh.triangles());
  if (this->Placement == LEAST_SQUARES)
  {
    const std::vector<stipple::Vec3> positions = stipple::leastSquaresPositions(mesh);
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      result->GetPoints()->SetPoint(static_cast<vtkIdType>(i), positions[i].data());
    }
  }
  std::vector<std::vector<int>> chains;
  for (const std::vector<stipple::Vertex>& chain : mesh.chains())
  {
    chains.emplace_back();
    for (const stipple::Vertex v : chain)
    {
      chains.back().push_back(v.index());
    }
  }
  const auto lines = stipple::featureLines(atlas->graph(), chains, result, false);
  meshOutput->ShallowCopy(result);
  linesOutput->ShallowCopy(lines);
  this->UpdateProgress(1.);
  return 1;
}

void vtkRemeshOptimizer::SetPreset(bool followDensity, bool ribs)
{
  this->SetConnectivity(REGULARITY);
  this->SetSmoothing(LLOYD);
  this->SetFollowDensity(followDensity);
  this->SetRibs(ribs);
}

void vtkRemeshOptimizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Connectivity: " << this->Connectivity << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "FollowDensity: " << this->FollowDensity << "\n";
  os << indent << "Ribs: " << this->Ribs << "\n";
  os << indent << "Placement: " << this->Placement << "\n";
  os << indent << "ErrorReduction: " << this->ErrorReduction << "\n";
  os << indent << "AcuteCornerAngle: " << this->AcuteCornerAngle << "\n";
}
