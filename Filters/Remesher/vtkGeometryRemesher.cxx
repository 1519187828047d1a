// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryRemesher.h"

#include "Atlas.h"
#include "CoarsePlaces.h"
#include "DensityArray.h"
#include "DeviationSearch.h"
#include "EdgeLengthSearch.h"
#include "FilterExecution.h"
#include "MeshCheck.h"
#include "MessageText.h"
#include "OptionTable.h"
#include "PolyDataConversion.h"
#include "Progress.h"
#include "RemesherStages.h"
#include "ReportingThread.h"
#include "SamplingConstants.h"
#include "SelectedPart.h"
#include "SizingFunction.h"
#include "SurfaceDeviation.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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

/// A count that is not known better, as it is read: 4300, 1200000.
std::string inTwoDigits(double count)
{
  const double unit = std::pow(10., std::max(0., std::floor(std::log10(count)) - 1.));
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << unit * std::round(count / unit);
  return text.str();
}

/// Whether all went well; if not, what there is to say of it.
bool noted(const stipple::Status& status, unsigned long& code, std::string& sentence)
{
  if (!status.ok())
  {
    code = static_cast<unsigned long>(status.code());
    sentence = status.message();
  }
  return status.ok();
}

/// Where edges are too long for a mesh to be sound or beautiful, shorter ones are asked for at so
/// many triangles at most, as a share of all.
constexpr double RefinedShare = 0.01;
/// Times that samples are taken anew for edges this much shorter where their mesh passes through
/// itself. Of 33 parts a third time left more such places on 12 and fewer on 13.
constexpr int MostDrafts = 2;
constexpr double DraftShare = 0.5;
}

struct vtkGeometryRemesher::Internals : stipple::RemesherStages
{
  std::array<double, NumberOfStages> Seconds = {};

  vtkWeakPointer<vtkPolyData> Input;
  vtkMTimeType InputTime = 0;
  std::string Selection; ///< the array's name
  stipple::SelectedPart Part;

  vtkGeometryRemesher* Self = nullptr;
  vtkNew<vtkCallbackCommand> Observer;
  int Current = 0;
  bool HasStarted = false;    ///< the current stage had something to do
  std::string StageError;     ///< the first that the stage reported
  std::string ExecutiveError; ///< the first that its executive reported
  std::string Sentence;       ///< why there is no mesh
  int Points = 0;             ///< asked for now: NumberOfPoints, or one that is tried
  bool IsTried = false;       ///< it is, whatever number lengths lead to
  double ProgressFrom = 0;    ///< of this trial in the whole
  double ProgressTo = 1;
  bool MayGrow = true;                ///< sizes may; a mesh that is wrong is tried again without
  double ToleranceScale = 1.;         ///< of features that the optimiser simplifies
  double FarthestFeature = 0;         ///< that these may move, a length; 0 if there is none
  double Area = 0;                    ///< of the surface, if there is
  vtkNew<vtkDoubleArray> Places;      ///< at which edges are to be shorter, for the control map
  vtkNew<vtkDoubleArray> Overlapping; ///< where the mesh before passes through itself: to be parted
  bool IsUnsound = false; ///< a mesh was made, and not sound: what would be is not known
  bool Stopped = false;   ///< the last execution was, so that its outputs are not up to date
  vtkTimeStamp StoppedTime;

  explicit Internals(vtkGeometryRemesher* self)
    : Self(self)
  {
    this->Places->SetNumberOfComponents(4);
    this->Overlapping->SetNumberOfComponents(4);
    this->Observer->SetClientData(this);
    this->Observer->SetCallback(&Internals::execute);
    for (vtkAlgorithm* stage : this->InOrder)
    {
      stage->AddObserver(vtkCommand::StartEvent, this->Observer);
      stage->AddObserver(vtkCommand::ProgressEvent, this->Observer);
      stage->AddObserver(vtkCommand::ErrorEvent, this->Observer);
      stage->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    }
  }

  ~Internals()
  {
    // A stage may outlive this filter in a caller's hands.
    for (vtkAlgorithm* stage : this->InOrder)
    {
      stage->RemoveObserver(this->Observer);
      stage->GetExecutive()->RemoveObserver(this->Observer);
    }
  }

  static void execute(vtkObject* caller, unsigned long event, void* data, void* callData)
  {
    auto* self = static_cast<Internals*>(data);
    vtkAlgorithm* stage = self->InOrder[self->Current];
    if (event == vtkCommand::ErrorEvent)
    {
      std::string& text = caller == stage ? self->StageError : self->ExecutiveError;
      if (text.empty() && callData)
      {
        text = stipple::sentenceOf(static_cast<const char*>(callData));
      }
    }
    else if (event == vtkCommand::StartEvent)
    {
      self->HasStarted = self->HasStarted || caller == stage;
    }
    else if (caller == stage)
    {
      const auto [begin, end] =
        progressOf(self->Current, self->Self->GetPattern() == vtkGeometryRemesher::SEMIREGULAR);
      self->tell(begin + (end - begin) * std::clamp(stage->GetProgress(), 0., 1.));
      if (self->Self->GetAbortExecute())
      {
        stage->SetAbortExecute(1);
      }
    }
  }

