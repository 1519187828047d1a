// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConformalAtlas.h"

#include "AtlasSurface.h"
#include "ChartPartition.h"
#include "ChartWriter.h"
#include "Curvature.h"
#include "FeatureCurves.h"
#include "FeatureDetection.h"
#include "FeatureGraphBuilder.h"
#include "FilterExecution.h"
#include "FlatFaces.h"
#include "LongEdges.h"
#include "NormalCurvature.h"
#include "RegionArrays.h"
#include "SurfaceArrays.h"
#include "SurfaceRepair.h"
#include "TextureSeams.h"
#include "UserArrays.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkConformalAtlas);
vtkCxxSetObjectMacro(vtkConformalAtlas, FeatureEdges, vtkIdTypeArray);
vtkCxxSetObjectMacro(vtkConformalAtlas, FixedEdges, vtkIdTypeArray);
vtkCxxSetObjectMacro(vtkConformalAtlas, FixedPoints, vtkIdTypeArray);
vtkCxxSetObjectMacro(vtkConformalAtlas, SharpEdges, vtkIdTypeArray);
vtkCxxSetObjectMacro(vtkConformalAtlas, FeatureCurves, vtkPolyData);
vtkCxxSetObjectMacro(vtkConformalAtlas, Constraints, vtkPoints);
vtkCxxSetObjectMacro(vtkConformalAtlas, ChartConstraints, vtkDoubleArray);

namespace
{
/// Marks edges that users name by the input's points. `what` they are called in errors.
stipple::Status keepEdges(vtkIdTypeArray* edges, const std::string& what, stipple::Keep keep,
  const stipple::RepairedSurface& repaired, stipple::CutSurface& surface)
{
  if (edges->GetNumberOfComponents() != 2)
  {
    return stipple::Status::error(what +
      " edges need two components, the ids of the points that "
      "they join, not " +
      std::to_string(edges->GetNumberOfComponents()) + ".");
  }
  // By the input's point that a vertex was made of: one that was split is several vertices.
  std::map<std::pair<int, int>, std::vector<stipple::Halfedge>> halfedges;
  for (const stipple::Halfedge h : surface.halfedges())
  {
    halfedges[std::minmax(repaired.sourcePoint[surface.tail(h).index()],
                repaired.sourcePoint[surface.head(h).index()])]
      .push_back(h);
  }
  const auto number = static_cast<vtkIdType>(repaired.pointOfInput.size());
  const auto source = [&](vtkIdType id) {
    const int p = id >= 0 && id < number ? repaired.pointOfInput[id] : -1;
    return p < 0 ? -1 : repaired.sourcePoint[p];
  };
  for (vtkIdType i = 0; i < edges->GetNumberOfTuples(); ++i)
  {
    const vtkIdType a = edges->GetTypedComponent(i, 0);
    const vtkIdType b = edges->GetTypedComponent(i, 1);
    const auto found = halfedges.find(std::minmax(source(a), source(b)));
    if (found == halfedges.end())
    {
      return stipple::Status::error(what + " edge " + std::to_string(i) + " joins the points " +
        std::to_string(a) + " and " + std::to_string(b) + ", which no edge of the input joins.");
    }
    for (const stipple::Halfedge h : found->second)
    {
      surface.setSharp(h, true);
      surface.setKeep(h, keep);
    }
  }
  return stipple::Status::success();
}

/// Marks the points where fixed edges have vertices: all points that were made of the input's.
stipple::Status markFixedPoints(
  vtkIdTypeArray* points, const stipple::RepairedSurface& repaired, stipple::CutSurface& surface)
{
  std::vector<char> isFixed(repaired.pointOfInput.size(), 0); // by the input's point
  const auto number = static_cast<vtkIdType>(repaired.pointOfInput.size());
  for (vtkIdType i = 0; i < points->GetNumberOfValues(); ++i)
  {
    const vtkIdType id = points->GetValue(i);
    const int p = id >= 0 && id < number ? repaired.pointOfInput[id] : -1;
    if (p < 0)
    {
      return stipple::Status::error("Fixed point " + std::to_string(i) + " is point " +
        std::to_string(id) + ", which is in no triangle of the input.");
    }
    isFixed[repaired.sourcePoint[p]] = 1;
  }
  surface.isFixedPoint.clear();
  for (const int p : repaired.sourcePoint)
  {
    surface.isFixedPoint.push_back(isFixed[p]);
  }
  return stipple::Status::success();
}

/// Marks the edges between regions.
stipple::Status markRegionBorders(
  vtkPolyData* input, const char* name, stipple::CutSurface& surface)
{
  vtkAbstractArray* labels = nullptr;
  if (stipple::Status status = stipple::findRegions(input, name, labels); !status.ok())
  {
    return status;
  }
  const std::vector<int> region = stipple::numberRegions(labels);
  const auto regionOf = [&](stipple::Halfedge h) {
    return region[surface.sourceCell[faceOf(h).index()]];
  };
  for (const stipple::Halfedge h : surface.halfedges())
  {
    if (!surface.isBoundary(h) && regionOf(h) != regionOf(surface.twin[h]))
    {
      surface.setKeep(h, stipple::Keep::Border);
    }
  }
  return stipple::Status::success();
}

/// The input with the largest normal curvature of its cells, the mean by area of their triangles.
vtkSmartPointer<vtkPolyData> withNormalCurvature(
  vtkPolyData* input, const stipple::CutSurface& surface)
{
  const std::vector<double> curvature = stipple::largestNormalCurvature(surface);
  const vtkIdType cells = input->GetNumberOfCells();
  std::vector<double> area(static_cast<std::size_t>(cells), 0.);
  vtkNew<vtkDoubleArray> ofCell;
  ofCell->SetName("LargestNormalCurvature");
  ofCell->SetNumberOfValues(cells);
  ofCell->FillValue(0.);
  for (const stipple::Face f : surface.faces())
  {
    const int cell = surface.sourceCell[f.index()];
    const double before = area[cell];
    area[cell] += surface.faceArea(f);
    const double share = area[cell] > 0 ? 1. - before / area[cell] : 1.;
    ofCell->SetValue(cell, (1. - share) * ofCell->GetValue(cell) + share * curvature[f.index()]);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(input);
  result->GetCellData()->AddArray(ofCell);
  return result;
}
}

/// One execution: it runs on a thread of its own, while the filter's thread reports.
struct vtkConformalAtlas::Work
{
  vtkConformalAtlas* Self;
  vtkPolyData* Input;
  vtkPartitionedDataSetCollection* Charts;
  vtkPolyData* Graph;

