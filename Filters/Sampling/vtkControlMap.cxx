// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkControlMap.h"

#include "ControlMapBuilder.h"
#include "FilterExecution.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkControlMap);
vtkCxxSetObjectMacro(vtkControlMap, ImportanceImage, vtkImageData);
vtkCxxSetObjectMacro(vtkControlMap, TransferFunction, vtkPiecewiseFunction);

namespace
{
using stipple::ImportanceKind;
using stipple::PictureProjection;
static_assert(vtkControlMap::UNIFORM == static_cast<int>(ImportanceKind::Uniform) &&
  vtkControlMap::MEAN == static_cast<int>(ImportanceKind::Mean) &&
  vtkControlMap::GAUSSIAN == static_cast<int>(ImportanceKind::Gaussian) &&
  vtkControlMap::MINIMUM == static_cast<int>(ImportanceKind::Minimum) &&
  vtkControlMap::MAXIMUM == static_cast<int>(ImportanceKind::Maximum) &&
  vtkControlMap::TOTAL == static_cast<int>(ImportanceKind::Total) &&
  vtkControlMap::L2 == static_cast<int>(ImportanceKind::L2) &&
  vtkControlMap::IMAGE == static_cast<int>(ImportanceKind::Image) &&
  vtkControlMap::ARRAY == static_cast<int>(ImportanceKind::Array));
static_assert(vtkControlMap::CHART == static_cast<int>(PictureProjection::Chart) &&
  vtkControlMap::X_AXIS == static_cast<int>(PictureProjection::XAxis) &&
  vtkControlMap::Y_AXIS == static_cast<int>(PictureProjection::YAxis) &&
  vtkControlMap::Z_AXIS == static_cast<int>(PictureProjection::ZAxis));

constexpr int StrokeComponents = 5;
constexpr int SizePlaceComponents = 4;

bool isStroke(const double* s)
{
  return std::all_of(s, s + StrokeComponents, [](double x) { return std::isfinite(x); }) &&
    s[3] >= 0. && s[4] >= -1.;
}

bool isSizePlace(const double* p)
{
  return std::all_of(p, p + SizePlaceComponents, [](double x) { return std::isfinite(x); }) &&
    p[3] > 0.;
}

/// The first row of an array that is none of so many components, or -1; nullptr has none.
vtkIdType firstBadRow(vtkDoubleArray* array, int components, bool (*isRow)(const double*))
{
  const vtkIdType n = array ? array->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    if (array->GetNumberOfComponents() != components || !isRow(array->GetPointer(components * i)))
    {
      return i;
    }
  }
  return -1;
}

/// Copies an array with as many components, nullptr being an empty one; whether that differs.
bool assign(vtkDoubleArray* own, vtkDoubleArray* other)
{
  const vtkIdType n = other ? other->GetNumberOfValues() : 0;
  if (n == own->GetNumberOfValues() &&
    (n == 0 || std::equal(own->GetPointer(0), own->GetPointer(0) + n, other->GetPointer(0))))
  {
    return false;
  }
  own->SetNumberOfValues(n);
  std::copy_n(n > 0 ? other->GetPointer(0) : nullptr, n, own->GetPointer(0));
  return true;
}
}

struct vtkControlMap::Internals
{
  vtkNew<vtkDoubleArray> strokes;
  vtkNew<vtkDoubleArray> sizePlaces;
  stipple::ControlMapBuilder builder;
};

namespace
{
/// The input's images with their control.
void addImages(vtkPartitionedDataSetCollection* input,
  const std::vector<vtkSmartPointer<vtkFloatArray>>& control,
  vtkPartitionedDataSetCollection* output)
{
  output->CopyStructure(input);
  for (unsigned int c = 0; c < control.size(); ++c)
  {
    vtkNew<vtkImageData> image;
    image->ShallowCopy(input->GetPartitionAsDataObject(c, 0));
    image->GetPointData()->AddArray(control[c]); // SetScalars would drop those that are
    image->GetPointData()->SetActiveScalars("Control");
    output->SetPartition(c, 0, image);
  }
}
}

