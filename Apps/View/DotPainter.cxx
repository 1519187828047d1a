// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DotPainter.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace stipple
{
/// A sample as it is shown.
struct DotPainter::Dot
{
  Vec3 position;
  Vec2 uv; ///< in its own chart
  double radius = 0;
  double density = 0; ///< samples per unit of area
  int chart = 0;
  Face face = Face(0);
  bool line = false; ///< on a feature, a boundary or a seam
};

namespace
{
using Texel = std::array<unsigned char, 4>; ///< a sample's number from 1, the lowest byte first
constexpr Texel NoSample = { { 0, 0, 0, 255 } };
constexpr double MeanShare = 0.24;     ///< of the mean distance between samples: a dot's radius ...
constexpr double LocalShare = 0.30;    ///< ... but no more than so much of the distance there
constexpr double LargestShare = 0.008; ///< ... and of the model's size
constexpr double RoomyTexel = 0.12;    ///< samples a texel, at most, nearly everywhere
constexpr int FinestTexture = 3;       ///< texels along a pixel of the halftone, at most
constexpr double MostTexels = 1 << 25; ///< of all charts: ten for each pixel of a large screen

Eigen::AlignedBox3d boxOf(const AtlasSurface& surface)
{
  Eigen::AlignedBox3d box;
  for (const Face f : surface.faces())
  {
    box.extend(surface.point(f, 0));
  }
  return box;
}

Texel texelOf(int number)
{
  const int code = number + 1;
  return { { static_cast<unsigned char>(code & 255), static_cast<unsigned char>(code >> 8 & 255),
    static_cast<unsigned char>(code >> 16 & 255), 255 } };
}

/// The metric by steps of (du, dv).
FirstFundamentalForm scaled(const FirstFundamentalForm& m, double du, double dv)
{
  return { static_cast<float>(m.E * du * du), static_cast<float>(m.F * du * dv),
    static_cast<float>(m.G * dv * dv) };
}

/// Area on the surface over area in the plane.
double areaOf(const FirstFundamentalForm& m)
{
  return std::sqrt(std::max(0., static_cast<double>(m.E) * m.G - static_cast<double>(m.F) * m.F));
}

/// An image of numbered dots that is painted.
struct Numbers
{
  int width;
  int height;
  Texel* texels;
  float* distances; ///< squared; those of texels that have a number

  /// Marks the texels that are within `reach` on the surface of a place of the plane, in texels, if
  /// no other sample is nearer to them.
  void mark(const Vec2& at, const FirstFundamentalForm& m, double reach, int number)
  {
    constexpr double Margin = 1.; // texels: the one at a pixel of the screen has its middle
                                  // elsewhere
    const double both = static_cast<double>(m.E) * m.G;
    const double determinant = std::max(both - static_cast<double>(m.F) * m.F, 1e-12 * both);
    const bool flat = !(determinant > 0); // a face without an area
    const double reachX = flat ? Margin : reach * std::sqrt(m.G / determinant) + Margin;
    const double reachY = flat ? Margin : reach * std::sqrt(m.E / determinant) + Margin;
    const int left = static_cast<int>(std::max(0., std::ceil(at.x() - reachX - 0.5)));
    const int right =
      static_cast<int>(std::min(this->width - 1., std::floor(at.x() + reachX - 0.5)));
    const int low = static_cast<int>(std::max(0., std::ceil(at.y() - reachY - 0.5)));
    const int high =
      static_cast<int>(std::min(this->height - 1., std::floor(at.y() + reachY - 0.5)));
    const double uu = m.E;
    const double uv = m.F;
    const double vv = m.G;
    const Texel texel = texelOf(number);
    // The margin, where it is the widest on the surface.
    const double limit = reach + Margin * std::sqrt(std::max(m.E, m.G));
    for (int y = low; y <= high; ++y)
    {
      for (int x = left; x <= right; ++x)
      {
        const std::size_t i = static_cast<std::size_t>(y) * this->width + x;
        const double du = x + 0.5 - at.x();
        const double dv = y + 0.5 - at.y();
        const double squared = (uu * du + 2 * uv * dv) * du + vv * dv * dv;
        if (squared <= limit * limit &&
          (this->texels[i] == NoSample || squared < this->distances[i]))
        {
          this->distances[i] = static_cast<float>(squared);
          this->texels[i] = texel;
        }
      }
    }
  }
};

/// How many texels along a pixel, of which each has so many samples.
int finenessOf(std::vector<double>& samplesPerPixel)
{
  int fine = 1;
  if (!samplesPerPixel.empty())
  {
    const auto high = samplesPerPixel.begin() +
      static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(samplesPerPixel.size() - 1));
    std::nth_element(samplesPerPixel.begin(), high, samplesPerPixel.end());
    const double most = *high / RoomyTexel;
    while (fine < FinestTexture && fine * fine < most)
    {
      ++fine;
    }
  }
  return fine;
}
}