  stipple::Status run(const stipple::Progress& progress);

private:
  void count(const stipple::RepairedSurface& repaired);
  stipple::Status markFeatures(const stipple::RepairedSurface& repaired,
    const stipple::FeatureDetectionOptions& detection, stipple::CutSurface& surface,
    const stipple::Progress& progress);
  /// Flat faces and long edges; what lies on flat faces is for charts to know.
  stipple::FlatFaceCells triangulate(
    const stipple::RepairedSurface& repaired, stipple::CutSurface& surface);
  stipple::Status constrain(const stipple::CutSurface& surface,
    const std::vector<stipple::FlatChart>& flat, const std::vector<int>& tips,
    stipple::FeatureGraph& graph);
};

vtkConformalAtlas::vtkConformalAtlas()
{
  this->SetNumberOfOutputPorts(2);
}

vtkConformalAtlas::~vtkConformalAtlas()
{
  this->SetRegionArrayName(nullptr);
  this->SetFeatureEdges(nullptr);
  this->SetFixedEdges(nullptr);
  this->SetFixedPoints(nullptr);
  this->SetSharpEdges(nullptr);
  this->SetFeatureCurves(nullptr);
  this->SetConstraints(nullptr);
  this->SetChartConstraints(nullptr);
}

vtkIdTypeArray* vtkConformalAtlas::GetFeatureEdges() const
{
  return this->FeatureEdges;
}

vtkIdTypeArray* vtkConformalAtlas::GetFixedEdges() const
{
  return this->FixedEdges;
}

vtkIdTypeArray* vtkConformalAtlas::GetFixedPoints() const
{
  return this->FixedPoints;
}

vtkIdTypeArray* vtkConformalAtlas::GetSharpEdges() const
{
  return this->SharpEdges;
}

vtkPolyData* vtkConformalAtlas::GetFeatureCurves() const
{
  return this->FeatureCurves;
}

vtkPoints* vtkConformalAtlas::GetConstraints() const
{
  return this->Constraints;
}

vtkDoubleArray* vtkConformalAtlas::GetChartConstraints() const
{
  return this->ChartConstraints;
}

vtkMTimeType vtkConformalAtlas::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* object :
    { static_cast<vtkObject*>(this->FeatureEdges), static_cast<vtkObject*>(this->FixedEdges),
      static_cast<vtkObject*>(this->FixedPoints), static_cast<vtkObject*>(this->SharpEdges),
      static_cast<vtkObject*>(this->FeatureCurves), static_cast<vtkObject*>(this->Constraints),
      static_cast<vtkObject*>(this->ChartConstraints) })
  {
    if (object)
    {
      time = std::max(time, object->GetMTime());
    }
  }
  return time;
}

