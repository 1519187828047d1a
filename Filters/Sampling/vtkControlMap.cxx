// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkControlMap.h"

#include "Gradation.h"
#include "Importance.h"

#include "vtkArrayDispatch.h"
#include "vtkBoundingBox.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkControlMap);
vtkCxxSetObjectMacro(vtkControlMap, ImportanceImage, vtkImageData);
vtkCxxSetObjectMacro(vtkControlMap, TransferFunction, vtkPiecewiseFunction);

namespace
{
/// Values of an array as floats: the norm of several components. Borrowed where they are floats
/// already.
class FloatValues
{
public:
  explicit FloatValues(vtkDataArray* array)
  {
    auto* floats = vtkFloatArray::SafeDownCast(array);
    if (floats && floats->GetNumberOfComponents() == 1)
    {
      this->Data = floats->GetPointer(0);
      return;
    }
    this->Copy.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
    const auto copy = [this](auto* typed) {
      const auto tuples = vtk::DataArrayTupleRange(typed);
      for (vtkIdType i = 0; i < tuples.size(); ++i)
      {
        double squared = 0;
        double last = 0;
        for (const auto component : tuples[i])
        {
          last = static_cast<double>(component);
          squared += last * last;
        }
        this->Copy[i] = static_cast<float>(tuples[i].size() == 1 ? last : std::sqrt(squared));
      }
    };
    if (!vtkArrayDispatch::Dispatch::Execute(array, copy))
    {
      copy(array);
    }
    this->Data = this->Copy.data();
  }
  FloatValues(const FloatValues&) = delete;
  void operator=(const FloatValues&) = delete;
  float operator[](std::size_t i) const { return this->Data[i]; }
  const float* data() const { return this->Data; }

private:
  const float* Data;
  std::vector<float> Copy;
};

struct ControlChart
{
  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkFloatArray> control;
  std::unique_ptr<FloatValues> area;
  std::size_t size = 0;
  float* values() const { return this->control->GetPointer(0); }
  double pixelArea() const { return this->image->GetSpacing()[0] * this->image->GetSpacing()[1]; }
};

/// Calls f(chart, begin, end) for runs of pixels, in parallel.
template <typename F>
void forEachPixelRun(const std::vector<ControlChart>& charts, F f)
{
  constexpr std::size_t length = 1u << 15;
  struct Run
  {
    std::size_t chart;
    std::size_t begin;
  };
  std::vector<Run> runs;
  for (std::size_t c = 0; c < charts.size(); ++c)
  {
    for (std::size_t begin = 0; begin < charts[c].size; begin += length)
    {
      runs.push_back({ c, begin });
    }
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(runs.size()), [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      const ControlChart& chart = charts[runs[i].chart];
      f(chart, runs[i].begin, std::min(runs[i].begin + length, chart.size));
    }
  });
}

/// Brightness of a picture at (x, y) in [0, 1]^2, linear between its pixels.
class Picture
{
public:
  explicit Picture(vtkImageData* image)
  {
    const int* dimensions = image->GetDimensions();
    this->Width = dimensions[0];
    this->Height = dimensions[1];
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    const int components = scalars->GetNumberOfComponents();
    this->Value.resize(static_cast<std::size_t>(this->Width) * this->Height);
    for (std::size_t i = 0; i < this->Value.size(); ++i)
    {
      const auto id = static_cast<vtkIdType>(i);
      this->Value[i] = static_cast<float>(components < 3 ? scalars->GetComponent(id, 0)
                                                         : 0.2126 * scalars->GetComponent(id, 0) +
            0.7152 * scalars->GetComponent(id, 1) + 0.0722 * scalars->GetComponent(id, 2));
    }
  }
  float operator()(double x, double y) const
  {
    const double u = std::clamp(x * this->Width - 0.5, 0., this->Width - 1.);
    const double v = std::clamp(y * this->Height - 0.5, 0., this->Height - 1.);
    const int i = std::min(static_cast<int>(u), std::max(0, this->Width - 2));
    const int j = std::min(static_cast<int>(v), std::max(0, this->Height - 2));
    const double s = u - i;
    const double t = v - j;
    const auto at = [this](int p, int q) {
      return this->Value[static_cast<std::size_t>(std::min(q, this->Height - 1)) * this->Width +
        std::min(p, this->Width - 1)];
    };
    return static_cast<float>((1. - t) * ((1. - s) * at(i, j) + s * at(i + 1, j)) +
      t * ((1. - s) * at(i, j + 1) + s * at(i + 1, j + 1)));
  }

private:
  int Width;
  int Height;
  std::vector<float> Value;
};

