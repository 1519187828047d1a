// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ControlMapBuilder.h"

#include "Atlas.h"
#include "CurvatureSizes.h"
#include "FloatValues.h"
#include "Importance.h"
#include "ImportanceSource.h"
#include "SamplingConstants.h"
#include "SizingFunction.h"
#include "SurfaceDiffusion.h"

#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

/// One chart: the map that comes in, and the control that goes out.
struct ControlChart
{
  vtkSmartPointer<vtkImageData> map;
  vtkSmartPointer<vtkFloatArray> control;
  std::unique_ptr<FloatValues> area;
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

/// Magnitudes of an importance that rounding leaves on a flat surface of this area: radii of
/// curvature beyond 1e5 times the surface's size.
double roundingNoise(ImportanceKind importance, double area)
{
  const double curvature = area > 0 ? 1e-5 / std::sqrt(area) : 0.;
  switch (importance)
  {
    case ImportanceKind::Mean:
    case ImportanceKind::Minimum:
    case ImportanceKind::Maximum:
      return curvature;
    case ImportanceKind::Gaussian:
    case ImportanceKind::Total:
      return curvature * curvature;
    case ImportanceKind::L2:
      return std::cbrt(curvature * curvature);
    default:
      return 0.;
  }
}

double surfaceArea(const std::vector<WeightedValues>& values)
{
  double area = 0;
  for (const WeightedValues& v : values)
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

/// The part of a step in the whole's progress.
Progress partOf(const Progress& progress, double begin, double end)
{
  return [&progress, begin, end](
           double fraction) { return report(progress, begin + (end - begin) * fraction); };
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
}

struct ControlMapBuilder::Internals
{
  // Kept from execution to execution, each with what it was made from:
  using Key = std::vector<std::pair<vtkSmartPointer<vtkDataObject>, vtkMTimeType>>;
  Key mapsKey;
  /// Kind, array, picture and its time, projection, band-pass.
  using SourceKey = std::tuple<ImportanceKind, std::string, vtkSmartPointer<vtkImageData>,
    vtkMTimeType, PictureProjection, double, double>;
  SourceKey sourceKey;
  bool hasBase = false;
  std::vector<std::vector<float>> base; ///< importance before the transfer function, in [0, 1]
  float largestBase = 0;                ///< 0: the quantity is the same everywhere

  Atlas::Pointer atlas; ///< the charts, once something needs the surface
  double diagonal = 0;
  std::array<double, 6> bounds = { { 0. } };

  std::vector<vtkSmartPointer<vtkIntArray>> faces; ///< per chart, the FaceIndex maps as integers
  SurfaceDiffusion diffusion;
  bool hasDiffusion = false;
  std::vector<BrushStroke> painted; ///< the strokes that the layers hold
  Atlas::Pointer paintedAtlas;      ///< with the features that bounded them; null if none asked
  std::vector<PaintLayer> layers;

  std::vector<ControlChart> charts; ///< of this execution
  Sizes sizes;                      ///< of the last control

  static Key keyOf(vtkPartitionedDataSetCollection* data);
  void takeMaps(vtkPartitionedDataSetCollection* maps);
  void forget();
  Status readMaps(vtkPartitionedDataSetCollection* maps);
  Status readSurface(vtkPartitionedDataSetCollection* charts, const char* what);
  Status readFaces();
  std::vector<ControlImage> views() const;
  Status fillBase(const ControlMapOptions& o, const Progress& progress);
  double scaleByQuantile(const std::vector<float*>& values, ImportanceKind importance);
  Status smooth(const std::vector<float*>& values, double percent, const Progress& p);
  Status paintStrokes(vtkPartitionedDataSetCollection* surfaceCharts, vtkPolyData* featureGraph,
    const std::vector<BrushStroke>& wanted);
  Status fillImportance(const ControlMapOptions& o, bool varies, const UnitFunctionTable& table,
    const Progress& progress, float& largest, std::string& warning);
  std::vector<float*> controls() const;
  Status fillControl(vtkPartitionedDataSetCollection* charts, vtkPolyData* featureGraph,
    const ControlMapOptions& o, const Progress& progress, std::string& warning);
  Status fillFromSizes(
    vtkPartitionedDataSetCollection* charts, const ControlMapOptions& o, const Progress& progress);
  Status sizesOfCurvature(vtkPartitionedDataSetCollection* charts, const ControlMapOptions& o,
    const Progress& progress, std::vector<std::vector<float>>& sizes);
  Status applySizes(vtkPartitionedDataSetCollection* charts, vtkPolyData* featureGraph,
    const ControlMapOptions& o, const Progress& progress);
};

ControlMapBuilder::Internals::Key ControlMapBuilder::Internals::keyOf(
  vtkPartitionedDataSetCollection* data)
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

/// Forgets what was made from other maps.
void ControlMapBuilder::Internals::takeMaps(vtkPartitionedDataSetCollection* maps)
{
  Key newMaps = keyOf(maps);
  if (newMaps != this->mapsKey)
  {
    this->mapsKey = std::move(newMaps);
    this->forget();
  }
}

void ControlMapBuilder::Internals::forget()
{
  this->hasBase = false;
  this->hasDiffusion = false;
  this->faces.clear();
  this->painted.clear();
  this->layers.clear();
}

Status ControlMapBuilder::Internals::readMaps(vtkPartitionedDataSetCollection* maps)
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
    chart.area = std::make_unique<FloatValues>(area);
    chart.size = static_cast<std::size_t>(map->GetNumberOfPoints());
    chart.control = vtkSmartPointer<vtkFloatArray>::New();
    chart.control->SetName("Control");
    chart.control->SetNumberOfValues(map->GetNumberOfPoints());
    this->charts.push_back(std::move(chart));
  }
  return Status::success();
}