/// Samples on lines, for who looks for the nearest.
class DotPainter::Lines
{
public:
  void add(const std::vector<Dot>& dots)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (std::size_t i = 0; i < dots.size(); ++i)
    {
      if (dots[i].line)
      {
        points->InsertNextPoint(dots[i].position.data());
        this->Numbers.push_back(static_cast<int>(i));
      }
    }
    if (!this->Numbers.empty())
    {
      vtkNew<vtkPolyData> data;
      data->SetPoints(points);
      this->Locator->SetDataSet(data);
      this->Locator->BuildLocator();
    }
  }

  /// By any thread; -1 if there is none.
  int nearest(const Vec3& place) const
  {
    return this->Numbers.empty() || !place.allFinite()
      ? -1
      : this->Numbers[static_cast<std::size_t>(this->Locator->FindClosestPoint(place.data()))];
  }

private:
  std::vector<int> Numbers;
  vtkNew<vtkStaticPointLocator> Locator;
};

/// One chart's image.
class DotPainter::ChartPainter
{
public:
  ChartPainter(const Atlas& atlas, int chart, vtkImageData* halftone, const std::vector<Dot>& dots)
    : Charted(atlas)
    , Number(chart)
    , Halftone(halftone)
    , Dots(dots)
    , Columns(halftone->GetDimensions()[0])
    , Rows(halftone->GetDimensions()[1])
    , Pixel(atlas.surface().extent[chart].x() / this->Columns,
        atlas.surface().extent[chart].y() / this->Rows)
  {
  }

  /// Texels along a pixel, as many as its own samples are dense.
  int fineness(const std::vector<int>& own) const
  {
    std::vector<double> crowd;
    for (const int i : own)
    {
      const Dot& dot = this->Dots[i];
      crowd.push_back(dot.density *
        areaOf(scaled(this->Charted.metric()[dot.face], this->Pixel.x(), this->Pixel.y())));
    }
    return finenessOf(crowd);
  }
  double numberOfPixels() const { return static_cast<double>(this->Columns) * this->Rows; }

  /// Its own samples, on an image of so many texels along a pixel.
  void paint(double fine, const std::vector<int>& own, vtkImageData* numbers,
    std::vector<float>& distances, const Stop& stop)
  {
    const int width = std::max(1, static_cast<int>(fine * this->Columns));
    const int height = std::max(1, static_cast<int>(fine * this->Rows));
    this->TexelSize =
      Vec2(this->Pixel.x() * this->Columns / width, this->Pixel.y() * this->Rows / height);
    numbers->SetDimensions(width, height, 1);
    numbers->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    const std::size_t size = static_cast<std::size_t>(width) * height;
    distances.resize(std::max(distances.size(), size));
    this->Image = { width, height, static_cast<Texel*>(numbers->GetScalarPointer()),
      distances.data() };
    std::fill_n(this->Image.texels, size, NoSample);
    for (std::size_t k = 0; k < own.size(); ++k)
    {
      if (isTimeToAsk(k) && isAsked(stop))
      {
        return;
      }
      this->mark(own[k], this->Dots[own[k]].face, this->Dots[own[k]].uv);
    }
  }

  void mark(int i, Face face, const Vec2& uv)
  {
    const Vec2& texel = this->TexelSize;
    // The metric is another one a triangle further.
    constexpr double Slack = 1.3;
    this->Image.mark(uv.cwiseQuotient(texel),
      scaled(this->Charted.metric()[face], texel.x(), texel.y()), Slack * this->Dots[i].radius, i);
  }