/// Diagonal of the bounding box of charts, or of the Position maps; 0 if neither is there.
double surfaceDiagonal(
  vtkPartitionedDataSetCollection* charts, const std::vector<ControlChart>& maps)
{
  vtkBoundingBox box;
  for (unsigned int c = 0; charts && c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    for (unsigned int p = 0; p < charts->GetNumberOfPartitions(c); ++p)
    {
      if (auto* data = vtkDataSet::SafeDownCast(charts->GetPartitionAsDataObject(c, p)))
      {
        box.AddBounds(data->GetBounds());
      }
    }
  }
  for (std::size_t c = 0; !box.IsValid() && c < maps.size(); ++c)
  {
    vtkDataArray* position = maps[c].image->GetPointData()->GetArray("Position");
    if (!position || position->GetNumberOfComponents() != 3)
    {
      return 0;
    }
    for (const ControlChart& map : maps)
    {
      if (vtkDataArray* p = map.image->GetPointData()->GetArray("Position"))
      {
        double bounds[6];
        for (int k = 0; k < 3; ++k)
        {
          p->GetRange(bounds + 2 * k, k);
        }
        box.AddBounds(bounds);
      }
    }
  }
  return box.IsValid() ? box.GetDiagonalLength() : 0.;
}

/// The quantity that an importance reads at a pixel, or what map is missing.
class Quantity
{
public:
  Quantity(int importance, const char* arrayName, const Picture* picture)
    : Importance(importance)
    , ArrayName(arrayName)
    , Brightness(picture)
  {
  }

  /// Fills the chart's control with magnitudes; returns the name of a missing map, or nothing.
  std::string fill(const ControlChart& chart) const
  {
    vtkPointData* data = chart.image->GetPointData();
    const auto find = [&](const char* name) {
      vtkDataArray* array = name ? data->GetArray(name) : nullptr;
      return array && array->GetNumberOfTuples() == static_cast<vtkIdType>(chart.size) ? array
                                                                                       : nullptr;
    };
    float* out = chart.values();
    const std::size_t n = chart.size;
    if (this->Importance == vtkControlMap::IMAGE)
    {
      const int width = chart.image->GetDimensions()[0];
      const int height = chart.image->GetDimensions()[1];
      for (int y = 0; y < height; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          *out++ = (*this->Brightness)((x + 0.5) / width, (y + 0.5) / height);
        }
      }
      return {};
    }
    static const char* const names[] = { nullptr, "MeanCurvature", "GaussianCurvature",
      "MinimumCurvature", "MaximumCurvature", "TotalCurvature", nullptr, nullptr };
    const char* name =
      this->Importance == vtkControlMap::ARRAY ? this->ArrayName : names[this->Importance];
    if (vtkDataArray* direct = find(name))
    {
      const FloatValues values(direct);
      for (std::size_t i = 0; i < n; ++i)
      {
        out[i] = std::abs(values[i]);
      }
      return {};
    }
    double (*formula)(double, double) = this->formula();
    if (!formula)
    {
      return name ? name : "(no ImportanceArrayName set)";
    }
    vtkDataArray* mean = find("MeanCurvature");
    vtkDataArray* gaussian = find("GaussianCurvature");
    if (!mean || !gaussian)
    {
      return mean ? "GaussianCurvature" : "MeanCurvature";
    }
    const FloatValues H(mean);
    const FloatValues K(gaussian);
    for (std::size_t i = 0; i < n; ++i)
    {
      out[i] = static_cast<float>(std::abs(formula(H[i], K[i])));
    }
    return {};
  }

private:
  double (*formula() const)(double, double)
  {
    switch (this->Importance)
    {
      case vtkControlMap::MINIMUM:
        return stipple::minimumCurvature;
      case vtkControlMap::MAXIMUM:
        return stipple::maximumCurvature;
      case vtkControlMap::TOTAL:
        return stipple::totalCurvature;
      case vtkControlMap::L2:
        return stipple::optimalL2Density;
      default:
        return nullptr;
    }
  }
  int Importance;
  const char* ArrayName;
  const Picture* Brightness;
};

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

float largestValue(const std::vector<ControlChart>& charts)
{
  float largest = 0;
  for (const ControlChart& chart : charts)
  {
    const float* v = chart.values();
    for (std::size_t i = 0; i < chart.size; ++i)
    {
      largest = v[i] > largest ? v[i] : largest;
    }
  }
  return largest;
}
}

