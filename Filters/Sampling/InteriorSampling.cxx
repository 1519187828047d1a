// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "InteriorSampling.h"

#include "BackboneBand.h"
#include "ErrorDiffusion.h"
#include "SamplingConstants.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

constexpr int PlacesAtOnce = 256; // a job for a thread

void eraseMarked(std::vector<Vec2>& places, const std::vector<char>& marked)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (!marked[i])
    {
      places[kept++] = places[i];
    }
  }
  places.resize(kept);
}

struct Ranked
{
  double key;
  int index;
  /// The order of a priority queue; equal keys go by index, so that nothing is left to chance.
  bool operator<(const Ranked& o) const { return key != o.key ? key < o.key : index > o.index; }
};
}

namespace
{
/// The pixels of a row of n that the middles of the pixels of a row of `enlarged` are in.
std::vector<int> nearestPixels(int n, int enlarged)
{
  std::vector<int> nearest(static_cast<std::size_t>(enlarged));
  for (int i = 0; i < enlarged; ++i)
  {
    nearest[i] = std::min(n - 1, static_cast<int>((i + 0.5) * n / enlarged));
  }
  return nearest;
}
}

namespace
{
/// By direction, such that pixels are square where the image's are far from it: error diffusion
/// knows no lengths but pixels. 1 at least.
Vec2 enlargement(const ControlImage& image, double factor)
{
  const double shape = image.extent.x() / image.width * image.height / image.extent.y(); // width
                                                                                         // over
                                                                                         // height
  if (std::abs(std::log(shape)) < std::log(Constants::SquareEnough))
  {
    return { factor, factor };
  }
  const Vec2 square(factor * std::sqrt(shape), factor / std::sqrt(shape));
  return square / std::min(1., square.minCoeff());
}
}

std::vector<InteriorSampler::Overlap> InteriorSampler::overlaps(int n, int enlarged)
{
  std::vector<Overlap> result(static_cast<std::size_t>(enlarged));
  const double length = static_cast<double>(n) / enlarged; // at most one
  for (int i = 0; i < enlarged; ++i)
  {
    const double begin = i * length;
    const int first = std::min(n - 1, static_cast<int>(begin));
    const double part = std::min(1., (first + 1 - begin) / length);
    // But for rounding
    const bool whole = part > 1. - 1e-6 || first + 1 == n;
    result[i] = { first, whole ? first : first + 1, whole ? 1.f : static_cast<float>(part) };
  }
  return result;
}

InteriorSampler::InteriorSampler(const SamplingDomain& domain, int chart, const ControlImage& image,
  const ChartGraph& graph, const std::vector<Sample>& samples, double scale)
  : Domain(domain)
  , Chart(chart)
  , Image(image)
  , Graph(graph)
  , Samples(samples)
  , Scale(scale)
{
}

double InteriorSampler::upsampling(
  const ControlImage& image, double scale, const ControlMass& mass, bool spikes)
{
  const double toWanted = scale * image.pixelArea();
  if (2. * mass.largest * toWanted <= 1.)
  {
    return 1;
  }
  // Mass by the factor that its pixel needs to want no more than half, or no more than one. Pixels
  // that are enlarged by a whole number each lie in one of the image's; a draft takes quarters, and
  // has fewer.
  const double step = spikes ? 1. : 0.25;
  const int least = spikes ? 1 : 4;
  constexpr int most = 4096;
  std::vector<double> crowded(most + 1, 0.);
  std::vector<double> overfull(most + 1, 0.);
  const float limit = static_cast<float>(0.5 / toWanted);
  const int n = image.numberOfPixels();
  for (int i = 0; i < n; ++i)
  {
    if (image.control[i] > limit)
    {
      const double wanted = image.control[i] * toWanted;
      const auto steps = [step](double x) {
        return static_cast<std::size_t>(
          std::min(std::ceil(std::sqrt(x) / step), static_cast<double>(most)));
      };
      crowded[steps(2. * wanted)] += wanted;
      overfull[steps(wanted)] += wanted;
    }
  }
  const double total = scale * mass.total;
  double aboveHalf = 0;
  double aboveOne = 0;
  int steps = most;
  const double mayCrowd = std::max(Constants::CrowdedShare * total, Constants::MissedSample);
  const double mayOverfill = std::max(Constants::OverfullShare * total, Constants::MissedSample);
  while (steps > least && aboveHalf + crowded[steps] <= mayCrowd &&
    aboveOne + overfull[steps] <= mayOverfill)
  {
    aboveHalf += crowded[steps];
    aboveOne += overfull[steps];
    --steps;
  }
  const double factor = steps * step;
  const double forAll = 0.25 * std::ceil(4. * std::sqrt(2. * mass.largest * toWanted));
  return forAll <= (spikes ? Constants::LargestForAll : 1.) * factor && withinLimits(image, forAll)
    ? forAll
    : factor;
}

