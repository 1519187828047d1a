// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapRasterizer.h"

#include "CompressedRows.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>

namespace stipple
{
namespace
{
constexpr int subpixelBits = 8;
constexpr int subpixelOne = 1 << subpixelBits;
constexpr int rowsPerBand = 16;
constexpr int wideBox = 24; ///< from this width on, solving for a row's span is cheaper than
                            ///< testing it

/// Fixed-point position relative to the centre of pixel (0, 0).
struct FixedPoint
{
  std::int32_t x;
  std::int32_t y;
};

FixedPoint snap(const std::array<float, 2>& device, int width, int height)
{
  // The float arithmetic of OpenGL's viewport transformation, so that both back ends round alike.
  const float halfWidth = 0.5f * static_cast<float>(width);
  const float halfHeight = 0.5f * static_cast<float>(height);
  const float x = device[0] * halfWidth + halfWidth;
  const float y = device[1] * halfHeight + halfHeight;
  return { static_cast<std::int32_t>(std::lrint((x - 0.5f) * subpixelOne)),
    static_cast<std::int32_t>(std::lrint((y - 0.5f) * subpixelOne)) };
}

std::int64_t floorDivide(std::int64_t a, std::int64_t b) // b > 0
{
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

std::int64_t ceilDivide(std::int64_t a, std::int64_t b) // b > 0
{
  return -floorDivide(-a, b);
}

/// E(i, j) = origin + i stepX + j stepY is not negative where the pixel's centre is inside the
/// edge.
struct EdgeFunction
{
  std::int64_t origin;
  std::int64_t stepX;
  std::int64_t stepY;

  EdgeFunction(const FixedPoint& a, const FixedPoint& b)
  {
    const std::int64_t dx = static_cast<std::int64_t>(b.x) - a.x;
    const std::int64_t dy = static_cast<std::int64_t>(b.y) - a.y;
    // Of a counterclockwise triangle with y up, the left edges run down. The top edge of the rule
    // is the one at the image's first row, which runs right: hardware draws into images that way
    // up.
    const bool topLeft = dy < 0 || (dy == 0 && dx > 0);
    this->origin = dy * a.x - dx * a.y - (topLeft ? 0 : 1);
    this->stepX = -dy * subpixelOne;
    this->stepY = dx * subpixelOne;
  }
};

/// First and last pixel index of a fixed-point interval; empty if first > last.
void pixelRange(int low, int high, int size, int& first, int& last)
{
  first = std::max<int>(0, (low + subpixelOne - 1) >> subpixelBits);
  last = std::min<int>(size - 1, high >> subpixelBits);
}

/// The faces of one chart in a set of image bands; a band belongs to one thread.
class FaceRasterizer
{
public:
  FaceRasterizer(const MapChart& chart, int width, int height, int* faces)
    : Chart(chart)
    , Width(width)
    , Height(height)
    , Faces(faces)
  {
    this->Points.reserve(chart.uv.size());
    for (const Vec2& uv : chart.uv)
    {
      this->Points.push_back(snap(deviceCoordinate(chart, uv), width, height));
    }
    this->sortIntoBands();
  }

  int numberOfBands() const { return static_cast<int>(this->Bands.numberOfRows()); }

  void drawBand(int band) const
  {
    const int firstRow = band * rowsPerBand;
    const int lastRow = std::min(this->Height, firstRow + rowsPerBand) - 1;
    std::fill(this->Faces + static_cast<std::size_t>(firstRow) * this->Width,
      this->Faces + static_cast<std::size_t>(lastRow + 1) * this->Width, -1);
    for (const int triangle : this->Bands[band])
    {
      this->drawTriangle(triangle, firstRow, lastRow);
    }
  }

private:
  bool rows(int triangle, int& first, int& last) const
  {
    const auto& t = this->Chart.triangles[triangle];
    const auto y =
      std::minmax({ this->Points[t[0]].y, this->Points[t[1]].y, this->Points[t[2]].y });
    pixelRange(y.first, y.second, this->Height, first, last);
    return first <= last;
  }

  /// The triangles by the bands that they touch, in the order of their indices.
  void sortIntoBands()
  {
    const int bands = (this->Height + rowsPerBand - 1) / rowsPerBand;
    const int n = this->Chart.numberOfTriangles();
    this->Bands = { static_cast<std::size_t>(bands), [&](const auto& add) {
                     int first;
                     int last;
                     for (int f = 0; f < n; ++f)
                     {
                       if (this->rows(f, first, last))
                       {
                         for (int b = first / rowsPerBand; b <= last / rowsPerBand; ++b)
                         {
                           add(b, f);
                         }
                       }
                     }
                   } };
  }

  void put(int* pixel, int triangle) const
  {
    // Triangles come in the order of their indices, so equal areas leave the lower one.
    if (*pixel < 0 || this->Chart.area[triangle] < this->Chart.area[*pixel])
    {
      *pixel = triangle;
    }
  }

  void drawTriangle(int triangle, int firstRow, int lastRow) const
  {
    const auto& t = this->Chart.triangles[triangle];
    FixedPoint a = this->Points[t[0]];
    FixedPoint b = this->Points[t[1]];
    const FixedPoint c = this->Points[t[2]];
    const std::int64_t area = static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) -
      static_cast<std::int64_t>(b.y - a.y) * (c.x - a.x);
    if (area == 0)
    {
      return;
    }
    if (area < 0)
    {
      std::swap(a, b); // rounding turned it over; it still owns its pixels
    }
    int x0;
    int x1;
    int y0;
    int y1;
    const auto x = std::minmax({ a.x, b.x, c.x });
    const auto y = std::minmax({ a.y, b.y, c.y });
    pixelRange(x.first, x.second, this->Width, x0, x1);
    pixelRange(y.first, y.second, this->Height, y0, y1);
    y0 = std::max(y0, firstRow);
    y1 = std::min(y1, lastRow);
    if (x0 > x1 || y0 > y1)
    {
      return;
    }
    const EdgeFunction edges[3] = { { a, b }, { b, c }, { c, a } };
    if (x1 - x0 < wideBox)
    {
      this->testBox(triangle, edges, x0, x1, y0, y1);
    }
    else
    {
      this->fillSpans(triangle, edges, x0, x1, y0, y1);
    }
  }

  void testBox(int triangle, const EdgeFunction (&edges)[3], int x0, int x1, int y0, int y1) const
  {
    std::int64_t row[3];
    for (int k = 0; k < 3; ++k)
    {
      row[k] = edges[k].origin + x0 * edges[k].stepX + y0 * edges[k].stepY;
    }
    for (int j = y0; j <= y1; ++j)
    {
      int* pixel = this->Faces + static_cast<std::size_t>(j) * this->Width + x0;
      std::int64_t e0 = row[0];
      std::int64_t e1 = row[1];
      std::int64_t e2 = row[2];
      for (int i = x0; i <= x1; ++i, ++pixel)
      {
        if ((e0 | e1 | e2) >= 0)
        {
          this->put(pixel, triangle);
        }
        e0 += edges[0].stepX;
        e1 += edges[1].stepX;
        e2 += edges[2].stepX;
      }
      for (int k = 0; k < 3; ++k)
      {
        row[k] += edges[k].stepY;
      }
    }
  }

  void fillSpans(int triangle, const EdgeFunction (&edges)[3], int x0, int x1, int y0, int y1) const
  {
    for (int j = y0; j <= y1; ++j)
    {
      std::int64_t first = x0;
      std::int64_t last = x1;
      for (const EdgeFunction& edge : edges)
      {
        const std::int64_t e = edge.origin + j * edge.stepY;
        if (edge.stepX > 0)
        {
          first = std::max(first, ceilDivide(-e, edge.stepX));
        }
        else if (edge.stepX < 0)
        {
          last = std::min(last, floorDivide(e, -edge.stepX));
        }
        else if (e < 0)
        {
          last = -1;
        }
      }
      int* row = this->Faces + static_cast<std::size_t>(j) * this->Width;
      for (std::int64_t i = first; i <= last; ++i)
      {
        this->put(row + i, triangle);
      }
    }
  }

  const MapChart& Chart;
  int Width;
  int Height;
  int* Faces;
  std::vector<FixedPoint> Points;
  CompressedRows<int, std::size_t> Bands; // of triangles
};

/// Squared distance of p from the plane triangle, in pixels.
double squaredDistance(const Vec2& p, const Vec2 (&t)[3])
{
  double best = std::numeric_limits<double>::max();
  bool inside = true;
  for (int k = 0; k < 3; ++k)
  {
    const Vec2& a = t[k];
    const Vec2& b = t[(k + 1) % 3];
    inside = inside && orient2(a, b, p) >= 0;
    best = std::min(best, (nearestOnSegment<2>(p, a, b) - p).squaredNorm());
  }
  return inside ? 0. : best;
}

class NearestTriangle
{
public:
  NearestTriangle(const MapChart& chart, int width, int height)
    : Chart(chart)
    , Scale(width / chart.extent.x(), height / chart.extent.y())
  {
  }
  double distance(int triangle, int i, int j) const
  {
    Vec2 corner[3];
    for (int k = 0; k < 3; ++k)
    {
      corner[k] = this->Chart.uv[this->Chart.triangles[triangle][k]].cwiseProduct(this->Scale);
    }
    return squaredDistance({ i + 0.5, j + 0.5 }, corner);
  }
  /// Over all triangles.
  int search(int i, int j) const
  {
    int best = -1;
    double least = std::numeric_limits<double>::max();
    for (int f = 0; f < this->Chart.numberOfTriangles(); ++f)
    {
      const double d = this->distance(f, i, j);
      if (d < least)
      {
        least = d;
        best = f;
      }
    }
    return best;
  }

private:
  const MapChart& Chart;
  Vec2 Scale;
};
} // namespace

PixelBarycentrics::PixelBarycentrics(const MapChart& chart, int triangle, int width, int height)
{
  const auto& t = chart.triangles[triangle];
  const Vec2 scale(width / chart.extent.x(), height / chart.extent.y());
  this->corner = chart.uv[t[0]].cwiseProduct(scale);
  const Vec2 u = chart.uv[t[1]].cwiseProduct(scale) - this->corner;
  const Vec2 v = chart.uv[t[2]].cwiseProduct(scale) - this->corner;
  const double area = cross2(u, v);
  const double inverse = area != 0. ? 1. / area : 0.;
  this->gradient1 = std::isfinite(inverse) ? Vec2(v.y() * inverse, -v.x() * inverse) : Vec2(0., 0.);
  this->gradient2 = std::isfinite(inverse) ? Vec2(-u.y() * inverse, u.x() * inverse) : Vec2(0., 0.);
}

void rasterizeFaces(const MapChart& chart, int width, int height, int* faces)
{
  const FaceRasterizer rasterizer(chart, width, height, faces);
  vtkSMPTools::For(0, rasterizer.numberOfBands(), 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType band = begin; band < end; ++band)
    {
      rasterizer.drawBand(static_cast<int>(band));
    }
  });
}

