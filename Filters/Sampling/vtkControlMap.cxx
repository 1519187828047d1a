// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkControlMap.h"

#include "FloatValues.h"
#include "Importance.h"
#include "ImportanceSource.h"
#include "Painting.h"
#include "SurfaceDiffusion.h"

#include "vtkBoundingBox.h"
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
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkControlMap);
vtkCxxSetObjectMacro(vtkControlMap, ImportanceImage, vtkImageData);
vtkCxxSetObjectMacro(vtkControlMap, TransferFunction, vtkPiecewiseFunction);

namespace
{
using stipple::Status;

/// One chart: the map that comes in, and the control that goes out.
struct ControlChart
{
  vtkSmartPointer<vtkImageData> map;
  vtkSmartPointer<vtkFloatArray> control;
  std::unique_ptr<stipple::FloatValues> area;
  std::size_t size = 0;
  float* values() const { return this->control->GetPointer(0); }
  double pixelArea() const { return this->map->GetSpacing()[0] * this->map->GetSpacing()[1]; }
};

struct PixelRun
{
  std::size_t chart;
  std::size_t begin;
  std::size_t end;
};

/// Calls f(run) for runs of pixels of all charts, in parallel; returns the largest result.
template <typename F>
float forEachPixelRun(const std::vector<ControlChart>& charts, F f)
{
  constexpr std::size_t length = 1u << 15;
  std::vector<PixelRun> runs;
  for (std::size_t c = 0; c < charts.size(); ++c)
  {
    for (std::size_t begin = 0; begin < charts[c].size; begin += length)
    {
      runs.push_back({ c, begin, std::min(begin + length, charts[c].size) });
    }
  }
  std::vector<float> results(runs.size(), 0.f);
  vtkSMPTools::For(0, static_cast<vtkIdType>(runs.size()), [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      results[i] = f(runs[i]);
    }
  });
  return results.empty() ? 0.f : *std::max_element(results.begin(), results.end());
}

template <typename F>
void forEachChart(std::size_t charts, F f)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(charts), 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType c = begin; c < end; ++c)
    {
      f(static_cast<std::size_t>(c));
    }
  });
}

/// Magnitudes of an importance that rounding leaves on a flat surface of this area: radii of
/// curvature beyond 1e5 times the surface's size.
double roundingNoise(int importance, double area)
{
  const double curvature = area > 0 ? 1e-5 / std::sqrt(area) : 0.;
  switch (importance)
  {
    case vtkControlMap::MEAN:
    case vtkControlMap::MINIMUM:
    case vtkControlMap::MAXIMUM:
      return curvature;
    case vtkControlMap::GAUSSIAN:
    case vtkControlMap::TOTAL:
      return curvature * curvature;
    case vtkControlMap::L2:
      return std::cbrt(curvature * curvature);
    default:
      return 0.;
  }
}

double surfaceArea(const std::vector<stipple::WeightedValues>& values)
{
  double area = 0;
  for (const stipple::WeightedValues& v : values)
  {
    double sum = 0;
    for (std::size_t i = 0; i < v.size; ++i)
    {
      sum += v.weight[i] > 0 ? v.weight[i] : 0.f;
    }
    area += sum * v.factor;
  }
  return area;
}

float largestOf(const float* values, std::size_t begin, std::size_t end)
{
  float largest = 0;
  for (std::size_t i = begin; i < end; ++i)
  {
    largest = values[i] > largest ? values[i] : largest;
  }
  return largest;
}

constexpr int strokeComponents = 5;

bool isStroke(const double* s)
{
  return std::all_of(s, s + strokeComponents, [](double x) { return std::isfinite(x); }) &&
    s[3] > 0. && s[4] >= -1.;
}
}

struct vtkControlMap::Internals
{
  vtkNew<vtkDoubleArray> strokes;

  // Kept from execution to execution, each with what it was made from:
  using Key = std::vector<std::pair<vtkSmartPointer<vtkDataObject>, vtkMTimeType>>;
  Key mapsKey;
  Key chartsKey;
  /// Kind, array, picture and its time, projection, band-pass.
  using SourceKey =
    std::tuple<int, std::string, vtkSmartPointer<vtkImageData>, vtkMTimeType, int, double, double>;
  SourceKey sourceKey;
  bool hasBase = false;
  std::vector<std::vector<float>> base; ///< importance before the transfer function, in [0, 1]
  float largestBase = 0;                ///< 0: the quantity is the same everywhere