bool InteriorSampler::withinLimits(const ControlImage& image, double factor)
{
  return factor <= Constants::LargestUpsampling &&
    image.numberOfPixels() * factor * factor <= Constants::LargestRasterSize;
}

Vec2 InteriorSampler::centre(int pixel) const
{
  const int x = pixel % this->Raster.width;
  const int y = pixel / this->Raster.width;
  return { (x + 0.5) * this->Image.extent.x() / this->Raster.width,
    (y + 0.5) * this->Image.extent.y() / this->Raster.height };
}

double InteriorSampler::control(const Vec2& uv) const
{
  const float c = this->Image.control[this->Image.pixelAt(uv)];
  return c > 0 ? c : 0.;
}

void InteriorSampler::prepare(double factor, const BandMask& bands,
  const std::vector<BackboneDensity>& densities, const Stop& stop)
{
  InteriorRaster& r = this->Raster;
  const Vec2 factors = enlargement(this->Image, factor);
  r.width = static_cast<int>(std::ceil(this->Image.width * factors.x()));
  r.height = static_cast<int>(std::ceil(this->Image.height * factors.y()));
  r.column = nearestPixels(this->Image.width, r.width);
  r.row = nearestPixels(this->Image.height, r.height);
  this->Columns = overlaps(this->Image.width, r.width);
  this->Rows = overlaps(this->Image.height, r.height);
  r.part.assign(static_cast<std::size_t>(r.width) * r.height, InteriorRaster::Whole);
  r.toWanted = static_cast<float>(
    this->Scale * this->Image.extent.x() / r.width * this->Image.extent.y() / r.height);
  this->maskOutside();
  bands.close(densities, this->Scale, r, stop);
  for (const ChartGraph::Segment& s : this->Graph.segments)
  {
    this->maskSegment(this->Graph.vertices[s.first].uv, this->Graph.vertices[s.second].uv);
  }
  this->sumLeft(stop);
}

void InteriorSampler::release()
{
  std::vector<unsigned char>().swap(this->Raster.part);
}

/// Fills rows; a thread has its own.
class InteriorSampler::RowFiller
{
public:
  explicit RowFiller(const InteriorSampler& sampler)
    : Sampler(sampler)
  {
  }