int fillUncoveredPixels(const MapChart& chart, int width, int height, int* faces)
{
  const int n = width * height;
  std::vector<int> open;
  for (int p = 0; p < n; ++p)
  {
    if (faces[p] < 0)
    {
      open.push_back(p);
    }
  }
  if (open.empty() || chart.triangles.empty())
  {
    return static_cast<int>(open.size());
  }
  const int holes = static_cast<int>(open.size());
  const NearestTriangle nearest(chart, width, height);
  if (holes == n)
  {
    faces[0] = nearest.search(0, 0); // a seed
    open.erase(open.begin());
  }
  // Rings from the rim of a gap inwards: a pixel takes the nearest of the triangles that its
  // neighbours have. Then all of them again, until nothing changes, as the first ring to come by
  // need not bring the nearest. Changes take effect after a round, so the order within one does not
  // matter.
  std::vector<std::pair<int, int>> changes;
  const std::vector<int> gap = open;
  const auto round = [&](const std::vector<int>& pixels) {
    changes.clear();
    for (const int p : pixels)
    {
      const int i = p % width;
      const int j = p / width;
      int best = faces[p];
      double least = best >= 0 ? nearest.distance(best, i, j) : std::numeric_limits<double>::max();
      for (int y = std::max(0, j - 1); y <= std::min(height - 1, j + 1); ++y)
      {
        for (int x = std::max(0, i - 1); x <= std::min(width - 1, i + 1); ++x)
        {
          const int f = faces[y * width + x];
          const double d = f >= 0 && f != best ? nearest.distance(f, i, j) : least;
          if (d < least || (d == least && f >= 0 && f < best))
          {
            least = d;
            best = f;
          }
        }
      }
      if (best != faces[p])
      {
        changes.emplace_back(p, best);
      }
    }
    for (const auto& [pixel, face] : changes)
    {
      faces[pixel] = face;
    }
  };
  while (!open.empty())
  {
    round(open);
    open.erase(
      std::remove_if(open.begin(), open.end(), [&](int p) { return faces[p] >= 0; }), open.end());
  }
  for (int k = 0; k < width + height && (k == 0 || !changes.empty()); ++k)
  {
    round(gap);
  }
  return holes;
}