  void tell(double fraction)
  {
    this->Self->UpdateProgress(std::max(this->Self->GetProgress(), // it may try again
      this->ProgressFrom + (this->ProgressTo - this->ProgressFrom) * fraction));
  }

  /// The one that the stages share.
  stipple::Status readAtlas(stipple::Atlas::Pointer& atlas)
  {
    return stipple::Atlas::read(
      vtkPartitionedDataSetCollection::SafeDownCast(this->Atlas->GetOutputDataObject(0)),
      vtkPolyData::SafeDownCast(this->Atlas->GetOutputDataObject(1)), atlas);
  }

  /// Calls observers, which may ask to stop.
  stipple::Progress reportNothingNew()
  {
    return [this](double) {
      this->tell(0.);
      return this->Self->GetAbortExecute() == 0;
    };
  }

  /// Whether the optimised mesh may be handed to a user.
  stipple::Status check(vtkPolyData* result)
  {
    stipple::Atlas::Pointer atlas;
    if (const stipple::Status status = this->readAtlas(atlas); !status.ok())
    {
      return status;
    }
    stipple::TriangleSurface mesh = stipple::fromPolyData(result);
    mesh.connect();
    return stipple::runReporting(this->reportNothingNew(), [&](const stipple::Progress& progress) {
      return stipple::checkMesh(mesh, atlas->surface(), atlas->topology(), progress);
    });
  }

  /// See stipple::addSizePlaces().
  stipple::Status addSizePlaces(vtkPolyData* mesh, double share, vtkDoubleArray* overlapping,
    vtkDoubleArray* poor, stipple::CoarsePlaceCount& count)
  {
    count = {};
    stipple::Atlas::Pointer atlas;
    if (const stipple::Status status = this->readAtlas(atlas); !status.ok())
    {
      return status;
    }
    return stipple::runReporting(this->reportNothingNew(), [&](const stipple::Progress& progress) {
      return stipple::addSizePlaces(mesh, *atlas, share, progress, overlapping, poor, count);
    });
  }

  /// The share of edges that is asked for where a mesh is at fault: as short as sizes may get
  /// beside features.
  double finestShare()
  {
    // Edges that are asked for are those of the base mesh.
    const bool isSplit = this->Self->GetPattern() == SEMIREGULAR;
    const double splits = isSplit ? this->Subdivider->GetNumberOfSubdivisions() : 0;
    return stipple::SamplingConstants::FinestSize * std::pow(2., splits);
  }

  /// See stipple::visibleDistance().
  stipple::Status measureVisibleDistance(double& distance)
  {
    stipple::Atlas::Pointer atlas;
    if (const stipple::Status status = this->readAtlas(atlas); !status.ok())
    {
      return status;
    }
    return stipple::runReporting(this->reportNothingNew(), [&](const stipple::Progress& progress) {
      return stipple::visibleDistance(this->mesh(), *atlas, progress, distance);
    });
  }

  /// Whether triangles' edges are to be EdgeLength long everywhere.
  bool hasOneEdgeLength()
  {
    vtkControlMap* c = this->ControlMap;
    return this->Self->GetPattern() == TRIANGLES && c->GetEdgeLength() > 0. &&
      !c->GetSizeArrayName() && c->GetCurvaturePoints() == 0. && c->GetSizeMinimum() == 0. &&
      c->GetSizeMaximum() == 0. && c->GetImportance() == vtkControlMap::UNIFORM &&
      c->GetNumberOfStrokes() == 0;
  }

  /// What the last stage has made.
  vtkPolyData* mesh()
  {
    return vtkPolyData::SafeDownCast(this->last(this->Self->GetPattern())->GetOutputDataObject(0));
  }

  /// Of the mesh, without those that are given.
  int numberOfPoints()
  {
    return static_cast<int>(
      vtkPolyData::SafeDownCast(this->Sampler->GetOutputDataObject(0))->GetNumberOfPoints() -
      this->numberOfGivenVertices());
  }

  /// The largest scale of their tolerance with which features move no farther than they may.
  double largestToleranceScale()
  {
    const double spacing = std::sqrt(this->Area / (this->Points * stipple::densityOfEdges(1.)));
    const double farthest = this->Optimizer->GetFeatureTolerance() * spacing;
    return this->FarthestFeature > 0. ? std::min(1., this->FarthestFeature / farthest) : 1.;
  }

  bool sizesGrow()
  {
    return this->ControlMap->GetGrowFromFeatures() && this->ControlMap->GetGrowth() > 1.;
  }

