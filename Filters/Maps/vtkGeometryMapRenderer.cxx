// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryMapRenderer.h"

#include "FilterExecution.h"
#include "MapCatalogue.h"
#include "MapSizing.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkFloatArray.h"
#include "vtkGeometryMapBackend.h"
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
#include "vtkWeakPointer.h"
#include "vtkWindow.h"

#include <algorithm>
#include <map>
#include <utility>

vtkStandardNewMacro(vtkGeometryMapRenderer);

namespace
{
using Size = std::array<int, 2>;

/// The images of one chart that were made so far.
struct ChartMaps
{
  Size size{ 0, 0 };
  vtkSmartPointer<vtkIntArray> faces;
  std::map<std::string, vtkSmartPointer<vtkFloatArray>> maps;

  void clear()
  {
    this->faces = nullptr;
    this->maps.clear();
  }
};

struct FinishAtEnd
{
  vtkGeometryMapBackend& backend;
  ~FinishAtEnd() { this->backend.Finish(); }
};
} // namespace

struct vtkGeometryMapRenderer::Internals
{
  vtkWeakPointer<vtkWindow> Window;
  vtkSmartPointer<vtkGeometryMapBackend> Renderer;
  std::string BackendName;
  stipple::MapCatalogue Catalogue;
  std::vector<stipple::MapDemand> Demands; ///< per chart
  std::vector<ChartMaps> Charts;
  /// Which charts the above are of, and as of when.
  std::vector<std::pair<vtkSmartPointer<vtkPolyData>, vtkMTimeType>> Key;

  void forget()
  {
    this->Key.clear();
    this->Charts.clear();
    this->Demands.clear();
  }
  stipple::Status read(vtkPartitionedDataSetCollection* charts, const stipple::Stop& stop);
  std::vector<Size> sizes(int mapSize, vtkIdType samples) const;
  stipple::Status chooseBackend(int backend);
  stipple::Status drawChart(
    int c, const std::vector<std::string>& names, const stipple::Progress& progress, int& made);
  vtkSmartPointer<vtkImageData> image(int c, const std::vector<std::string>& names) const;
};

//------------------------------------------------------------------------------
stipple::Status vtkGeometryMapRenderer::Internals::read(
  vtkPartitionedDataSetCollection* charts, const stipple::Stop& stop)
{
  decltype(this->Key) key;
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    vtkPolyData* chart = stipple::chartOf(charts, c);
    key.emplace_back(chart, chart ? chart->GetMTime() : 0);
  }
  if (key == this->Key && !key.empty())
  {
    return stipple::Status::success();
  }
  this->forget();
  const stipple::Status status = this->Catalogue.read(charts, stop);
  if (status.ok())
  {
    this->Key = std::move(key);
    this->Charts.resize(this->Catalogue.numberOfCharts());
    for (int c = 0; c < this->Catalogue.numberOfCharts(); ++c)
    {
      this->Demands.push_back(stipple::demandOf(this->Catalogue.chart(c)));
    }
  }
  return status;
}

std::vector<Size> vtkGeometryMapRenderer::Internals::sizes(int mapSize, vtkIdType samples) const
{
  if (mapSize <= 0)
  {
    return stipple::automaticMapSizes(this->Demands, static_cast<double>(samples));
  }
  std::vector<Size> result;
  for (const stipple::MapDemand& demand : this->Demands)
  {
    result.push_back(stipple::fixedMapSize(demand.extent, mapSize));
  }
  return result;
}

stipple::Status vtkGeometryMapRenderer::Internals::chooseBackend(int backend)
{
  using stipple::Status;
  if (this->Renderer)
  {
    const Status status = this->Renderer->Initialize();
    if (status.ok())
    {
      return status;
    }
    this->Renderer = nullptr; // its window is gone
  }
  if (backend != vtkGeometryMapRenderer::CPU)
  {
    const auto opengl =
      vtkSmartPointer<vtkGeometryMapBackend>::Take(vtkGeometryMapBackend::NewOverride());
    const bool wanted = backend == vtkGeometryMapRenderer::OPENGL;
    if (!opengl && wanted)
    {
      return Status::error("There is no OpenGL back end in this program: link or load "
                           "StippleRenderingGeometryMaps, or use the CPU back end.");
    }
    if (opengl)
    {
      opengl->SetWindow(this->Window);
      const Status status =
        wanted || opengl->IsPreferred() ? opengl->Initialize() : Status::aborted();
      if (status.ok() || wanted)
      {
        this->Renderer = status.ok() ? opengl : nullptr;
        return status;
      }
    }
  }
  this->Renderer = vtkSmartPointer<vtkGeometryMapBackend>::New();
  return Status::success();
}