Status ControlMapBuilder::Internals::readSurface(
  vtkPartitionedDataSetCollection* surfaceCharts, const char* what)
{
  if (!surfaceCharts ||
    surfaceCharts->GetNumberOfPartitionedDataSets() != static_cast<unsigned>(this->charts.size()))
  {
    return Status::error(std::string(what) +
      " works on the surface: pass the charts that the maps are of to input port 1.");
  }
  const Atlas::Pointer before = this->atlas;
  if (Status status = Atlas::read(surfaceCharts, nullptr, this->atlas); !status.ok())
  {
    return status;
  }
  if (this->atlas == before)
  {
    return Status::success();
  }
  this->forget();
  vtkBoundingBox box;
  for (vtkPolyData* chart : this->atlas->surface().charts)
  {
    box.AddBounds(chart->GetBounds());
  }
  if (!box.IsValid())
  {
    return Status::error("The charts have no points: pass the charts that the maps are of.");
  }
  box.GetBounds(this->bounds.data());
  this->diagonal = box.GetDiagonalLength();
  return Status::success();
}

Status ControlMapBuilder::Internals::readFaces()
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
        " has no point array FaceIndex, which BandPass, Gradation and Strokes need.");
    }
    vtkSmartPointer<vtkIntArray> integers = vtkIntArray::SafeDownCast(array);
    if (!integers)
    {
      integers = vtkSmartPointer<vtkIntArray>::New();
      integers->DeepCopy(array);
    }
    double range[2];
    integers->GetRange(range);
    if (range[0] < 0 || range[1] >= this->atlas->surface().faces(Chart(static_cast<int>(c))).size())
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

std::vector<ControlImage> ControlMapBuilder::Internals::views() const
{
  std::vector<ControlImage> result;
  for (std::size_t c = 0; c < this->charts.size(); ++c)
  {
    ControlImage view;
    view.width = this->charts[c].map->GetDimensions()[0];
    view.height = this->charts[c].map->GetDimensions()[1];
    const double* spacing = this->charts[c].map->GetSpacing();
    view.extent = Vec2(view.width * spacing[0], view.height * spacing[1]);
    view.areaDistortion = this->charts[c].area->data();
    view.faceIndex = this->faces.empty() ? nullptr : this->faces[c]->GetPointer(0);
    result.push_back(view);
  }
  return result;
}