  /// Hands the input, or the part of it that is selected, to the atlas if it is not the one of
  /// before.
  stipple::Status takeInput(vtkPolyData* input, const std::string& selection)
  {
    if (this->Input == input && this->InputTime == input->GetMTime() &&
      this->Selection == selection)
    {
      return stipple::Status::success();
    }
    this->Input = nullptr;
    this->Part = stipple::SelectedPart();
    if (!selection.empty())
    {
      if (stipple::Status status = this->Part.split(input, selection); !status.ok())
      {
        return status;
      }
    }
    vtkNew<vtkPolyData> copy; // the atlas must not lead upstream of this filter
    copy->ShallowCopy(selection.empty() ? input : this->Part.part());
    this->Atlas->SetInputDataObject(0, copy);
    if (!selection.empty() || !this->Selection.empty())
    {
      this->Atlas->SetFixedEdges(this->Part.borderEdges());
    }
    this->Input = input;
    this->InputTime = input->GetMTime();
    this->Selection = selection;
    return stipple::Status::success();
  }

  /// Vertices that are not among those asked for: the ends of backbones that run from fixed point
  /// to fixed point. On the border of a part these are its edges; where cells of it touch in a
  /// point only, the surface has that point more than once.
  int numberOfGivenVertices()
  {
    const bool areFixed = this->Part.numberOfBorderPoints() > 0 || this->Atlas->GetFixedPoints();
    auto* graph = vtkPolyData::SafeDownCast(this->Atlas->GetOutputDataObject(1));
    vtkDataArray* keep = areFixed && graph ? graph->GetCellData()->GetArray("Keep") : nullptr;
    vtkDataArray* surfacePoint = keep ? graph->GetPointData()->GetArray("SurfacePointId") : nullptr;
    if (!surfacePoint)
    {
      return 0;
    }
    std::set<double> ends;
    vtkIdType size;
    const vtkIdType* points;
    for (vtkIdType l = 0; l < graph->GetNumberOfLines(); ++l)
    {
      graph->GetLines()->GetCellAtId(l, size, points);
      if (size > 0 &&
        keep->GetComponent(graph->GetNumberOfVerts() + l, 0) ==
          static_cast<double>(stipple::Keep::Edges))
      {
        ends.insert({ surfacePoint->GetComponent(points[0], 0),
          surfacePoint->GetComponent(points[size - 1], 0) });
      }
    }
    return static_cast<int>(ends.size());
  }
};

vtkGeometryRemesher::vtkGeometryRemesher()
  : Stages(new Internals(this))
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
  for (vtkAlgorithm* stage : this->Stages->InOrder)
  {
    time = std::max(time, stage->GetMTime());
  }
  return std::max(time, this->Stages->StoppedTime.GetMTime());
}

int vtkGeometryRemesher::ComputePipelineMTime(vtkInformation* request,
  vtkInformationVector** inInfo, vtkInformationVector* outInfo, int requestFromOutputPort,
  vtkMTimeType* time)
{
  // An update begins: what a stopped execution left empty, here and behind, is older than that.
  if (this->Stages->Stopped)
  {
    this->Stages->StoppedTime.Modified();
  }
  return this->Superclass::ComputePipelineMTime(
    request, inInfo, outInfo, requestFromOutputPort, time);
}

bool vtkGeometryRemesher::RunStage(int algorithm)
{
  Internals& s = *this->Stages;
  vtkAlgorithm* filter = s.InOrder[algorithm];
  int stage = RemesherStages::stageOf(algorithm);
  s.Current = algorithm;
  s.HasStarted = false;
  s.StageError.clear();
  s.ExecutiveError.clear();
  this->InvokeEvent(StageStartEvent, &stage);
  if (this->AbortExecute)
  {
    this->ErrorCode = ABORTED;
    return false;
  }
  const double begin = vtkTimerLog::GetUniversalTime();
  const bool updated = filter->GetExecutive()->Update() != 0;
  s.Seconds[stage] += s.HasStarted ? vtkTimerLog::GetUniversalTime() - begin : 0.;
  if (stipple::takeStop(filter) || this->AbortExecute)
  {
    this->AbortExecute = 1;
    this->ErrorCode = ABORTED;
    return false;
  }
  if (!updated || !s.StageError.empty())
  {
    filter->Modified();
    this->ErrorCode = filter->GetErrorCode();
    if (this->ErrorCode == 0)
    {
      this->ErrorCode = INTERNAL_ERROR;
    }
    s.Sentence = !s.StageError.empty() ? s.StageError
      : !s.ExecutiveError.empty()
      ? s.ExecutiveError
      : "The " + std::string(RemesherStages::nameOf(algorithm)) + " failed without saying why.";
    if (const int least = this->GetLeastNumberOfPoints();
        s.Part.numberOfBorderPoints() > 0 && this->ErrorCode == TOO_FEW_POINTS && least > 0)
    {
      s.Sentence = "The selected part has no mesh of " + std::to_string(s.Points) +
        " new points: ask for at least " + std::to_string(least) + ".";
    }
    return false;
  }
  s.tell(RemesherStages::progressOf(algorithm, this->Pattern == SEMIREGULAR)[1]);
  this->InvokeEvent(StageEndEvent, &stage);
  return true;
}