  void fill(int y, float* out)
  {
    const InteriorRaster& r = this->Sampler.Raster;
    const Overlap& rows = this->Sampler.Rows[y];
    const float* first = this->enlarged(rows.first);
    const float* second = this->enlarged(rows.second);
    const unsigned char* part = r.part.data() + static_cast<std::size_t>(y) * r.width;
    for (int x = 0; x < r.width; ++x)
    {
      const float v = rows.part * first[x] + (1.f - rows.part) * second[x];
      constexpr float toShare = 1.f / InteriorRaster::Whole;
      const float share = toShare * static_cast<float>(part[x] % InteriorRaster::Blocked);
      out[x] = part[x] < InteriorRaster::Blocked ? share * v : -share * v;
    }
  }

private:
  const float* enlarged(int row)
  {
    // Rows of an enlarged image come several times, two at a time.
    std::vector<float>& result = this->Enlarged[row % 2];
    if (this->EnlargedRow[row % 2] != row)
    {
      this->EnlargedRow[row % 2] = row;
      const InteriorRaster& r = this->Sampler.Raster;
      const ControlImage& image = this->Sampler.Image;
      result.resize(static_cast<std::size_t>(r.width));
      const float* in = image.control + static_cast<std::size_t>(row) * image.width;
      for (int x = 0; x < r.width; ++x)
      {
        const Overlap& o = this->Sampler.Columns[x];
        result[x] =
          (o.part * std::max(0.f, in[o.first]) + (1.f - o.part) * std::max(0.f, in[o.second])) *
          r.toWanted;
      }
    }
    return result.data();
  }

  const InteriorSampler& Sampler;
  // What the raster's pixels want in two rows of the image, an even and an odd one.
  std::array<std::vector<float>, 2> Enlarged;
  std::array<int, 2> EnlargedRow = { { -1, -1 } };
};

/// Rows in ascending order, filled ahead on all threads.
class InteriorSampler::WantedRows
{
public:
  explicit WantedRows(const InteriorSampler& sampler)
    : Sampler(sampler)
  {
  }

  const float* row(int y)
  {
    if (y < this->Begin || y >= this->End)
    {
      this->fill(y);
    }
    return this->at(y);
  }

private:
  void fill(int begin)
  {
    const InteriorRaster& r = this->Sampler.Raster;
    this->Begin = begin;
    this->End = std::min(r.height, begin + Ahead);
    this->Values.resize(static_cast<std::size_t>(Ahead) * r.width);
    vtkSMPTools::For(begin, this->End, Constants::RowsAtOnce, [&](vtkIdType first, vtkIdType last) {
      RowFiller filler(this->Sampler);
      for (auto y = static_cast<int>(first); y < last; ++y)
      {
        filler.fill(y, this->at(y));
      }
    });
  }
  float* at(int y)
  {
    return this->Values.data() +
      static_cast<std::size_t>(y - this->Begin) * this->Sampler.Raster.width;
  }

  static constexpr int Ahead = 128;
  const InteriorSampler& Sampler;
  int Begin = 0;
  int End = 0;
  std::vector<float> Values;
};

void InteriorSampler::maskOutside()
{
  InteriorRaster& r = this->Raster;
  const Vec2& extent = this->Image.extent;
  const double t = this->Domain.tolerance(this->Chart);
  const std::vector<int>& loop = this->Graph.boundary;
  const Vec2 pixel(extent.x() / r.width, extent.y() / r.height);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vec2& a = this->Graph.vertices[loop[i]].uv;
    const Vec2& b = this->Graph.vertices[loop[(i + 1) % loop.size()]].uv;
    const Vec2 d = b - a;
    if ((std::abs(d.x()) <= t && (a.x() <= t || a.x() >= extent.x() - t)) ||
      (std::abs(d.y()) <= t && (a.y() <= t || a.y() >= extent.y() - t)))
    {
      continue; // along a side of the rectangle
    }
    for (int y = 0; y < r.height; ++y)
    {
      // What lies to the right of the segment's line is outside: the polygon is convex.
      const double dy = (y + 0.5) * pixel.y() - a.y();
      int begin = 0;
      int end = r.width;
      if (d.y() != 0)
      {
        const double x = (a.x() + d.x() * dy / d.y()) / pixel.x() - 0.5;
        const double clamped = std::clamp(x, -1., static_cast<double>(r.width));
        (d.y() > 0 ? begin : end) = d.y() > 0 ? static_cast<int>(std::ceil(clamped))
                                              : static_cast<int>(std::floor(clamped)) + 1;
      }
      else if (d.x() * dy > 0)
      {
        continue;
      }
      begin = std::max(begin, 0);
      end = std::min(end, r.width);
      if (begin < end)
      {
        std::fill_n(r.part.data() + static_cast<std::size_t>(y) * r.width + begin, end - begin, 0);
      }
    }
  }
}

