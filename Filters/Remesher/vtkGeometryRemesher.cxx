// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryRemesher.h"

#include "NumberSearches.h"
#include "OptionTable.h"
#include "PolyDataConversion.h"
#include "RemesherRun.h"

#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

vtkStandardNewMacro(vtkGeometryRemesher);

namespace
{
using Remesher = vtkGeometryRemesher;
using stipple::RemesherStages;
constexpr bool isCode(int code, stipple::StatusCode status)
{
  return code == static_cast<int>(status) && code > vtkErrorCode::UserError;
}
static_assert(isCode(Remesher::ABORTED, stipple::StatusCode::Aborted) &&
  isCode(Remesher::BAD_INPUT, stipple::StatusCode::BadInput) &&
  isCode(Remesher::TOO_FEW_POINTS, stipple::StatusCode::TooFewPoints) &&
  isCode(Remesher::INTERNAL_ERROR, stipple::StatusCode::Internal));
static_assert(
  static_cast<int>(Remesher::StageStartEvent) > static_cast<int>(vtkCommand::UserEvent));

stipple::RunCallbacks callbacksOf(vtkGeometryRemesher* filter)
{
  stipple::RunCallbacks callbacks;
  // What is told never falls, though it may try again.
  callbacks.tell = [filter](double fraction) {
    filter->UpdateProgress(std::max(filter->GetProgress(), fraction));
  };
  callbacks.isStopped = [filter] { return filter->GetAbortExecute() != 0; };
  callbacks.stageStarts = [filter](
                            int stage) { filter->InvokeEvent(Remesher::StageStartEvent, &stage); };
  callbacks.stageEnds = [filter](
                          int stage) { filter->InvokeEvent(Remesher::StageEndEvent, &stage); };
  return callbacks;
}

/// What the input says of itself, on a mesh of it that has been made by stages.
void takeAttributes(vtkPolyData* input, vtkPolyData* mesh)
{
  // Names of regions, materials, units: of it as a whole.
  vtkFieldData* whole = mesh->GetFieldData();
  for (int i = 0; i < input->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = input->GetFieldData()->GetAbstractArray(i);
    if (!array->GetName() || !whole->HasArray(array->GetName()))
    {
      whole->AddArray(array);
    }
  }
  // On the way the active texture coordinates were the charts' parameters.
  vtkPointData* points = mesh->GetPointData();
  vtkDataArray* texture = input->GetPointData()->GetTCoords();
  if (texture && texture->GetName())
  {
    points->SetActiveTCoords(texture->GetName());
  }
  // Of points that are others: normals, which differ across creases that have one point now, and
  // numbers that no two points have.
  points->SetNormals(nullptr);
  points->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
}
}

vtkGeometryRemesher::vtkGeometryRemesher()
  : Run(new stipple::RemesherRun(callbacksOf(this)))
{
  this->SetNumberOfOutputPorts(7);
}

vtkGeometryRemesher::~vtkGeometryRemesher()
{
  this->SetSelectionArrayName(nullptr);
}

int vtkGeometryRemesher::FillOutputPortInformation(int port, vtkInformation* info)
{
  const bool collection = port == 2 || port == 4 || port == 6;
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    collection ? "vtkPartitionedDataSetCollection" : "vtkPolyData");
  return 1;
}

vtkMTimeType vtkGeometryRemesher::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkAlgorithm* stage : this->Run->stages().InOrder)
  {
    time = std::max(time, stage->GetMTime());
  }
  return std::max(time, this->StoppedTime.GetMTime());
}

int vtkGeometryRemesher::ComputePipelineMTime(vtkInformation* request,
  vtkInformationVector** inInfo, vtkInformationVector* outInfo, int requestFromOutputPort,
  vtkMTimeType* time)
{
  // An update begins: what a stopped execution left empty, here and behind, is older than that.
  if (this->Stopped)
  {
    this->StoppedTime.Modified();
  }
  return this->Superclass::ComputePipelineMTime(
    request, inInfo, outInfo, requestFromOutputPort, time);
}