std::vector<float*> ControlMapBuilder::Internals::controls() const
{
  std::vector<float*> result;
  for (const ControlChart& chart : this->charts)
  {
    result.push_back(chart.values());
  }
  return result;
}

/// Divides by the largest quantile, clamping to [0, 1]; returns the largest result, or 0 if the
/// values are nothing but rounding.
double ControlMapBuilder::Internals::scaleByQuantile(
  const std::vector<float*>& values, ImportanceKind importance)
{
  std::vector<WeightedValues> weighted;
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    const ControlChart& chart = this->charts[c];
    weighted.push_back({ values[c], chart.area->data(), chart.size, chart.pixelArea() });
  }
  const double noise = roundingNoise(importance, surfaceArea(weighted));
  double quantile = weightedQuantile(weighted, Constants::LargestQuantile);
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

Status ControlMapBuilder::Internals::smooth(
  const std::vector<float*>& values, double percent, const Progress& progress)
{
  if (Status status = this->readFaces(); !status.ok())
  {
    return status;
  }
  if (!this->hasDiffusion)
  {
    this->diffusion.setDomain(this->atlas->surface(), this->views());
    this->hasDiffusion = true;
  }
  return this->diffusion.smooth(values, 0.01 * percent * this->diagonal, progress);
}

/// The importance before the transfer function. Needs the surface where it works on it.
Status ControlMapBuilder::Internals::fillBase(const ControlMapOptions& o, const Progress& progress)
{
  const bool picture = o.importance == ImportanceKind::Image;
  SourceKey key(o.importance, o.importance == ImportanceKind::Array ? o.arrayName : "",
    picture ? o.image : nullptr, picture && o.image ? o.image->GetMTime() : 0,
    picture ? o.projection : PictureProjection::Chart, o.bandPass[0], o.bandPass[1]);
  if (this->hasBase && key == this->sourceKey)
  {
    return Status::success();
  }
  this->hasBase = false;
  std::unique_ptr<PictureBrightness> brightness;
  if (picture)
  {
    if (!o.image || o.image->GetNumberOfPoints() == 0 || !o.image->GetPointData()->GetScalars())
    {
      return Status::error(
        "The importance is IMAGE, but there is no ImportanceImage with scalars: set one.");
    }
    brightness = std::make_unique<PictureBrightness>(o.image);
  }
  ImportanceSource source;
  source.importance = o.importance;
  source.arrayName = o.arrayName.empty() ? nullptr : o.arrayName.c_str();
  source.picture = brightness.get();
  source.projection = o.projection;
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
        ", which the importance needs.");
    }
  }
  double largest = this->scaleByQuantile(values, o.importance);
  if (largest > 0 && o.bandPass[1] > 0)
  {
    std::vector<std::vector<float>> coarse = this->base;
    std::vector<float*> coarseValues;
    for (std::vector<float>& v : coarse)
    {
      coarseValues.push_back(v.data());
    }
    Status status = this->smooth(
      coarseValues, o.bandPass[1], [&](double f) { return report(progress, 0.5 * f); });
    if (status.ok() && o.bandPass[0] > 0)
    {
      status = this->smooth(
        values, o.bandPass[0], [&](double f) { return report(progress, 0.5 + 0.5 * f); });
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
    largest = rest > 1e-5f ? this->scaleByQuantile(values, ImportanceKind::Uniform) : 0.;
  }
  this->largestBase = static_cast<float>(largest);
  this->sourceKey = std::move(key);
  this->hasBase = true;
  return Status::success();
}

