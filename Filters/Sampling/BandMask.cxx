// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BandMask.h"

#include "BackboneBand.h"
#include "SamplingConstants.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

/// The disc around a lone sample has the area of a lattice cell: pi r^2 rho = 1.
constexpr double DiscLimit = 1. / Pi;

/// From the middle of a pixel to any place of the next one, in ways from its middle to a corner.
constexpr double ToNextPixel = 3.;

/// The least density that is wanted at any pixel that wants samples; infinite if there is none.
double leastDensity(const ControlImage& image)
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < image.numberOfPixels(); ++i)
  {
    const double density = image.density(i);
    least = density > 0. ? std::min(least, density) : least;
  }
  return least;
}

/// The first column (or row) of the raster in each column of the image, and where the last ends.
std::vector<int> firstOf(const std::vector<int>& nearest, int pixels)
{
  std::vector<int> first(static_cast<std::size_t>(pixels) + 1);
  for (int i = 0; i <= pixels; ++i)
  {
    first[i] =
      static_cast<int>(std::lower_bound(nearest.begin(), nearest.end(), i) - nearest.begin());
  }
  return first;
}
}

struct BandMask::Control
{
  const std::vector<BackboneDensity>& densities;
  double scale;
  float farthest;             ///< scale over the squared width of the widest band
  std::vector<double> widest; ///< band, by line
};

struct BandMask::Band
{
  bool whole;   ///< whether all of the pixel is in it
  double reach; ///< of the band, in units of length, where it is not
};

struct BandMask::Surroundings
{
  const Line& line;
  const FirstFundamentalForm& form;
  Vec2 gradient; ///< of the dot product with the line
  double squaredLength;

  Surroundings(const Line& l, const FirstFundamentalForm& f)
    : line(l)
    , form(f)
    , gradient(f.times(l.e))
    , squaredLength(this->gradient.dot(l.e))
  {
  }

  /// Where along the line, from 0 to 1, the place is that is nearest to a parameter.
  double nearest(const Vec2& uv) const
  {
    const double along = this->gradient.dot(uv - this->line.a);
    return along <= 0 ? 0. : (along >= this->squaredLength ? 1. : along / this->squaredLength);
  }
  /// From there to the parameter.
  Vec2 away(const Vec2& uv) const { return uv - this->line.a - this->nearest(uv) * this->line.e; }
};

FirstFundamentalForm BandMask::form(int pixel) const
{
  const int face = this->Image.faceIndex ? this->Image.faceIndex[pixel] : -1;
  const float area = this->Image.areaDistortion[pixel];
  return face >= 0 && face < this->NumberOfFaces ? this->Metric[face]
                                                 : FirstFundamentalForm{ area, 0, area };
}

double BandMask::toCorner(int pixel) const
{
  const Vec2 half(0.5 * this->Image.extent.x() / this->Image.width,
    0.5 * this->Image.extent.y() / this->Image.height);
  const FirstFundamentalForm form = this->form(pixel);
  return std::sqrt(std::max(form.squared(half), form.squared({ half.x(), -half.y() })) /
    this->Lines[this->Nearest[pixel]].limit);
}

void BandMask::build(const SamplingDomain& domain, int chart, const ControlImage& image,
  double scale, const Stop& stop)
{
  const std::size_t n = static_cast<std::size_t>(image.numberOfPixels());
  this->Image = image;
  const int firstFace = domain.surface().chartBegin[chart];
  this->Metric = &domain.metric(firstFace);
  this->NumberOfFaces = domain.surface().chartBegin[chart + 1] - firstFace;
  this->Nearest.assign(n, -1);
  this->Apart.assign(n, std::numeric_limits<float>::max());
  this->addLines(domain, chart);
  this->spread(scale, stop);
  if (isAsked(stop))
  {
    return;
  }
  this->Low.assign(n, std::numeric_limits<float>::infinity());
  this->High.assign(n, std::numeric_limits<float>::infinity());
  const int pixelsAtOnce = Constants::RowsAtOnce * image.width;
  vtkSMPTools::For(0, image.numberOfPixels(), pixelsAtOnce, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      if (this->Nearest[i] < 0)
      {
        continue;
      }
      const double toCorner = this->toCorner(static_cast<int>(i));
      const double toMiddle = std::sqrt(static_cast<double>(this->Apart[i]));
      this->Low[i] = static_cast<float>(std::pow(std::max(0., toMiddle - toCorner), 2));
      this->High[i] = static_cast<float>(std::pow(toMiddle + toCorner, 2));
    }
  });
  std::vector<float>().swap(this->Apart);
  std::vector<int>().swap(this->Queue);
}