void InteriorSampler::maskSegment(const Vec2& a, const Vec2& b)
{
  // The pixels that it touches, line by line across its longer extent.
  InteriorRaster& r = this->Raster;
  const Vec2 toPixels(r.width / this->Image.extent.x(), r.height / this->Image.extent.y());
  const Vec2 begin = a.cwiseProduct(toPixels);
  const Vec2 step = (b - a).cwiseProduct(toPixels);
  const int major = std::abs(step.y()) > std::abs(step.x()) ? 1 : 0;
  const int minor = 1 - major;
  const std::array<int, 2> size = { { r.width, r.height } };
  const auto pixelOf = [&](double x, int axis) {
    return std::clamp(static_cast<int>(std::floor(x)), 0, size[axis] - 1);
  };
  const int first = pixelOf(std::min(begin[major], begin[major] + step[major]) - 1., major);
  const int last = pixelOf(std::max(begin[major], begin[major] + step[major]) + 1., major);
  for (int line = first; line <= last; ++line)
  {
    const double t =
      step[major] != 0 ? std::clamp((line + 0.5 - begin[major]) / step[major], 0., 1.) : 0.;
    const double crossing = begin[minor] + t * step[minor];
    for (int i = pixelOf(crossing - 1., minor); i <= pixelOf(crossing + 1., minor); ++i)
    {
      unsigned char& part = r.part[major == 0 ? static_cast<std::size_t>(i) * r.width + line
                                              : static_cast<std::size_t>(line) * r.width + i];
      if (part == 0 || part >= InteriorRaster::Blocked)
      {
        continue; // as nearly all are, in a band
      }
      Vec2 middle;
      middle[major] = line + 0.5;
      middle[minor] = i + 0.5;
      if (distanceToSegment(middle, begin, Vec2(begin + step)) < Constants::Touching)
      {
        part |= InteriorRaster::Blocked;
      }
    }
  }
}

void InteriorSampler::sumLeft(const Stop& stop)
{
  InteriorRaster& r = this->Raster;
  std::vector<double> sums(static_cast<std::size_t>(r.height), 0.); // by row: added up in order
  vtkSMPTools::For(0, r.height, Constants::RowsAtOnce, [&](vtkIdType first, vtkIdType last) {
    RowFiller filler(*this);
    std::vector<float> row(static_cast<std::size_t>(r.width));
    for (auto y = static_cast<int>(first); y < last && !isAsked(stop); ++y)
    {
      filler.fill(y, row.data());
      std::array<float, 4> sum = { { 0, 0, 0, 0 } };
      int x = 0;
      for (; x + 4 <= r.width; x += 4)
      {
        for (int k = 0; k < 4; ++k)
        {
          sum[k] += std::abs(row[x + k]);
        }
      }
      for (; x < r.width; ++x)
      {
        sum[0] += std::abs(row[x]);
      }
      sums[y] = (static_cast<double>(sum[0]) + sum[1]) + (static_cast<double>(sum[2]) + sum[3]);
    }
  });
  r.left = std::accumulate(sums.begin(), sums.end(), 0.);
}

