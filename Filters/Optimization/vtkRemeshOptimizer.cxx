// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRemeshOptimizer.h"

#include "FilterInputs.h"
#include "LeastSquaresPlacement.h"
#include "MeshCreation.h"
#include "MeshOptimizer.h"
#include "PolyDataConversion.h"
#include "RegionTransfer.h"

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
  stipple::OptimizerOptions Options;

  /// The density may be null.
  stipple::Status optimize(const stipple::FilterInputs& inputs,
    vtkPartitionedDataSetCollection* density, const stipple::Progress& progress,
    std::vector<stipple::Sample>& samples, stipple::OptimizedMesh& mesh);
  void write(const stipple::OptimizedMesh& mesh, const std::vector<stipple::Sample>& samples,
    bool leastSquares, vtkInformationVector* output) const;
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

stipple::Status vtkRemeshOptimizer::Internals::optimize(const stipple::FilterInputs& inputs,
  vtkPartitionedDataSetCollection* density, const stipple::Progress& progress,
  std::vector<stipple::Sample>& samples, stipple::OptimizedMesh& mesh)
{
  stipple::TriangleSurface given;
  stipple::Status status = inputs.read(this->Atlas, samples);
  if (status.ok())
  {
    status = this->Density.read(density, this->Atlas->surface());
  }
  if (status.ok())
  {
    status = stipple::readPolyData(inputs.samples(), given);
  }
  if (status.ok())
  {
    status = mesh.build(*this->Atlas, this->Density, samples, given.triangles);
  }
  if (status.ok())
  {
    status = stipple::optimizeMesh(
      mesh, this->Options, [&](double fraction) { return progress(0.05 + 0.9 * fraction); });
  }
  if (status.ok() && this->Options.moves != stipple::OptimizerOptions::Moves::None &&
    this->Options.iterations > 0)
  {
    samples = mesh.samples();
  }
  return status;
}

void vtkRemeshOptimizer::Internals::write(const stipple::OptimizedMesh& mesh,
  const std::vector<stipple::Sample>& samples, bool leastSquares,
  vtkInformationVector* output) const
{
  const auto result = stipple::meshToPolyData(*this->Atlas, samples, mesh.triangles());
  if (leastSquares)
  {
    const std::vector<stipple::Vec3> positions = stipple::leastSquaresPositions(mesh);
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      result->GetPoints()->SetPoint(static_cast<vtkIdType>(i), positions[i].data());
    }
  }
  std::vector<std::vector<int>> chains;
  for (const stipple::OptimizedMesh::Chain& chain : mesh.chains())
  {
    chains.emplace_back();
    for (const stipple::BackboneVertex& v : chain)
    {
      chains.back().push_back(v.vertex.index());
    }
  }
  stipple::transferRegions(*this->Atlas, chains, result);
  const auto lines = stipple::featureLines(this->Atlas->graph(), chains, result, false);
  vtkPolyData::GetData(output, 0)->ShallowCopy(result);
  vtkPolyData::GetData(output, 1)->ShallowCopy(lines);
}

int vtkRemeshOptimizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const stipple::FilterInputs inputs(inputVector);
  auto* density =
    this->FollowDensity ? vtkPartitionedDataSetCollection::GetData(inputVector[3]) : nullptr;
  using Options = stipple::OptimizerOptions;
  Options& options = this->Implementation->Options;
  options.swaps = static_cast<Options::Swaps>(this->Connectivity);
  options.moves = static_cast<Options::Moves>(this->Smoothing);
  options.iterations = this->NumberOfIterations;
  options.ribs = this->Ribs;
  options.errorReduction = 0.01 * this->ErrorReduction;
  options.acuteCornerAngle = vtkMath::RadiansFromDegrees(this->AcuteCornerAngle);
  options.featureTolerance = this->KeepBackbones ? 0. : this->FeatureTolerance;
  this->NumberOfSimplifiedFeatures = 0;
  return stipple::execute(this, this->ErrorCode, [&](const stipple::Progress& progress) {
    stipple::Status status = stipple::Status::success();
    if (!inputs.isEmpty())
    {
      std::vector<stipple::Sample> samples;
      stipple::OptimizedMesh mesh;
      status = this->Implementation->optimize(inputs, density, progress, samples, mesh);
      if (status.ok())
      {
        this->NumberOfSimplifiedFeatures = mesh.numberOfChanges();
        this->Implementation->write(mesh, samples, this->Placement == LEAST_SQUARES, outputVector);
      }
    }
    return status;
  });
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
  os << indent << "FeatureTolerance: " << this->FeatureTolerance << "\n";
  os << indent << "KeepBackbones: " << this->KeepBackbones << "\n";
  os << indent << "NumberOfSimplifiedFeatures: " << this->NumberOfSimplifiedFeatures << "\n";
}