  bool hasSurface = false;
  stipple::AtlasSurface surface;
  double diagonal = 0;
  std::array<double, 6> bounds = { { 0. } };

  std::vector<vtkSmartPointer<vtkIntArray>> faces; ///< per chart, the FaceIndex maps as integers
  stipple::SurfaceDiffusion diffusion;
  bool hasDiffusion = false;
  std::vector<stipple::BrushStroke> painted; ///< the strokes that the layers hold
  std::vector<stipple::PaintLayer> layers;

  std::vector<ControlChart> charts; ///< of this execution

  static Key keyOf(vtkPartitionedDataSetCollection* data);
  void takeInput(vtkPartitionedDataSetCollection* maps, vtkPartitionedDataSetCollection* charts);
  Status readMaps(vtkPartitionedDataSetCollection* maps);
  Status readSurface(vtkPartitionedDataSetCollection* charts, const char* what);
  Status readFaces();
  std::vector<stipple::ControlImage> views() const;
  Status fillBase(vtkControlMap* self, const stipple::Progress& progress);
  double scaleByQuantile(const std::vector<float*>& values, int importance);
  Status smooth(const std::vector<float*>& values, double percent, const stipple::Progress& p);
  void paintStrokes();
  std::vector<float*> controls() const;
};

vtkControlMap::Internals::Key vtkControlMap::Internals::keyOf(vtkPartitionedDataSetCollection* data)
{
  Key key;
  for (unsigned int c = 0; data && c < data->GetNumberOfPartitionedDataSets(); ++c)
  {
    vtkDataObject* object =
      data->GetNumberOfPartitions(c) > 0 ? data->GetPartitionAsDataObject(c, 0) : nullptr;
    key.emplace_back(object, object ? object->GetMTime() : 0);
  }
  return key;
}

/// Forgets what was made from other maps or charts.
void vtkControlMap::Internals::takeInput(
  vtkPartitionedDataSetCollection* maps, vtkPartitionedDataSetCollection* surfaceCharts)
{
  Key newMaps = keyOf(maps);
  Key newCharts = keyOf(surfaceCharts);
  if (newCharts != this->chartsKey)
  {
    this->chartsKey = std::move(newCharts);
    this->hasSurface = false;
    this->mapsKey.clear();
  }
  if (newMaps != this->mapsKey)
  {
    this->mapsKey = std::move(newMaps);
    this->hasBase = false;
    this->hasDiffusion = false;
    this->faces.clear();
    this->painted.clear();
    this->layers.clear();
  }
}

Status vtkControlMap::Internals::readMaps(vtkPartitionedDataSetCollection* maps)
{
  this->charts.clear();
  for (unsigned int c = 0; c < maps->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto* map = maps->GetNumberOfPartitions(c) > 0
      ? vtkImageData::SafeDownCast(maps->GetPartitionAsDataObject(c, 0))
      : nullptr;
    vtkDataArray* area = map ? map->GetPointData()->GetArray("AreaDistortion") : nullptr;
    if (!area || area->GetNumberOfTuples() != map->GetNumberOfPoints())
    {
      return Status::error("Map " + std::to_string(c) +
        " is no vtkImageData with the point array AreaDistortion: pass the output of "
        "vtkGeometryMapRenderer with this map selected.");
    }
    ControlChart chart;
    chart.map = map;
    chart.area = std::make_unique<stipple::FloatValues>(area);
    chart.size = static_cast<std::size_t>(map->GetNumberOfPoints());
    chart.control = vtkSmartPointer<vtkFloatArray>::New();
    chart.control->SetName("Control");
    chart.control->SetNumberOfValues(map->GetNumberOfPoints());
    this->charts.push_back(std::move(chart));
  }
  return Status::success();
}