stipple::Status vtkGeometryRemesher::Remesh(vtkPolyData* input)
{
  stipple::RemesherRun& run = *this->Run;
  const std::string selection = this->SelectionArrayName ? this->SelectionArrayName : "";
  if (stipple::Status status = run.takeInput(input, selection); !status.ok())
  {
    return status;
  }
  if (this->MaximumDeviation == 0. && this->MaximumDeviationLength == 0.)
  {
    return run.stages().hasOneEdgeLength()
      ? stipple::remeshToEdgeLength(run, this->NumberOfPoints, this->MedianEdgeLength)
      : run.remesh(this->NumberOfPoints);
  }
  if (run.stages().ControlMap->GetEdgeLength() > 0.)
  {
    return stipple::Status::error("A largest deviation excludes an edge length, which follows from "
                                  "it: set one of them to 0.");
  }
  const stipple::TriangleSurface reference =
    stipple::fromPolyData(run.part().part() ? run.part().part() : input);
  const double diagonal = reference.boundingBoxDiagonal();
  if (!(diagonal > 0.) || !std::isfinite(diagonal))
  {
    return run.remesh(this->NumberOfPoints); // which says what is wrong, or makes nothing
  }
  double largest = std::numeric_limits<double>::infinity();
  for (const double bound :
    { 0.01 * this->MaximumDeviation * diagonal, this->MaximumDeviationLength })
  {
    largest = bound > 0. ? std::min(largest, bound) : largest;
  }
  return stipple::remeshWithinDeviation(run, reference, largest, this->Deviation);
}

int vtkGeometryRemesher::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  stipple::RemesherRun& run = *this->Run;
  this->ErrorCode = 0;
  this->Stopped = false;
  this->Deviation = 0.;
  this->MedianEdgeLength = 0.;
  run.begin(this->Pattern);
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (!input || input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    return 1;
  }
  stipple::Status status = this->Remesh(input);
  run.end();
  if (status.ok())
  {
    RemesherStages& stages = run.stages();
    if (stages.Atlas->GetNumberOfSurfaceTriangles() == 0)
    {
      vtkWarningMacro("The input has no triangle with an area: the output is empty.");
    }
    vtkAlgorithm* last = stages.last(this->Pattern);
    const std::array<vtkDataObject*, 7> results = { { last->GetOutputDataObject(0),
      last->GetOutputDataObject(1), stages.Atlas->GetOutputDataObject(0),
      stages.Atlas->GetOutputDataObject(1), stages.ControlMap->GetOutputDataObject(0),
      stages.Sampler->GetOutputDataObject(0), stages.Sampler->GetOutputDataObject(1) } };
    for (int port = 0; port < 7; ++port)
    {
      vtkDataObject::GetData(outputVector, port)->ShallowCopy(results[port]);
    }
    vtkPolyData* mesh = vtkPolyData::GetData(outputVector, 0);
    if (run.part().part())
    {
      status = run.part().join(run.mesh(), vtkPolyData::GetData(outputVector, 1), mesh);
    }
    takeAttributes(input, mesh);
  }
  this->ErrorCode = static_cast<unsigned long>(status.code());
  if (status.isAbort()) // of a stage, too
  {
    this->AbortExecute = 1;
    this->Stopped = true;
  }
  else if (!status.ok())
  {
    vtkErrorMacro(<< status.message());
    return 0;
  }
  return 1;
}

int vtkGeometryRemesher::GetLeastNumberOfPoints()
{
  return this->Run->leastNumberOfPoints();
}

int vtkGeometryRemesher::GetNumberOfOverlaps()
{
  return this->Run->stages().NumberOfOverlaps;
}

int vtkGeometryRemesher::GetNumberOfPointsTried()
{
  return this->Run->numberTried();
}

int vtkGeometryRemesher::GetNumberOfGivenPoints()
{
  return this->Run->numberOfGivenPoints();
}

std::string vtkGeometryRemesher::GetOptionTable()
{
  return stipple::optionTableText();
}

double vtkGeometryRemesher::GetStageSeconds(int stage)
{
  return stage >= 0 && stage < RemesherStages::NumberOfStages ? this->Run->runner().seconds(stage)
                                                              : 0.;
}

// Parameters that live in the stages.
#define stippleForward(stage, name, type)                                                          \
  type vtkGeometryRemesher::Get##name()                                                            \
  {                                                                                                \
    return this->Run->stages().stage->Get##name();                                                 \
  }                                                                                                \
  void vtkGeometryRemesher::Set##name(type value)                                                  \
  {                                                                                                \
    this->Run->stages().stage->Set##name(value);                                                   \
  }