stipple::Status vtkGeometryMapRenderer::Internals::drawChart(
  int c, const std::vector<std::string>& names, const stipple::Progress& progress, int& made)
{
  ChartMaps& images = this->Charts[c];
  const stipple::MapChart& chart = this->Catalogue.chart(c);
  const auto [width, height] = images.size;
  const vtkIdType pixels = static_cast<vtkIdType>(width) * height;
  if (!images.faces)
  {
    vtkNew<vtkIntArray> faces;
    faces->SetName("FaceIndex");
    faces->SetNumberOfTuples(pixels);
    const stipple::Status status =
      this->Renderer->DrawFaces(chart, width, height, faces->GetPointer(0));
    if (!status.ok())
    {
      return status;
    }
    images.faces = faces;
    ++made;
  }
  std::vector<stipple::MapValues> values;
  std::vector<stipple::MapRequest> requests;
  std::vector<vtkSmartPointer<vtkFloatArray>> arrays;
  values.reserve(names.size());
  for (const std::string& name : names)
  {
    if (name == "FaceIndex" || images.maps.count(name))
    {
      continue;
    }
    values.emplace_back();
    const stipple::Status status = this->Catalogue.find(name, c, values.back());
    if (!status.ok())
    {
      return status;
    }
    const auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(values.back().components);
    array->SetNumberOfTuples(pixels);
    arrays.push_back(array);
    requests.push_back(
      { values.back().kind, values.back().components, values.back().values, array->GetPointer(0) });
  }
  const stipple::Status status =
    this->Renderer->DrawMaps(chart, width, height, images.faces->GetPointer(0), requests, progress);
  if (status.ok())
  {
    for (const auto& array : arrays)
    {
      images.maps[array->GetName()] = array;
      ++made;
    }
  }
  return status;
}

vtkSmartPointer<vtkImageData> vtkGeometryMapRenderer::Internals::image(
  int c, const std::vector<std::string>& names) const
{
  const ChartMaps& images = this->Charts[c];
  const stipple::Vec2& extent = this->Catalogue.chart(c).extent;
  const double dx = extent.x() / images.size[0];
  const double dy = extent.y() / images.size[1];
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(images.size[0], images.size[1], 1);
  image->SetSpacing(dx, dy, 1.);
  image->SetOrigin(0.5 * dx, 0.5 * dy, 0.);
  for (const std::string& name : names)
  {
    if (name == "FaceIndex")
    {
      image->GetPointData()->AddArray(images.faces);
    }
    else
    {
      image->GetPointData()->AddArray(images.maps.at(name));
    }
  }
  return image;
}

//------------------------------------------------------------------------------
vtkGeometryMapRenderer::vtkGeometryMapRenderer()
  : MapSelection(vtkDataArraySelection::New())
  , Internal(new Internals)
{
  for (const std::string& name : stipple::MapCatalogue::names())
  {
    this->MapSelection->AddArray(name.c_str(), stipple::MapCatalogue::isDefault(name));
  }
}

vtkGeometryMapRenderer::~vtkGeometryMapRenderer()
{
  this->MapSelection->Delete();
}

vtkMTimeType vtkGeometryMapRenderer::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->MapSelection->GetMTime());
}

void vtkGeometryMapRenderer::SetNumberOfSamples(vtkIdType samples)
{
  samples = std::max<vtkIdType>(samples, 1);
  if (samples == this->NumberOfSamples)
  {
    return;
  }
  const bool known = !this->Internal->Demands.empty();
  const bool same = known &&
    (this->MapSize > 0 ||
      this->Internal->sizes(0, samples) == this->Internal->sizes(0, this->NumberOfSamples));
  this->NumberOfSamples = samples;
  if (!same)
  {
    this->Modified();
  }
}