int vtkConformalAtlas::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkConformalAtlas::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPartitionedDataSetCollection" : "vtkPolyData");
  return 1;
}

int vtkConformalAtlas::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->DensityRatio = 0;
  this->NumberOfFallbackCharts = 0;
  Work work = { this, vtkPolyData::GetData(inputVector[0]),
    vtkPartitionedDataSetCollection::GetData(outputVector, 0),
    vtkPolyData::GetData(outputVector, 1) };
  const int result = stipple::execute(
    this, this->ErrorCode, [&](const stipple::Progress& progress) { return work.run(progress); });
  if (this->ErrorCode == 0 && this->DensityRatio > this->MaximumDensityRatio)
  {
    vtkWarningMacro(<< "The density ratio of a chart is " << this->DensityRatio << ", more than "
                    << this->MaximumDensityRatio
                    << ": it has so few of the input's triangles that splitting it does not help. "
                       "Points may be badly placed there; subdivide the input first.");
  }
  return result;
}

stipple::Status vtkConformalAtlas::Work::run(const stipple::Progress& progress)
{
  const auto part = [&](double from, double to) -> stipple::Progress {
    return [&progress, from, to](double f) { return progress(from + (to - from) * f); };
  };
  for (stipple::Status status : { stipple::checkAttributes(this->Input->GetPointData(),
                                    this->Input->GetNumberOfPoints(), "points", "the input"),
         stipple::checkAttributes(
           this->Input->GetCellData(), this->Input->GetNumberOfCells(), "cells", "the input") })
  {
    if (!status.ok())
    {
      return status;
    }
  }
  stipple::RepairedSurface repaired;
  if (stipple::Status status = stipple::repairSurface(this->Input, repaired, part(0., 0.1));
      !status.ok())
  {
    return status;
  }
  this->count(repaired);
  if (repaired.surface.numberOfFaces() == 0)
  {
    return stipple::Status::success();
  }
  const stipple::Curvature curvature =
    stipple::computeCurvature(repaired.surface, [&] { return !progress(0.1); });
  if (!progress(0.1))
  {
    return stipple::Status::aborted();
  }
  stipple::CutSurface surface(repaired.surface, repaired.sourceCell);
  std::optional<stipple::TextureSeams> texture;
  if (this->Self->KeepTextureSeams)
  {
    vtkDataArray* coordinates = this->Input->GetPointData()->GetTCoords();
    if (!coordinates || coordinates->GetNumberOfComponents() < 2)
    {
      return stipple::Status::error(
        "The input has no texture coordinates, two numbers a point, whose seams could be kept.");
    }
    texture.emplace(this->Input, repaired);
    texture->mark(surface);
  }
  stipple::FeatureDetectionOptions detection;
  detection.angle = this->Self->FeatureAngle;
  detection.minimumLength = this->Self->MinimumFeatureLength;
  detection.roundedWidth = this->Self->RoundedEdgeWidth;
  if (stipple::Status status = this->markFeatures(repaired, detection, surface, part(0.1, 0.15));
      !status.ok())
  {
    return status;
  }
  if (!progress(0.15))
  {
    return stipple::Status::aborted();
  }
  vtkSmartPointer<vtkPolyData> input = this->Input;
  if (this->Self->MeasureNormalCurvature)
  {
    input = withNormalCurvature(this->Input, surface); // before edges are split, which lie flat
  }
  const std::vector<int> tips = stipple::findTips(surface, detection);
  if (!progress(0.15))
  {
    return stipple::Status::aborted();
  }
  const stipple::FlatFaceCells flatFaces = this->triangulate(repaired, surface);

  stipple::ChartPartitionOptions options;
  options.numberOfCharts = this->Self->NumberOfCharts;
  options.maximumDensityRatio =
    std::max(2., this->Self->MaximumDensityRatio * std::pow(0.1, this->Self->RefinementLevel));
  options.square = this->Self->DomainShape == SQUARE;
  options.placement = static_cast<stipple::BoundaryPlacement>(this->Self->BoundaryPlacement);
  std::vector<stipple::FlatChart> flat;
  if (stipple::Status status = stipple::partitionSurface(surface, options, flat, part(0.15, 0.9));
      !status.ok())
  {
    return status;
  }
  for (const stipple::FlatChart& chart : flat)
  {
    this->Self->DensityRatio = std::max(this->Self->DensityRatio, chart.map.densityRatio);
    this->Self->NumberOfFallbackCharts += chart.map.fallback;
  }

  stipple::FeatureGraph graph = stipple::buildFeatureGraph(surface, this->Self->CornerAngle, tips);
  stipple::measureRoundedEdges(surface, stipple::roundedEdgeOptions(surface, detection), graph);
  stipple::measureCorrugations(surface, stipple::corrugationOptions(surface, detection), graph);
  graph.regionArray = this->Self->RegionArrayName ? this->Self->RegionArrayName : "";
  if (stipple::Status status = this->constrain(surface, flat, tips, graph); !status.ok())
  {
    return status;
  }
  if (stipple::Status status = stipple::writeCharts(
        input, repaired, surface, flat, curvature, flatFaces, this->Charts, part(0.9, 1.));
      !status.ok())
  {
    return status;
  }
  if (texture)
  {
    unsigned int c = 0;
    for (const auto& corners : texture->corners(surface, flat))
    {
      stipple::chartOf(this->Charts, c++)->GetCellData()->AddArray(corners);
    }
  }
  this->Graph->ShallowCopy(stipple::toPolyData(graph, surface.points));
  return stipple::Status::success();
}

