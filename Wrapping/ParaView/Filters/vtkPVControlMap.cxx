// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVControlMap.h"

#include "PointRows.h"
#include "RankExchange.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>

vtkStandardNewMacro(vtkPVControlMap);

namespace
{
const char* nullIfNone(const char* name)
{
  return name && *name && std::string(name) != "None" ? name : nullptr;
}
}

vtkPVControlMap::vtkPVControlMap()
{
  this->SetNumberOfInputPorts(5);
}

void vtkPVControlMap::SetImportanceArrayName(const char* name)
{
  this->Superclass::SetImportanceArrayName(nullIfNone(name));
}

void vtkPVControlMap::SetSizeArrayName(const char* name)
{
  this->Superclass::SetSizeArrayName(nullIfNone(name));
}

int vtkPVControlMap::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port < 3)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(INPUT_REQUIRED_DATA_TYPE(), port == 3 ? "vtkImageData" : "vtkPointSet");
  info->Set(INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkPVControlMap::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* picture = input[3]->GetInformationObject(0);
  if (picture && picture->Has(Pipeline::WHOLE_EXTENT()))
  {
    picture->Set(Pipeline::UPDATE_EXTENT(), picture->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return this->Superclass::RequestUpdateExtent(request, input, output);
}

int vtkPVControlMap::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  return stipple::runOnRoot(output, [&]() {
    return this->TakeInputs(input) && this->Superclass::RequestData(request, input, output);
  });
}

bool vtkPVControlMap::TakeInputs(vtkInformationVector** input)
{
  this->SetImportanceImage(vtkImageData::GetData(input[3]));
  vtkNew<vtkPolyData> points;
  if (vtkPointSet* given = vtkPointSet::GetData(input[4]))
  {
    points->SetPoints(given->GetPoints());
    points->GetPointData()->ShallowCopy(given->GetPointData());
  }
  stipple::OptionValues values;
  const stipple::Status status = stipple::addStrokes(points, values);
  if (!status.ok())
  {
    this->ErrorCode = static_cast<unsigned long>(status.code());
    vtkErrorMacro(<< status.message());
    return false;
  }
  const stipple::Option& strokes = *stipple::findOption("strokes");
  strokes.apply(this, strokes, values.at("strokes"));
  return true;
}

void vtkPVControlMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