bool vtkGeometryRemesher::TakeInput(vtkPolyData* input)
{
  const std::string selection = this->SelectionArrayName ? this->SelectionArrayName : "";
  vtkControlMap* control = this->Stages->ControlMap;
  stipple::Status status = !selection.empty() && this->Pattern != TRIANGLES
    ? stipple::Status::error("A selected part can be remeshed with triangles only.")
    : stipple::Status::success();
  if (status.ok() && control->GetImportance() == vtkControlMap::ARRAY)
  {
    status = stipple::checkDensityArray(input, control->GetImportanceArrayName());
  }
  if (status.ok())
  {
    status = stipple::checkSizeArray(input, control->GetSizeArrayName());
  }
  if (status.ok())
  {
    status = this->Stages->takeInput(input, selection);
  }
  return noted(status, this->ErrorCode, this->Stages->Sentence);
}

bool vtkGeometryRemesher::RunStages()
{
  Internals& s = *this->Stages;
  s.Atlas->SetMeasureNormalCurvature(s.ControlMap->GetCurvaturePoints() > 0.);
  if (!this->RunStage(ATLAS))
  {
    return false;
  }
  if (s.Atlas->GetNumberOfSurfaceTriangles() == 0)
  {
    vtkWarningMacro("The input has no triangle with an area: the output is empty.");
    return false;
  }
  s.selectMaps();
  // Where sizes are to be alike, or triangles in rows, they do not grow from features.
  const bool mayGrow =
    s.Optimizer->GetFollowDensity() && !s.Optimizer->GetRibs() && this->Pattern != QUADS;
  s.ControlMap->SetGrowFromFeatures(mayGrow && s.MayGrow);
  s.ControlMap->SetSizePlaces(s.Places);
  s.ControlMap->SetFollowImportance(s.Optimizer->GetFollowDensity() || this->Pattern == QUADS);
  if (!this->RunMapsAndControl())
  {
    return false;
  }
  if (!this->RunStage(SAMPLING))
  {
    return false;
  }
  if (this->Pattern == QUADS)
  {
    s.QuadMesher->SetFeatureTolerance(s.Optimizer->GetFeatureTolerance());
    return this->RunStage(RemesherStages::QuadMeshing);
  }
  s.Optimizer->SetFeatureToleranceScale(s.ToleranceScale);
  s.Optimizer->SetRefineFaults(s.sizesGrow());
  return this->RunStage(MESHING) && this->PartSheets() && this->RunStage(OPTIMISATION);
}

/// Samples and their mesh are made in a fraction of the time that it takes to optimise one: where
/// it passes through itself, they are made anew with shorter edges.
bool vtkGeometryRemesher::PartSheets()
{
  Internals& s = *this->Stages;
  const vtkIdType all = s.Overlapping->GetNumberOfTuples();
  for (int i = 0; all > 0 && i < MostDrafts && s.ControlMap->GetHasGrownInFull(); ++i)
  {
    vtkPolyData* mesh = s.Mesher->GetOutput();
    vtkNew<vtkDoubleArray> places;
    places->DeepCopy(s.ControlMap->GetSizePlaces());
    stipple::CoarsePlaceCount count;
    if (!noted(
          s.addSizePlaces(mesh, DraftShare, places, nullptr, count), this->ErrorCode, s.Sentence))
    {
      return false;
    }
    if (count.overlaps == 0 && i > 0)
    {
      break;
    }
    // What comes up later is not seen here.
    const vtkIdType later = count.overlaps == 0 ? all : 0;
    places->InsertTuples(places->GetNumberOfTuples(), later, 0, s.Overlapping);
    s.ControlMap->SetSizePlaces(places);
    if (!this->RunMapsAndControl() || !this->RunStage(SAMPLING) || !this->RunStage(MESHING))
    {
      return false;
    }
  }
  return true;
}