vtkControlMap::vtkControlMap()
{
  this->SetNumberOfInputPorts(2);
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
  auto* output = vtkPartitionedDataSetCollection::GetData(outputVector, 0);
  if (!input || !output)
  {
    return 0;
  }
  const unsigned int n = input->GetNumberOfPartitionedDataSets();
  std::vector<ControlChart> charts;
  output->CopyStructure(input);
  for (unsigned int c = 0; c < n; ++c)
  {
    auto* map = input->GetNumberOfPartitions(c) > 0
      ? vtkImageData::SafeDownCast(input->GetPartitionAsDataObject(c, 0))
      : nullptr;
    vtkDataArray* area = map ? map->GetPointData()->GetArray("AreaDistortion") : nullptr;
    if (!area || area->GetNumberOfTuples() != map->GetNumberOfPoints())
    {
      vtkErrorMacro(
        "Map " << c
               << " is no vtkImageData with the point array AreaDistortion: pass the output of "
                  "vtkGeometryMapRenderer with this map selected.");
      output->Initialize();
      return 0;
    }
    ControlChart chart;
    chart.image = vtkSmartPointer<vtkImageData>::New();
    chart.image->ShallowCopy(map);
    chart.area = std::make_unique<FloatValues>(area);
    chart.size = static_cast<std::size_t>(map->GetNumberOfPoints());
    chart.control = vtkSmartPointer<vtkFloatArray>::New();
    chart.control->SetName("Control");
    chart.control->SetNumberOfValues(map->GetNumberOfPoints());
    charts.push_back(std::move(chart));
  }

  if (n == 0)
  {
    return 1;
  }
  const bool uniform = this->Importance == UNIFORM || this->Gamma == 0.;
  float floorValue = 0.f;
  double quantile = 0.;
  double noise = 0.;
  std::unique_ptr<Picture> picture;
  if (!uniform)
  {
    if (this->Importance == IMAGE)
    {
      if (!this->ImportanceImage || this->ImportanceImage->GetNumberOfPoints() == 0 ||
        !this->ImportanceImage->GetPointData()->GetScalars())
      {
        vtkErrorMacro(
          "The importance is IMAGE, but there is no ImportanceImage with scalars: set one.");
        output->Initialize();
        return 0;
      }
      picture = std::make_unique<Picture>(this->ImportanceImage);
    }
    const Quantity quantity(this->Importance, this->ImportanceArrayName, picture.get());
    std::vector<std::string> missing(n);
    vtkSMPTools::For(0, n, 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType c = begin; c < end; ++c)
      {
        missing[c] = quantity.fill(charts[c]);
      }
    });
    for (unsigned int c = 0; c < n; ++c)
    {
      if (!missing[c].empty())
      {
        vtkErrorMacro(
          "Map " << c << " has no point array " << missing[c]
                 << ", which the importance needs: select it in vtkGeometryMapRenderer.");
        output->Initialize();
        return 0;
      }
    }
    this->UpdateProgress(0.3);
    std::vector<stipple::WeightedValues> weighted;
    for (const ControlChart& chart : charts)
    {
      weighted.push_back({ chart.values(), chart.area->data(), chart.size, chart.pixelArea() });
    }
    noise = roundingNoise(this->Importance, surfaceArea(weighted));
    quantile = stipple::weightedQuantile(weighted, 0.995);
    if (quantile <= noise || !std::isfinite(quantile))
    {
      quantile = largestValue(charts); // all but a few places are flat
    }
  }
  bool varies = !uniform && quantile > noise && std::isfinite(quantile);
  if (varies)
  {
    const stipple::UnitFunctionTable table([this](double x) {
      const double y = this->TransferFunction ? this->TransferFunction->GetValue(x) : x;
      return std::pow(std::max(y, 0.), this->Gamma);
    });
    const auto scale = static_cast<float>(1. / quantile);
    forEachPixelRun(charts, [&](const ControlChart& chart, std::size_t begin, std::size_t end) {
      float* v = chart.values();
      for (std::size_t i = begin; i < end; ++i)
      {
        v[i] = table(v[i] * scale);
      }
    });
    this->UpdateProgress(0.5);
    if (this->Gradation > 0)
    {
      const double diagonal =
        surfaceDiagonal(vtkPartitionedDataSetCollection::GetData(inputVector[1], 0), charts);
      if (diagonal <= 0)
      {
        vtkErrorMacro(
          "Gradation needs the surface's size: pass the charts to input port 1, or select the "
          "Position map in vtkGeometryMapRenderer.");
        output->Initialize();
        return 0;
      }
      const double sigma = 0.01 * this->Gradation * diagonal;
      vtkSMPTools::For(0, n, 1, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType c = begin; c < end; ++c)
        {
          const int* size = charts[c].image->GetDimensions();
          const double* spacing = charts[c].image->GetSpacing();
          stipple::smoothOnSurface(charts[c].values(), charts[c].area->data(), size[0], size[1],
            spacing[0], spacing[1], sigma);
        }
      });
    }
    const float largest = largestValue(charts);
    floorValue = static_cast<float>(this->MinimumDensity) * largest;
    if (!(largest > 0))
    {
      vtkWarningMacro("The transfer function makes all importance zero: it is taken as uniform.");
      varies = false;
    }
  }
  this->UpdateProgress(0.8);
  forEachPixelRun(charts, [&](const ControlChart& chart, std::size_t begin, std::size_t end) {
    float* v = chart.values();
    const float* area = chart.area->data();
    for (std::size_t i = begin; i < end; ++i)
    {
      const float importance = varies ? std::max(floorValue, v[i]) : 1.f;
      v[i] = area[i] > 0 ? importance * area[i] : 0.f;
    }
  });
  for (unsigned int c = 0; c < n; ++c)
  {
    charts[c].image->GetPointData()->AddArray(charts[c].control); // SetScalars would drop those
                                                                  // that are
    charts[c].image->GetPointData()->SetActiveScalars("Control");
    output->SetPartition(c, 0, charts[c].image);
  }
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
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "TransferFunction: " << this->TransferFunction << "\n";
  os << indent << "Gradation: " << this->Gradation << "\n";
  os << indent << "MinimumDensity: " << this->MinimumDensity << "\n";
}