  /// What is black besides is a seam's sample that belongs to the chart on the other side.
  void markOthers(const std::vector<int>& own, const Lines& lines, const Stop& stop)
  {
    auto* black =
      vtkUnsignedCharArray::SafeDownCast(this->Halftone->GetPointData()->GetArray("Halftone"));
    auto* faces = vtkIntArray::SafeDownCast(this->Halftone->GetPointData()->GetArray("FaceIndex"));
    if (!black || !faces)
    {
      return;
    }
    std::vector<vtkIdType> pixels; // of the chart's own samples
    for (const int i : own)
    {
      const Vec2 at = this->Dots[i].uv.cwiseQuotient(this->Pixel);
      const int x = std::clamp(static_cast<int>(at.x()), 0, this->Columns - 1);
      const int y = std::clamp(static_cast<int>(at.y()), 0, this->Rows - 1);
      pixels.push_back(static_cast<vtkIdType>(y) * this->Columns + x);
    }
    std::sort(pixels.begin(), pixels.end());
    const AtlasSurface& surface = this->Charted.surface();
    const unsigned char* first = black->GetPointer(0);
    const unsigned char* last = first + black->GetNumberOfValues();
    std::size_t step = 0;
    for (const unsigned char* p = first; (p = std::find(p, last, 0)) != last; ++p)
    {
      if (isTimeToAsk(step++) && isAsked(stop))
      {
        return;
      }
      const vtkIdType id = p - first;
      if (std::binary_search(pixels.begin(), pixels.end(), id))
      {
        continue;
      }
      const Face face(surface.chartBegin[this->Number] + std::max(0, faces->GetValue(id)));
      const Vec2 uv((static_cast<double>(id % this->Columns) + 0.5) * this->Pixel.x(),
        (static_cast<double>(id / this->Columns) + 0.5) * this->Pixel.y());
      const Vec3 bary = barycentric(
        uv, surface.cornerUV(face, 0), surface.cornerUV(face, 1), surface.cornerUV(face, 2));
      const int i = lines.nearest(surface.position(face, bary));
      if (i >= 0)
      {
        this->mark(i, face, uv);
      }
    }
  }

private:
  const Atlas& Charted;
  int Number;
  vtkImageData* Halftone;
  const std::vector<Dot>& Dots;
  int Columns;
  int Rows;
  Vec2 Pixel; ///< of the halftone, in the chart's plane
  Vec2 TexelSize;
  Numbers Image{};
};

DotPainter::DotPainter(vtkPartitionedDataSetCollection* charts)
{
  if (!Atlas::read(charts, nullptr, this->Charted).ok())
  {
    return;
  }
  const AtlasSurface& surface = this->Charted->surface();
  this->Origin = originOf(surface);
  this->LargestDot = LargestShare * boxOf(surface).diagonal().norm();
  this->SurfaceArea = surface.area();
  this->Distances.resize(static_cast<std::size_t>(surface.numberOfCharts()));
}

DotPainter::~DotPainter() = default;

Vec3 DotPainter::originOf(const AtlasSurface& surface)
{
  return boxOf(surface).center();
}