void BandMask::addLines(const SamplingDomain& domain, int chart)
{
  this->Lines.clear();
  this->Queue.clear();
  for (const auto& [backbone, side] : domain.chartSides[chart])
  {
    const BackboneTrace& trace = domain.traces()[backbone];
    for (int i = 0; i + 1 < static_cast<int>(trace.arcLength.size()); ++i)
    {
      const Vec2 a = trace.parameter(domain.surface(), { i, 0. }, side);
      const Vec2 b = trace.parameter(domain.surface(), { i, 1. }, side);
      this->Lines.push_back({ a, b - a, BandLimit, backbone, trace.arcLength[i],
        trace.arcLength[i + 1] - trace.arcLength[i] });
    }
  }
  for (const Vec2& p : domain.chartConstraints[chart])
  {
    this->Lines.push_back({ p, Vec2::Zero(), DiscLimit, -1, 0., 0. });
  }
  const Vec2 pixel(
    this->Image.extent.x() / this->Image.width, this->Image.extent.y() / this->Image.height);
  for (std::size_t l = 0; l < this->Lines.size(); ++l)
  {
    const Line& line = this->Lines[l];
    const double pixels = line.e.cwiseQuotient(pixel).cwiseAbs().maxCoeff();
    const int steps = static_cast<int>(std::ceil(2. * pixels)) + 1;
    for (int k = 0; k <= steps; ++k)
    {
      const Vec2 place = line.a + static_cast<double>(k) / steps * line.e;
      this->offer(this->Image.pixelAt(place), static_cast<int>(l));
    }
  }
}

void BandMask::offer(int pixel, int line)
{
  const Line& l = this->Lines[line];
  const FirstFundamentalForm form = this->form(pixel);
  const Vec2 away = Surroundings(l, form).away(this->Image.centre(pixel));
  const auto apart = static_cast<float>(form.squared(away) / l.limit);
  if (apart < this->Apart[pixel])
  {
    this->Apart[pixel] = apart;
    this->Nearest[pixel] = line;
    this->Queue.push_back(pixel);
  }
}

void BandMask::spread(double scale, const Stop& stop)
{
  const int width = this->Image.width;
  // No band of the chart is wider than that of the pixel that wants least, at the least scale that
  // this is for.
  const double widest =
    Constants::WidestBand / std::sqrt(leastDensity(this->Image) * scale / Constants::FarScale);
  // Behind what is this far from a line no place is in a band, unless it wants far fewer samples.
  const double farthest = Constants::WidestBand * Constants::FarthestPixel;
  // A pixel is offered lines often: only those that wait are kept, not all that ever did.
  std::vector<int> front;
  while (!this->Queue.empty() && !isAsked(stop))
  {
    front.swap(this->Queue);
    this->Queue.clear();
    for (const int pixel : front)
    {
      if (this->Apart[pixel] > widest * widest &&
        std::sqrt(this->Apart[pixel]) - ToNextPixel * this->toCorner(pixel) > widest)
      {
        continue;
      }
      const double density = scale * this->Image.density(pixel);
      if (density * this->Apart[pixel] > farthest * farthest &&
        std::sqrt(this->Apart[pixel]) - this->toCorner(pixel) > farthest / std::sqrt(density))
      {
        continue;
      }
      const int line = this->Nearest[pixel];
      const int x = pixel % width;
      const auto handTo = [&](bool exists, int neighbour) {
        if (exists && this->Nearest[neighbour] != line)
        {
          this->offer(neighbour, line);
        }
      };
      handTo(x > 0, pixel - 1);
      handTo(x + 1 < width, pixel + 1);
      handTo(pixel >= width, pixel - width);
      handTo(pixel + width < this->Image.numberOfPixels(), pixel + width);
    }
  }
}

BandMask::Control BandMask::controlOf(
  const std::vector<BackboneDensity>& densities, double scale) const
{
  Control control = { densities, scale,
    static_cast<float>(scale / (Constants::WidestBand * Constants::WidestBand)), {} };
  control.widest.reserve(this->Lines.size());
  for (const Line& line : this->Lines)
  {
    control.widest.push_back(line.backbone < 0
        ? 1.
        : densities[line.backbone].widest(line.arcLength, line.arcLength + line.rise));
  }
  return control;
}