Status vtkControlMap::Internals::readSurface(
  vtkPartitionedDataSetCollection* surfaceCharts, const char* what)
{
  if (!surfaceCharts ||
    surfaceCharts->GetNumberOfPartitionedDataSets() != static_cast<unsigned>(this->charts.size()))
  {
    return Status::error(std::string(what) +
      " works on the surface: pass the charts that the maps are of to input port 1.");
  }
  if (this->hasSurface)
  {
    return Status::success();
  }
  if (Status status = stipple::readAtlas(surfaceCharts, this->surface); !status.ok())
  {
    return status;
  }
  vtkBoundingBox box;
  for (vtkPolyData* chart : this->surface.charts)
  {
    box.AddBounds(chart->GetBounds());
  }
  if (!box.IsValid())
  {
    return Status::error("The charts have no points: pass the charts that the maps are of.");
  }
  box.GetBounds(this->bounds.data());
  this->diagonal = box.GetDiagonalLength();
  this->hasSurface = true;
  return Status::success();
}

Status vtkControlMap::Internals::readFaces()
{
  if (!this->faces.empty())
  {
    return Status::success();
  }
  std::vector<vtkSmartPointer<vtkIntArray>> result;
  for (std::size_t c = 0; c < this->charts.size(); ++c)
  {
    vtkImageData* map = this->charts[c].map;
    vtkDataArray* array = map->GetPointData()->GetArray("FaceIndex");
    if (!array || array->GetNumberOfTuples() != map->GetNumberOfPoints() ||
      array->GetNumberOfComponents() != 1)
    {
      return Status::error("Map " + std::to_string(c) +
        " has no point array FaceIndex, which BandPass, Gradation and Strokes need: select it in "
        "vtkGeometryMapRenderer.");
    }
    vtkSmartPointer<vtkIntArray> integers = vtkIntArray::SafeDownCast(array);
    if (!integers)
    {
      integers = vtkSmartPointer<vtkIntArray>::New();
      integers->DeepCopy(array);
    }
    double range[2];
    integers->GetRange(range);
    const int begin = this->surface.chartBegin[c];
    if (range[0] < 0 || range[1] >= this->surface.chartBegin[c + 1] - begin)
    {
      return Status::error("FaceIndex of map " + std::to_string(c) +
        " names triangles that chart " + std::to_string(c) +
        " does not have: pass maps and charts of the same atlas.");
    }
    result.push_back(integers);
  }
  this->faces = std::move(result);
  return Status::success();
}

std::vector<stipple::ControlImage> vtkControlMap::Internals::views() const
{
  std::vector<stipple::ControlImage> result;
  for (std::size_t c = 0; c < this->charts.size(); ++c)
  {
    stipple::ControlImage view;
    view.width = this->charts[c].map->GetDimensions()[0];
    view.height = this->charts[c].map->GetDimensions()[1];
    view.extent = this->surface.extent[c];
    view.areaDistortion = this->charts[c].area->data();
    view.faceIndex = this->faces[c]->GetPointer(0);
    result.push_back(view);
  }
  return result;
}

std::vector<float*> vtkControlMap::Internals::controls() const
{
  std::vector<float*> result;
  for (const ControlChart& chart : this->charts)
  {
    result.push_back(chart.values());
  }
  return result;
}

/// Divides by the 99.5 % quantile, clamping to [0, 1]; returns the largest result, or 0 if the
/// values are nothing but rounding.
double vtkControlMap::Internals::scaleByQuantile(const std::vector<float*>& values, int importance)
{
  std::vector<stipple::WeightedValues> weighted;
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    const ControlChart& chart = this->charts[c];
    weighted.push_back({ values[c], chart.area->data(), chart.size, chart.pixelArea() });
  }
  const double noise = roundingNoise(importance, surfaceArea(weighted));
  double quantile = stipple::weightedQuantile(weighted, 0.995);
  if (quantile <= noise || !std::isfinite(quantile)) // all but a few places are flat
  {
    quantile = forEachPixelRun(
      this->charts, [&](const PixelRun& r) { return largestOf(values[r.chart], r.begin, r.end); });
  }
  if (quantile <= noise || !std::isfinite(quantile))
  {
    return 0.;
  }
  const auto scale = static_cast<float>(1. / quantile);
  return forEachPixelRun(this->charts, [&](const PixelRun& r) {
    float* v = values[r.chart];
    for (std::size_t i = r.begin; i < r.end; ++i)
    {
      const float scaled = v[i] * scale;
      v[i] = scaled > 0.f ? (scaled < 1.f ? scaled : 1.f) : 0.f; // NaN is nothing
    }
    return largestOf(v, r.begin, r.end);
  });
}