namespace
{
/// Pixels [begin, end) of a row that share a face.
struct Run
{
  int begin;
  int end;
  int face;
};

/// Makes the maps of one row at a time; one object a thread.
class RowPainter
{
public:
  RowPainter(const MapChart& chart, int width, int height, const std::vector<MapRequest>& requests)
    : Chart(chart)
    , Width(width)
    , Height(height)
    , Requests(requests)
    , B1(width)
    , B2(width)
  {
    for (const MapRequest& request : requests)
    {
      this->NeedsBarycentrics = this->NeedsBarycentrics || request.kind != MapKind::Constant;
    }
  }

  void paint(int row, const int* faces)
  {
    this->findRuns(row, faces);
    for (const MapRequest& request : this->Requests)
    {
      float* output = request.output +
        static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Width) * request.components;
      switch (request.kind)
      {
        case MapKind::Constant:
          this->paintConstant(request, output);
          break;
        case MapKind::Linear:
          this->paintLinear(request, output);
          break;
        case MapKind::UnitVector:
          this->paintLinear(request, output);
          this->normalize(request.components, output);
          break;
        case MapKind::TotalCurvature:
          this->paintTotalCurvature(request, output);
          break;
      }
    }
  }

private:
  void findRuns(int row, const int* faces)
  {
    faces += static_cast<std::size_t>(row) * this->Width;
    this->Runs.clear();
    for (int begin = 0; begin < this->Width;)
    {
      const int face = faces[begin];
      int end = begin + 1;
      while (end < this->Width && faces[end] == face)
      {
        ++end;
      }
      this->Runs.push_back({ begin, end, face });
      if (this->NeedsBarycentrics)
      {
        this->weigh(begin, end, face, row);
      }
      begin = end;
    }
  }