std::vector<DotPainter::Dot> DotPainter::placeDots(vtkPolyData* samples, DotImages& images) const
{
  constexpr int Width = DotImages::PlacesWidth;
  vtkPointData* data = samples->GetPointData();
  vtkDataArray* kind = data->GetArray("SampleKind");
  vtkDataArray* chart = data->GetArray("ChartId");
  vtkDataArray* cell = data->GetArray("ChartCellId");
  vtkDataArray* uv = data->GetArray("UV");
  vtkDataArray* density = data->GetArray("Density");
  const vtkIdType n = kind && chart && cell && uv && density ? samples->GetNumberOfPoints() : 0;
  const double mean = std::sqrt(this->SurfaceArea / static_cast<double>(std::max<vtkIdType>(1, n)));
  const double most = std::min(MeanShare * mean, this->LargestDot);
  std::vector<Dot> dots(static_cast<std::size_t>(n));
  images.places = vtkSmartPointer<vtkImageData>::New();
  images.places->SetDimensions(Width, std::max(1, static_cast<int>((n + Width - 1) / Width)), 1);
  images.places->AllocateScalars(VTK_FLOAT, 4);
  auto* places = static_cast<float*>(images.places->GetScalarPointer());
  for (vtkIdType i = 0; i < n; ++i)
  {
    Dot& dot = dots[static_cast<std::size_t>(i)];
    dot.position = Vec3(samples->GetPoint(i));
    dot.uv = Vec2(uv->GetComponent(i, 0), uv->GetComponent(i, 1));
    dot.chart = static_cast<int>(chart->GetComponent(i, 0));
    dot.face = Face(
      this->Charted->surface().chartBegin[dot.chart] + static_cast<int>(cell->GetComponent(i, 0)));
    dot.line = kind->GetComponent(i, 0) == 1 || kind->GetComponent(i, 0) == 2;
    dot.density = density->GetComponent(i, 0);
    dot.radius = dot.density > 0 ? std::min(most, LocalShare / std::sqrt(dot.density)) : most;
    const Vec3 place = dot.position - this->Origin;
    for (int k = 0; k < 3; ++k)
    {
      places[4 * i + k] = static_cast<float>(place[k]);
    }
    places[4 * i + 3] = static_cast<float>(dot.radius);
  }
  return dots;
}

std::shared_ptr<const DotImages> DotPainter::paint(
  vtkPolyData* samples, vtkPartitionedDataSetCollection* halftones, const Stop& stop)
{
  return this->paint(samples, halftones, nullptr, stop);
}

std::shared_ptr<const DotImages> DotPainter::paint(
  const MeshDots& dots, vtkPartitionedDataSetCollection* halftones, const Stop& stop)
{
  return this->paint(dots.samples, halftones, &dots.beyond, stop);
}

/// `beyond`: where dots reach into other charts; null: halftones say it.
std::shared_ptr<const DotImages> DotPainter::paint(vtkPolyData* samples,
  vtkPartitionedDataSetCollection* halftones, const std::vector<DotBeyond>* beyond,
  const Stop& stop)
{
  const std::size_t n = this->Distances.size();
  if (!this->Charted || !halftones || halftones->GetNumberOfPartitionedDataSets() != n)
  {
    return nullptr;
  }
  auto images = std::make_shared<DotImages>();
  const std::vector<Dot> dots = this->placeDots(samples, *images);
  std::vector<std::vector<int>> own(n);
  for (std::size_t i = 0; i < dots.size(); ++i)
  {
    own[static_cast<std::size_t>(dots[i].chart)].push_back(static_cast<int>(i));
  }
  std::vector<std::vector<const DotBeyond*>> others(n);
  Lines lines;
  if (!beyond)
  {
    lines.add(dots);
  }
  else
  {
    for (const DotBeyond& other : *beyond)
    {
      others[static_cast<std::size_t>(other.chart)].push_back(&other);
    }
  }
  std::vector<ChartPainter> charts;
  std::vector<int> fine;
  double texels = 0;
  for (std::size_t c = 0; c < n; ++c)
  {
    auto* halftone = vtkImageData::SafeDownCast(
      halftones->GetPartitionAsDataObject(static_cast<unsigned int>(c), 0));
    charts.emplace_back(*this->Charted, static_cast<int>(c), halftone, dots);
    fine.push_back(charts[c].fineness(own[c]));
    texels += fine[c] * fine[c] * charts[c].numberOfPixels();
    images->numbers.push_back(vtkSmartPointer<vtkImageData>::New());
  }
  const double share = std::min(1., std::sqrt(MostTexels / texels));
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), 1, [&](vtkIdType begin, vtkIdType end) {
    for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
    {
      ChartPainter& chart = charts[c];
      chart.paint(share * fine[c], own[c], images->numbers[c], this->Distances[c], stop);
      for (const DotBeyond* other : others[c])
      {
        chart.mark(other->dot, Face(other->face), other->uv);
      }
      if (!beyond)
      {
        chart.markOthers(own[c], lines, stop);
      }
    }
  });
  return isAsked(stop) ? nullptr : images;
}
}