/// Also finds how many points there will be.
bool vtkGeometryRemesher::RunMapsAndControl()
{
  Internals& s = *this->Stages;
  const int most = this->GetNumberOfPointsMaxValue();
  const bool isByLength = (s.ControlMap->GetEdgeLength() > 0. && !s.IsTried) ||
    ((s.ControlMap->GetSizeArrayName() || s.ControlMap->GetCurvaturePoints() > 0.) &&
      s.Points == 0);
  // By lengths: about so many; the control says it exactly.
  int points = s.Points > 0
    ? s.Points + s.numberOfGivenVertices()
    : static_cast<int>(std::min<vtkIdType>(s.Atlas->GetNumberOfSurfacePoints(), most));
  for (bool isFirst = true;; isFirst = false)
  {
    s.MapRenderer->SetNumberOfSamples(points);
    s.ControlMap->SetNumberOfSamples(isByLength ? 0 : points);
    if (!this->RunStage(MAPS) || !this->RunStage(CONTROL))
    {
      return false;
    }
    const double wanted = isByLength ? s.ControlMap->GetNumberOfWantedSamples() : points;
    if (wanted > most)
    {
      std::ostringstream sentence;
      constexpr double MostWritten = 1e15;
      if (wanted < MostWritten)
      {
        sentence << std::fixed << std::setprecision(0);
      }
      sentence << "Edges of these lengths take " << wanted << " points, more than " << most
               << ": ask for longer ones.";
      this->ErrorCode = BAD_INPUT;
      s.Sentence = sentence.str();
      return false;
    }
    const int before = points;
    points = std::max(1, static_cast<int>(std::lround(wanted)));
    if (!isFirst || points <= before) // maps are fine enough
    {
      break;
    }
  }
  s.Sampler->SetNumberOfSamples(points);
  s.Sampler->SetRaiseNumberOfSamples(this->NumberOfPoints == 0 || isByLength || s.IsTried);
  return true;
}

bool vtkGeometryRemesher::RunStagesAndCheck()
{
  Internals& s = *this->Stages;
  s.MayGrow = true;
  // Features of a base mesh may move as far as the mesh that it is subdivided to is fine; if no
  // sound one comes of that, as far as the base mesh is fine, or not at all.
  const int splits = this->Pattern == SEMIREGULAR ? s.Subdivider->GetNumberOfSubdivisions() : 0;
  const double finest = std::min(std::pow(0.5, splits), s.largestToleranceScale());
  s.ToleranceScale = finest;
  std::vector<double> otherScales =
    splits > 0 ? std::vector<double>{ 0., 1. } : std::vector<double>();
  int level = 0;
  s.IsUnsound = false;
  stipple::Status status = stipple::Status::success(); // of the mesh before
  for (;;)
  {
    s.Atlas->SetRefinementLevel(level);
    if (!this->RunStages())
    {
      // Maps that differ in density by more than numbers can tell places apart: other charts do.
      if (this->ErrorCode == INTERNAL_ERROR && level < s.Atlas->GetRefinementLevelMaxValue())
      {
        ++level;
        continue;
      }
      // A number that other charts and sizes ask for says nothing about those before.
      if (this->ErrorCode == TOO_FEW_POINTS)
      {
        s.IsUnsound = !noted(status, this->ErrorCode, s.Sentence);
      }
      return false;
    }
    status = s.check(this->Pattern == QUADS ? s.QuadMesher->GetOutput() : s.Optimizer->GetOutput());
    if (status.ok() && this->Pattern == SEMIREGULAR)
    {
      // Each level has four times the triangles, and about four times the points.
      const double points = s.Optimizer->GetOutput()->GetNumberOfPoints() *
        std::pow(4., s.Subdivider->GetNumberOfSubdivisions());
      if (points > this->GetNumberOfPointsMaxValue())
      {
        this->ErrorCode = BAD_INPUT;
        s.Sentence = "The mesh would have some " + inTwoDigits(points) +
          " points, of which there can be " + std::to_string(this->GetNumberOfPointsMaxValue()) +
          ": ask for fewer, or for fewer subdivisions.";
        return false;
      }
      if (!this->RunStage(RemesherStages::Subdivision))
      {
        return false;
      }
      status = s.check(s.Subdivider->GetOutput());
    }
    if (status.ok())
    {
      return true;
    }
    if (!status.isAbort() && !otherScales.empty())
    {
      s.ToleranceScale = otherScales.back();
      otherScales.pop_back();
      continue;
    }
    s.ToleranceScale = finest;
    const bool hasGrown = s.ControlMap->GetHasGrown();
    if (status.isAbort() || (!hasGrown && level == s.Atlas->GetRefinementLevelMaxValue()))
    {
      s.IsUnsound = !status.isAbort();
      return noted(status, this->ErrorCode, s.Sentence);
    }
    s.MayGrow = s.MayGrow && !hasGrown;
    level += hasGrown ? 0 : 1;
  }
}