  void weigh(int begin, int end, int face, int row)
  {
    const PixelBarycentrics b(this->Chart, face, this->Width, this->Height);
    const double y = row + 0.5 - b.corner.y();
    const double c1 = y * b.gradient1.y();
    const double c2 = y * b.gradient2.y();
    for (int i = begin; i < end; ++i)
    {
      const double x = i + 0.5 - b.corner.x();
      const double b1 = x * b.gradient1.x() + c1;
      const double b2 = x * b.gradient2.x() + c2;
      // Clamped to the triangle: the centre may be outside by the rounding to subpixels.
      const double p0 = std::max(0., 1. - b1 - b2);
      const double p1 = std::max(0., b1);
      const double p2 = std::max(0., b2);
      const double sum = p0 + p1 + p2;
      this->B1[i] = p1 / sum;
      this->B2[i] = p2 / sum;
    }
  }

  void paintConstant(const MapRequest& request, float* output) const
  {
    const int n = request.components;
    for (const Run& run : this->Runs)
    {
      for (int k = 0; k < n; ++k)
      {
        const float value =
          static_cast<float>(request.values[static_cast<std::size_t>(run.face) * n + k]);
        for (int i = run.begin; i < run.end; ++i)
        {
          output[static_cast<std::size_t>(i) * n + k] = value;
        }
      }
    }
  }

