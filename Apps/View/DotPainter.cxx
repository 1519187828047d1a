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
#include <limits>
#include <utility>

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

/// A dot in an image: the texels that are within `reach` of it on the surface, and around these.
struct Spot
{
  Vec2 at; ///< in texels
  FirstFundamentalForm metric;
  double limit; ///< of distances on the surface, the margin in
  double reachX;
  int low; ///< first and last row of the image, if it has them
  int high;
  int number;
};

/// A place of the plane, in texels, where the metric by steps of these is m.
Spot spotAt(const Vec2& at, const FirstFundamentalForm& m, double reach, int number)
{
  constexpr double Margin = 1.; // texels: the one at a pixel of the screen has its middle elsewhere
  const double both = static_cast<double>(m.E) * m.G;
  const double determinant = std::max(both - static_cast<double>(m.F) * m.F, 1e-12 * both);
  const bool flat = !(determinant > 0); // a face without an area
  const double reachY = flat ? Margin : reach * std::sqrt(m.E / determinant) + Margin;
  // The margin, where it is the widest on the surface.
  const double limit = reach + Margin * std::sqrt(std::max(m.E, m.G));
  constexpr double Beyond = 1e9; // of rows: more than there are
  return { at, m, limit, flat ? Margin : reach * std::sqrt(m.G / determinant) + Margin,
    static_cast<int>(std::clamp(std::ceil(at.y() - reachY - 0.5), -Beyond, Beyond)),
    static_cast<int>(std::clamp(std::floor(at.y() + reachY - 0.5), -Beyond, Beyond)), number };
}

/// An image of numbered dots that is painted.
struct Numbers
{
  int width;
  int height;
  Texel* texels;
  float* distances; ///< squared, to the nearest dot

  /// The rows from one on, before another, are without dots.
  void clear(int begin, int end)
  {
    const std::size_t first = static_cast<std::size_t>(begin) * this->width;
    const std::size_t n = static_cast<std::size_t>(end - begin) * this->width;
    std::fill_n(this->texels + first, n, NoSample);
    std::fill_n(this->distances + first, n, std::numeric_limits<float>::infinity());
  }

  /// Marks a spot's texels in these rows, if no other sample is nearer to them.
  void mark(const Spot& spot, int begin, int end)
  {
    const int left = static_cast<int>(std::max(0., std::ceil(spot.at.x() - spot.reachX - 0.5)));
    const int right =
      static_cast<int>(std::min(this->width - 1., std::floor(spot.at.x() + spot.reachX - 0.5)));
    const double uu = spot.metric.E;
    const double uv = spot.metric.F;
    const double vv = spot.metric.G;
    const Texel texel = texelOf(spot.number);
    const double limit = spot.limit * spot.limit;
    const int high = std::min(end - 1, spot.high);
    for (int y = std::max(begin, spot.low); y <= high; ++y)
    {
      const std::size_t row = static_cast<std::size_t>(y) * this->width;
      const double dv = y + 0.5 - spot.at.y();
      for (int x = left; x <= right; ++x)
      {
        const double du = x + 0.5 - spot.at.x();
        const double squared = (uu * du + 2 * uv * dv) * du + vv * dv * dv;
        if (squared <= limit && squared < this->distances[row + x])
        {
          this->distances[row + x] = static_cast<float>(squared);
          this->texels[row + x] = texel;
        }
      }
    }
  }
};

/// Calls f(i) for i from 0 to n - 1, on all threads.
template <typename F>
void forEach(std::size_t n, const F& f)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), 1, [&](vtkIdType begin, vtkIdType end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      f(i);
    }
  });
}

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

  /// Prepares an image of so many texels along a pixel for spots.
  void begin(double fine, vtkImageData* numbers, std::vector<float>& distances)
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
  }

  void add(int i, Face face, const Vec2& uv)
  {
    const Vec2& texel = this->TexelSize;
    // The metric is another one a triangle further.
    constexpr double Slack = 1.3;
    this->Spots.push_back(spotAt(uv.cwiseQuotient(texel),
      scaled(this->Charted.metric()[face], texel.x(), texel.y()), Slack * this->Dots[i].radius, i));
  }

  /// Its own samples.
  void addOwn(const std::vector<int>& own)
  {
    for (const int i : own)
    {
      this->add(i, this->Dots[i].face, this->Dots[i].uv);
    }
  }

  /// What is black besides is a seam's sample that belongs to the chart on the other side.
  void addOthers(const std::vector<int>& own, const Lines& lines, const Stop& stop)
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
        this->add(i, face, uv);
      }
    }
  }

  /// Deals the spots out to strips of rows.
  void makeStrips()
  {
    this->Strips.assign(static_cast<std::size_t>((this->Image.height - 1) / StripRows + 1), {});
    for (std::size_t i = 0; i < this->Spots.size(); ++i)
    {
      const int low = std::max(0, this->Spots[i].low);
      const int high = std::min(this->Image.height - 1, this->Spots[i].high);
      for (int strip = low / StripRows; low <= high && strip <= high / StripRows; ++strip)
      {
        this->Strips[static_cast<std::size_t>(strip)].push_back(static_cast<int>(i));
      }
    }
  }
  std::size_t numberOfStrips() const { return this->Strips.size(); }
  void paintStrip(std::size_t strip, const Stop& stop)
  {
    const int begin = static_cast<int>(strip) * StripRows;
    const int end = std::min(this->Image.height, begin + StripRows);
    this->Image.clear(begin, end);
    for (const int i : this->Strips[strip])
    {
      if (isAsked(stop))
      {
        return;
      }
      this->Image.mark(this->Spots[static_cast<std::size_t>(i)], begin, end);
    }
  }

private:
  static constexpr int StripRows = 64; // a job for a thread

  const Atlas& Charted;
  int Number;
  vtkImageData* Halftone;
  const std::vector<Dot>& Dots;
  int Columns;
  int Rows;
  Vec2 Pixel; ///< of the halftone, in the chart's plane
  Vec2 TexelSize;
  Numbers Image{};
  std::vector<Spot> Spots;
  std::vector<std::vector<int>> Strips; ///< spots that reach into it
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
  forEach(n, [&](std::size_t c) {
    ChartPainter& chart = charts[c];
    chart.begin(share * fine[c], images->numbers[c], this->Distances[c]);
    chart.addOwn(own[c]);
    for (const DotBeyond* other : others[c])
    {
      chart.add(other->dot, Face(other->face), other->uv);
    }
    if (!beyond)
    {
      chart.addOthers(own[c], lines, stop);
    }
    chart.makeStrips();
  });
  std::vector<std::pair<std::size_t, std::size_t>> strips; // chart, strip
  for (std::size_t c = 0; c < n; ++c)
  {
    for (std::size_t strip = 0; strip < charts[c].numberOfStrips(); ++strip)
    {
      strips.emplace_back(c, strip);
    }
  }
  forEach(strips.size(),
    [&](std::size_t i) { charts[strips[i].first].paintStrip(strips[i].second, stop); });
  return isAsked(stop) ? nullptr : images;
}
}
