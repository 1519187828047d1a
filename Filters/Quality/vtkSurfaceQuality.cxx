// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceQuality.h"

#include "FilterExecution.h"
#include "MeshQuality.h"
#include "PolyDataConversion.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkSurfaceQuality);

namespace
{
constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

/// Names the first point of a triangle that is not finite.
stipple::Status readSurface(vtkPolyData* data, const char* name, stipple::TriangleSurface& surface,
  std::vector<int>* cellOf = nullptr)
{
  if (stipple::Status status = stipple::readPolyData(data, surface, cellOf); !status.ok())
  {
    return status;
  }
  int bad = -1;
  for (const stipple::Triangle& t : surface.triangles)
  {
    for (const int p : t)
    {
      bad = !surface.points[p].allFinite() && (bad < 0 || p < bad) ? p : bad;
    }
  }
  return bad < 0
    ? stipple::Status::success()
    : stipple::Status::error("point " + std::to_string(bad) + " of the " + name + " is not finite");
}

void addColumn(vtkTable* table, vtkDataArray* column, const stipple::QualityFigure& figure)
{
  column->SetName(figure.name);
  column->InsertNextTuple1(figure.value);
  table->AddColumn(column);
}

void fill(vtkTable* table, const std::vector<stipple::QualityFigure>& figures)
{
  for (const stipple::QualityFigure& figure : figures)
  {
    switch (figure.kind)
    {
      case stipple::QualityFigure::Count:
        addColumn(table, vtkNew<vtkIdTypeArray>(), figure);
        break;
      case stipple::QualityFigure::Truth:
        addColumn(table, vtkNew<vtkUnsignedCharArray>(), figure);
        break;
      case stipple::QualityFigure::Number:
        addColumn(table, vtkNew<vtkDoubleArray>(), figure);
        break;
    }
  }
}

vtkDoubleArray* addArray(vtkDataSetAttributes* data, const char* name, vtkIdType size)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(size);
  array->FillValue(NotMeasured);
  data->AddArray(array);
  return array; // the data keeps it
}

void addShapes(
  vtkPolyData* output, const stipple::TriangleSurface& mesh, const std::vector<int>& cellOf)
{
  const vtkIdType n = output->GetNumberOfCells();
  vtkDoubleArray* quality = addArray(output->GetCellData(), "Quality", n);
  vtkDoubleArray* smallest = addArray(output->GetCellData(), "MinimumAngle", n);
  vtkDoubleArray* largest = addArray(output->GetCellData(), "MaximumAngle", n);
  vtkDoubleArray* area = addArray(output->GetCellData(), "Area", n);
  for (const stipple::Face f : mesh.faces())
  {
    const stipple::TriangleShape shape = stipple::measureTriangle(mesh, f);
    const vtkIdType c = cellOf[f.index()];
    const bool first = std::isnan(area->GetValue(c));
    quality->SetValue(c, first ? shape.quality : std::min(quality->GetValue(c), shape.quality));
    smallest->SetValue(
      c, first ? shape.smallestAngle : std::min(smallest->GetValue(c), shape.smallestAngle));
    largest->SetValue(
      c, first ? shape.largestAngle : std::max(largest->GetValue(c), shape.largestAngle));
    area->SetValue(c, (first ? 0. : area->GetValue(c)) + shape.area);
  }
}
}

vtkSurfaceQuality::vtkSurfaceQuality()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkSurfaceQuality::~vtkSurfaceQuality() = default;

void vtkSurfaceQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
}

void vtkSurfaceQuality::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputDataInternal(1, reference);
}

void vtkSurfaceQuality::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(1, reference);
}

vtkTable* vtkSurfaceQuality::GetSummary()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

double vtkSurfaceQuality::GetFigure(const char* name)
{
  vtkTable* table = this->GetSummary();
  auto* column = table ? vtkDataArray::SafeDownCast(table->GetColumnByName(name)) : nullptr;
  return column && column->GetNumberOfTuples() == 1 ? column->GetTuple1(0) : NotMeasured;
}

int vtkSurfaceQuality::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkSurfaceQuality::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkSurfaceQuality::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return stipple::execute(this, this->ErrorCode, [&](const stipple::Progress& progress) {
    vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
    vtkPolyData* referenceData = vtkPolyData::GetData(inputVector[1]);
    std::vector<int> cellOf;
    stipple::TriangleSurface mesh;
    stipple::Status status = readSurface(input, "mesh", mesh, &cellOf);
    stipple::MeshDistance distance;
    if (status.ok() && referenceData)
    {
      stipple::TriangleSurface reference;
      status = readSurface(referenceData, "reference", reference);
      if (status.ok() && !(reference.area() > 0))
      {
        status = stipple::Status::error(
          "the reference has no triangle with an area: there is nothing to measure to");
      }
      if (status.ok())
      {
        status =
          stipple::measureDistance(mesh, reference, this->NumberOfSamples, progress, distance);
      }
    }
    if (!status.ok())
    {
      return status;
    }
    vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
    output->ShallowCopy(input);
    addShapes(output, mesh, cellOf);
    if (referenceData)
    {
      vtkDoubleArray* array =
        addArray(output->GetPointData(), "Distance", output->GetNumberOfPoints());
      std::copy(distance.ofPoint.begin(), distance.ofPoint.end(), array->GetPointer(0));
    }
    stipple::MeshQuality quality = stipple::measureQuality(mesh);
    quality.selfIntersections = stipple::countSelfIntersections(mesh);
    fill(vtkTable::GetData(outputVector, 1),
      stipple::figuresOf(quality, referenceData ? &distance : nullptr));
    return status;
  });
}