  /// Corner 0's value, and the differences of corners 1 and 2 to it.
  std::array<double, 3> corners(const MapRequest& request, int face, int component) const
  {
    const auto& t = this->Chart.triangles[face];
    const std::size_t n = request.valueComponents();
    const double v0 = request.values[t[0] * n + component];
    return { v0, request.values[t[1] * n + component] - v0,
      request.values[t[2] * n + component] - v0 };
  }

  void paintLinear(const MapRequest& request, float* output) const
  {
    switch (request.components)
    {
      case 1:
        this->paintComponents<1>(request, output);
        break;
      case 2:
        this->paintComponents<2>(request, output);
        break;
      case 3:
        this->paintComponents<3>(request, output);
        break;
      default:
        this->paintComponents<4>(request, output);
    }
  }

  template <int n>
  void paintComponents(const MapRequest& request, float* output) const
  {
    for (const Run& run : this->Runs)
    {
      std::array<double, 3> v[n];
      for (int k = 0; k < n; ++k)
      {
        v[k] = this->corners(request, run.face, k);
      }
      for (int i = run.begin; i < run.end; ++i)
      {
        const double b1 = this->B1[i];
        const double b2 = this->B2[i];
        for (int k = 0; k < n; ++k)
        {
          output[static_cast<std::size_t>(i) * n + k] =
            static_cast<float>(v[k][0] + b1 * v[k][1] + b2 * v[k][2]);
        }
      }
    }
  }

  void normalize(int n, float* output) const
  {
    for (int i = 0; i < this->Width; ++i)
    {
      float* v = output + static_cast<std::size_t>(i) * n;
      double squared = 0.;
      for (int k = 0; k < n; ++k)
      {
        squared += static_cast<double>(v[k]) * v[k];
      }
      const double scale = squared > 0. ? 1. / std::sqrt(squared) : 0.;
      for (int k = 0; k < n; ++k)
      {
        v[k] = static_cast<float>(v[k] * scale);
      }
    }
  }

  void paintTotalCurvature(const MapRequest& request, float* output) const
  {
    for (const Run& run : this->Runs)
    {
      const auto h = this->corners(request, run.face, 0);
      const auto r = this->corners(request, run.face, 1);
      for (int i = run.begin; i < run.end; ++i)
      {
        const double mean = h[0] + this->B1[i] * h[1] + this->B2[i] * h[2];
        const double half = r[0] + this->B1[i] * r[1] + this->B2[i] * r[2];
        output[i] = static_cast<float>(2. * (mean * mean + half * half));
      }
    }
  }

  const MapChart& Chart;
  int Width;
  int Height;
  const std::vector<MapRequest>& Requests;
  bool NeedsBarycentrics = false;
  std::vector<Run> Runs;
  std::vector<double> B1;
  std::vector<double> B2;
};
} // namespace

Status rasterizeMaps(const MapChart& chart, int width, int height, const int* faces,
  const std::vector<MapRequest>& requests, const Progress& progress)
{
  if (requests.empty())
  {
    return Status::success();
  }
  // Slabs of about a million pixels, so that an abort is honoured soon.
  const int slab = std::max(rowsPerBand, (1 << 20) / std::max(1, width));
  for (int first = 0; first < height; first += slab)
  {
    if (!report(progress, static_cast<double>(first) / height))
    {
      return Status::aborted();
    }
    vtkSMPTools::For(
      first, std::min(height, first + slab), rowsPerBand, [&](vtkIdType begin, vtkIdType end) {
        RowPainter painter(chart, width, height, requests);
        for (vtkIdType row = begin; row < end; ++row)
        {
          painter.paint(static_cast<int>(row), faces);
        }
      });
  }
  return Status::success();
}
} // namespace stipple
