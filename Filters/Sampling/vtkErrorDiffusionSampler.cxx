// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkErrorDiffusionSampler.h"

#include "FilterExecution.h"
#include "SurfaceSampler.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>

vtkStandardNewMacro(vtkErrorDiffusionSampler);

namespace
{
/// Control images as the kernels read them; arrays of other types are converted and kept here.
class ControlImages
{
public:
  std::vector<stipple::ControlImage> views;

  stipple::Status read(
    vtkPartitionedDataSetCollection* images, const stipple::AtlasSurface& surface)
  {
    const int n = surface.numberOfCharts();
    const int given = static_cast<int>(images->GetNumberOfPartitionedDataSets());
    if (given != n)
    {
      return stipple::Status::error("There are " + std::to_string(given) + " control images and " +
        std::to_string(n) + " charts: pass images and charts of the same atlas.");
    }
    for (int c = 0; c < n; ++c)
    {
      auto* image = images->GetNumberOfPartitions(c) > 0
        ? vtkImageData::SafeDownCast(images->GetPartitionAsDataObject(c, 0))
        : nullptr;
      vtkPointData* data = image ? image->GetPointData() : nullptr;
      vtkDataArray* control = data ? data->GetArray("Control") : nullptr;
      if (data && !control)
      {
        control = data->GetScalars();
      }
      vtkDataArray* area = data ? data->GetArray("AreaDistortion") : nullptr;
      vtkDataArray* face = data ? data->GetArray("FaceIndex") : nullptr;
      for (vtkDataArray* array : { control, area, face })
      {
        if (!array || array->GetNumberOfTuples() != image->GetNumberOfPoints() ||
          array->GetNumberOfTuples() == 0)
        {
          return stipple::Status::error("Control image " + std::to_string(c) +
            " is no vtkImageData with the point arrays Control, AreaDistortion and FaceIndex: pass "
            "the "
            "output of vtkControlMap, with FaceIndex selected in vtkGeometryMapRenderer.");
        }
      }
      stipple::ControlImage view;
      view.width = image->GetDimensions()[0];
      view.height = image->GetDimensions()[1];
      view.extent = surface.extent[c];
      view.control = this->values<vtkFloatArray, float>(control);
      view.areaDistortion = this->values<vtkFloatArray, float>(area);
      view.faceIndex = this->values<vtkIntArray, int>(face);
      this->views.push_back(view);
    }
    return stipple::Status::success();
  }

private:
  template <typename ArrayT, typename T>
  const T* values(vtkDataArray* array)
  {
    auto* typed = ArrayT::SafeDownCast(array);
    if (!typed || typed->GetNumberOfComponents() != 1)
    {
      auto copy = vtkSmartPointer<ArrayT>::New();
      copy->SetNumberOfValues(array->GetNumberOfTuples());
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        copy->SetValue(i, static_cast<T>(array->GetComponent(i, 0)));
      }
      this->Copies.push_back(copy);
      typed = copy;
    }
    return typed->GetPointer(0);
  }
  std::vector<vtkSmartPointer<vtkDataArray>> Copies;
};

/// One chart's halftone: a black pixel under every sample, those on backbones on each of their
/// sides.
vtkSmartPointer<vtkUnsignedCharArray> halftone(const stipple::ControlImage& image,
  const stipple::ChartGraph& graph, const std::vector<stipple::Vec2>& interior,
  const std::vector<stipple::Vec2>& constraints)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName("Halftone");
  array->SetNumberOfValues(image.numberOfPixels());
  unsigned char* pixel = array->GetPointer(0);
  std::memset(pixel, 255, static_cast<std::size_t>(image.numberOfPixels()));
  for (const stipple::Vec2& p : interior)
  {
    pixel[image.pixelAt(p)] = 0;
  }
  for (const stipple::Vec2& p : constraints)
  {
    pixel[image.pixelAt(p)] = 0;
  }
  for (const stipple::ChartGraph::Vertex& v : graph.vertices)
  {
    pixel[image.pixelAt(v.uv)] = 0;
  }
  return array;
}
}

