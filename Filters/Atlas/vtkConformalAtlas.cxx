// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConformalAtlas.h"

#include "ChartPartition.h"
#include "ChartWriter.h"
#include "Curvature.h"
#include "FeatureCurves.h"
#include "FeatureDetection.h"
#include "FeatureGraphBuilder.h"
#include "LongEdges.h"
#include "SurfaceRepair.h"
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
#include <iterator>

vtkStandardNewMacro(vtkConformalAtlas);
vtkCxxSetObjectMacro(vtkConformalAtlas, FeatureEdges, vtkIdTypeArray);
vtkCxxSetObjectMacro(vtkConformalAtlas, FeatureCurves, vtkPolyData);
vtkCxxSetObjectMacro(vtkConformalAtlas, Constraints, vtkPoints);
vtkCxxSetObjectMacro(vtkConformalAtlas, ChartConstraints, vtkDoubleArray);

namespace
{
/// Marks the user's edges as sharp.
stipple::Status tagFeatureEdges(
  vtkIdTypeArray* edges, const stipple::RepairedSurface& repaired, stipple::CutSurface& surface)
{
  const auto first = surface.vertexHalfedges();
  const auto number = static_cast<vtkIdType>(repaired.pointOfInput.size());
  for (vtkIdType i = 0; i < edges->GetNumberOfTuples(); ++i)
  {
    const vtkIdType a = edges->GetTypedComponent(i, 0);
    const vtkIdType b = edges->GetTypedComponent(i, 1);
    bool found = false;
    if (a >= 0 && b >= 0 && a < number && b < number)
    {
      const stipple::Vertex p{ repaired.pointOfInput[a] };
      const stipple::Vertex q{ repaired.pointOfInput[b] };
      stipple::Halfedge h;
      if (p.valid() && q.valid())
      {
        h = stipple::findHalfedge(surface, first, p, q);
        h = h.valid() ? h : stipple::findHalfedge(surface, first, q, p);
      }
      found = h.valid();
      if (found)
      {
        surface.setSharp(h.index(), true);
      }
    }
    if (!found)
    {
      return stipple::Status::error("Feature edge " + std::to_string(i) + " joins the points " +
        std::to_string(a) + " and " + std::to_string(b) + ", which no edge of the input joins.");
    }
  }
  return stipple::Status::success();
}
}

vtkConformalAtlas::vtkConformalAtlas()
{
  this->SetNumberOfOutputPorts(2);
}

vtkConformalAtlas::~vtkConformalAtlas()
{
  this->SetFeatureEdges(nullptr);
  this->SetFeatureCurves(nullptr);
  this->SetConstraints(nullptr);
  this->SetChartConstraints(nullptr);
}