std::vector<Vec2> InteriorSampler::sample(int count, DiffusionMethod method, const Stop& stop)
{
  std::vector<Vec2> places;
  if (count <= 0)
  {
    return places;
  }
  std::vector<int> pixels;
  if (this->Raster.left > 0)
  {
    ErrorDiffusionOptions options;
    options.scale = count / this->Raster.left;
    options.method = method;
    options.stop = stop;
    std::vector<int> trial;
    WantedRows rows(*this);
    const WantedRow wanted = [&](int y) { return rows.row(y); };
    for (int pass = 0; pass < 4; ++pass)
    {
      diffuseErrors(wanted, this->Raster.width, this->Raster.height, options, trial);
      if (isAsked(stop))
      {
        return places;
      }
      const int got = static_cast<int>(trial.size());
      if (pass == 0 || std::abs(got - count) < std::abs(static_cast<int>(pixels.size()) - count))
      {
        pixels = trial;
      }
      // A few samples too many or too few are corrected below; more are a wrong density.
      if (got == 0 || std::abs(got - count) <= std::max(3., 0.02 * count))
      {
        break;
      }
      options.scale *= std::clamp(static_cast<double>(count) / got, 0.5, 2.);
    }
  }
  places.reserve(static_cast<std::size_t>(count));
  for (int pixel : pixels)
  {
    places.push_back(this->centre(pixel));
  }
  const ChordDistance chords(this->Domain.surface(), this->Graph, this->Samples);
  std::vector<char> tooNear(places.size(), 0);
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(places.size()), PlacesAtOnce, [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType i = first; i < last; ++i)
      {
        tooNear[i] = this->isTooNear(chords, places[i]);
      }
    });
  eraseMarked(places, tooNear);
  const int missing = count - static_cast<int>(places.size());
  if (missing > 0)
  {
    this->add(chords, places, missing);
  }
  else if (missing < 0)
  {
    this->remove(places, -missing);
  }
  return places;
}

NeighbourGrid InteriorSampler::gridOf(const std::vector<Vec2>& places) const
{
  const std::vector<Vec2>& constraints = this->Domain.chartConstraints[this->Chart];
  NeighbourGrid grid(
    this->Image.extent, places.size() + this->Graph.vertices.size() + constraints.size());
  for (const Vec2& p : places)
  {
    grid.insert(p);
  }
  for (const ChartGraph::Vertex& v : this->Graph.vertices)
  {
    grid.insert(v.uv);
  }
  for (const Vec2& p : constraints)
  {
    grid.insert(p);
  }
  return grid;
}

bool InteriorSampler::isTooNear(const ChordDistance& chords, const Vec2& uv) const
{
  const int pixel = this->Image.pixelAt(uv);
  const int first = this->Domain.surface().chartBegin[this->Chart];
  const int start = this->Image.faceIndex ? this->Image.faceIndex[pixel] : 0;
  int face = 0;
  Vec3 bary;
  locate(this->Domain.surface(), this->Chart, uv, first + std::max(0, start), face, bary);
  const double near = Constants::NearestChord * Constants::NearestChord * BandLimit;
  return chords.squared(this->Domain.surface().position(face, bary)) * this->Scale *
    this->Image.density(pixel) <
    near;
}

