// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapRasterizer.h"
#include "SyntheticMapChart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace
{
using stipple::MapChart;
using stipple::MapKind;
using stipple::MapRequest;
using stipple::Vec2;
using stipple::Vec3;

std::vector<int> facesOf(const MapChart& chart, int width, int height)
{
  std::vector<int> faces(static_cast<std::size_t>(width) * height, -2);
  stipple::rasterizeFaces(chart, width, height, faces.data());
  return faces;
}

/// The face that the pixel's centre is deepest in, by exact-enough geometry and brute force.
double depthIn(const MapChart& chart, int f, int i, int j, int width, int height)
{
  const Vec2 p((i + 0.5) * chart.extent.x() / width, (j + 0.5) * chart.extent.y() / height);
  const auto& t = chart.triangles[f];
  return stipple::barycentric(p, chart.uv[t[0]], chart.uv[t[1]], chart.uv[t[2]]).minCoeff();
}

TEST(MapRasterizer, FacesContainTheirPixelCentres)
{
  const auto sheet = synthetic::makeSheet(17, 13, 1., 0.7, 0.25);
  const int width = 211;
  const int height = 148;
  const auto faces = facesOf(sheet.chart, width, height);
  std::set<int> seen;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const int f = faces[j * width + i];
      ASSERT_GE(f, 0);
      // A pixel may be off by the rounding to 1/256 of a pixel.
      EXPECT_GT(depthIn(sheet.chart, f, i, j, width, height), -2e-3) << "pixel " << i << ", " << j;
      seen.insert(f);
    }
  }
  EXPECT_EQ(seen.size(), sheet.chart.triangles.size()) << "triangles of 60 pixels each own some";
}

TEST(MapRasterizer, EveryPixelHasAFaceWithoutRepairs)
{
  // From one triangle a thousand pixels to a hundred triangles a pixel, and centres right on edges.
  for (const double jitter : { 0., 0.35 })
  {
    for (const int n : { 1, 2, 16, 33, 250 })
    {
      const auto sheet = synthetic::makeSheet(n, n, 0.8, 1., jitter);
      for (const int size : { 1, 2, 32, 33, 45, 64, 257 })
      {
        const auto faces = facesOf(sheet.chart, size, size);
        EXPECT_EQ(std::count_if(faces.begin(), faces.end(), [](int f) { return f < 0; }), 0)
          << n << " quads, " << size << " pixels, jitter " << jitter;
      }
    }
  }
}

TEST(MapRasterizer, EdgesThroughCentresBelongToOneSide)
{
  // Four triangles around the centre of the middle pixel of 3 x 3; both diagonals run through
  // centres.
  MapChart chart;
  chart.uv = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0.5, 0.5 } };
  chart.triangles = { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
  chart.area = { 1.f, 1.f, 1.f, 1.f };
  // Left edges and edges at a first row belong to a triangle. Were any centre owned twice, the
  // equal areas would leave the lower index; reversing the order must not change who owns it.
  const auto faces = facesOf(chart, 3, 3);
  MapChart reversed = chart;
  std::reverse(reversed.triangles.begin(), reversed.triangles.end());
  const auto other = facesOf(reversed, 3, 3);
  for (int p = 0; p < 9; ++p)
  {
    EXPECT_EQ(faces[p], 3 - other[p]) << "pixel " << p;
  }
}

TEST(MapRasterizer, WideTrianglesAreFilledLikeSmallOnes)
{
  // Triangles wider than a few pixels are filled by spans, which must be the same pixels.
  const auto sheet = synthetic::makeSheet(2, 30, 1., 1., 0.4);
  const int size = 200;
  const auto faces = facesOf(sheet.chart, size, size);
  for (int p = 0; p < size * size; ++p)
  {
    ASSERT_GE(faces[p], 0);
    EXPECT_GT(depthIn(sheet.chart, faces[p], p % size, p / size, size, size), -5e-3);
  }
}

TEST(MapRasterizer, SmallerTrianglesWinTheirPixels)
{
  MapChart chart;
  chart.uv = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
  chart.triangles = { { 0, 1, 2 }, { 1, 3, 2 }, { 0, 1, 3 }, { 0, 3, 2 } }; // the square, twice
  chart.area = { 2.f, 2.f, 1.f, 3.f };
  const auto faces = facesOf(chart, 8, 8);
  for (int j = 0; j < 8; ++j)
  {
    for (int i = 0; i < 8; ++i)
    {
      if (i > j)
      {
        EXPECT_EQ(faces[8 * j + i], 2) << i << ", " << j;
      }
      else if (i < j)
      {
        EXPECT_NE(faces[8 * j + i], 3) << i << ", " << j;
      }
    }
  }
}