vtkIdTypeArray* vtkConformalAtlas::GetFeatureEdges() const
{
  return this->FeatureEdges;
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
    { static_cast<vtkObject*>(this->FeatureEdges), static_cast<vtkObject*>(this->FeatureCurves),
      static_cast<vtkObject*>(this->Constraints), static_cast<vtkObject*>(this->ChartConstraints) })
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
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPartitionedDataSetCollection* charts =
    vtkPartitionedDataSetCollection::GetData(outputVector, 0);
  vtkPolyData* graphOutput = vtkPolyData::GetData(outputVector, 1);
  const auto fail = [&](const stipple::Status& status) {
    charts->Initialize();
    graphOutput->Initialize();
    if (!status.isAbort())
    {
      vtkErrorMacro(<< status.message());
    }
    return 0;
  };
  const auto progressIn = [this](double from, double to) {
    return [this, from, to](double fraction) {
      // Splitting a chart makes new work: better to wait than to go back.
      this->UpdateProgress(std::max(this->GetProgress(), from + (to - from) * fraction));
      return !this->GetAbortExecute();
    };
  };

  for (const stipple::Status& status : { stipple::checkAttributes(input->GetPointData(),
                                           input->GetNumberOfPoints(), "points", "the input"),
         stipple::checkAttributes(
           input->GetCellData(), input->GetNumberOfCells(), "cells", "the input") })
  {
    if (!status.ok())
    {
      return fail(status);
    }
  }
  stipple::RepairedSurface repaired;
  if (const stipple::Status status = stipple::repairSurface(input, repaired); !status.ok())
  {
    return fail(status);
  }
  const stipple::RepairCounts& counts = repaired.counts;
  this->NumberOfWeldedPoints = counts.weldedPoints;
  this->NumberOfUnusedPoints = counts.unusedPoints;
  this->NumberOfDegenerateTriangles = counts.degenerateTriangles;
  this->NumberOfDuplicateTriangles = counts.duplicateTriangles;
  this->NumberOfReorientedTriangles = counts.reorientedTriangles;
  this->NumberOfSplitEdges = counts.splitEdges;
  this->NumberOfSplitVertices = counts.splitVertices;
  const stipple::SurfaceTopology topology = repaired.surface.topology();
  this->NumberOfSurfacePoints = static_cast<vtkIdType>(repaired.surface.points.size());
  this->NumberOfSurfaceTriangles = repaired.surface.numberOfFaces();
  this->NumberOfComponents = topology.components;
  this->NumberOfBoundaryLoops = topology.boundaryLoops;
  this->EulerCharacteristic = topology.euler;
  this->DensityRatio = 0;
  this->NumberOfFallbackCharts = 0;
  if (repaired.surface.numberOfFaces() == 0)
  {
    return 1;
  }
  if (!progressIn(0., 0.1)(1.))
  {
    return fail(stipple::Status::aborted());
  }

  const stipple::Curvature curvature = stipple::computeCurvature(repaired.surface);
  stipple::CutSurface surface(repaired.surface, repaired.sourceCell);
  stipple::FeatureDetectionOptions detection;
  detection.angle = this->FeatureAngle;
  detection.minimumLength = this->MinimumFeatureLength;
  stipple::detectFeatures(surface, detection);
  if (this->FeatureEdges)
  {
    if (const stipple::Status status = tagFeatureEdges(this->FeatureEdges, repaired, surface);
        !status.ok())
    {
      return fail(status);
    }
  }

  if (this->FeatureCurves)
  {
    if (const stipple::Status status =
          stipple::insertFeatureCurves(surface, this->FeatureCurves, progressIn(0.1, 0.15));
        !status.ok())
    {
      return fail(status);
    }
  }

  const std::vector<int> tips = stipple::findTips(surface, detection);
  stipple::splitLongEdges(surface, stipple::longestEdgeForCharts(surface));

  stipple::ChartPartitionOptions options;
  options.numberOfCharts = this->NumberOfCharts;
  options.maximumDensityRatio = this->MaximumDensityRatio;
  options.square = this->DomainShape == SQUARE;
  options.placement = static_cast<stipple::BoundaryPlacement>(this->BoundaryPlacement);
  std::vector<stipple::FlatChart> flat;
  if (const stipple::Status status =
        stipple::partitionSurface(surface, options, flat, progressIn(0.15, 0.9));
      !status.ok())
  {
    return fail(status);
  }
  for (const stipple::FlatChart& chart : flat)
  {
    this->DensityRatio = std::max(this->DensityRatio, chart.map.densityRatio);
    this->NumberOfFallbackCharts += chart.map.fallback;
  }

  stipple::FeatureGraph graph = stipple::buildFeatureGraph(surface, this->CornerAngle, tips);
  if (this->Constraints)
  {
    graph.constraints = stipple::locateConstraints(surface, flat, this->Constraints);
  }
  if (this->ChartConstraints)
  {
    if (const stipple::Status status =
          stipple::locateChartConstraints(surface, flat, this->ChartConstraints, graph.constraints);
        !status.ok())
    {
      return fail(status);
    }
  }
  std::vector<int> tipsInside;
  std::copy_if(tips.begin(), tips.end(), std::back_inserter(tipsInside),
    [&](int p) { return !graph.isCorner[p]; });
  stipple::constrainPoints(surface, flat, tipsInside, graph.constraints);
  stipple::writeCharts(input, repaired, surface, flat, curvature, charts);
  graphOutput->ShallowCopy(stipple::toPolyData(graph, surface.points));
  this->UpdateProgress(1.);
  return 1;
}

void vtkConformalAtlas::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MinimumFeatureLength: " << this->MinimumFeatureLength << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "FeatureEdges: " << this->FeatureEdges << "\n";
  os << indent << "FeatureCurves: " << this->FeatureCurves << "\n";
  os << indent << "ChartConstraints: " << this->ChartConstraints << "\n";
  os << indent << "Constraints: " << this->Constraints << "\n";
  os << indent << "NumberOfCharts: " << this->NumberOfCharts << "\n";
  os << indent << "MaximumDensityRatio: " << this->MaximumDensityRatio << "\n";
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