/// Asks once more, for shorter edges where they are too long (coarsePlaces()). That mesh is kept if
/// it has fewer such places, and is no farther from the surface than shows, or than the first one.
bool vtkGeometryRemesher::RunStagesAndRefine()
{
  Internals& s = *this->Stages;
  s.Places->SetNumberOfTuples(0);
  s.Overlapping->SetNumberOfTuples(0);
  if (!this->RunStagesAndCheck())
  {
    return false;
  }
  const auto find = [&](vtkDoubleArray* overlapping, vtkDoubleArray* poor,
                      stipple::CoarsePlaceCount& count) {
    return noted(s.addSizePlaces(s.mesh(), s.finestShare(), overlapping, poor, count),
      this->ErrorCode, s.Sentence);
  };
  const auto measure = [&](double& distance) {
    return noted(s.measureVisibleDistance(distance), this->ErrorCode, s.Sentence);
  };
  vtkNew<vtkDoubleArray> poor;
  poor->SetNumberOfComponents(4);
  stipple::CoarsePlaceCount count;
  if (!find(s.Overlapping, poor, count))
  {
    return false;
  }
  s.NumberOfOverlaps = count.overlaps;
  // Where sizes do not grow, they do not from places either; where features have less than they ask
  // for, or the places are all over, points for them would be missed by others as poor.
  if (count.triangles == 0 || !s.sizesGrow() || !s.ControlMap->GetHasGrownInFull() ||
    count.triangles > RefinedShare * static_cast<double>(s.mesh()->GetNumberOfCells()))
  {
    return true;
  }
  double distance = 0.;
  if (!measure(distance))
  {
    return false;
  }
  const Internals::Made first = s.made();
  s.Places->DeepCopy(poor);
  if (this->RunStagesAndCheck())
  {
    stipple::CoarsePlaceCount countLeft;
    double distanceLeft = 0.;
    if (!find(nullptr, nullptr, countLeft) || (countLeft < count && !measure(distanceLeft)))
    {
      return false;
    }
    if (countLeft < count && distanceLeft <= distance)
    {
      s.NumberOfOverlaps = countLeft.overlaps;
      return true;
    }
  }
  else if (this->ErrorCode == ABORTED)
  {
    return false;
  }
  this->ErrorCode = 0;
  s.Sentence.clear();
  if (s.putBack(first))
  {
    return true;
  }
  s.Places->SetNumberOfTuples(0);
  s.Overlapping->SetNumberOfTuples(0);
  return this->RunStagesAndCheck();
}

/// made: the points of the mesh, without those that are given; 0 if there is none.
bool vtkGeometryRemesher::TryNumberOfPoints(int points, int& made)
{
  Internals& s = *this->Stages;
  made = 0;
  s.Points = points;
  s.IsTried = true;
  this->NumberOfPointsTried = points;
  s.ProgressFrom = s.ProgressTo;
  s.ProgressTo = 0.5 * (1. + s.ProgressTo);
  if (!this->RunStagesAndRefine())
  {
    return false;
  }
  made = s.numberOfPoints();
  return true;
}

/// Remeshes with the number of points that the area asks for, and with others until the edges are
/// as long as asked for, or as near as they get.
bool vtkGeometryRemesher::SearchEdgeLength()
{
  Internals& s = *this->Stages;
  s.ProgressTo = 0.9; // mostly it is the only one
  if (!this->RunStagesAndRefine())
  {
    return false;
  }
  const auto measure = [&] {
    stipple::TriangleSurface result = stipple::fromPolyData(s.mesh());
    result.connect();
    this->MedianEdgeLength = stipple::medianEdgeLength(result);
    return this->MedianEdgeLength;
  };
  const int first = s.numberOfPoints();
  int mesh = first; // of so many points is the last one
  stipple::EdgeLengthSearch search(s.ControlMap->GetEdgeLength());
  search.add(first, mesh, measure());
  Internals::Made best = s.made();
  while (const int points = search.next())
  {
    if (!this->TryNumberOfPoints(points, mesh))
    {
      if (this->ErrorCode == ABORTED)
      {
        return false;
      }
      this->ErrorCode = 0; // so many make no mesh
      s.Sentence.clear();
      break;
    }
    search.add(points, mesh, measure());
    if (mesh == search.found())
    {
      best = s.made();
    }
  }
  if (mesh == search.found())
  {
    return true;
  }
  if (s.putBack(best))
  {
    measure();
    return true;
  }
  s.IsTried = search.found() != first;
  s.Points = s.IsTried ? search.found() : this->NumberOfPoints;
  if (!this->RunStagesAndRefine())
  {
    return false;
  }
  measure();
  return true;
}