#define stippleForwardChoice(stage, name, choice)                                                  \
  void vtkGeometryRemesher::Set##name##To##choice()                                                \
  {                                                                                                \
    this->Run->stages().stage->Set##name##To##choice();                                            \
  }

stippleForward(Atlas, FeatureAngle, double);
stippleForward(Atlas, NumberOfCharts, int);
stippleForward(ControlMap, Importance, int);
stippleForwardChoice(ControlMap, Importance, Uniform);
stippleForwardChoice(ControlMap, Importance, Mean);
stippleForwardChoice(ControlMap, Importance, Gaussian);
stippleForwardChoice(ControlMap, Importance, Minimum);
stippleForwardChoice(ControlMap, Importance, Maximum);
stippleForwardChoice(ControlMap, Importance, Total);
stippleForwardChoice(ControlMap, Importance, L2);
stippleForwardChoice(ControlMap, Importance, Image);
stippleForwardChoice(ControlMap, Importance, Array);
stippleForward(ControlMap, ImportanceArrayName, const char*);
stippleForward(ControlMap, ImportanceImage, vtkImageData*);
stippleForward(ControlMap, Gamma, double);
stippleForward(ControlMap, Gradation, double);
stippleForward(Optimizer, NumberOfIterations, int);
stippleForwardChoice(Optimizer, Preset, Uniform);
stippleForwardChoice(Optimizer, Preset, Adaptive);
stippleForwardChoice(Optimizer, Preset, Rib);
stippleForward(Subdivider, NumberOfSubdivisions, int);

int vtkGeometryRemesher::GetNumberOfPointsMinValue()
{
  return 0;
}

int vtkGeometryRemesher::GetNumberOfPointsMaxValue()
{
  return this->Run->stages().Sampler->GetNumberOfSamplesMaxValue();
}

void vtkGeometryRemesher::SetNumberOfPoints(int points)
{
  points = std::clamp(points, this->GetNumberOfPointsMinValue(), this->GetNumberOfPointsMaxValue());
  if (this->NumberOfPoints != points)
  {
    this->NumberOfPoints = points;
    this->Modified();
  }
}

vtkConformalAtlas* vtkGeometryRemesher::GetAtlas()
{
  return this->Run->stages().Atlas;
}

vtkGeometryMapRenderer* vtkGeometryRemesher::GetMapRenderer()
{
  return this->Run->stages().MapRenderer;
}

vtkControlMap* vtkGeometryRemesher::GetControlMap()
{
  return this->Run->stages().ControlMap;
}

vtkErrorDiffusionSampler* vtkGeometryRemesher::GetSampler()
{
  return this->Run->stages().Sampler;
}

vtkCDTRemesh* vtkGeometryRemesher::GetMesher()
{
  return this->Run->stages().Mesher;
}

vtkRemeshOptimizer* vtkGeometryRemesher::GetOptimizer()
{
  return this->Run->stages().Optimizer;
}

vtkQuadRemesh* vtkGeometryRemesher::GetQuadMesher()
{
  return this->Run->stages().QuadMesher;
}

vtkSemiRegularSubdivision* vtkGeometryRemesher::GetSubdivision()
{
  return this->Run->stages().Subdivider;
}

void vtkGeometryRemesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "MaximumDeviation: " << this->MaximumDeviation << "\n";
  os << indent << "MaximumDeviationLength: " << this->MaximumDeviationLength << "\n";
  os << indent << "Deviation: " << this->Deviation << "\n";
  os << indent << "MedianEdgeLength: " << this->MedianEdgeLength << "\n";
  os << indent << "NumberOfOverlaps: " << this->Run->stages().NumberOfOverlaps << "\n";
  os << indent << "NumberOfPointsTried: " << this->GetNumberOfPointsTried() << "\n";
  os << indent << "Pattern: " << this->Pattern << "\n";
  os << indent
     << "SelectionArrayName: " << (this->SelectionArrayName ? this->SelectionArrayName : "(none)")
     << "\n";
  for (int a = 0; a < RemesherStages::NumberOfAlgorithms; ++a)
  {
    os << indent << "The " << RemesherStages::nameOf(a);
    if (a < RemesherStages::NumberOfStages)
    {
      os << " (" << this->Run->runner().seconds(a) << " s)";
    }
    os << ":\n";
    this->Run->stages().InOrder[a]->PrintSelf(os, indent.GetNextIndent());
  }
}