vtkControlMap::vtkControlMap()
  : Data(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(3);
  this->Data->strokes->SetName("Strokes");
  this->Data->strokes->SetNumberOfComponents(StrokeComponents);
  this->Data->sizePlaces->SetName("SizePlaces");
  this->Data->sizePlaces->SetNumberOfComponents(SizePlaceComponents);
}

vtkControlMap::~vtkControlMap()
{
  this->SetImportanceArrayName(nullptr);
  this->SetSizeArrayName(nullptr);
  this->SetImportanceImage(nullptr);
  this->SetTransferFunction(nullptr);
}

vtkMTimeType vtkControlMap::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->ImportanceImage)
  {
    time = std::max(time, this->ImportanceImage->GetMTime());
  }
  if (this->TransferFunction)
  {
    time = std::max(time, this->TransferFunction->GetMTime());
  }
  return time;
}

bool vtkControlMap::AddStroke(double x, double y, double z, double radius, double strength)
{
  const double stroke[StrokeComponents] = { x, y, z, radius, strength };
  if (!isStroke(stroke))
  {
    vtkErrorMacro("A stroke with radius " << radius << " and strength " << strength
                                          << " is none: all its numbers must be finite, the radius "
                                             "positive, and the strength at least -1.");
    return false;
  }
  this->Data->strokes->InsertNextTuple(stroke);
  this->Modified();
  return true;
}

bool vtkControlMap::AddStroke(const double position[3], double radius, double strength)
{
  return this->AddStroke(position[0], position[1], position[2], radius, strength);
}

void vtkControlMap::RemoveLastStroke()
{
  if (this->GetNumberOfStrokes() > 0)
  {
    this->Data->strokes->RemoveLastTuple();
    this->Modified();
  }
}

void vtkControlMap::RemoveAllStrokes()
{
  if (this->GetNumberOfStrokes() > 0)
  {
    this->Data->strokes->SetNumberOfTuples(0);
    this->Modified();
  }
}

int vtkControlMap::GetNumberOfStrokes()
{
  return static_cast<int>(this->Data->strokes->GetNumberOfTuples());
}

void vtkControlMap::SetStrokes(vtkDoubleArray* strokes)
{
  if (const vtkIdType i = firstBadRow(strokes, StrokeComponents, isStroke); i >= 0)
  {
    vtkErrorMacro("Stroke " << i
                            << " is none: it has the components x, y, z, radius and strength, all "
                               "finite, the radius positive, and the strength at least -1.");
    return;
  }
  if (assign(this->Data->strokes, strokes))
  {
    this->Modified();
  }
}

vtkDoubleArray* vtkControlMap::GetStrokes()
{
  return this->Data->strokes;
}

void vtkControlMap::SetSizePlaces(vtkDoubleArray* places)
{
  if (const vtkIdType i = firstBadRow(places, SizePlaceComponents, isSizePlace); i >= 0)
  {
    vtkErrorMacro("Place " << i
                           << " of a size is none: it has the components x, y, z and length, all "
                              "finite, the length positive.");
    return;
  }
  if (assign(this->Data->sizePlaces, places))
  {
    this->Modified();
  }
}

vtkDoubleArray* vtkControlMap::GetSizePlaces()
{
  return this->Data->sizePlaces;
}