/// Brings the layers up to the strokes: only what is new is painted, unless strokes are gone, or
/// features have changed that bound them.
Status ControlMapBuilder::Internals::paintStrokes(vtkPartitionedDataSetCollection* surfaceCharts,
  vtkPolyData* featureGraph, const std::vector<BrushStroke>& wanted)
{
  const auto fills = [](const BrushStroke& s) { return s.radius == 0; };
  Atlas::Pointer whole; // with its features
  if (std::any_of(wanted.begin(), wanted.end(), fills))
  {
    if (Status status = Atlas::read(surfaceCharts, featureGraph, whole); !status.ok())
    {
      return status;
    }
    if (whole != this->paintedAtlas)
    {
      this->painted.clear();
      this->layers.clear();
    }
  }
  this->paintedAtlas = whole;
  const bool longer = this->painted.size() <= wanted.size() &&
    std::equal(this->painted.begin(), this->painted.end(), wanted.begin());
  if (!longer || this->layers.size() != this->charts.size())
  {
    this->painted.clear();
    this->layers.assign(this->charts.size(), {});
  }
  const std::vector<ControlImage> images = this->views();
  const auto firstNew = wanted.begin() + static_cast<std::ptrdiff_t>(this->painted.size());
  const std::vector<char> walls = std::any_of(firstNew, wanted.end(), fills)
    ? whole->halfedgesOn({ BackboneType::Sharp })
    : std::vector<char>();
  for (std::size_t i = this->painted.size(); i < wanted.size(); ++i)
  {
    paint(this->atlas->surface(), images, wanted[i], walls, this->layers);
  }
  this->painted = wanted;
  return Status::success();
}

/// The importance before the floor, in place of the control; `varies` says whether there is a base.
Status ControlMapBuilder::Internals::fillImportance(const ControlMapOptions& o, bool varies,
  const UnitFunctionTable& table, const Progress& progress, float& largest, std::string& warning)
{
  const auto values = this->controls();
  largest = forEachPixelRun(this->charts, [&](const PixelRun& r) {
    float* v = values[r.chart];
    for (std::size_t i = r.begin; i < r.end; ++i)
    {
      v[i] = varies ? table(this->base[r.chart][i]) : 1.f;
    }
    return largestOf(v, r.begin, r.end);
  });
  if (!(largest > 0))
  {
    warning = "The transfer function makes all importance zero: it is taken as uniform.";
    forEachPixelRun(this->charts, [&](const PixelRun& r) {
      std::fill(values[r.chart] + r.begin, values[r.chart] + r.end, 1.f);
      return 0.f;
    });
  }
  else if (varies && o.gradation > 0)
  {
    if (Status status = this->smooth(values, o.gradation, progress); !status.ok())
    {
      return status;
    }
  }
  largest = forEachPixelRun(this->charts, [&](const PixelRun& r) {
    float* v = values[r.chart];
    if (!o.strokes.empty() && !this->layers[r.chart].factor.empty())
    {
      const PaintLayer& layer = this->layers[r.chart];
      for (std::size_t i = r.begin; i < r.end; ++i)
      {
        v[i] = v[i] * layer.factor[i] + layer.offset[i];
      }
    }
    return largestOf(v, r.begin, r.end);
  });
  return largest > 0 ? Status::success()
                     : Status::error("The strokes erase all importance: remove some of them.");
}