Status vtkControlMap::Internals::smooth(
  const std::vector<float*>& values, double percent, const stipple::Progress& progress)
{
  if (Status status = this->readFaces(); !status.ok())
  {
    return status;
  }
  if (!this->hasDiffusion)
  {
    this->diffusion.setDomain(this->surface, this->views());
    this->hasDiffusion = true;
  }
  return this->diffusion.smooth(values, 0.01 * percent * this->diagonal, progress);
}

/// The importance before the transfer function. Needs the surface where it works on it.
Status vtkControlMap::Internals::fillBase(vtkControlMap* self, const stipple::Progress& progress)
{
  const bool picture = self->Importance == IMAGE;
  SourceKey key(self->Importance,
    self->Importance == ARRAY && self->ImportanceArrayName ? self->ImportanceArrayName : "",
    picture ? self->ImportanceImage : nullptr,
    picture && self->ImportanceImage ? self->ImportanceImage->GetMTime() : 0,
    picture ? self->ImageProjection : 0, self->BandPass[0], self->BandPass[1]);
  if (this->hasBase && key == this->sourceKey)
  {
    return Status::success();
  }
  this->hasBase = false;
  std::unique_ptr<stipple::PictureBrightness> brightness;
  if (picture)
  {
    if (!self->ImportanceImage || self->ImportanceImage->GetNumberOfPoints() == 0 ||
      !self->ImportanceImage->GetPointData()->GetScalars())
    {
      return Status::error(
        "The importance is IMAGE, but there is no ImportanceImage with scalars: set one.");
    }
    brightness = std::make_unique<stipple::PictureBrightness>(self->ImportanceImage);
  }
  stipple::ImportanceSource source;
  source.importance = self->Importance;
  source.arrayName = self->ImportanceArrayName;
  source.picture = brightness.get();
  source.projection = self->ImageProjection;
  source.bounds = this->bounds;
  this->base.resize(this->charts.size());
  std::vector<float*> values;
  for (std::size_t c = 0; c < this->charts.size(); ++c)
  {
    this->base[c].resize(this->charts[c].size);
    values.push_back(this->base[c].data());
  }
  std::vector<std::string> missing(this->charts.size());
  forEachChart(this->charts.size(),
    [&](std::size_t c) { missing[c] = source.fill(this->charts[c].map, values[c]); });
  for (std::size_t c = 0; c < missing.size(); ++c)
  {
    if (!missing[c].empty())
    {
      return Status::error("Map " + std::to_string(c) + " has no point array " + missing[c] +
        ", which the importance needs: select it in vtkGeometryMapRenderer.");
    }
  }
  double largest = this->scaleByQuantile(values, self->Importance);
  if (largest > 0 && self->BandPass[1] > 0)
  {
    std::vector<std::vector<float>> coarse = this->base;
    std::vector<float*> coarseValues;
    for (std::vector<float>& v : coarse)
    {
      coarseValues.push_back(v.data());
    }
    Status status = this->smooth(coarseValues, self->BandPass[1],
      [&](double f) { return stipple::report(progress, 0.5 * f); });
    if (status.ok() && self->BandPass[0] > 0)
    {
      status = this->smooth(values, self->BandPass[0],
        [&](double f) { return stipple::report(progress, 0.5 + 0.5 * f); });
    }
    if (!status.ok())
    {
      return status;
    }
    forEachPixelRun(this->charts, [&](const PixelRun& r) {
      for (std::size_t i = r.begin; i < r.end; ++i)
      {
        values[r.chart][i] = std::abs(values[r.chart][i] - coarseValues[r.chart][i]);
      }
      return 0.f;
    });
    // What six digits cannot tell from nothing is nothing.
    const float rest = forEachPixelRun(
      this->charts, [&](const PixelRun& r) { return largestOf(values[r.chart], r.begin, r.end); });
    largest = rest > 1e-5f ? this->scaleByQuantile(values, vtkControlMap::UNIFORM) : 0.;
  }
  this->largestBase = static_cast<float>(largest);
  this->sourceKey = std::move(key);
  this->hasBase = true;
  return Status::success();
}