TEST(MapRasterizer, UncoveredPixelsGoToTheNearestTriangle)
{
  auto sheet = synthetic::makeSheet(12, 12, 1., 1., 0.3);
  // Cut a hole.
  MapChart& chart = sheet.chart;
  MapChart holed = chart;
  holed.triangles.clear();
  holed.area.clear();
  for (int f = 0; f < chart.numberOfTriangles(); ++f)
  {
    const auto& t = chart.triangles[f];
    const Vec2 center = (chart.uv[t[0]] + chart.uv[t[1]] + chart.uv[t[2]]) / 3.;
    if ((center - Vec2(0.45, 0.5)).norm() > 0.2)
    {
      holed.triangles.push_back(t);
      holed.area.push_back(chart.area[f]);
    }
  }
  const int size = 64;
  auto faces = facesOf(holed, size, size);
  const auto before = faces;
  const auto open = std::count(faces.begin(), faces.end(), -1);
  ASSERT_GT(open, 200);
  EXPECT_EQ(stipple::fillUncoveredPixels(holed, size, size, faces.data()), open);
  const auto distance = [&](int f, int p) {
    const Vec2 q((p % size + 0.5) / size, (p / size + 0.5) / size);
    double least = std::numeric_limits<double>::max();
    for (int k = 0; k < 3; ++k)
    {
      const Vec2& a = holed.uv[holed.triangles[f][k]];
      const Vec2 ab = holed.uv[holed.triangles[f][(k + 1) % 3]] - a;
      const double s = std::clamp((q - a).dot(ab) / ab.squaredNorm(), 0., 1.);
      least = std::min(least, (q - a - s * ab).norm());
    }
    return least;
  };
  for (int p = 0; p < size * size; ++p)
  {
    ASSERT_GE(faces[p], 0);
    if (before[p] >= 0)
    {
      EXPECT_EQ(faces[p], before[p]) << "covered pixels stay";
      continue;
    }
    double nearest = std::numeric_limits<double>::max();
    for (int f = 0; f < holed.numberOfTriangles(); ++f)
    {
      nearest = std::min(nearest, distance(f, p));
    }
    EXPECT_LT(distance(faces[p], p), nearest + 0.5 / size) << "half a pixel from the best at most";
  }

  // No pixel at all covered: still a face each.
  MapChart far;
  far.uv = { { 0, 0 }, { 0.001, 0 }, { 0, 0.001 } };
  far.triangles = { { 0, 1, 2 } };
  far.area = { 1.f };
  auto none = facesOf(far, 4, 4);
  EXPECT_EQ(stipple::fillUncoveredPixels(far, 4, 4, none.data()), 16);
  EXPECT_EQ(std::count(none.begin(), none.end(), 0), 16);
}

TEST(MapRasterizer, LinearMapsReproduceLinearFunctions)
{
  const auto sheet = synthetic::makeSheet(23, 19, 1., 0.5, 0.3);
  const int width = 160;
  const int height = 80;
  const auto faces = facesOf(sheet.chart, width, height);
  std::vector<double> values;
  for (const Vec2& uv : sheet.chart.uv)
  {
    values.push_back(3. * uv.x() - 5. * uv.y() + 1.);
    values.push_back(1e6 + uv.x());
  }
  std::vector<float> map(2 * faces.size());
  ASSERT_TRUE(stipple::rasterizeMaps(
    sheet.chart, width, height, faces.data(), { { MapKind::Linear, 2, values.data(), map.data() } })
                .ok());
  for (int p = 0; p < width * height; ++p)
  {
    const double u = (p % width + 0.5) / width;
    const double v = (p / width + 0.5) / height * 0.5;
    EXPECT_NEAR(map[2 * p], 3. * u - 5. * v + 1., 1e-3)
      << "but for centres that rounding moved over an edge";
    EXPECT_NEAR(map[2 * p + 1], 1e6 + u, 0.07);
  }
}

TEST(MapRasterizer, TotalCurvatureSquaresWhatItInterpolates)
{
  const auto sheet = synthetic::makeSheet(1, 1, 1., 1., 0.);
  const auto faces = facesOf(sheet.chart, 2, 2);
  std::vector<double> mean;
  std::vector<double> half;
  std::vector<double> pairs;
  for (std::size_t p = 0; p < sheet.points.size(); ++p)
  {
    mean.push_back(1.5 - static_cast<double>(p));
    half.push_back(0.25 + 0.5 * static_cast<double>(p));
    pairs.insert(pairs.end(), { mean.back(), half.back() });
  }
  float h[4];
  float r[4];
  float total[4];
  ASSERT_TRUE(stipple::rasterizeMaps(sheet.chart, 2, 2, faces.data(),
    { { MapKind::Linear, 1, mean.data(), h }, { MapKind::Linear, 1, half.data(), r },
      { MapKind::TotalCurvature, 1, pairs.data(), total } })
                .ok());
  for (int p = 0; p < 4; ++p)
  {
    const double low = h[p] - r[p];
    const double high = h[p] + r[p];
    EXPECT_NEAR(total[p], low * low + high * high, 1e-5);
  }
}

TEST(MapRasterizer, AnAbortIsHonoured)
{
  const auto sheet = synthetic::makeSheet(4, 4, 1., 1., 0.3);
  const auto faces = facesOf(sheet.chart, 16, 16);
  std::vector<double> values(sheet.points.size(), 1.);
  std::vector<float> map(faces.size());
  const stipple::Status status = stipple::rasterizeMaps(sheet.chart, 16, 16, faces.data(),
    { { MapKind::Linear, 1, values.data(), map.data() } }, [](double) { return false; });
  EXPECT_TRUE(status.isAbort());
}
} // namespace
