// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A chart made up for tests: a bumpy, irregular sheet over its rectangle, denser on one side.
#ifndef SyntheticMapChart_h
#define SyntheticMapChart_h

#include "MapRasterizer.h"

#include <cmath>
#include <cstdint>

namespace synthetic
{
/// Small and portable, so that the pictures are the same everywhere.
class Random
{
public:
  explicit Random(std::uint32_t seed)
    : State(seed * 2654435761u + 1u)
  {
  }
  double next() // [0, 1)
  {
    this->State = this->State * 1664525u + 1013904223u;
    return (this->State >> 8) / 16777216.;
  }

private:
  std::uint32_t State;
};

struct Sheet
{
  stipple::MapChart chart;
  std::vector<stipple::Vec3> points;
};

inline stipple::Vec3 sheetPoint(double s, double t)
{
  // Stretched towards s = 1, with bumps.
  const double x = s * (0.4 + 0.6 * s);
  return { 2. * x, t, 0.08 * std::sin(9. * s) * std::cos(7. * t) };
}

/// n x m quads, split by random diagonals; interior points are moved by up to jitter of a quad.
inline Sheet makeSheet(
  int n, int m, double width, double height, double jitter, std::uint32_t seed = 1)
{
  Sheet sheet;
  Random random(seed);
  sheet.chart.extent = { width, height };
  for (int j = 0; j <= m; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const bool inside = i > 0 && i < n && j > 0 && j < m;
      const double di = inside ? jitter * (2. * random.next() - 1.) : 0.;
      const double dj = inside ? jitter * (2. * random.next() - 1.) : 0.;
      const double s = (i + di) / n;
      const double t = (j + dj) / m;
      sheet.chart.uv.emplace_back(s * width, t * height);
      sheet.points.push_back(sheetPoint(s, t));
    }
  }
  for (int j = 0; j < m; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i;
      const int b = a + 1;
      const int c = a + n + 2;
      const int d = a + n + 1;
      if (random.next() < 0.5)
      {
        sheet.chart.triangles.push_back({ a, b, c });
        sheet.chart.triangles.push_back({ a, c, d });
      }
      else
      {
        sheet.chart.triangles.push_back({ a, b, d });
        sheet.chart.triangles.push_back({ b, c, d });
      }
    }
  }
  for (const auto& t : sheet.chart.triangles)
  {
    sheet.chart.area.push_back(static_cast<float>(
      stipple::triangleArea(sheet.points[t[0]], sheet.points[t[1]], sheet.points[t[2]])));
  }
  return sheet;
}
} // namespace synthetic

#endif