/// Brings the layers up to the strokes: only what is new is painted, unless strokes are gone.
void vtkControlMap::Internals::paintStrokes()
{
  std::vector<stipple::BrushStroke> wanted;
  for (vtkIdType i = 0; i < this->strokes->GetNumberOfTuples(); ++i)
  {
    const double* s = this->strokes->GetPointer(strokeComponents * i);
    wanted.push_back({ { s[0], s[1], s[2] }, s[3], s[4] });
  }
  const bool longer = this->painted.size() <= wanted.size() &&
    std::equal(this->painted.begin(), this->painted.end(), wanted.begin());
  if (!longer || this->layers.size() != this->charts.size())
  {
    this->painted.clear();
    this->layers.assign(this->charts.size(), {});
  }
  const std::vector<stipple::ControlImage> images = this->views();
  for (std::size_t i = this->painted.size(); i < wanted.size(); ++i)
  {
    stipple::paint(this->surface, images, wanted[i], this->layers);
  }
  this->painted = std::move(wanted);
}

vtkControlMap::vtkControlMap()
  : Data(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(2);
  this->Data->strokes->SetName("Strokes");
  this->Data->strokes->SetNumberOfComponents(strokeComponents);
}

vtkControlMap::~vtkControlMap()
{
  this->SetImportanceArrayName(nullptr);
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
  const double stroke[strokeComponents] = { x, y, z, radius, strength };
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
  const vtkIdType n = strokes ? strokes->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    if (strokes->GetNumberOfComponents() != strokeComponents ||
      !isStroke(strokes->GetPointer(strokeComponents * i)))
    {
      vtkErrorMacro(
        "Stroke " << i
                  << " is none: it has the components x, y, z, radius and strength, all "
                     "finite, the radius positive, and the strength at least -1.");
      return;
    }
  }
  vtkDoubleArray* own = this->Data->strokes;
  if (n == own->GetNumberOfTuples() &&
    std::equal(own->GetPointer(0), own->GetPointer(0) + strokeComponents * n,
      n > 0 ? strokes->GetPointer(0) : own->GetPointer(0)))
  {
    return;
  }
  own->SetNumberOfTuples(n);
  std::copy_n(n > 0 ? strokes->GetPointer(0) : nullptr, strokeComponents * n, own->GetPointer(0));
  this->Modified();
}

vtkDoubleArray* vtkControlMap::GetStrokes()
{
  return this->Data->strokes;
}