int vtkControlMap::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  if (port >= 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkControlMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkPartitionedDataSetCollection::GetData(inputVector[0], 0);
  auto* charts = vtkPartitionedDataSetCollection::GetData(inputVector[1], 0);
  auto* graph = vtkPolyData::GetData(inputVector[2], 0);
  auto* output = vtkPartitionedDataSetCollection::GetData(outputVector, 0);
  if (!input || !output)
  {
    return 0;
  }
  stipple::ControlMapOptions options;
  options.importance = static_cast<ImportanceKind>(this->Importance);
  options.arrayName = this->ImportanceArrayName ? this->ImportanceArrayName : "";
  options.image = this->ImportanceImage;
  options.projection = static_cast<PictureProjection>(this->ImageProjection);
  options.bandPass = { { this->BandPass[0], this->BandPass[1] } };
  options.transfer = this->TransferFunction;
  options.gamma = this->Gamma;
  options.gradation = this->Gradation;
  options.tolerance = this->SmoothingTolerance;
  options.minimumDensity = this->MinimumDensity;
  options.sizeArray = this->SizeArrayName ? this->SizeArrayName : "";
  options.curvaturePoints = this->CurvaturePoints;
  options.sizing.numberOfSamples = this->NumberOfSamples;
  options.sizing.edgeLength = this->EdgeLength;
  options.sizing.smallest = this->SizeMinimum;
  options.sizing.largest = this->SizeMaximum;
  options.sizing.growth = this->Growth;
  options.growFromFeatures = this->GrowFromFeatures;
  for (vtkIdType i = 0; i < this->Data->sizePlaces->GetNumberOfTuples(); ++i)
  {
    const double* p = this->Data->sizePlaces->GetPointer(SizePlaceComponents * i);
    options.sizing.places.push_back({ { p[0], p[1], p[2] }, p[3] });
  }
  for (vtkIdType i = 0; i < this->Data->strokes->GetNumberOfTuples(); ++i)
  {
    const double* s = this->Data->strokes->GetPointer(StrokeComponents * i);
    options.strokes.push_back({ { s[0], s[1], s[2] }, s[3], s[4] });
  }
  if (!this->FollowImportance)
  {
    options.importance = stipple::ImportanceKind::Uniform;
    options.strokes.clear();
  }
  std::vector<vtkSmartPointer<vtkFloatArray>> control;
  std::string warning;
  const int result =
    stipple::execute(this, this->ErrorCode, [&](const stipple::Progress& progress) {
      const stipple::Status status =
        this->Data->builder.build(input, charts, graph, options, progress, control, warning);
      if (status.ok())
      {
        addImages(input, control, output);
      }
      return status;
    });
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  return result;
}

double vtkControlMap::GetNumberOfWantedSamples()
{
  return this->Data->builder.sizes().numberOfSamples;
}

bool vtkControlMap::GetHasGrown()
{
  return this->Data->builder.sizes().hasGrown;
}

bool vtkControlMap::GetHasGrownInFull()
{
  return this->Data->builder.sizes().hasGrownInFull;
}

void vtkControlMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Importance: " << this->Importance << "\n";
  os << indent << "ImportanceArrayName: "
     << (this->ImportanceArrayName ? this->ImportanceArrayName : "(none)") << "\n";
  os << indent << "ImportanceImage: " << this->ImportanceImage << "\n";
  os << indent << "ImageProjection: " << this->ImageProjection << "\n";
  os << indent << "BandPass: " << this->BandPass[0] << " " << this->BandPass[1] << "\n";
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "TransferFunction: " << this->TransferFunction << "\n";
  os << indent << "Gradation: " << this->Gradation << "\n";
  os << indent << "SmoothingTolerance: " << this->SmoothingTolerance << "\n";
  os << indent << "Strokes: " << this->GetNumberOfStrokes() << "\n";
  os << indent << "MinimumDensity: " << this->MinimumDensity << "\n";
  os << indent << "SizeArrayName: " << (this->SizeArrayName ? this->SizeArrayName : "(none)")
     << "\n";
  os << indent << "CurvaturePoints: " << this->CurvaturePoints << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "SizeMinimum: " << this->SizeMinimum << "\n";
  os << indent << "SizeMaximum: " << this->SizeMaximum << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "SizePlaces: " << this->Data->sizePlaces->GetNumberOfTuples() << "\n";
  os << indent << "FollowImportance: " << this->FollowImportance << "\n";
  os << indent << "GrowFromFeatures: " << this->GrowFromFeatures << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
}