void vtkGeometryMapRenderer::SetBackend(int backend)
{
  backend = std::clamp<int>(backend, AUTO, CPU);
  if (backend != this->Backend)
  {
    this->Backend = backend;
    this->Internal->Renderer = nullptr;
    this->Modified();
  }
}

void vtkGeometryMapRenderer::SetRenderWindow(vtkWindow* window)
{
  if (window != this->Internal->Window.GetPointer())
  {
    this->Internal->Window = window;
    this->Internal->Renderer = nullptr;
    this->Modified();
  }
}

vtkWindow* vtkGeometryMapRenderer::GetRenderWindow()
{
  return this->Internal->Window;
}

const char* vtkGeometryMapRenderer::GetBackendName()
{
  return this->Internal->BackendName.c_str();
}

int vtkGeometryMapRenderer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkGeometryMapRenderer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkPartitionedDataSetCollection::GetData(inputVector[0], 0);
  auto* output = vtkPartitionedDataSetCollection::GetData(outputVector, 0);
  Internals& self = *this->Internal;
  this->ErrorCode = 0;
  output->Initialize();
  this->NumberOfRenderedMaps = 0;
  if (!input || input->GetNumberOfPartitionedDataSets() == 0)
  {
    self.forget();
    return 1;
  }
  std::vector<std::string> names;
  for (int k = 0; k < this->MapSelection->GetNumberOfArrays(); ++k)
  {
    if (this->MapSelection->GetArraySetting(k))
    {
      names.emplace_back(this->MapSelection->GetArrayName(k));
    }
  }
  const auto isStopped = [this] {
    this->UpdateProgress(0.);
    return this->GetAbortExecute() != 0;
  };
  stipple::Status status = self.read(input, isStopped);
  if (status.ok())
  {
    status = self.chooseBackend(this->Backend);
  }
  if (!status.ok())
  {
    return stipple::endAfter(status, this, this->ErrorCode);
  }
  const std::string backendName = self.Renderer->GetName();
  const std::vector<Size> sizes = self.sizes(this->MapSize, this->NumberOfSamples);
  const unsigned int n = static_cast<unsigned int>(sizes.size());
  for (unsigned int c = 0; c < n; ++c)
  {
    if (self.Charts[c].size != sizes[c] || backendName != self.BackendName)
    {
      self.Charts[c].clear();
      self.Charts[c].size = sizes[c];
    }
  }
  self.BackendName = backendName;
  const FinishAtEnd finish{ *self.Renderer };
  for (unsigned int c = 0; c < n; ++c)
  {
    const auto progress = [&](double fraction) {
      this->UpdateProgress((c + fraction) / n);
      return !this->GetAbortExecute();
    };
    status = progress(0.) ? self.drawChart(c, names, progress, this->NumberOfRenderedMaps)
                          : stipple::Status::aborted();
    if (!status.ok())
    {
      output->Initialize();
      return stipple::endAfter(status, this, this->ErrorCode);
    }
    output->SetPartition(c, 0, self.image(c, names));
    if (input->HasMetaData(c) && input->GetMetaData(c)->Has(vtkCompositeDataSet::NAME()))
    {
      output->GetMetaData(c)->Set(
        vtkCompositeDataSet::NAME(), input->GetMetaData(c)->Get(vtkCompositeDataSet::NAME()));
    }
  }
  this->UpdateProgress(1.);
  return 1;
}

void vtkGeometryMapRenderer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Backend: " << this->Backend << "\n";
  os << indent << "BackendName: " << this->Internal->BackendName << "\n";
  os << indent << "NumberOfRenderedMaps: " << this->NumberOfRenderedMaps << "\n";
  os << indent << "RenderWindow: " << this->Internal->Window.GetPointer() << "\n";
  os << indent << "MapSelection:\n";
  this->MapSelection->PrintSelf(os, indent.GetNextIndent());
}