stipple::FlatFaceCells vtkConformalAtlas::Work::triangulate(
  const stipple::RepairedSurface& repaired, stipple::CutSurface& surface)
{
  // What is to be a vertex exactly stays where it is.
  const std::set<int> held = this->Self->Constraints
    ? stipple::nearestCells(repaired, this->Self->Constraints)
    : std::set<int>();
  std::vector<std::pair<int, int>> joined;
  const auto flip = [&] {
    std::optional<stipple::ArraysOverEdges> arrays; // of use to flat slivers alone
    const auto isHeld = [&](stipple::Halfedge h) {
      return held.count(surface.sourceCell[stipple::faceOf(h).index()]) > 0;
    };
    const auto pairs =
      stipple::triangulateFlatFaces(surface, [&](stipple::Halfedge h, double s, double t) {
        if (!arrays)
        {
          arrays.emplace(this->Input, repaired, surface);
        }
        return !isHeld(h) && !isHeld(surface.twin[h]) && arrays->allowFlip(h, s, t);
      });
    joined.insert(joined.end(), pairs.begin(), pairs.end());
  };
  flip();
  if (stipple::splitLongEdges(surface, stipple::longestEdgeForCharts(surface)) > 0)
  {
    flip();
  }
  return stipple::flatFaceCells(repaired, joined);
}

void vtkConformalAtlas::Work::count(const stipple::RepairedSurface& repaired)
{
  const stipple::RepairCounts& counts = repaired.counts;
  this->Self->NumberOfWeldedPoints = counts.weldedPoints;
  this->Self->NumberOfUnusedPoints = counts.unusedPoints;
  this->Self->NumberOfDegenerateTriangles = counts.degenerateTriangles;
  this->Self->NumberOfDuplicateTriangles = counts.duplicateTriangles;
  this->Self->NumberOfReorientedTriangles = counts.reorientedTriangles;
  this->Self->NumberOfSplitEdges = counts.splitEdges;
  this->Self->NumberOfSplitVertices = counts.splitVertices;
  const stipple::SurfaceTopology topology = repaired.surface.topology();
  this->Self->NumberOfSurfacePoints = static_cast<vtkIdType>(repaired.surface.points.size());
  this->Self->NumberOfSurfaceTriangles = repaired.surface.numberOfFaces();
  this->Self->NumberOfComponents = topology.components;
  this->Self->NumberOfBoundaryLoops = topology.boundaryLoops;
  this->Self->EulerCharacteristic = topology.euler;
}

stipple::Status vtkConformalAtlas::Work::markFeatures(const stipple::RepairedSurface& repaired,
  const stipple::FeatureDetectionOptions& detection, stipple::CutSurface& surface,
  const stipple::Progress& progress)
{
  stipple::detectFeatures(surface, detection, repaired.joints);
  if (this->Self->FeatureEdges)
  {
    if (stipple::Status status =
          keepEdges(this->Self->FeatureEdges, "Feature", stipple::Keep::Line, repaired, surface);
        !status.ok())
    {
      return status;
    }
  }
  if (this->Self->FixedEdges)
  {
    if (stipple::Status status =
          keepEdges(this->Self->FixedEdges, "Fixed", stipple::Keep::Edges, repaired, surface);
        !status.ok())
    {
      return status;
    }
  }
  if (this->Self->FixedPoints)
  {
    if (stipple::Status status = markFixedPoints(this->Self->FixedPoints, repaired, surface);
        !status.ok())
    {
      return status;
    }
  }
  if (this->Self->SharpEdges)
  {
    if (stipple::Status status =
          keepEdges(this->Self->SharpEdges, "Sharp", stipple::Keep::Nothing, repaired, surface);
        !status.ok())
    {
      return status;
    }
  }
  if (this->Self->RegionArrayName)
  {
    if (stipple::Status status =
          markRegionBorders(this->Input, this->Self->RegionArrayName, surface);
        !status.ok())
    {
      return status;
    }
  }
  if (this->Self->FeatureCurves)
  {
    return stipple::insertFeatureCurves(surface, this->Self->FeatureCurves, progress);
  }
  return stipple::Status::success();
}

