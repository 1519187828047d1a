// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRemeshOptimizer.h"

#include "JoinedCreases.h"
#include "LeastSquaresPlacement.h"
#include "MeshCreation.h"
#include "MeshOptimizer.h"
#include "PolyDataConversion.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkRemeshOptimizer);

vtkRemeshOptimizer::vtkRemeshOptimizer()
{
  this->SetNumberOfInputPorts(4); // with control images
}

int vtkRemeshOptimizer::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfSimplifiedFeatures = 0;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

stipple::Status vtkRemeshOptimizer::MakeMesh(stipple::MeshRequest& request)
{
  using Options = stipple::OptimizerOptions;
  Options options;
  options.swaps = static_cast<Options::Swaps>(this->Connectivity);
  options.moves = static_cast<Options::Moves>(this->Smoothing);
  options.iterations = this->NumberOfIterations;
  options.ribs = this->Ribs;
  options.errorReduction = 0.01 * this->ErrorReduction;
  options.acuteCornerAngle = vtkMath::RadiansFromDegrees(this->AcuteCornerAngle);
  options.featureTolerance = this->FeatureToleranceScale * this->FeatureTolerance;
  options.refinesFaults = this->RefineFaults;

  auto* images = this->FollowDensity
    ? vtkPartitionedDataSetCollection::SafeDownCast(this->GetInputDataObject(3, 0))
    : nullptr;
  const stipple::JoinedCreases& creases = request.atlas.joinedCreases();
  stipple::DensityField density;
  stipple::TriangleSurface given;
  stipple::OptimizedMesh mesh;
  stipple::Status status = density.read(images, request.atlas.surface());
  if (status.ok())
  {
    status = stipple::readPolyData(request.given, given);
  }
  if (status.ok())
  {
    status = mesh.build(creases.atlas(), density, creases.joined(request.samples), given.triangles);
  }
  if (status.ok())
  {
    status = stipple::optimizeMesh(
      mesh, options, [&](double fraction) { return request.progress(0.05 + 0.9 * fraction); });
  }
  if (!status.ok())
  {
    return status;
  }
  this->NumberOfSimplifiedFeatures = mesh.numberOfSimplifiedFeatures();
  const bool hasMoved = options.moves != Options::Moves::None && options.iterations > 0;
  request.mesh->ShallowCopy(stipple::meshToPolyData(request.atlas,
    hasMoved ? creases.original(mesh.samples()) : request.samples, mesh.triangles()));
  if (this->Placement == LEAST_SQUARES)
  {
    const std::vector<stipple::Vec3> positions = stipple::leastSquaresPositions(mesh);
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      request.mesh->GetPoints()->SetPoint(static_cast<vtkIdType>(i), positions[i].data());
    }
  }
  request.lines->ShallowCopy(stipple::featureLines(
    request.atlas.graph(), creases.original(stipple::idsOf(mesh.chains())), request.mesh, false));
  return status;
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
  os << indent << "FeatureToleranceScale: " << this->FeatureToleranceScale << "\n";
  os << indent << "RefineFaults: " << this->RefineFaults << "\n";
  os << indent << "NumberOfSimplifiedFeatures: " << this->NumberOfSimplifiedFeatures << "\n";
}