void InteriorSampler::add(const ChordDistance& chords, std::vector<Vec2>& places, int count)
{
  // Candidates are taken each time the running sum of what is wanted passes a step, so that they
  // are as dense as the samples: six a sample, or a hundred for each sample to add if that is less.
  const InteriorRaster& r = this->Raster;
  NeighbourGrid grid = this->gridOf(places);
  std::vector<Ranked> candidates;
  const double step =
    r.left / std::min(6. * (static_cast<double>(places.size()) + count), 100. * count);
  double sum = 0;
  WantedRows rows(*this);
  for (int y = 0; y < r.height && r.left > 0; ++y)
  {
    const float* row = rows.row(y);
    constexpr int run = 16; // added up side by side; only few runs pass a step
    for (int begin = 0; begin < r.width; begin += run)
    {
      const int end = std::min(begin + run, r.width);
      float part[4] = { 0, 0, 0, 0 };
      for (int x = begin; x < end; ++x)
      {
        part[x % 4] += std::max(0.f, row[x]);
      }
      const double next = sum + ((part[0] + part[1]) + (part[2] + part[3]));
      if (next < step)
      {
        sum = next;
        continue;
      }
      for (int x = begin; x < end; ++x)
      {
        sum += std::max(0.f, row[x]);
        if (sum >= step && row[x] > 0)
        {
          sum = sum < 2. * step ? sum - step : 0.;
          const int pixel = y * r.width + x;
          candidates.push_back({ grid.nearest(this->centre(pixel)) * row[x], pixel });
        }
      }
    }
  }
  std::priority_queue<Ranked> holes({}, std::move(candidates));
  const double closest =
    0.25 * std::pow(this->Image.extent.minCoeff() / std::max(r.width, r.height), 2);
  while (count > 0 && !holes.empty())
  {
    const Ranked top = holes.top();
    holes.pop();
    const Vec2 p = this->centre(top.index);
    const double away = grid.nearest(p);
    if (away < closest || this->isTooNear(chords, p))
    {
      continue;
    }
    // Distances only shrink while samples are added: what is still on top is the largest hole.
    const double wanted = this->control(p) * r.toWanted;
    const Ranked now = { away * wanted, top.index };
    if (!holes.empty() && now < holes.top())
    {
      holes.push(now);
      continue;
    }
    places.push_back(p);
    grid.insert(p);
    --count;
  }
  if (count > 0)
  {
    this->addInGaps(places, count);
  }
}

bool InteriorSampler::clearOfGraph(const Vec2& p) const
{
  const double t = 1e-6 * this->Image.extent.minCoeff();
  const std::vector<int>& loop = this->Graph.boundary;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vec2& a = this->Graph.vertices[loop[i]].uv;
    const Vec2& b = this->Graph.vertices[loop[(i + 1) % loop.size()]].uv;
    if (orient2(a, b, p) <= t * (b - a).norm())
    {
      return false;
    }
  }
  for (const ChartGraph::Segment& s : this->Graph.segments)
  {
    const Vec2& a = this->Graph.vertices[s.first].uv;
    const Vec2 e = this->Graph.vertices[s.second].uv - a;
    const double squared = e.squaredNorm();
    const double along = squared > 0 ? std::clamp((p - a).dot(e) / squared, 0., 1.) : 0.;
    if ((a + along * e - p).norm() <= t)
    {
      return false;
    }
  }
  return true;
}

Vec2 InteriorSampler::longDirection() const
{
  Vec2 mean = Vec2::Zero();
  for (int v : this->Graph.boundary)
  {
    mean += this->Graph.vertices[v].uv / static_cast<double>(this->Graph.boundary.size());
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (int v : this->Graph.boundary)
  {
    const Vec2 d = this->Graph.vertices[v].uv - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double angle = 0.5 * std::atan2(2. * xy, xx - yy);
  return { std::cos(angle), std::sin(angle) };
}

void InteriorSampler::addInGaps(std::vector<Vec2>& places, int count)
{
  // A chart whose raster has no room left: its backbones are everywhere, or its polygon is a
  // sliver. Look for the widest gaps on ever finer lattices, along the axes and, as slivers may
  // lie between all nodes of these, along the polygon.
  NeighbourGrid grid = this->gridOf(places);
  const double closest = 1e-12 * this->Image.extent.squaredNorm();
  for (int side = 15; count > 0 && side <= 2047; side = 2 * side + 1)
  {
    for (const Vec2& along : { Vec2(1, 0), this->longDirection() })
    {
      const std::vector<Vec2> nodes = this->latticeIn(along, side);
      std::priority_queue<Ranked> gaps;
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        if (this->clearOfGraph(nodes[i]))
        {
          gaps.push({ grid.nearest(nodes[i]), static_cast<int>(i) });
        }
      }
      while (count > 0 && !gaps.empty())
      {
        const Ranked top = gaps.top();
        gaps.pop();
        const Ranked now = { grid.nearest(nodes[top.index]), top.index };
        if (now.key <= closest)
        {
          continue;
        }
        if (!gaps.empty() && now < gaps.top())
        {
          gaps.push(now);
          continue;
        }
        places.push_back(nodes[top.index]);
        grid.insert(places.back());
        --count;
      }
    }
  }
}

std::vector<Vec2> InteriorSampler::latticeIn(const Vec2& along, int side) const
{
  const Vec2 across(-along.y(), along.x());
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::max());
  Vec2 high = -low;
  for (int v : this->Graph.boundary)
  {
    const Vec2& uv = this->Graph.vertices[v].uv;
    low = low.cwiseMin(Vec2(uv.dot(along), uv.dot(across)));
    high = high.cwiseMax(Vec2(uv.dot(along), uv.dot(across)));
  }
  const Vec2 step = (high - low) / (side + 1);
  std::vector<Vec2> nodes;
  nodes.reserve(static_cast<std::size_t>(side) * side);
  for (int y = 1; y <= side; ++y)
  {
    for (int x = 1; x <= side; ++x)
    {
      nodes.emplace_back((low.x() + x * step.x()) * along + (low.y() + y * step.y()) * across);
    }
  }
  return nodes;
}