bool BandMask::isInBand(const Control& control, int pixel, Band& band) const
{
  // Most pixels are far from lines: that is told without a division.
  const float wanted = this->Image.control[pixel];
  const float area = this->Image.areaDistortion[pixel];
  if (!(wanted > 0 && area > 0 && control.farthest * wanted * this->Low[pixel] < area))
  {
    return false;
  }
  const double density = control.scale * wanted / area;
  const int nearest = this->Nearest[pixel];
  const Line& line = this->Lines[nearest];
  const double high = density * this->High[pixel];
  double width = 1;
  if (high >= 1. && control.widest[nearest] > 1.)
  {
    const double t = Surroundings(line, this->form(pixel)).nearest(this->Image.centre(pixel));
    width = control.densities[line.backbone].widthAt(line.arcLength + t * line.rise);
  }
  band.whole = high < width * width;
  band.reach = band.whole ? 0. : std::sqrt(line.limit / density) * width;
  return density * this->Low[pixel] < width * width;
}

double BandMask::share(const std::vector<BackboneDensity>& densities, double scale) const
{
  const ControlImage& image = this->Image;
  const Control control = this->controlOf(densities, scale);
  const Vec2 half(0.5 * image.extent.x() / image.width, 0.5 * image.extent.y() / image.height);
  double inBands = 0;
  double sum = 0;
  // A fourth of the pixels, of each row and each column.
  constexpr std::array<int, 4> First = { { 0, 2, 1, 3 } };
  for (int y = 0; y < image.height; ++y)
  {
    for (int x = First[y % 4]; x < image.width; x += 4)
    {
      const int i = y * image.width + x;
      const double wanted = std::max(0.f, image.control[i]);
      sum += wanted;
      if (Band band; this->isInBand(control, i, band))
      {
        inBands +=
          wanted * (band.whole ? 1. : this->partWithin(i, band.reach, image.centre(i), half));
      }
    }
  }
  return sum > 0 ? inBands / sum : 0.;
}

double BandMask::partWithin(int pixel, double reach, const Vec2& middle, const Vec2& half) const
{
  const FirstFundamentalForm form = this->form(pixel);
  const Vec2 away = Surroundings(this->Lines[this->Nearest[pixel]], form).away(middle);
  const double apart = std::sqrt(form.squared(away));
  const Vec2 slope = apart > 0 ? Vec2(form.times(away).cwiseAbs() / apart)
                               : Vec2(std::sqrt(form.E), std::sqrt(form.G));
  // The distance changes by as much from the middle to a side.
  const double change = slope.cwiseProduct(half).maxCoeff();
  const double inside = std::min(reach, apart + change) - std::max(-reach, apart - change);
  // Where the change is lost in the distance's rounding, any share may come out.
  return change > 0 ? std::clamp(inside / (2. * change), 0., 1.) : 0.;
}

void BandMask::close(const std::vector<BackboneDensity>& densities, double scale,
  InteriorRaster& raster, const Stop& stop) const
{
  const ControlImage& image = this->Image;
  const Control control = this->controlOf(densities, scale);
  const std::vector<int> firstColumn = firstOf(raster.column, image.width);
  const std::vector<int> firstRow = firstOf(raster.row, image.height);
  vtkSMPTools::For(0, image.height, Constants::RowsAtOnce, [&](vtkIdType begin, vtkIdType end) {
    for (auto y = static_cast<int>(begin); y < end && !isAsked(stop); ++y)
    {
      for (int x = 0; x < image.width; ++x)
      {
        const int i = y * image.width + x;
        if (Band band; this->isInBand(control, i, band))
        {
          this->closePixel(
            i, band, { firstColumn[x], firstColumn[x + 1], firstRow[y], firstRow[y + 1] }, raster);
        }
      }
    }
  });
}

void BandMask::closePixel(
  int pixel, const Band& band, const PixelBox& box, InteriorRaster& raster) const
{
  const Vec2 size(this->Image.extent.x() / raster.width, this->Image.extent.y() / raster.height);
  for (int y = box.yBegin; y < box.yEnd; ++y)
  {
    unsigned char* part = raster.part.data() + static_cast<std::size_t>(y) * raster.width;
    if (band.whole)
    {
      std::fill(part + box.xBegin, part + box.xEnd, 0);
      continue;
    }
    for (int x = box.xBegin; x < box.xEnd; ++x)
    {
      if (part[x] == 0)
      {
        continue; // outside
      }
      const Vec2 middle((x + 0.5) * size.x(), (y + 0.5) * size.y());
      const double within = this->partWithin(pixel, band.reach, middle, 0.5 * size);
      const auto left = static_cast<unsigned char>(InteriorRaster::Whole * (1. - within) + 0.5);
      part[x] = within > 0.5 ? left | InteriorRaster::Blocked : left;
    }
  }
}
}
