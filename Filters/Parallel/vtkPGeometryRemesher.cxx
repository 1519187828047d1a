// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPGeometryRemesher.h"

#include "BlockGhosts.h"
#include "BlockwiseRemesher.h"
#include "FilterExecution.h"

#include "vtkCommand.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <new>
#include <vector>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkPGeometryRemesher);
vtkCxxSetObjectMacro(vtkPGeometryRemesher, Controller, vtkMultiProcessController);

vtkPGeometryRemesher::vtkPGeometryRemesher()
  : Remesher(vtkGeometryRemesher::New())
{
  this->SetNumberOfOutputPorts(2);
  this->Remesher->GetMapRenderer()->SetBackendToCPU();
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPGeometryRemesher::~vtkPGeometryRemesher()
{
  this->SetController(nullptr);
  this->Remesher->Delete();
}

vtkGeometryRemesher* vtkPGeometryRemesher::GetRemesher()
{
  return this->Remesher;
}

double vtkPGeometryRemesher::GetPhaseSeconds(int phase)
{
  return phase >= 0 && phase < NUMBER_OF_PHASES ? this->PhaseSeconds[phase] : 0.;
}

vtkMTimeType vtkPGeometryRemesher::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Remesher->GetMTime());
}

int vtkPGeometryRemesher::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSet");
  return 1;
}

int vtkPGeometryRemesher::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPartitionedDataSet" : "vtkPolyData");
  return 1;
}

int vtkPGeometryRemesher::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!vtkPartitionedDataSet::GetData(outputVector, 0))
  {
    outputVector->GetInformationObject(0)->Set(
      vtkDataObject::DATA_OBJECT(), vtkNew<vtkPartitionedDataSet>());
  }
  if (!vtkPolyData::GetData(outputVector, 1))
  {
    outputVector->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
  }
  return 1;
}

int vtkPGeometryRemesher::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // Otherwise ranks but the first would not be asked, nor any for ghost cells.
  for (int port = 0; port < 2; ++port)
  {
    outputVector->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

int vtkPGeometryRemesher::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  const bool isAlone = !this->Controller;
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), isAlone ? 0 : this->Controller->GetLocalProcessId());
  info->Set(
    Pipeline::UPDATE_NUMBER_OF_PIECES(), isAlone ? 1 : this->Controller->GetNumberOfProcesses());
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

int vtkPGeometryRemesher::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  const auto add = [&](vtkDataObject* data) {
    auto* piece = vtkPolyData::SafeDownCast(data);
    if (piece && piece->GetNumberOfPolys() + piece->GetNumberOfStrips() > 0)
    {
      pieces.emplace_back(piece);
    }
  };
  if (auto* parts = vtkPartitionedDataSet::GetData(inputVector[0]))
  {
    for (unsigned int i = 0; i < parts->GetNumberOfPartitions(); ++i)
    {
      add(parts->GetPartitionAsDataObject(i));
    }
  }
  else
  {
    add(vtkDataObject::GetData(inputVector[0]));
  }
  stipple::SurfacePieces surface;
  surface.count = static_cast<int>(pieces.size());
  surface.read = [&](int i, vtkSmartPointer<vtkPolyData>& piece) {
    piece = pieces[static_cast<std::size_t>(i)];
    return stipple::Status::success();
  };
  stipple::BlockwiseOptions options;
  options.points = this->NumberOfPoints;
  options.trianglesPerBlock = this->TrianglesPerBlock;
  options.healingRings = this->HealingRings;
  const stipple::RankMessages ranks(this->Controller);
  stipple::BlockwiseResult result;
  vtkPartitionedDataSet* output = vtkPartitionedDataSet::GetData(outputVector);
  // On this thread: MPI may know no other.
  stipple::Status status = stipple::remeshBlockwise(
    surface, options, this->Remesher, ranks,
    [this](double fraction) {
      this->UpdateProgress(fraction);
      return this->AbortExecute == 0;
    },
    output, result);
  if (status.ok())
  {
    vtkInformation* asked = outputVector->GetInformationObject(0);
    const int levels = asked->Has(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())
      ? asked->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())
      : 0;
    std::vector<double> least = { -static_cast<double>(
      std::max(levels, this->MinimumNumberOfGhostLevels)) };
    ranks.minimum(least); // the same for all, whatever each was asked for
    status = stipple::addGhostCells(static_cast<int>(-least[0]), ranks, output);
  }
  this->NumberOfBlocks = result.blocks;
  this->NumberOfBorderPoints = result.borderPoints;
  this->LeastNumberOfPoints = result.least;
  this->BytesSent = ranks.sent();
  std::copy(result.seconds.begin(), result.seconds.end(), this->PhaseSeconds);
  this->ErrorCode = 0;
  if (status.ok() && result.borders && ranks.rank() == 0)
  {
    vtkPolyData::GetData(outputVector, 1)->ShallowCopy(result.borders);
  }
  if (!status.ok())
  {
    output->Initialize();
    this->ErrorCode = static_cast<unsigned long>(status.code());
    if (!status.isAbort())
    {
      vtkErrorMacro(<< status.message());
      return 0;
    }
  }
  return 1;
}

void vtkPGeometryRemesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "TrianglesPerBlock: " << this->TrianglesPerBlock << "\n";
  os << indent << "HealingRings: " << this->HealingRings << "\n";
  os << indent << "MinimumNumberOfGhostLevels: " << this->MinimumNumberOfGhostLevels << "\n";
  os << indent << "NumberOfBlocks: " << this->NumberOfBlocks << "\n";
  os << indent << "NumberOfBorderPoints: " << this->NumberOfBorderPoints << "\n";
  os << indent << "LeastNumberOfPoints: " << this->LeastNumberOfPoints << "\n";
  os << indent << "BytesSent: " << this->BytesSent << "\n";
  os << indent << "Seconds:";
  for (const double seconds : this->PhaseSeconds)
  {
    os << " " << seconds;
  }
  os << "\n";
  os << indent << "Remesher:\n";
  this->Remesher->PrintSelf(os, indent.GetNextIndent());
}