stipple::Status vtkConformalAtlas::Work::constrain(const stipple::CutSurface& surface,
  const std::vector<stipple::FlatChart>& flat, const std::vector<int>& tips,
  stipple::FeatureGraph& graph)
{
  if (this->Self->Constraints)
  {
    if (stipple::Status status =
          stipple::locateConstraints(surface, flat, this->Self->Constraints, graph.constraints);
        !status.ok())
    {
      return status;
    }
  }
  if (this->Self->ChartConstraints)
  {
    if (stipple::Status status = stipple::locateChartConstraints(
          surface, flat, this->Self->ChartConstraints, graph.constraints);
        !status.ok())
    {
      return status;
    }
  }
  std::vector<int> tipsInside;
  std::copy_if(tips.begin(), tips.end(), std::back_inserter(tipsInside),
    [&](int p) { return !graph.isCorner[p]; });
  stipple::constrainPoints(surface, flat, tipsInside, graph.constraints);
  return stipple::Status::success();
}

void vtkConformalAtlas::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MinimumFeatureLength: " << this->MinimumFeatureLength << "\n";
  os << indent << "RoundedEdgeWidth: " << this->RoundedEdgeWidth << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "FeatureEdges: " << this->FeatureEdges << "\n";
  os << indent << "FixedEdges: " << this->FixedEdges << "\n";
  os << indent << "FixedPoints: " << this->FixedPoints << "\n";
  os << indent << "SharpEdges: " << this->SharpEdges << "\n";
  os << indent << "FeatureCurves: " << this->FeatureCurves << "\n";
  os << indent << "ChartConstraints: " << this->ChartConstraints << "\n";
  os << indent << "Constraints: " << this->Constraints << "\n";
  os << indent << "KeepTextureSeams: " << this->KeepTextureSeams << "\n";
  os << indent << "RegionArrayName: " << (this->RegionArrayName ? this->RegionArrayName : "(none)")
     << "\n";
  os << indent << "NumberOfCharts: " << this->NumberOfCharts << "\n";
  os << indent << "MaximumDensityRatio: " << this->MaximumDensityRatio << "\n";
  os << indent << "RefinementLevel: " << this->RefinementLevel << "\n";
  os << indent << "MeasureNormalCurvature: " << this->MeasureNormalCurvature << "\n";
  os << indent << "BoundaryPlacement: " << this->BoundaryPlacement << "\n";
  os << indent << "DomainShape: " << (this->DomainShape == SQUARE ? "SQUARE" : "RECTANGLE") << "\n";
  os << indent << "NumberOfWeldedPoints: " << this->NumberOfWeldedPoints << "\n";
  os << indent << "NumberOfUnusedPoints: " << this->NumberOfUnusedPoints << "\n";
  os << indent << "NumberOfDegenerateTriangles: " << this->NumberOfDegenerateTriangles << "\n";
  os << indent << "NumberOfDuplicateTriangles: " << this->NumberOfDuplicateTriangles << "\n";
  os << indent << "NumberOfReorientedTriangles: " << this->NumberOfReorientedTriangles << "\n";
  os << indent << "NumberOfSplitEdges: " << this->NumberOfSplitEdges << "\n";
  os << indent << "NumberOfSplitVertices: " << this->NumberOfSplitVertices << "\n";
  os << indent << "NumberOfSurfacePoints: " << this->NumberOfSurfacePoints << "\n";
  os << indent << "NumberOfSurfaceTriangles: " << this->NumberOfSurfaceTriangles << "\n";
  os << indent << "NumberOfComponents: " << this->NumberOfComponents << "\n";
  os << indent << "NumberOfBoundaryLoops: " << this->NumberOfBoundaryLoops << "\n";
  os << indent << "EulerCharacteristic: " << this->EulerCharacteristic << "\n";
  os << indent << "DensityRatio: " << this->DensityRatio << "\n";
  os << indent << "NumberOfFallbackCharts: " << this->NumberOfFallbackCharts << "\n";
}