/// Remeshes with numbers of points until one holds the largest deviation.
bool vtkGeometryRemesher::SearchNumberOfPoints(vtkPolyData* input)
{
  Internals& s = *this->Stages;
  const auto fail = [&](const std::string& sentence) {
    this->ErrorCode = BAD_INPUT;
    s.Sentence = sentence;
    return false;
  };
  if (s.ControlMap->GetEdgeLength() > 0.)
  {
    return fail("A largest deviation excludes an edge length, which follows from it: set one of "
                "them to 0.");
  }
  stipple::TriangleSurface reference = stipple::fromPolyData(s.Part.part() ? s.Part.part() : input);
  const double diagonal = reference.boundingBoxDiagonal();
  if (!(diagonal > 0.) || !std::isfinite(diagonal))
  {
    return this->RunStagesAndRefine(); // they say what is wrong, or make nothing of nothing
  }
  double wanted = std::numeric_limits<double>::infinity();
  for (const double bound :
    { 0.01 * this->MaximumDeviation * diagonal, this->MaximumDeviationLength })
  {
    wanted = bound > 0. ? std::min(wanted, bound) : wanted;
  }
  // Other numbers cannot keep the bounds on lengths, with a percent for what pixels are off.
  const auto pointsOf = [&](double length, double none, double share) {
    return length > 0. ? share * reference.area() * stipple::densityOfEdges(length) : none;
  };
  // No more than the input has, which may be flat.
  const double first = std::min(
    stipple::pointsOfSphere(diagonal, wanted), static_cast<double>(reference.points.size()));
  const double all = this->GetNumberOfPointsMaxValue();
  const double most = std::min(all, pointsOf(s.ControlMap->GetSizeMinimum(), all, 0.99));
  stipple::DeviationSearch search(
    wanted, first, pointsOf(s.ControlMap->GetSizeMaximum(), 1., 1.01), most);
  int mesh = 0; // of so many points is the last one
  s.ProgressTo = 0.;
  const auto report = [this](double) { return this->AbortExecute == 0; };
  // A feature that goes to another one takes the mesh as far from the surface.
  s.FarthestFeature = wanted;
  s.Area = reference.area();
  double reached = 0;
  Internals::Made best;
  while (const int points = search.next())
  {
    if (!this->TryNumberOfPoints(points, mesh))
    {
      if (this->ErrorCode != TOO_FEW_POINTS)
      {
        return false;
      }
      this->ErrorCode = 0;
      s.Sentence.clear();
      search.add(points, points, std::numeric_limits<double>::infinity());
      continue;
    }
    const stipple::TriangleSurface result = stipple::fromPolyData(s.mesh());
    stipple::DeviationBounds bounds;
    if (!stipple::surfaceDeviation(result, reference, 1e-3 * wanted, report, bounds).ok())
    {
      this->ErrorCode = ABORTED;
      return false;
    }
    reached = bounds.upper <= wanted ? bounds.upper : reached;
    search.add(points, mesh, bounds.upper);
    if (mesh == search.found())
    {
      best = s.made();
    }
  }
  if (search.found() == 0)
  {
    std::ostringstream sentence;
    sentence << "No mesh that was tried deviates from the input by at most "
             << 100. * wanted / diagonal << " % of its diagonal, the nearest one does by "
             << 100. * search.nearest() / diagonal << " %";
    if (search.tooMany() > 0.)
    {
      sentence << ", and it takes at least some " << inTwoDigits(search.tooMany())
               << " points, of which there can be " << static_cast<int>(most);
    }
    sentence << ": allow a larger deviation" << (most < all ? ", or shorter edges." : ".");
    return fail(sentence.str());
  }
  this->Deviation = 100. * reached / diagonal;
  if (mesh != search.found() && s.putBack(best))
  {
    return true;
  }
  return mesh == search.found() || this->TryNumberOfPoints(search.found(), mesh);
}

int vtkGeometryRemesher::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& s = *this->Stages;
  this->ErrorCode = 0;
  s.Stopped = false;
  s.Seconds.fill(0.);
  s.Sentence.clear();
  s.Points = this->NumberOfPoints;
  s.IsTried = false;
  s.FarthestFeature = 0.;
  s.ProgressFrom = 0.;
  s.ProgressTo = 1.;
  this->Deviation = 0.;
  this->MedianEdgeLength = 0.;
  s.NumberOfOverlaps = 0;
  this->NumberOfPointsTried = 0;
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (!input || input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    return 1;
  }
  const bool done = this->TakeInput(input) &&
    (this->MaximumDeviation > 0. || this->MaximumDeviationLength > 0.
        ? this->SearchNumberOfPoints(input)
        : s.hasOneEdgeLength() ? this->SearchEdgeLength()
                               : this->RunStagesAndRefine());
  this->NumberOfPointsTried = 0;
  if (done)
  {
    vtkAlgorithm* last = s.last(this->Pattern);
    const std::array<vtkDataObject*, 7> results = { { last->GetOutputDataObject(0),
      last->GetOutputDataObject(1), s.Atlas->GetOutputDataObject(0),
      s.Atlas->GetOutputDataObject(1), s.ControlMap->GetOutputDataObject(0),
      s.Sampler->GetOutputDataObject(0), s.Sampler->GetOutputDataObject(1) } };
    for (int port = 0; port < 7; ++port)
    {
      vtkDataObject::GetData(outputVector, port)->ShallowCopy(results[port]);
    }
    if (s.Part.part())
    {
      if (!noted(s.Part.join(vtkPolyData::SafeDownCast(results[0]),
                   vtkPolyData::GetData(outputVector, 1), vtkPolyData::GetData(outputVector, 0)),
            this->ErrorCode, s.Sentence))
      {
        vtkErrorMacro(<< s.Sentence);
        return 0;
      }
    }
    // Names of regions, materials, units: what the input says of itself as a whole.
    vtkFieldData* whole = vtkPolyData::GetData(outputVector)->GetFieldData();
    for (int i = 0; i < input->GetFieldData()->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = input->GetFieldData()->GetAbstractArray(i);
      if (!array->GetName() || !whole->HasArray(array->GetName()))
      {
        whole->AddArray(array);
      }
    }
    // On the way the active texture coordinates were the charts' parameters.
    vtkDataArray* texture = input->GetPointData()->GetTCoords();
    if (texture && texture->GetName())
    {
      vtkPolyData::GetData(outputVector)->GetPointData()->SetActiveTCoords(texture->GetName());
    }
    // Of points that are others: normals, which differ across creases that have one point now, and
    // numbers that no two points have.
    vtkPointData* points = vtkPolyData::GetData(outputVector)->GetPointData();
    points->SetNormals(nullptr);
    points->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
    return 1;
  }
  s.Stopped = this->ErrorCode == ABORTED;
  if (this->ErrorCode != 0 && !s.Stopped)
  {
    vtkErrorMacro(<< s.Sentence);
  }
  return this->ErrorCode == 0 || s.Stopped ? 1 : 0;
}