struct vtkErrorDiffusionSampler::Internals
{
  stipple::SurfaceSampler sampler; // a new control map finds all done that the charts ask for

  void write(const stipple::SurfaceSamples& result, const ControlImages& control,
    vtkPartitionedDataSetCollection* images, vtkPolyData* output,
    vtkPartitionedDataSetCollection* halftones) const
  {
    output->ShallowCopy(stipple::toPolyData(result.samples, this->sampler.domain().surface()));
    vtkNew<vtkDoubleArray> density;
    density->SetName("Density");
    density->SetNumberOfValues(static_cast<vtkIdType>(result.density.size()));
    std::copy(result.density.begin(), result.density.end(), density->GetPointer(0));
    output->GetPointData()->AddArray(density);

    halftones->CopyStructure(images);
    for (std::size_t c = 0; c < control.views.size(); ++c)
    {
      const auto index = static_cast<unsigned int>(c);
      vtkNew<vtkImageData> image;
      image->ShallowCopy(images->GetPartitionAsDataObject(index, 0));
      image->GetPointData()->AddArray(halftone(control.views[c], result.graphs[c],
        result.interior[c], this->sampler.domain().chartConstraints[c]));
      image->GetPointData()->SetActiveScalars("Halftone");
      halftones->SetPartition(index, 0, image);
    }
  }
};

vtkErrorDiffusionSampler::vtkErrorDiffusionSampler()
  : Data(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkErrorDiffusionSampler::~vtkErrorDiffusionSampler() = default;

int vtkErrorDiffusionSampler::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(),
    port == 2 ? "vtkPolyData" : "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkErrorDiffusionSampler::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkPartitionedDataSetCollection");
  return 1;
}

vtkPartitionedDataSetCollection* vtkErrorDiffusionSampler::GetHalftones()
{
  return vtkPartitionedDataSetCollection::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkErrorDiffusionSampler::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* images = vtkPartitionedDataSetCollection::GetData(inputVector[0], 0);
  auto* charts = vtkPartitionedDataSetCollection::GetData(inputVector[1], 0);
  auto* graph = vtkPolyData::GetData(inputVector[2], 0);
  auto* output = vtkPolyData::GetData(outputVector, 0);
  auto* halftones = vtkPartitionedDataSetCollection::GetData(outputVector, 1);
  this->MinimumNumberOfSamples = 0;
  stipple::SurfaceSampler& sampler = this->Data->sampler;
  return stipple::execute(this, this->ErrorCode, [&](const stipple::Progress& progress) {
    if (charts->GetNumberOfPartitionedDataSets() == 0)
    {
      return stipple::Status::success();
    }
    ControlImages control;
    stipple::Status status = sampler.setDomain(charts, graph);
    this->MinimumNumberOfSamples = sampler.minimumNumberOfSamples();
    if (status.ok())
    {
      status = control.read(images, sampler.domain().surface());
    }
    if (!status.ok())
    {
      return status;
    }
    stipple::SurfaceSamples result;
    const auto sample = [&](int n) {
      return sampler.sample(control.views, n,
        [&](double fraction) { return progress(0.1 + 0.8 * fraction); }, result,
        { static_cast<stipple::DiffusionMethod>(this->DiffusionMethod), this->UpsampleSpikes });
    };
    status = sample(this->NumberOfSamples);
    if (status.leastNumberOfPoints() > 0)
    {
      this->MinimumNumberOfSamples = status.leastNumberOfPoints();
      if (this->RaiseNumberOfSamples)
      {
        status = sample(status.leastNumberOfPoints());
      }
    }
    if (status.ok())
    {
      this->Data->write(result, control, images, output, halftones);
    }
    return status;
  });
}

void vtkErrorDiffusionSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "RaiseNumberOfSamples: " << this->RaiseNumberOfSamples << "\n";
  os << indent << "DiffusionMethod: " << this->DiffusionMethod << "\n";
  os << indent << "UpsampleSpikes: " << this->UpsampleSpikes << "\n";
  os << indent << "MinimumNumberOfSamples: " << this->MinimumNumberOfSamples << "\n";
}