void InteriorSampler::remove(std::vector<Vec2>& places, int count) const
{
  NeighbourGrid grid = this->gridOf(places);
  const auto key = [&](int i) { return -grid.nearest(places[i], i) * this->control(places[i]); };
  std::priority_queue<Ranked> pairs;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    pairs.push({ key(static_cast<int>(i)), static_cast<int>(i) });
  }
  std::vector<char> gone(places.size(), 0);
  while (count > 0 && !pairs.empty())
  {
    const Ranked top = pairs.top();
    pairs.pop();
    // Distances only grow while samples are removed.
    const Ranked now = { key(top.index), top.index };
    if (!pairs.empty() && now < pairs.top())
    {
      pairs.push(now);
      continue;
    }
    gone[top.index] = 1;
    grid.remove(top.index);
    --count;
  }
  eraseMarked(places, gone);
}

void locate(
  const AtlasSurface& surface, int chart, const Vec2& uv, int startFace, int& face, Vec3& bary)
{
  const int begin = surface.chartBegin[chart];
  const int end = surface.chartBegin[chart + 1];
  const auto inFace = [&](int f) {
    return barycentric(uv, surface.cornerUV(f, 0), surface.cornerUV(f, 1), surface.cornerUV(f, 2));
  };
  const double tolerance = -1e-9;
  int f = std::clamp(startFace, begin, end - 1);
  int from = -1;
  for (int step = 0; step < end - begin; ++step)
  {
    const Vec3 b = inFace(f);
    if (b.allFinite() && b.minCoeff() >= tolerance)
    {
      face = f;
      bary = clampedBarycentric(b);
      return;
    }
    // Cross the edge opposite the most negative coordinate that leads on within the chart.
    int next = -1;
    double most = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int h = 3 * f + (k + 1) % 3;
      const int twin = surface.twin[h];
      if (b[k] < most && twin >= 0 && twin / 3 != from && surface.faceChart[twin / 3] == chart &&
        surface.chartPoints[f][h % 3] == surface.chartPoints[twin / 3][nextHalfedge(twin) % 3])
      {
        most = b[k];
        next = twin / 3;
      }
    }
    if (next < 0)
    {
      break;
    }
    from = f;
    f = next;
  }
  // The walk ran into the chart's border or a degenerate triangle: the best of all triangles.
  double best = -std::numeric_limits<double>::max();
  face = f;
  bary = Vec3(1., 1., 1.) / 3.;
  for (int g = begin; g < end; ++g)
  {
    const Vec3 b = inFace(g);
    if (b.allFinite() && b.minCoeff() > best)
    {
      best = b.minCoeff();
      face = g;
      bary = clampedBarycentric(b);
    }
  }
}
}