int vtkGeometryRemesher::GetLeastNumberOfPoints()
{
  Internals& s = *this->Stages;
  return s.IsUnsound
    ? 0
    : std::max(0, s.Sampler->GetMinimumNumberOfSamples() - s.numberOfGivenVertices());
}

int vtkGeometryRemesher::GetNumberOfOverlaps()
{
  return this->Stages->NumberOfOverlaps;
}

int vtkGeometryRemesher::GetNumberOfGivenPoints()
{
  return this->Stages->numberOfGivenVertices();
}

std::string vtkGeometryRemesher::GetOptionTable()
{
  return stipple::optionTableText();
}

double vtkGeometryRemesher::GetStageSeconds(int stage)
{
  return stage >= 0 && stage < RemesherStages::NumberOfStages ? this->Stages->Seconds[stage] : 0.;
}

// Parameters that live in the stages.
#define stippleForward(stage, name, type)                                                          \
  type vtkGeometryRemesher::Get##name()                                                            \
  {                                                                                                \
    return this->Stages->stage->Get##name();                                                       \
  }                                                                                                \
  void vtkGeometryRemesher::Set##name(type value)                                                  \
  {                                                                                                \
    this->Stages->stage->Set##name(value);                                                         \
  }
#define stippleForwardChoice(stage, name, choice)                                                  \
  void vtkGeometryRemesher::Set##name##To##choice()                                                \
  {                                                                                                \
    this->Stages->stage->Set##name##To##choice();                                                  \
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
  return this->Stages->Sampler->GetNumberOfSamplesMaxValue();
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
  return this->Stages->Atlas;
}

vtkGeometryMapRenderer* vtkGeometryRemesher::GetMapRenderer()
{
  return this->Stages->MapRenderer;
}

vtkControlMap* vtkGeometryRemesher::GetControlMap()
{
  return this->Stages->ControlMap;
}

vtkErrorDiffusionSampler* vtkGeometryRemesher::GetSampler()
{
  return this->Stages->Sampler;
}

vtkCDTRemesh* vtkGeometryRemesher::GetMesher()
{
  return this->Stages->Mesher;
}

vtkRemeshOptimizer* vtkGeometryRemesher::GetOptimizer()
{
  return this->Stages->Optimizer;
}

vtkQuadRemesh* vtkGeometryRemesher::GetQuadMesher()
{
  return this->Stages->QuadMesher;
}

vtkSemiRegularSubdivision* vtkGeometryRemesher::GetSubdivision()
{
  return this->Stages->Subdivider;
}

void vtkGeometryRemesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "MaximumDeviation: " << this->MaximumDeviation << "\n";
  os << indent << "MaximumDeviationLength: " << this->MaximumDeviationLength << "\n";
  os << indent << "Deviation: " << this->Deviation << "\n";
  os << indent << "MedianEdgeLength: " << this->MedianEdgeLength << "\n";
  os << indent << "NumberOfOverlaps: " << this->Stages->NumberOfOverlaps << "\n";
  os << indent << "NumberOfPointsTried: " << this->NumberOfPointsTried << "\n";
  os << indent << "Pattern: " << this->Pattern << "\n";
  os << indent
     << "SelectionArrayName: " << (this->SelectionArrayName ? this->SelectionArrayName : "(none)")
     << "\n";
  for (int a = 0; a < RemesherStages::NumberOfAlgorithms; ++a)
  {
    os << indent << "The " << RemesherStages::nameOf(a);
    if (a < RemesherStages::NumberOfStages)
    {
      os << " (" << this->Stages->Seconds[a] << " s)";
    }
    os << ":\n";
    this->Stages->InOrder[a]->PrintSelf(os, indent.GetNextIndent());
  }
}