/// The control that an importance makes, after paper 3.1 and 3.3.
Status ControlMapBuilder::Internals::fillControl(vtkPartitionedDataSetCollection* surfaceCharts,
  vtkPolyData* featureGraph, const ControlMapOptions& o, const Progress& progress,
  std::string& warning)
{
  bool varies = o.importance != ImportanceKind::Uniform && o.gamma > 0.;
  const bool bandPass = varies && o.bandPass[1] > 0.;
  const bool gradation = varies && o.gradation > 0.;
  const bool projection =
    varies && o.importance == ImportanceKind::Image && o.projection != PictureProjection::Chart;
  const bool strokes = !o.strokes.empty();
  if (bandPass && !(o.bandPass[0] < o.bandPass[1]))
  {
    return Status::error(
      "BandPass lets nothing through: its first size must be smaller than its second one.");
  }
  if (bandPass || gradation || projection || strokes)
  {
    const char* what = strokes ? "Painting"
      : gradation              ? "Gradation"
      : bandPass               ? "BandPass"
                               : "A projected ImportanceImage";
    if (Status status = this->readSurface(surfaceCharts, what); !status.ok())
    {
      return status;
    }
  }
  if (strokes)
  {
    Status status = this->readFaces();
    if (status.ok())
    {
      status = this->paintStrokes(surfaceCharts, featureGraph, o.strokes);
    }
    if (!status.ok())
    {
      return status;
    }
  }
  if (varies)
  {
    if (Status status = this->fillBase(o, partOf(progress, 0., 0.5)); !status.ok())
    {
      return status;
    }
    varies = this->largestBase > 0;
  }
  const UnitFunctionTable table([&o](double x) {
    const double y = o.transfer ? o.transfer->GetValue(x) : x;
    return std::pow(std::max(y, 0.), o.gamma);
  });
  // Where nothing but the table acts, which ascends, one pass over the pixels does.
  const bool inPlace = strokes || (varies && (gradation || o.transfer));
  float largest = varies ? table(this->largestBase) : 1.f;
  if (inPlace)
  {
    if (Status status =
          this->fillImportance(o, varies, table, partOf(progress, 0.5, 1.), largest, warning);
        !status.ok())
    {
      return status;
    }
  }
  const auto floorValue = static_cast<float>(o.minimumDensity) * largest;
  forEachPixelRun(this->charts, [&](const PixelRun& r) {
    float* v = this->charts[r.chart].values();
    const float* area = this->charts[r.chart].area->data();
    for (std::size_t i = r.begin; i < r.end; ++i)
    {
      const float importance = inPlace ? v[i] : (varies ? table(this->base[r.chart][i]) : 1.f);
      v[i] = area[i] > 0 ? std::max(floorValue, importance) * area[i] : 0.f;
    }
    return 0.f;
  });
  return Status::success();
}

/// Bounds the lengths of edges.
Status ControlMapBuilder::Internals::applySizes(vtkPartitionedDataSetCollection* surfaceCharts,
  vtkPolyData* featureGraph, const ControlMapOptions& o, const Progress& progress)
{
  this->sizes = {};
  SizingOptions sizing = o.sizing;
  if (o.curvaturePoints > 0)
  {
    sizing.edgeLength = 0; // it is one of the lengths
  }
  const bool isKnown = sizing.numberOfSamples > 0 || sizing.edgeLength > 0 ||
    !o.sizeArray.empty() || o.curvaturePoints > 0;
  if (!isKnown)
  {
    return o.sizing.smallest > 0 || o.sizing.largest > 0
      ? Status::error("SizeMinimum and SizeMaximum bound lengths of edges, which are not known "
                      "without NumberOfSamples, EdgeLength, CurvaturePoints or a SizeArray: set "
                      "one.")
      : Status::success();
  }
  const bool grows = o.sizing.growth > 1. && o.growFromFeatures && featureGraph;
  Atlas::Pointer whole; // with its features
  if (grows)
  {
    if (Status status = this->readSurface(surfaceCharts, "Growth"); !status.ok())
    {
      return status;
    }
    if (Status status = this->readFaces(); !status.ok())
    {
      return status;
    }
    if (Status status = Atlas::read(surfaceCharts, featureGraph, whole); !status.ok())
    {
      return status;
    }
  }
  std::vector<ControlImage> images = this->views();
  for (std::size_t c = 0; c < images.size(); ++c)
  {
    images[c].control = this->charts[c].values();
  }
  return applySizing(whole.get(), images, sizing, progress, this->controls(), this->sizes);
}