int vtkControlMap::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkControlMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkPartitionedDataSetCollection::GetData(inputVector[0], 0);
  auto* surfaceCharts = vtkPartitionedDataSetCollection::GetData(inputVector[1], 0);
  auto* output = vtkPartitionedDataSetCollection::GetData(outputVector, 0);
  if (!input || !output)
  {
    return 0;
  }
  Internals& d = *this->Data;
  const auto fail = [&](const Status& status) {
    output->Initialize();
    d.charts.clear();
    if (!status.isAbort())
    {
      vtkErrorMacro(<< status.message());
    }
    return 0;
  };
  d.takeInput(input, surfaceCharts);
  if (Status status = d.readMaps(input); !status.ok())
  {
    return fail(status);
  }
  if (d.charts.empty())
  {
    output->CopyStructure(input);
    return 1;
  }
  const auto progressFrom = [this](double begin, double end) {
    return [=](double fraction) {
      this->UpdateProgress(begin + (end - begin) * fraction);
      return this->GetAbortExecute() == 0;
    };
  };
  bool varies = this->Importance != UNIFORM && this->Gamma > 0.;
  const bool bandPass = varies && this->BandPass[1] > 0.;
  const bool gradation = varies && this->Gradation > 0.;
  const bool projection = varies && this->Importance == IMAGE && this->ImageProjection != CHART;
  const bool strokes = this->GetNumberOfStrokes() > 0;
  if (bandPass && !(this->BandPass[0] < this->BandPass[1]))
  {
    return fail(Status::error(
      "BandPass lets nothing through: its first size must be smaller than its second one."));
  }
  if (bandPass || gradation || projection || strokes)
  {
    const char* what = strokes ? "Painting"
      : gradation              ? "Gradation"
      : bandPass               ? "BandPass"
                               : "A projected ImportanceImage";
    if (Status status = d.readSurface(surfaceCharts, what); !status.ok())
    {
      return fail(status);
    }
  }
  if (strokes)
  {
    if (Status status = d.readFaces(); !status.ok())
    {
      return fail(status);
    }
  }
  if (varies)
  {
    if (Status status = d.fillBase(this, progressFrom(0., 0.4)); !status.ok())
    {
      return fail(status);
    }
    varies = d.largestBase > 0;
  }
  this->UpdateProgress(0.4);
  const stipple::UnitFunctionTable table([this](double x) {
    const double y = this->TransferFunction ? this->TransferFunction->GetValue(x) : x;
    return std::pow(std::max(y, 0.), this->Gamma);
  });
  float largest = 1.f; // before the floor
  const bool inPlace = strokes || (varies && (gradation || this->TransferFunction));
  if (inPlace)
  {
    const auto values = d.controls();
    largest = forEachPixelRun(d.charts, [&](const PixelRun& r) {
      float* v = values[r.chart];
      for (std::size_t i = r.begin; i < r.end; ++i)
      {
        v[i] = varies ? table(d.base[r.chart][i]) : 1.f;
      }
      return largestOf(v, r.begin, r.end);
    });
    if (varies && !(largest > 0))
    {
      vtkWarningMacro("The transfer function makes all importance zero: it is taken as uniform.");
      forEachPixelRun(d.charts, [&](const PixelRun& r) {
        std::fill(values[r.chart] + r.begin, values[r.chart] + r.end, 1.f);
        return 0.f;
      });
      largest = 1.f;
    }
    else if (varies && gradation)
    {
      if (Status status = d.smooth(values, this->Gradation, progressFrom(0.4, 0.7)); !status.ok())
      {
        return fail(status);
      }
    }
    if (strokes)
    {
      d.paintStrokes();
    }
    largest = forEachPixelRun(d.charts, [&](const PixelRun& r) {
      float* v = values[r.chart];
      if (strokes && !d.layers[r.chart].factor.empty())
      {
        const stipple::PaintLayer& layer = d.layers[r.chart];
        for (std::size_t i = r.begin; i < r.end; ++i)
        {
          v[i] = v[i] * layer.factor[i] + layer.offset[i];
        }
      }
      return largestOf(v, r.begin, r.end);
    });
    if (!(largest > 0))
    {
      return fail(Status::error("The strokes erase all importance: remove some of them."));
    }
  }
  else if (varies)
  {
    largest = table(d.largestBase); // the table ascends
  }
  this->UpdateProgress(0.8);
  const auto floorValue = static_cast<float>(this->MinimumDensity) * largest;
  forEachPixelRun(d.charts, [&](const PixelRun& r) {
    float* v = d.charts[r.chart].values();
    const float* area = d.charts[r.chart].area->data();
    for (std::size_t i = r.begin; i < r.end; ++i)
    {
      const float importance = inPlace ? v[i] : (varies ? table(d.base[r.chart][i]) : 1.f);
      v[i] = area[i] > 0 ? std::max(floorValue, importance) * area[i] : 0.f;
    }
    return 0.f;
  });
  output->CopyStructure(input);
  for (unsigned int c = 0; c < d.charts.size(); ++c)
  {
    vtkNew<vtkImageData> image;
    image->ShallowCopy(d.charts[c].map);
    image->GetPointData()->AddArray(d.charts[c].control); // SetScalars would drop those that are
    image->GetPointData()->SetActiveScalars("Control");
    output->SetPartition(c, 0, image);
  }
  d.charts.clear();
  this->UpdateProgress(1.);
  return 1;
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
  os << indent << "Strokes: " << this->GetNumberOfStrokes() << "\n";
  os << indent << "MinimumDensity: " << this->MinimumDensity << "\n";
}