Status ControlMapBuilder::Internals::sizesOfCurvature(
  vtkPartitionedDataSetCollection* surfaceCharts, const ControlMapOptions& o,
  const Progress& progress, std::vector<std::vector<float>>& sizes)
{
  if (Status status = this->readSurface(surfaceCharts, "CurvaturePoints"); !status.ok())
  {
    return status;
  }
  if (Status status = this->readFaces(); !status.ok())
  {
    return status;
  }
  CurvatureSizeOptions options;
  options.pointsPerTurn = o.curvaturePoints;
  options.smallest = o.sizing.smallest;
  options.growth = o.sizing.growth;
  for (const double bound : { o.sizing.largest, o.sizing.edgeLength })
  {
    options.largest = bound > 0 ? std::min(options.largest, bound) : options.largest;
  }
  if (o.sizeArray.empty() && std::isinf(options.largest))
  {
    options.largest = largestOfTurn(o.curvaturePoints, this->diagonal);
  }
  return curvatureSizes(this->atlas->surface(), this->views(), options, progress, sizes);
}

/// The control that wants the lengths of an array, of the curvature, or the smaller ones.
Status ControlMapBuilder::Internals::fillFromSizes(vtkPartitionedDataSetCollection* surfaceCharts,
  const ControlMapOptions& o, const Progress& progress)
{
  const std::string& array = o.sizeArray;
  std::vector<std::vector<float>> bent;
  if (o.curvaturePoints > 0)
  {
    if (Status status = this->sizesOfCurvature(surfaceCharts, o, progress, bent); !status.ok())
    {
      return status;
    }
  }
  for (std::size_t c = 0; c < this->charts.size(); ++c)
  {
    const ControlChart& chart = this->charts[c];
    vtkDataArray* sizes =
      array.empty() ? nullptr : chart.map->GetPointData()->GetArray(array.c_str());
    if (!array.empty() &&
      (!sizes || sizes->GetNumberOfTuples() != chart.map->GetNumberOfPoints() ||
        sizes->GetNumberOfComponents() != 1))
    {
      return Status::error(
        "The maps have no point array " + array + " of one component, the array of sizes.");
    }
    const auto values = sizes ? std::make_unique<FloatValues>(sizes) : nullptr;
    float* v = chart.values();
    for (std::size_t i = 0; i < chart.size; ++i)
    {
      const float own = values ? values->data()[i] : bent[c][i];
      const float size = bent.empty() || !(own > bent[c][i]) ? own : bent[c][i];
      const float area = chart.area->data()[i];
      if (area > 0 && !(size > 0 && std::isfinite(size)))
      {
        return Status::error(
          "The size array " + array + " holds lengths that are not positive and finite.");
      }
      v[i] = area > 0 ? static_cast<float>(densityOfEdges(size)) * area : 0.f;
    }
  }
  return Status::success();
}

ControlMapBuilder::ControlMapBuilder()
  : Data(std::make_unique<Internals>())
{
}

ControlMapBuilder::~ControlMapBuilder() = default;

const Sizes& ControlMapBuilder::sizes() const
{
  return this->Data->sizes;
}

Status ControlMapBuilder::build(vtkPartitionedDataSetCollection* maps,
  vtkPartitionedDataSetCollection* surfaceCharts, vtkPolyData* featureGraph,
  const ControlMapOptions& o, const Progress& progress,
  std::vector<vtkSmartPointer<vtkFloatArray>>& control, std::string& warning)
{
  Internals& d = *this->Data;
  control.clear();
  d.diffusion.setTolerance(o.tolerance);
  d.takeMaps(maps);
  if (Status status = d.readMaps(maps); !status.ok() || d.charts.empty())
  {
    return status;
  }
  Status status = o.sizeArray.empty() && o.curvaturePoints <= 0
    ? d.fillControl(surfaceCharts, featureGraph, o, partOf(progress, 0., 0.8), warning)
    : d.fillFromSizes(surfaceCharts, o, partOf(progress, 0., 0.8));
  if (status.ok())
  {
    status = d.applySizes(surfaceCharts, featureGraph, o, partOf(progress, 0.8, 1.));
  }
  if (!status.ok())
  {
    return status;
  }
  for (const ControlChart& chart : d.charts)
  {
    control.push_back(chart.control);
  }
  d.charts.clear();
  return Status::success();
}
}
